#include "libdepixel/raster/flattened_curves.hpp"

#include "libdepixel/raster/flatten.hpp"

namespace depixel {

void FlattenedCurves::start(const SplineTable& table, const OutputGrid& grid) {
  table_ = &table;
  if (generation_ != table.generation() || scale_ != grid.scale) {
    entries_.clear();
    points_.clear();
    generation_ = table.generation();
    scale_ = grid.scale;
  }
  entries_.resize(table.size() + 1);
}

void FlattenedCurves::flatten_curve(int number) {
  const EdgeCurve& curve = table_->curve(number);
  const OutputGrid grid(View{scale_.x, scale_.y, 0, 0}, Lattice(), PictureView{});
  const glm::ivec2 p0(curve.p0), p1(curve.p1), p2(curve.p2), p3(curve.p3);
  const int first = static_cast<int>(points_.size());
  points_.emplace_back(grid(p0));
  flatten(grid(p0), grid(p1), grid(p2), grid(p3), flattening_pieces(p0, p1, p2, p3, scale_),
          [&](glm::ivec2, glm::ivec2 to) { points_.emplace_back(to); });
  entries_[number] = {first, static_cast<int>(points_.size()) - first};
}

}  // namespace depixel
