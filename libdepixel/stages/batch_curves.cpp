#include "libdepixel/stages/batch_curves.hpp"

#include <algorithm>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

/// The whole number nearest to each of eight, of magnitudes below 2^22.
inline Float8 nearest(Float8 v) {
  constexpr float kMagic = 12582912.0f;
  return (v + kMagic) - kMagic;
}

inline Float8 min8(Float8 a, Float8 b) {
  return a < b ? a : b;
}

/// Where curves go along an axis, in subpixels from the edge's owner.
struct Points {
  Float8 p0, p1, p2, p3;

  Float8 low() const { return min8(min8(p0, p1), min8(p2, p3)); }
  Float8 high() const { return max8(max8(p0, p1), max8(p2, p3)); }
};

/// \param steps     lattice steps along the axis. \param is_back  where the step leads west or north.
inline Points points_along(const float* control, const float* knot, const float* steps, Int8 is_back, int i) {
  const Float8 step = kSubpixels * load8(steps + i);
  const Float8 owner = is_back ? step : Float8{};
  const Float8 a = nearest(kSubpixels * load8(control + i));
  const Float8 b = nearest(kSubpixels * load8(control + i + 1)) + step;
  const Float8 from = nearest(kSubpixels * load8(knot + i)) - owner;
  const Float8 to = nearest(kSubpixels * load8(knot + i + 1)) + step - owner;
  // Thirds never lie half-way between whole numbers.
  const Float8 near_a = nearest((2 * a + b) / 3) - owner, near_b = nearest((2 * b + a) / 3) - owner;
  return {is_back ? to : from, is_back ? near_b : near_a, is_back ? near_a : near_b, is_back ? from : to};
}

/// Bits -1, 0 and 1 of the tiles along an axis; what runs along the side of two touches both.
inline Int8 tiles_along(const Points& p) {
  const Float8 low = p.low(), high = p.high(), zero{}, one = zero + kSubpixels;
  return ((low <= zero) & 1) | ((low <= one) & (high >= zero) & 2) | ((high >= one) & 4);
}

/// Whether a curve stays within less than a pixel of an edge of a length.
inline Int8 stays_near(const Points& p, Float8 length) {
  return (p.low() > -kSubpixels) & (p.high() < length + kSubpixels);
}

struct Input {
  const float *x, *y, *knot_x, *knot_y, *step_x, *step_y, *retracted;
};

DEPIXEL_VECTOR_CLONES void compute_curves(const Input& in, int from, int to,
                                          const std::array<std::int32_t*, 8>& points, std::int32_t* tiles) {
  for (int i = from; i < to; i += kFloatLanes) {
    const Float8 step_x = load8(in.step_x + i), step_y = load8(in.step_y + i);
    const Int8 is_back = (step_x + step_y) < 0;
    Points x = points_along(in.x, in.knot_x, in.step_x, is_back, i);
    Points y = points_along(in.y, in.knot_y, in.step_y, is_back, i);
    const Float8 length_x = kSubpixels * abs8(step_x), length_y = kSubpixels * abs8(step_y);
    const Int8 is_retracted =
        (load8(in.retracted + i) != 0) | ~(stays_near(x, length_x) & stays_near(y, length_y));
    x.p1 = is_retracted ? 0.5f * length_x : x.p1;
    x.p2 = is_retracted ? 0.5f * length_x : x.p2;
    y.p1 = is_retracted ? 0.5f * length_y : y.p1;
    y.p2 = is_retracted ? 0.5f * length_y : y.p2;
    int k = 0;
    for (const Float8 value : {x.p0, x.p1, x.p2, x.p3, y.p0, y.p1, y.p2, y.p3}) {
      store_vector(points[k++] + i, __builtin_convertvector(value, Int8));
    }
    const Int8 columns = tiles_along(x), rows = tiles_along(y);
    store_vector(tiles + i, (columns & -(rows & 1)) | (columns & -(rows >> 1 & 1)) << 3 |
                                (columns & -(rows >> 2 & 1)) << 6);
  }
}

}  // namespace

void BatchCurves::compute(const ArcBatch& batch, const std::vector<std::uint8_t>& retracted) {
  const std::size_t room = batch.x.size();
  if (tiles_.size() < room) {
    for (auto& values : points_) values.resize(room);
    tiles_.resize(room);
    retracted_.resize(room);
  }
  std::transform(retracted.begin(), retracted.begin() + batch.size, retracted_.begin(),
                 [](std::uint8_t v) { return v != 0 ? 1.0f : 0.0f; });
  std::array<std::int32_t*, 8> points;
  std::transform(points_.begin(), points_.end(), points.begin(), [](auto& values) { return values.data(); });
  compute_curves({batch.x.data(), batch.y.data(), batch.knot_x.data(), batch.knot_y.data(),
                  batch.step_x.data(), batch.step_y.data(), retracted_.data()},
                 ArcBatch::kGhosts, batch.size - ArcBatch::kGhosts, points, tiles_.data());
}

std::size_t BatchCurves::memory_bytes() const {
  std::size_t bytes = held_bytes(tiles_, retracted_);
  for (const auto& values : points_) bytes += held_bytes(values);
  return bytes;
}

}  // namespace depixel
