#include "libdepixel/views/painter.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel {
namespace {

/// How much of a unit interval round `distance` lies within half_width of 0.
float band_coverage(float distance, float half_width) {
  const float inside = std::min(distance + 0.5f, half_width) - std::max(distance - 0.5f, -half_width);
  return std::max(0.0f, inside);
}

/// A line from a point on, to measure distances from.
class Line {
 public:
  Line(glm::vec2 from, glm::vec2 to) : from_(from), along_(to - from) {
    const float squared = glm::dot(along_, along_);
    inverse_ = squared > 0 ? 1 / squared : 0;
  }
  float distance(glm::vec2 p) const {
    const glm::vec2 offset = p - from_;
    return glm::length(offset - along_ * std::clamp(glm::dot(offset, along_) * inverse_, 0.0f, 1.0f));
  }

 private:
  glm::vec2 from_, along_;
  float inverse_;
};

/// A range of whole pixels within 0 .. size.
struct PixelRange {
  int from, to;
  PixelRange(float low, float high, int size)
      : from(static_cast<int>(std::floor(std::clamp(low, 0.0f, float(size))))),
        to(static_cast<int>(std::ceil(std::clamp(high, 0.0f, float(size))))) {}
};

std::uint8_t mixed(float a, float b, float t) {
  return static_cast<std::uint8_t>(std::lrint(a + (b - a) * t));
}

/// Paints a colour over a pixel.
void blend(Rgba colour, float coverage, std::uint8_t* p) {
  const float over = std::min(coverage, 1.0f) * float(colour.a) / 255.0f;
  const float under = float(p[3]) / 255.0f * (1 - over), alpha = over + under;
  if (alpha <= 0) return;
  const float t = over / alpha;
  p[0] = mixed(p[0], colour.r, t);
  p[1] = mixed(p[1], colour.g, t);
  p[2] = mixed(p[2], colour.b, t);
  p[3] = static_cast<std::uint8_t>(std::lrint(alpha * 255.0f));
}

}  // namespace

Painter::Painter(const View& view, const PictureView& target)
    : target_(target),
      scale_(view.scale_x, view.scale_y),
      offset_(view.origin_x * view.scale_x, view.origin_y * view.scale_y),
      length_scale_(std::sqrt(scale_.x * scale_.y)),
      coverage_(std::size_t(target.width) * target.height, 0.0f) {}

void Painter::paint(std::span<const Stroke> strokes) {
  paint_groups(strokes);
}

void Painter::paint(std::span<const Circle> circles) {
  paint_groups(circles);
}

template <typename Shape>
void Painter::paint_groups(std::span<const Shape> shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    cover(shapes[i]);
    if (i + 1 == shapes.size() || shapes[i + 1].colour != shapes[i].colour) blend_covered(shapes[i].colour);
  }
}

glm::vec2 Painter::to_target(glm::ivec2 subpixels) const {
  return glm::vec2(subpixels) * (scale_ / float(kSubpixels)) - offset_;
}

bool Painter::is_near_target(glm::vec2 low, glm::vec2 high, float reach) const {
  return low.x - reach < float(target_.width) && high.x + reach > 0 &&
         low.y - reach < float(target_.height) && high.y + reach > 0;
}

void Painter::cover(const Stroke& stroke) {
  constexpr float kTolerance = 0.1f;  // output pixels
  const glm::vec2 p0 = to_target(stroke.p0), p1 = to_target(stroke.p1), p2 = to_target(stroke.p2),
                  p3 = to_target(stroke.p3);
  const float half_width = stroke.width_px * length_scale_ / 2;
  // The curve lies within the box of its points.
  const glm::vec2 low = glm::min(glm::min(p0, p1), glm::min(p2, p3));
  const glm::vec2 high = glm::max(glm::max(p0, p1), glm::max(p2, p3));
  if (!is_near_target(low, high, half_width + 0.5f)) return;
  // A cubic strays from its chord by at most 6/8 of its larger second difference; n pieces divide that by n
  // squared.
  const float bend = std::max(glm::length(p0 - 2.0f * p1 + p2), glm::length(p1 - 2.0f * p2 + p3));
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::sqrt(0.75f * bend / kTolerance))));
  glm::vec2 from = p0;
  for (int i = 1; i <= pieces; ++i) {
    const float t = float(i) / float(pieces), s = 1 - t;
    const glm::vec2 to = s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3;
    cover_line(from, to, half_width);
    from = to;
  }
}

