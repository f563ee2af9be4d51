#include "apps/player/view_control.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace depixel {
namespace {

/// Zooming by wheel multiplies often; a scale that near to a whole number is meant to be it.
constexpr double kNearWhole = 1e-9;
/// What rounding may take from a position, in output pixels.
constexpr double kRounding = 1e-6;
/// Pixels are not shown narrower or wider than this, whatever shape the picture has.
constexpr double kMinFactor = 0.25, kMaxFactor = 4;

int rounded(double value) {
  return static_cast<int>(std::lround(value));
}

glm::dvec2 middle(const PixelRect& area) {
  return glm::dvec2(area.x, area.y) + glm::dvec2(area.width, area.height) / 2.0;
}

}  // namespace

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::max(0, std::min(a.x + a.width, b.x + b.width) - x),
          std::max(0, std::min(a.y + a.height, b.y + b.height) - y)};
}

double ViewControl::width_factor() const {
  switch (aspect_) {
    case PixelAspect::square:
      return std::clamp(source_aspect_, kMinFactor, kMaxFactor);
    case PixelAspect::eight_sevenths:
      return 8.0 / 7;
    case PixelAspect::picture_4_3:
      return std::clamp(4.0 / 3 * source_.y / std::max(1, source_.x), kMinFactor, kMaxFactor);
  }
  return 1;
}

double ViewControl::allowed(double scale) const {
  if (whole_ && scale > 1) scale = std::round(scale);
  const double longest = std::max({source_.x * width_factor(), double(source_.y), 1.0});
  const double smallest = kMinScale / std::min(1.0, width_factor());
  return std::clamp(scale, smallest, std::min(kMaxScale, std::max(1.0, kMaxShownSide / longest)));
}

double ViewControl::fitting_scale() const {
  if (source_.x < 1 || source_.y < 1) return 1;
  const double scale = std::min(area_.width / (source_.x * width_factor()), double(area_.height) / source_.y);
  return allowed(whole_ && scale > 1 ? std::floor(scale) : scale);
}

double ViewControl::scale() const {
  return fitted_ ? fitting_scale() : scale_;
}

void ViewControl::set_source(glm::ivec2 size, double aspect) {
  source_ = size;
  source_aspect_ = aspect;
  scale_ = allowed(scale_);
  keep_visible();
}

void ViewControl::set_aspect(PixelAspect aspect) {
  aspect_ = aspect;
  scale_ = allowed(scale_);
}

void ViewControl::set_whole(bool whole) {
  whole_ = whole;
  scale_ = allowed(scale_);
}

void ViewControl::fit() {
  fitted_ = true;
}

void ViewControl::release() {
  if (!fitted_) return;
  scale_ = fitting_scale();
  centre_ = glm::dvec2(source_) / 2.0;
  fitted_ = false;
}

void ViewControl::set_scale(double scale) {
  fitted_ = false;
  scale_ = allowed(scale);
  centre_ = glm::dvec2(source_) / 2.0;
}

void ViewControl::zoom_about(glm::dvec2 pointer, double factor) {
  release();
  const glm::dvec2 fixed = source_at(pointer);
  if (whole_ && scale_ >= 1) {
    // A small turn of the wheel must move on by a step, or it would never leave its number.
    scale_ = allowed(factor > 1 ? std::max(scale_ * factor, std::floor(scale_) + 1)
                                : std::min(scale_ * factor, std::ceil(scale_) - 1));
  } else {
    const double scale = allowed(scale_ * factor);
    scale_ = std::abs(scale - std::round(scale)) < kNearWhole ? std::round(scale) : scale;
  }
  centre_ += fixed - source_at(pointer);
  keep_visible();
}

void ViewControl::pan(glm::dvec2 by) {
  release();
  centre_ -= by / glm::dvec2(scale_ * width_factor(), scale_);
  keep_visible();
}

void ViewControl::keep_visible() {
  centre_ = glm::clamp(centre_, glm::dvec2(0), glm::dvec2(source_));
}

glm::dvec2 ViewControl::source_at(glm::dvec2 position) const {
  const glm::dvec2 centre = fitted_ ? glm::dvec2(source_) / 2.0 : centre_;
  return centre + (position - middle(area_)) / glm::dvec2(scale() * width_factor(), scale());
}

PixelRect ViewControl::placement() const {
  if (source_.x < 1 || source_.y < 1 || area_.empty()) return {};
  const glm::dvec2 scales(scale() * width_factor(), scale());
  const glm::dvec2 centre = fitted_ ? glm::dvec2(source_) / 2.0 : centre_;
  const glm::dvec2 corner = middle(area_) - centre * scales;
  const auto floored = [](double value) { return static_cast<int>(std::floor(value + kRounding)); };
  return {floored(corner.x), floored(corner.y), std::max(1, rounded(source_.x * scales.x)),
          std::max(1, rounded(source_.y * scales.y))};
}

View ViewControl::view_of(const PixelRect& part) const {
  const PixelRect all = placement();
  const double scale_x = double(all.width) / source_.x, scale_y = double(all.height) / source_.y;
  return {scale_x, scale_y, (part.x - all.x) / scale_x, (part.y - all.y) / scale_y};
}

}  // namespace depixel
