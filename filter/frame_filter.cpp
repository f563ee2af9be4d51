#include "filter/frame_filter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "libdepixel/core/stopwatch.hpp"

namespace depixel {
namespace {

tl::unexpected<Error> refuse(std::string sentence) {
  return tl::unexpected(Error{std::move(sentence)});
}

bool is_inside(const Viewport& viewport, const PictureView& picture) {
  return viewport.x >= 0 && viewport.y >= 0 && viewport.width <= picture.width - viewport.x &&
         viewport.height <= picture.height - viewport.y;
}

}  // namespace

bool FrameFilter::has_pixels(const FrameView& frame) {
  return frame.pixels != nullptr && frame.width > 0 && frame.height > 0;
}

tl::expected<void, Error> FrameFilter::submit(const FrameView& frame, const Options& options) {
  if (!has_pixels(frame)) {
    return refuse("A frame without pixels cannot be drawn.");
  }
  stats_ = {};
  const Stopwatch time(stats_.submit_ns);
  options_ = options;
  vectorizer_.vectorize(frame, options);
  has_frame_ = true;
  if (is_checking_) {
    Vectorizer scratch;
    if (!(scratch.vectorize(frame, options) == vectorizer_.map())) {
      return refuse("The map that was made incrementally is not the one made from scratch.");
    }
  }
  return {};
}

const PictureView* picture_of(const Target& target) {
  if (const auto* kept = std::get_if<KeptPicture>(&target)) return &kept->picture;
  return std::get_if<PictureView>(&target);
}

PictureView part_of(const PictureView& picture, const Viewport& viewport) {
  return {picture.pixels + viewport.y * picture.pitch + std::ptrdiff_t{4} * viewport.x, viewport.width,
          viewport.height, picture.pitch, picture.order};
}

tl::expected<void, Error> FrameFilter::check(const Target& target, const Viewport& viewport,
                                             const View& view) const {
  if (!has_frame_) return refuse("There is no frame to draw yet.");
  if (viewport.width < 0 || viewport.height < 0) return refuse("A viewport cannot be smaller than nothing.");
  const PictureView* picture = picture_of(target);
  if (picture != nullptr && !is_inside(viewport, *picture)) {
    return refuse(fmt::format("A viewport of {} x {} pixels at {}, {} is not inside a picture of {} x {}.",
                              viewport.width, viewport.height, viewport.x, viewport.y, picture->width,
                              picture->height));
  }
  const Lattice& lattice = vectorizer_.lattice();
  const auto in_range = [](double scale, double origin, int size) {
    return scale > 0 && std::abs(origin * scale) < kLargestCoordinate &&
           std::abs((size - origin) * scale) < kLargestCoordinate;
  };
  if (!in_range(view.scale_x, view.origin_x, lattice.width()) ||
      !in_range(view.scale_y, view.origin_y, lattice.height())) {
    return refuse(fmt::format("The view's scale of {} by {} at {}, {} is out of range.", view.scale_x,
                              view.scale_y, view.origin_x, view.origin_y));
  }
  return {};
}

}  // namespace depixel
