#pragma once

#include <vector>

#include "libdepixel/core/color.hpp"
#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/core/memory.hpp"

namespace depixel {

/// Colours in the order that a target has them. Blending treats red and blue alike, so a picture that is
/// drawn of colours in another order is the same picture in that order.
class OrderedColours {
 public:
  /// \return the colours themselves, or copies that stay until the next call.
  const std::vector<Rgba>& of(const std::vector<Rgba>& colours, ChannelOrder order) {
    if (order == ChannelOrder::rgba) return colours;
    swapped_.resize(colours.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const Rgba c = colours[i];
      swapped_[i] = {c.b, c.g, c.r, c.a};
    }
    return swapped_;
  }

  std::size_t memory_bytes() const { return held_bytes(swapped_); }

 private:
  std::vector<Rgba> swapped_;
};

}  // namespace depixel
