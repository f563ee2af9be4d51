#include "libdepixel/stages/edge_curve.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel {

/// As RapidCheck shows it.
void showValue(const EdgeCurve& c, std::ostream& out) {
  out << '{';
  for (const glm::ivec2 p : {glm::ivec2(c.p0), glm::ivec2(c.p1), glm::ivec2(c.p2), glm::ivec2(c.p3)}) {
    out << '{' << p.x << ", " << p.y << "}, ";
  }
  out << '}';
}

namespace test {
namespace {

glm::dvec2 point_of(const EdgeCurve& c, double t) {
  const double u = 1 - t;
  return u * u * u * glm::dvec2(c.p0) + 3 * u * u * t * glm::dvec2(c.p1) + 3 * u * t * t * glm::dvec2(c.p2) +
         t * t * t * glm::dvec2(c.p3);
}

int bit_of(int column, int row) {
  return 1 << (3 * (row + 1) + column + 1);
}

TEST(EdgeCurve, ALevelEdgeTouchesTheTilesOnItsSides) {
  // The edge that leaves eastwards lies along the north side of the owner's tile, and its ends touch more.
  const EdgeCurve straight{{0, 0}, {1365, 0}, {2731, 0}, {4096, 0}};
  EXPECT_EQ(touched_tiles(straight),
            bit_of(-1, -1) | bit_of(0, -1) | bit_of(1, -1) | bit_of(-1, 0) | bit_of(0, 0) | bit_of(1, 0));
}

TEST(EdgeCurve, ACurveInsideATileTouchesThatOne) {
  EXPECT_EQ(touched_tiles({{1, 1}, {100, 200}, {2000, 4095}, {4095, 4095}}), bit_of(0, 0));
  EXPECT_EQ(touched_tiles({{-1, -1}, {-5, -4095}, {-9, -7}, {-4095, -3}}), bit_of(-1, -1));
}

rc::Gen<EdgeCurve> random_curve(bool southwards) {
  const auto near = [](bool is_along) {
    return rc::gen::resize(rc::kNominalSize,
                           rc::gen::map(rc::gen::inRange(-4095, is_along ? 8192 : 4096),
                                        [](int v) { return static_cast<std::int16_t>(v); }));
  };
  const auto point = rc::gen::map(rc::gen::pair(near(!southwards), near(southwards)),
                                  [](auto p) { return glm::i16vec2(p.first, p.second); });
  return rc::gen::build<EdgeCurve>(rc::gen::set(&EdgeCurve::p0, point), rc::gen::set(&EdgeCurve::p1, point),
                                   rc::gen::set(&EdgeCurve::p2, point), rc::gen::set(&EdgeCurve::p3, point));
}

RC_GTEST_PROP(EdgeCurve, AllTilesThatACurvePassesAreTouched, (bool southwards)) {
  const EdgeCurve curve = *random_curve(southwards);
  RC_ASSERT(stays_near_edge(curve, southwards));
  constexpr int kSamples = 500;
  const TileMask touched = touched_tiles(curve);
  RC_ASSERT(touched < 1 << 9);
  for (int i = 0; i <= kSamples; ++i) {
    const glm::dvec2 p = point_of(curve, double(i) / kSamples) / double(kSubpixels);
    const int column = static_cast<int>(std::floor(p.x)), row = static_cast<int>(std::floor(p.y));
    RC_ASSERT((touched & bit_of(column, row)) != 0);
  }
}

RC_GTEST_PROP(EdgeCurve, NoMoreTilesAreTouchedThanItsPointsSpan, (bool southwards)) {
  const EdgeCurve curve = *random_curve(southwards);
  const TileMask touched = touched_tiles(curve);
  std::set<int> columns, rows;
  for (const glm::ivec2 p :
       {glm::ivec2(curve.p0), glm::ivec2(curve.p1), glm::ivec2(curve.p2), glm::ivec2(curve.p3)}) {
    columns.insert({(p.x - 1) >> 12, p.x >> 12});
    rows.insert({(p.y - 1) >> 12, p.y >> 12});
  }
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column) {
      if ((touched & bit_of(column, row)) == 0) continue;
      RC_ASSERT(*columns.begin() <= column && column <= *columns.rbegin());
      RC_ASSERT(*rows.begin() <= row && row <= *rows.rbegin());
    }
  }
}

TEST(EdgeCurve, APixelAwayIsNotNearTheEdge) {
  EdgeCurve curve{{0, 0}, {1365, 4095}, {2731, -4095}, {4096, 0}};
  EXPECT_TRUE(stays_near_edge(curve, false));
  EXPECT_FALSE(stays_near_edge({{0, 0}, {1365, 4096}, {2731, 0}, {4096, 0}}, false));
  EXPECT_FALSE(stays_near_edge({{0, 0}, {1365, -4096}, {2731, 0}, {4096, 0}}, false));
  EXPECT_FALSE(stays_near_edge({{0, 0}, {-4096, 0}, {2731, 0}, {4096, 0}}, false));
  EXPECT_TRUE(stays_near_edge({{0, 0}, {0, 1365}, {0, 8191}, {0, 4096}}, true));
  EXPECT_FALSE(stays_near_edge({{0, 0}, {0, 1365}, {0, 8192}, {0, 4096}}, true));
}

RC_GTEST_PROP(EdgeCurve, CurvesOfPicturesStayNearTheirEdges, (const Picture& picture)) {
  Vectorizer v;
  v.vectorize(picture.view(), *random_options());
  for (std::size_t slot = 0; slot < v.edges().curve.size(); ++slot) {
    const int number = v.edges().curve[slot];
    if (number == 0) continue;
    RC_ASSERT(stays_near_edge(v.table().curve(number), slot % 2 == 1));
    RC_ASSERT(v.table().tiles(number) == touched_tiles(v.table().curve(number)));
  }
}

TEST(EdgeCurve, AnEdgeIsTheSameFromBothItsEnds) {
  const Lattice lattice(7, 5);
  const std::array<int, 4> step = lattice.step_offsets();
  const int corner = lattice.corner(3, 2);
  std::set<int> slots;
  for (const Direction d : kDirections) {
    const EdgeEnd here = edge_end(corner, d, step), there = edge_end(corner + step[d], opposite(d), step);
    EXPECT_EQ(here.slot, there.slot);
    EXPECT_NE(here.is_owner, there.is_owner);
    EXPECT_EQ(here.is_owner, d == kEast || d == kSouth);
    slots.insert(here.slot);
  }
  EXPECT_EQ(slots.size(), 4U);
}

}  // namespace
}  // namespace test
}  // namespace depixel
