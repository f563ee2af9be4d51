#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "libdepixel/raster/view.hpp"

namespace depixel {

/// How wide a source pixel is shown.
enum class PixelAspect {
  square,          ///< or as the source says
  eight_sevenths,  ///< 8:7, as televisions showed consoles of 256 pixels a line
  picture_4_3      ///< whatever makes the whole picture 4:3
};

/// A rectangle of output pixels; y counts from the top.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;

  bool empty() const { return width <= 0 || height <= 0; }
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// The pixels of both rectangles; empty where they do not meet.
PixelRect intersection(const PixelRect& a, const PixelRect& b);

/// Where the picture lies in the area that is left for it in the window: zoom and pan, as arithmetic.
///
/// The scale is that of height; the width's follows by the pixel aspect. While the view fits the area, it
/// follows the area's and the picture's sizes; zooming or panning ends that. Positions are output pixels in
/// the window, from its top left.
class ViewControl {
 public:
  static constexpr double kMinScale = 1.0 / 16, kMaxScale = 256;
  /// The largest side of the picture as shown, in output pixels: huge pictures are magnified less.
  static constexpr double kMaxShownSide = 1 << 21;

  void set_area(const PixelRect& area) { area_ = area; }
  /// \param aspect  a pixel's width over its height, for PixelAspect::square.
  void set_source(glm::ivec2 size, double aspect = 1);
  void set_aspect(PixelAspect aspect);
  /// Whole scales only: fitting rounds down, zooming goes from one to the next.
  void set_whole(bool whole);

  /// Shows the whole picture, as large as it can be.
  void fit();
  /// Shows the picture's middle at a scale, in output pixels to a source pixel.
  void set_scale(double scale);
  /// Multiplies the scale; the source point under `pointer` stays there.
  void zoom_about(glm::dvec2 pointer, double factor);
  /// Moves the picture by output pixels. At least a part of it stays visible.
  void pan(glm::dvec2 by);

  const PixelRect& area() const { return area_; }
  bool is_fitted() const { return fitted_; }
  /// Output pixels to a source pixel, downwards.
  double scale() const;
  /// The source point at a position of the window; may lie outside the picture.
  glm::dvec2 source_at(glm::dvec2 position) const;

  /// The whole picture in the window, on whole pixels; empty without a picture or an area.
  PixelRect placement() const;
  /// What of it is visible.
  PixelRect visible() const { return intersection(area_, placement()); }
  /// The part of the source that a rectangle of the window shows.
  View view_of(const PixelRect& part) const;

 private:
  double width_factor() const;
  double fitting_scale() const;
  double allowed(double scale) const;
  void release();
  void keep_visible();

  PixelRect area_;
  glm::ivec2 source_{0, 0};
  double source_aspect_ = 1;
  PixelAspect aspect_ = PixelAspect::square;
  bool whole_ = false;
  bool fitted_ = true;
  double scale_ = 1;         ///< when not fitted
  glm::dvec2 centre_{0, 0};  ///< source point at the area's middle, when not fitted
};

}  // namespace depixel
