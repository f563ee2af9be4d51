#include "libdepixel/raster/curve_cells.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "libdepixel/raster/flatten.hpp"
#include "libdepixel/stages/planar_map.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

/// Any curve that stays near its edge.
EdgeCurve curve_near_edge() {
  const bool southwards = *rc::gen::arbitrary<bool>();
  const auto point = [&] {
    return glm::i16vec2(*random_int(1 - kSubpixels, southwards ? kSubpixels : 2 * kSubpixels),
                        *random_int(1 - kSubpixels, southwards ? 2 * kSubpixels : kSubpixels));
  };
  const glm::i16vec2 p0 = point(), p1 = point(), p2 = point(), p3 = point();
  return {p0, p1, p2, p3};
}

/// Areas alone, as CurveCells sums them up.
struct Area {
  using Sums = std::int32_t;
  using Change = std::int32_t;
  static Sums times(Change change, int factor) { return change * factor; }
};

RC_GTEST_PROP(CurveCells, AreWhatLinesAddAnywhere, ()) {
  const int scale_x = *random_int(1, CurveCells::kLargestScale + 1);
  const int scale_y = *random_int(1, CurveCells::kLargestScale + 1);
  const glm::ivec2 owner(*random_int(2, 8), *random_int(2, 8));
  const int width = 12 * scale_x, pitch = width + *random_int(1, 50);
  const OutputGrid grid(View{double(scale_x), double(scale_y), 0, 0}, Lattice(12, 12), PictureView{});
  RC_ASSERT(CurveCells::fits(grid));
  CurveCells cells;
  cells.start(grid, pitch);
  BandSums<Area> sums;
  sums.resize(width);
  std::map<int, EdgeCurve> known;
  for (int i = 0, count = *random_int(1, 40); i < count; ++i) {
    const EdgeCurve curve = curve_near_edge();
    const int found = cells.number_of(curve);
    RC_ASSERT(found != 0);
    RC_ASSERT(known.emplace(found, curve).first->second == curve);
    RC_ASSERT(cells.number_of(curve) == found);
    const Segment s = segment_of(curve, owner, 0, false, 1);
    for (int row = -1; row <= 1; ++row) {
      const int first_px = (owner.y + row) * scale_y;
      sums.start(first_px, scale_y);
      flatten(grid(s.p0), grid(s.p1), grid(s.p2), grid(s.p3),
              flattening_pieces(s.p0, s.p1, s.p2, s.p3, grid.scale),
              [&](glm::ivec2 a, glm::ivec2 b) { sums.add_line(a.x, a.y, b.x, b.y, 1); });
      std::map<int, std::int32_t> expected, actual;
      for (int y = 0; y < scale_y; ++y) {
        sums.take(y, [&](int column, std::int32_t sum) {
          if (sum != 0) expected[(first_px + y) * pitch + column] = sum;
        });
      }
      const int origin = owner.y * scale_y * pitch + owner.x * scale_x;
      for (const CurveCells::Cell cell : cells.in_row(found, row)) actual[origin + cell.place] += cell.factor;
      RC_ASSERT(actual == expected);
    }
  }
}

TEST(CurveCells, AreForgottenWithTheScale) {
  const auto grid = [](double scale) {
    return OutputGrid(View{scale, scale, 0, 0}, Lattice(4, 4), PictureView{});
  };
  CurveCells cells;
  EXPECT_FALSE(cells.start(grid(4), 17));
  EXPECT_TRUE(cells.start(grid(4), 17));
  EXPECT_FALSE(cells.start(grid(8), 17));
  EXPECT_FALSE(cells.start(grid(8), 33));
}

TEST(CurveCells, SeeFromCentresInTheCornersOfPixels) {
  const auto sees = [](double x, double y) {
    const OutputGrid grid(View{x, y, 0, 0}, Lattice(4, 4), PictureView{});
    return CurveCells::sees_from_centres(grid);
  };
  EXPECT_TRUE(sees(4, 4));
  EXPECT_TRUE(sees(16, 6));
  EXPECT_FALSE(sees(2, 4));
  EXPECT_FALSE(sees(4, 5));
  EXPECT_FALSE(sees(4.5, 4));
  EXPECT_FALSE(sees(18, 4));
}

}  // namespace
}  // namespace depixel::test
