#include "libdepixel/raster/flattened_curves.hpp"

#include "libdepixel/raster/curve_to_output.hpp"

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
  const CurveToOutput to_output{glm::ivec2(scale_)};
  const CurveToOutput::Points points = to_output(curve);
  const int first = static_cast<int>(points_.size());
  points_.emplace_back(points[0]);
  to_output.flatten(curve, points, [&](glm::ivec2, glm::ivec2 to) { points_.emplace_back(to); });
  entries_[number] = {first, static_cast<int>(points_.size()) - first};
}

}  // namespace depixel
