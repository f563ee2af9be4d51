#include "libdepixel/raster/curve_to_output.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "libdepixel/stages/planar_map.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

RC_GTEST_PROP(CurveToOutput, MapsAsTheGridDoesRoundAnyCorner, ()) {
  const auto scale = [] { return *rc::gen::inRange(1, 65); };
  const auto coordinate = [] { return static_cast<std::int16_t>(*random_int(-8192, 8193)); };
  const auto point = [&] { return glm::i16vec2(coordinate(), coordinate()); };
  const glm::ivec2 scales(scale(), scale());
  const glm::ivec2 origin(*rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10));
  const glm::ivec2 owner(*rc::gen::inRange(0, 512), *rc::gen::inRange(0, 512));
  const OutputGrid grid(View{double(scales.x), double(scales.y), double(origin.x), double(origin.y)},
                        Lattice(512, 512), PictureView{});
  const EdgeCurve curve{point(), point(), point(), point()};
  RC_ASSERT(CurveToOutput::fits(grid));
  const CurveToOutput::Points points = CurveToOutput(grid)(curve);
  const Segment segment = segment_of(curve, owner, 0, false, 1);
  const glm::ivec2 from(grid.column(owner.x), grid.row(owner.y));
  const std::array<glm::ivec2, 4> expected{grid(segment.p0), grid(segment.p1), grid(segment.p2),
                                           grid(segment.p3)};
  for (std::size_t k = 0; k < points.size(); ++k) RC_ASSERT(from + points[k] == expected[k]);
}

TEST(CurveToOutput, IsForWholeScalesOnly) {
  const auto fits = [](double x, double y) {
    return CurveToOutput::fits(OutputGrid(View{x, y, 0, 0}, Lattice(8, 8), PictureView{}));
  };
  EXPECT_TRUE(fits(1, 3));
  EXPECT_FALSE(fits(2.5, 3));
  EXPECT_FALSE(fits(3, 0.5));
  EXPECT_FALSE(fits(1 << 13, 1));
}

}  // namespace
}  // namespace depixel::test
