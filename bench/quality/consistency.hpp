#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/common/picture.hpp"
#include "bench/quality/upscalers.hpp"

namespace depixel::bench {

/// A picture whose true shapes nobody knows: what is drawn is compared with itself and with the picture.
struct SamplePicture {
  std::string name;
  Picture picture;  ///< opaque
};

/// Reads pictures and lays them on grey, as not all upscalers know transparency. Throws as read_picture().
std::vector<SamplePicture> read_samples(const std::vector<std::filesystem::path>& files);

/// Faithfulness: mean absolute difference of red, green and blue, 0..255, between a picture and what is drawn
/// of it, averaged over each pixel's square. 0 where every pixel keeps its mean colour.
double reduction_error(const Upscaler& upscaler, const Picture& picture, int scale);

/// Flicker: the same difference between what is drawn of a picture and of its copy shifted by one pixel, to
/// the right and down, shifted back. What enters the picture repeats its border. 0 where what is drawn moves
/// with the picture; what lies near the border is left out.
double shift_error(const Upscaler& upscaler, const Picture& picture, int scale);

/// Whether a picture has enough that is not near the border for shift_error().
bool has_middle(const Picture& picture);

}  // namespace depixel::bench
