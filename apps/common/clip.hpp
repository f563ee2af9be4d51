#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "apps/common/inputs.hpp"
#include "apps/common/picture.hpp"
#include "libdepixel/core/error.hpp"

namespace depixel {

/// A frame of a clip.
struct ClipFrame {
  Picture picture;
  std::string name;    ///< that its output is to have, without ending
  double seconds = 0;  ///< how long it is shown
};

/// The frames of inputs, in any order: what a player plays. Decoded frames are kept as far as a budget of
/// memory goes, and decoded again when they are asked for again.
///
/// Standard input is read by a thread as it comes. Of it the newest frames can be had only; reading waits
/// when it is far ahead of what was asked for.
class Clip {
 public:
  static constexpr std::size_t kBudgetBytes = std::size_t{512} << 20;  ///< hundreds of frames of any console

  /// Looks at all files, so that the number of frames is known; of pictures the first bytes only.
  static tl::expected<std::unique_ptr<Clip>, Error> open(const Inputs& inputs,
                                                         std::size_t budget_bytes = kBudgetBytes);

  Clip() = default;
  Clip(const Clip&) = delete;
  Clip& operator=(const Clip&) = delete;
  virtual ~Clip() = default;

  /// None while standard input may bring more.
  virtual std::optional<int> frame_count() = 0;
  /// The first frame that can still be had; above 0 for standard input only.
  virtual int first_frame() = 0;
  /// Whether frame() has it at once or, for standard input, at all yet. Never waits.
  virtual bool has_frame(int index) = 0;
  /// A frame for which has_frame() is true, or what is wrong with it. It stays as long as it is held.
  virtual tl::expected<std::shared_ptr<const ClipFrame>, Error> frame(int index) = 0;
  /// Width of a pixel over its height, if the source says.
  virtual std::optional<double> pixel_aspect() = 0;
};

// The two kinds of clips behind open().
tl::expected<std::unique_ptr<Clip>, Error> open_file_clip(const Inputs& inputs, std::size_t budget_bytes);
std::unique_ptr<Clip> open_stream_clip(std::size_t budget_bytes);

}  // namespace depixel
