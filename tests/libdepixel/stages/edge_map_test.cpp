#include "libdepixel/stages/edge_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/map_splines.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

RC_GTEST_PROP(EdgeMap, VisibleEdgesHaveACurveAndOthersNone, (const Picture& picture)) {
  Vectorizer v;
  v.vectorize(picture.view(), *random_options());
  const Lattice& lattice = v.cells().lattice;
  std::set<int> visible;
  for (int y = 0; y <= picture.height; ++y) {
    for (int x = 0; x <= picture.width; ++x) {
      const int corner = lattice.corner(x, y);
      for (const Direction d : {kEast, kSouth}) {
        if (v.cells().corners[corner].is_visible(d)) visible.insert(edge_slot(corner, d == kSouth));
      }
    }
  }
  std::set<int> held;
  for (std::size_t slot = 0; slot < v.edges().curve.size(); ++slot) {
    if (v.edges().curve[slot] != 0) held.insert(static_cast<int>(slot));
  }
  RC_ASSERT(held == visible);
}

/// The end of a segment at a corner that it leaves in a direction.
glm::ivec2 end_at(const PlanarMap& map, int corner, Direction d) {
  return segment_along(map, corner, d).p0;
}

RC_GTEST_PROP(EdgeMap, ContoursEndOnTheOneThatGoesThrough, (const Picture& picture)) {
  Vectorizer v;
  const PlanarMap& map = v.vectorize(picture.view(), *random_options());
  const CellGraph& cells = v.cells();
  for (int y = 1; y < picture.height; ++y) {
    for (int x = 1; x < picture.width; ++x) {
      const int corner = cells.lattice.corner(x, y);
      if (!cells.is_t_junction(corner)) continue;
      std::set<std::pair<int, int>> ends;
      for (const Direction d : kDirections) {
        if (!cells.corners[corner].is_visible(d)) continue;
        const glm::ivec2 end = end_at(map, corner, d);
        ends.emplace(end.x, end.y);
      }
      RC_ASSERT(ends.size() == 1U);
    }
  }
}

RC_GTEST_PROP(EdgeMap, JoiningAgainChangesNothing, (const Picture& picture)) {
  Vectorizer v;
  v.vectorize(picture.view(), *random_options());
  SplineTable table = v.table();
  const std::size_t size = table.size();
  const CellGraph& cells = v.cells();
  for (int y = 1; y < picture.height; ++y) {
    for (int x = 1; x < picture.width; ++x) {
      const int corner = cells.lattice.corner(x, y);
      if (!cells.is_t_junction(corner)) continue;
      const JoinedEdge joined = join_at(corner, cells, v.edges(), table);
      RC_ASSERT(v.edges().curve[joined.slot] == joined.curve);
    }
  }
  // A contour of one step between two junctions was joined at one end first, and perhaps is known so.
  RC_ASSERT(table.size() == size);
}

TEST(EdgeMap, AStepBetweenTwoJunctionsIsJoinedAtBothEnds) {
  // The curves above and below the step bulge; r and g meet for one pixel only.
  const Picture picture = ascii_picture({"......",  //
                                         "......",  //
                                         "..rg..",  //
                                         ".rrgg.",  //
                                         "......"});
  Options options;
  options.smoothing = Smoothing::none;
  options.spline = SplineKind::approximate;
  for (int y = 2; y < 4; ++y) {
    Picture one = picture;
    paste(one, Picture(6, 1, palette_colour('.')), 0, y == 2 ? 3 : 2);
    Vectorizer v;
    const PlanarMap& map = v.vectorize(one.view(), options);
    const int top = v.cells().lattice.corner(3, y), bottom = v.cells().lattice.corner(3, y + 1);
    ASSERT_TRUE(v.cells().is_t_junction(top));
    ASSERT_TRUE(v.cells().is_t_junction(bottom));
    const Segment step = segment_along(map, top, kSouth);
    EXPECT_EQ(step.p0, end_at(map, top, kWest));
    EXPECT_EQ(step.p3, end_at(map, bottom, kWest));
    EXPECT_EQ(v.table().curve(v.table().fitted(v.edges().curve[edge_slot(top, true)])).p0, glm::i16vec2(0));
  }
}

TEST(EdgeMap, ArcsNameEachOfTheirEdges) {
  Vectorizer v;
  v.vectorize(ascii_picture({"....",  //
                             ".##.",  //
                             ".#..",  //
                             "...."})
                  .view(),
              {});
  const std::array<int, 4> step = v.cells().lattice.step_offsets();
  ASSERT_EQ(v.arcs().list.size(), 1U);
  std::set<int> slots;
  for_each_edge(v.arcs(), v.arcs().list[0], v.table(), step, [&](int slot, int number) {
    EXPECT_EQ(v.edges().curve[slot], number);
    slots.insert(slot);
  });
  EXPECT_EQ(slots.size(), 8U);
}

}  // namespace
}  // namespace depixel::test
