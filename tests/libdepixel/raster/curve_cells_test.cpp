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

RC_GTEST_PROP(CurveCells, AreWhatLinesAddAnywhere, ()) {
  const int scale_x = *random_int(1, CurveCells::kLargestScale + 1);
  const int scale_y = *random_int(1, CurveCells::kLargestScale + 1);
  const glm::ivec2 owner(*random_int(2, 8), *random_int(2, 8));
  const int width = 12 * scale_x, pitch = width + *random_int(1, 50);
  const OutputGrid grid(View{double(scale_x), double(scale_y), 0, 0}, Lattice(12, 12), PictureView{});
  RC_ASSERT(CurveCells::fits(grid));
  CurveCells cells;
  constexpr int kMostCurves = 40;
  cells.start(grid, pitch, 1, kMostCurves);
  LineSlicer slicer;
  slicer.resize(width);
  std::map<int, EdgeCurve> known;
  for (int i = 0, count = *random_int(1, 80); i < count; ++i) {
    const int number = *random_int(1, kMostCurves);
    if (known.count(number) == 0) known[number] = curve_near_edge();
    const EdgeCurve curve = known[number];
    const Segment s = segment_of(curve, owner, 0, false, 1);
    for (int row = -1; row <= 1; ++row) {
      const int first_px = (owner.y + row) * scale_y;
      slicer.start(first_px, scale_y);
      std::map<int, std::int32_t> expected, actual;
      const auto add_slice = [&](const LineSlicer::Slice& slice) {
        slice.for_each_pixel([&](int column, int height, int area) {
          const int place = (first_px + slice.row) * pitch + column;
          expected[place] += 2 * kRasterSubpixels * height - area;
          expected[place + 1] += area;
        });
      };
      flatten(grid(s.p0), grid(s.p1), grid(s.p2), grid(s.p3),
              flattening_pieces(s.p0, s.p1, s.p2, s.p3, grid.scale),
              [&](glm::ivec2 a, glm::ivec2 b) { slicer.cut(a.x, a.y, b.x, b.y, add_slice); });
      std::erase_if(expected, [](const auto& cell) { return cell.second == 0; });
      const int origin = owner.y * scale_y * pitch + owner.x * scale_x;
      for (const CurveCells::Cell cell : cells.in_row(number, curve, row))
        actual[origin + cell.place] += cell.factor;
      RC_ASSERT(actual == expected);
    }
  }
}

TEST(CurveCells, AreForgottenWithTheScaleThePitchAndTheGeneration) {
  const auto grid = [](double scale) {
    return OutputGrid(View{scale, scale, 0, 0}, Lattice(4, 4), PictureView{});
  };
  const EdgeCurve upright{{0, 0}, {0, kSubpixels / 3}, {0, 2 * kSubpixels / 3}, {0, kSubpixels}};
  const EdgeCurve level{{0, 0}, {kSubpixels / 3, 0}, {2 * kSubpixels / 3, 0}, {kSubpixels, 0}};
  CurveCells cells;
  cells.start(grid(4), 17, 1, 2);
  EXPECT_EQ(cells.in_row(1, upright, 0).size(), 4u);
  cells.start(grid(4), 17, 1, 3);
  EXPECT_EQ(cells.in_row(1, level, 0).size(), 4u);  // that it is known by this number is taken on trust
  cells.start(grid(8), 17, 1, 3);
  EXPECT_EQ(cells.in_row(1, upright, 0).size(), 8u);
  cells.start(grid(8), 33, 1, 3);
  EXPECT_EQ(cells.in_row(1, upright, 0).back().place, 7 * 33);
  cells.start(grid(8), 33, 2, 3);
  EXPECT_TRUE(cells.in_row(1, level, 0).empty());
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
