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

/// Whether the rows of a target are counted from its bottom.
bool is_upside_down(const Target& target) {
  return std::holds_alternative<GlFramebuffer>(target);
}

}  // namespace

tl::expected<void, Error> FrameFilter::submit(const FrameView& frame, const Options& options) {
  if (frame.pixels == nullptr || frame.width <= 0 || frame.height <= 0) {
    return refuse("A frame without pixels cannot be drawn.");
  }
  stats_ = {};
  const Stopwatch time(stats_.submit_ns);
  options_ = options;
  vectorizer_.vectorize(frame, options);
  changes_.add(vectorizer_.changes());
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
  const View all = view.from_margin(lattice);
  if (!in_range(view.scale_x, all.origin_x, lattice.width()) ||
      !in_range(view.scale_y, all.origin_y, lattice.height())) {
    return refuse(fmt::format("The view's scale of {} by {} at {}, {} is out of range.", view.scale_x,
                              view.scale_y, view.origin_x, view.origin_y));
  }
  return {};
}

tl::expected<void, Error> FrameFilter::draw(const Target& target, const Viewport& viewport,
                                            const View& view) {
  if (auto checked = check(target, viewport, view); !checked) return checked;
  if (vectorizer_.lattice().margin() == 0) return draw_checked(target, viewport, view);
  const Viewport shown = shown_part(viewport, view);
  const int first_row = is_upside_down(target) ? viewport.height - shown.y - shown.height : shown.y;
  const Viewport inside{viewport.x + shown.x, viewport.y + first_row, shown.width, shown.height};
  if (inside.width > 0 && inside.height > 0) {
    const View part{view.scale_x, view.scale_y, view.origin_x + shown.x / view.scale_x,
                    view.origin_y + shown.y / view.scale_y};
    if (auto drawn = draw_checked(target, inside, part); !drawn) return drawn;
  }
  return clear_outside(target, viewport, inside);
}

/// The frame's rectangle, to the nearest output pixels, from the viewport's top left.
Viewport FrameFilter::shown_part(const Viewport& viewport, const View& view) const {
  const Lattice& lattice = vectorizer_.lattice();
  const auto edge = [](double source, double scale, double origin, int size) {
    return static_cast<int>(std::clamp(std::round((source - origin) * scale), 0.0, double(size)));
  };
  const int west = edge(0, view.scale_x, view.origin_x, viewport.width);
  const int east = edge(lattice.shown_width(), view.scale_x, view.origin_x, viewport.width);
  const int north = edge(0, view.scale_y, view.origin_y, viewport.height);
  const int south = edge(lattice.shown_height(), view.scale_y, view.origin_y, viewport.height);
  return {west, north, east - west, south - north};
}

tl::expected<void, Error> FrameFilter::clear_outside(const Target& target, const Viewport& viewport,
                                                     const Viewport& inside) {
  const int east = viewport.x + viewport.width, end = viewport.y + viewport.height;
  const int inside_east = inside.x + inside.width, inside_end = inside.y + inside.height;
  for (const Viewport& part : {Viewport{viewport.x, viewport.y, viewport.width, inside.y - viewport.y},
                               Viewport{viewport.x, inside_end, viewport.width, end - inside_end},
                               Viewport{viewport.x, inside.y, inside.x - viewport.x, inside.height},
                               Viewport{inside_east, inside.y, east - inside_east, inside.height}}) {
    if (part.width <= 0 || part.height <= 0) continue;
    if (const PictureView* picture = picture_of(target)) {
      const PictureView pixels = part_of(*picture, part);
      for (int y = 0; y < pixels.height; ++y) {
        std::fill_n(pixels.pixels + y * pixels.pitch, std::size_t{4} * pixels.width, std::uint8_t{0});
      }
    } else if (auto cleared = clear(std::get<GlFramebuffer>(target), part); !cleared) {
      return cleared;
    }
  }
  return {};
}

}  // namespace depixel
