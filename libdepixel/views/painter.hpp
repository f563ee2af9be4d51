#pragma once

#include "libdepixel/views/stage_view.hpp"

namespace depixel {

/// Paints strokes and circles over a picture. A pixel's coverage is that of a straight band through it at the
/// distance of its centre: exact for level and upright lines, within a few percent for others. Neighbours of
/// one colour are painted as one shape, so that they do not darken each other where they join. Source: the
/// distance-to-coverage rule common to GPU line drawing.
class Painter {
 public:
  /// \param view  the part of the source that the target shows.
  Painter(const View& view, const PictureView& target);

  void paint(std::span<const Stroke> strokes);
  void paint(std::span<const Circle> circles);

 private:
  glm::vec2 to_target(glm::ivec2 subpixels) const;
  bool is_near_target(glm::vec2 low, glm::vec2 high, float reach) const;
  void cover(const Stroke& stroke);
  void cover(const Circle& circle);
  void cover_line(glm::vec2 a, glm::vec2 b, float half_width);
  void cover_pixel(int x, int y, float coverage);
  template <typename Shape>
  void paint_groups(std::span<const Shape> shapes);
  void blend_covered(Rgba colour);

  PictureView target_;
  glm::vec2 scale_;              ///< output pixels to a source pixel
  glm::vec2 offset_;             ///< output pixels from the source's origin to the target's top left
  float length_scale_;           ///< for widths and radii
  std::vector<float> coverage_;  ///< of each output pixel by the group that is being painted
  std::vector<int> covered_;     ///< pixels whose coverage is not zero
};

}  // namespace depixel