void Painter::cover_line(glm::vec2 a, glm::vec2 b, float half_width) {
  if (a.y > b.y) std::swap(a, b);
  const float reach = half_width + 0.5f;
  const Line line(a, b);
  const PixelRange rows(a.y - reach, b.y + reach, target_.height);
  for (int y = rows.from; y < rows.to; ++y) {
    // Only the part of the line near this row matters to it.
    const float centre = float(y) + 0.5f, height = b.y - a.y;
    const auto x_at = [&](float level) {
      return height > 0 ? a.x + (b.x - a.x) * std::clamp((level - a.y) / height, 0.0f, 1.0f) : a.x;
    };
    const float x0 = x_at(centre - reach), x1 = height > 0 ? x_at(centre + reach) : b.x;
    const PixelRange columns(std::min(x0, x1) - reach, std::max(x0, x1) + reach, target_.width);
    for (int x = columns.from; x < columns.to; ++x) {
      cover_pixel(x, y, band_coverage(line.distance({float(x) + 0.5f, centre}), half_width));
    }
  }
}

void Painter::cover(const Circle& circle) {
  const glm::vec2 centre = to_target(circle.centre);
  const bool is_ring = circle.ring_px > 0;
  const float radius = circle.radius_px * length_scale_;
  const float half_width = is_ring ? circle.ring_px * length_scale_ / 2 : radius;
  const float reach = (is_ring ? radius + half_width : radius) + 0.5f;
  const PixelRange rows(centre.y - reach, centre.y + reach, target_.height);
  const PixelRange columns(centre.x - reach, centre.x + reach, target_.width);
  for (int y = rows.from; y < rows.to; ++y) {
    for (int x = columns.from; x < columns.to; ++x) {
      const float from_centre = glm::distance(centre, glm::vec2(float(x) + 0.5f, float(y) + 0.5f));
      const float distance = is_ring ? std::abs(from_centre - radius) : from_centre;
      cover_pixel(x, y, band_coverage(distance, half_width));
    }
  }
}

void Painter::cover_pixel(int x, int y, float coverage) {
  if (coverage <= 0) return;
  const int pixel = y * target_.width + x;
  if (coverage_[pixel] == 0) covered_.push_back(pixel);
  coverage_[pixel] = std::max(coverage_[pixel], coverage);
}

void Painter::blend_covered(Rgba colour) {
  for (const int pixel : covered_) {
    blend(colour, coverage_[pixel],
          target_.pixels + pixel / target_.width * target_.pitch + pixel % target_.width * 4);
    coverage_[pixel] = 0;
  }
  covered_.clear();
}

void paint_stage(const StageDrawing& drawing, const PictureView& target) {
  if (target.width <= 0 || target.height <= 0) return;
  paint_stage(drawing, View::fit(drawing.fill.lattice, target.width, target.height), target);
}

void paint_stage(const StageDrawing& drawing, const View& view, const PictureView& target) {
  if (target.width <= 0 || target.height <= 0) return;
  CpuRaster raster;
  raster.draw(drawing.fill, view, drawing.linear_light, 1, target);
  Painter painter(view.from_margin(drawing.fill.lattice), target);
  painter.paint(std::span<const Stroke>(drawing.strokes));
  painter.paint(std::span<const Circle>(drawing.circles));
}

}  // namespace depixel
