#include "libdepixel/raster/curve_cells.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

#include "libdepixel/raster/curve_to_output.hpp"

namespace depixel {
namespace {

/// With more cells than so many for each pixel of the frame, all are forgotten: a frame has fewer mostly, and
/// what frames have in common is known again soon.
constexpr std::size_t kCellsAPixel = 2, kFewestCells = std::size_t{1} << 14;

}  // namespace

void CurveCells::start(const OutputGrid& grid, int pitch, std::uint64_t generation, std::size_t numbers) {
  const std::size_t pixels = std::size_t(grid.lattice.width()) * grid.lattice.height();
  const bool has_room = cells_.size() < std::max(kFewestCells, kCellsAPixel * pixels);
  if (scale_ != grid.scale || pitch_ != pitch || generation_ != generation || !has_room) {
    scale_ = grid.scale;
    whole_scale_ = {grid.x.whole_scale(), grid.y.whole_scale()};
    pitch_ = pitch;
    generation_ = generation;
    slicer_.resize(3 * whole_scale_.x);
    slicer_.start(0, 3 * whole_scale_.y);
    sums_.assign(std::size_t(sums_pitch()) * 3 * whole_scale_.y, 0);
    entries_.clear();
    views_.assign(1, {});
    cells_.assign(1, {});
  }
  if (entries_.size() < numbers) entries_.resize(numbers);
}

void CurveCells::flatten_curve(const EdgeCurve& curve) {
  const CurveToOutput to_output(whole_scale_);
  const CurveToOutput::Points points = to_output(curve);
  points_.assign(1, points[0]);
  to_output.flatten(curve, points, [&](glm::ivec2, glm::ivec2 to) { points_.push_back(to); });
}

/// Source: font-rs, as BandSums, for a colour change of 1.
void CurveCells::add_line(glm::ivec2 a, glm::ivec2 b) {
  slicer_.cut(a.x, a.y, b.x, b.y, [&](const LineSlicer::Slice& slice) {
    std::int32_t* sum = sums_.data() + slice.row * sums_pitch();
    slice.for_each_pixel([&](int column, int height, int area) {
      sum[column] += 2 * kRasterSubpixels * height - area;
      sum[column + 1] += area;
    });
  });
}

void CurveCells::make_cells(const EdgeCurve& curve, Entry& entry) {
  flatten_curve(curve);
  // The sums begin a tile north-west of the owner: curves reach no farther.
  const glm::ivec2 shift = whole_scale_ * kRasterSubpixels;
  glm::ivec2 low = points_.front() + shift, high = low;
  for (std::size_t k = 1; k < points_.size(); ++k) {
    const glm::ivec2 from = points_[k - 1] + shift, to = points_[k] + shift;
    low = glm::min(low, to);
    high = glm::max(high, to);
    add_line(from, to);
  }
  const int first_row = low.y / kRasterSubpixels,
            end_row = (high.y + kRasterSubpixels - 1) / kRasterSubpixels;
  const int first_column = low.x / kRasterSubpixels,
            last_column = std::min(high.x / kRasterSubpixels + 1, 3 * whole_scale_.x);
  entry.first = static_cast<int>(cells_.size());
  for (int row = 0; row < 3; ++row) {
    const int from = std::max(row * whole_scale_.y, first_row);
    const int to = std::min((row + 1) * whole_scale_.y, end_row);
    for (int y = from; y < to; ++y) {
      std::int32_t* sum = sums_.data() + y * sums_pitch();
      const int place = (y - whole_scale_.y) * pitch_ - whole_scale_.x;
      for (int x = first_column; x <= last_column; ++x) {
        add_cell(place + x, sum[x]);
        sum[x] = 0;
      }
    }
    entry.ends[row + 1] = static_cast<std::uint16_t>(static_cast<int>(cells_.size()) - entry.first);
  }
}

int CurveCells::add_views() {
  views_.push_back({});
  return static_cast<int>(views_.size()) - 1;
}

/// What curves do west of the middle line is known without looking at them if each is closed there: an end
/// that lies west goes upright to the height of the centre, and level to it. Of all curves that share the
/// end, that adds nothing, as their changes cancel out. Then curves that stay west add nothing either, and
/// those that cross the line make a difference to the centre only if they do so south of it: that is taken
/// back.
CurveCells::Range CurveCells::make_view(const EdgeCurve& curve, const Entry& entry, int tile) {
  const int row = tile / 3 - 1, column = tile % 3 - 1;
  const glm::ivec2 centre = (2 * glm::ivec2(column, row) + 1) * whole_scale_ * (kRasterSubpixels / 2);
  flatten_curve(curve);
  const auto [west, east] = std::minmax_element(points_.begin(), points_.end(),
                                                [](glm::ivec2 a, glm::ivec2 b) { return a.x < b.x; });
  if (east->x < centre.x) return {1, 0};
  const int from = entry.first + entry.ends[row + 1], to = entry.first + entry.ends[row + 2];
  if (west->x >= centre.x) return {from, to - from};

  const int first = static_cast<int>(cells_.size()), first_column = centre.x / kRasterSubpixels;
  int next = from;
  for (int y = row * whole_scale_.y; y < (row + 1) * whole_scale_.y; ++y) {
    const int place = y * pitch_ + first_column;
    std::int32_t sum = sum_beside(y * kRasterSubpixels, centre);
    for (; next < to && cells_[next].place <= place; ++next) sum += cells_[next].factor;
    add_cell(place, sum);
    for (; next < to && cells_[next].place <= y * pitch_ + 2 * whole_scale_.x; ++next) {
      add_cell(cells_[next].place, cells_[next].factor);
    }
  }
  return {first, static_cast<int>(cells_.size()) - first};
}

/// What closing the curve in hand, and what crosses the middle line, add to a row of output pixels.
std::int32_t CurveCells::sum_beside(int top, glm::ivec2 centre) const {
  constexpr int kFar = std::numeric_limits<int>::max() / 2;
  // The height of an upright way downwards inside the row.
  const auto way = [&](int from, int to) {
    const auto inside = [&](int y) { return std::clamp(y, top, top + kRasterSubpixels); };
    return inside(to) - inside(from);
  };
  int height = 0;
  if (points_.front().x < centre.x) height += way(centre.y, points_.front().y);
  if (points_.back().x < centre.x) height += way(points_.back().y, centre.y);
  for (std::size_t k = 1; k < points_.size(); ++k) {
    const glm::ivec2 from = points_[k - 1], to = points_[k];
    const bool is_eastwards = from.x < centre.x;
    if (is_eastwards == (to.x < centre.x)) continue;
    const double part = double(centre.x - from.x) / (to.x - from.x);
    const bool is_south = from.y + part * (to.y - from.y) > centre.y;
    height += (is_eastwards ? -1 : 1) * way(centre.y, is_south ? kFar : -kFar);
  }
  return height * 2 * kRasterSubpixels;
}

}  // namespace depixel
