#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/incremental/rules.hpp"
#include "libdepixel/stages/dithers.hpp"

namespace depixel {

/// Blends the dithers of successive frames of one size: what blend_dithers() makes of each, bit for bit, for
/// work that follows the rows that changed.
class DitherUpdater {
 public:
  /// Forgets the frames before.
  void reset() { is_known_ = false; }

  /// \param linear_light  as in the call before, unless that was forgotten.
  /// \return the blended frame, valid until the next call.
  FrameView update(const FrameView& frame, bool linear_light, RuleSet rules);

  std::size_t memory_bytes() const {
    return dithers_.memory_bytes() + areas_before_.memory_bytes() + held_bytes(is_row_changed_);
  }

 private:
  bool take_changed_rows(const FrameView& frame);
  bool are_areas_changed(int y) const;

  Dithers dithers_;
  BitRows areas_before_;
  std::vector<std::uint8_t> is_row_changed_;  ///< by row of pixels
  bool is_known_ = false;
};

}  // namespace depixel
