#include "libdepixel/stages/contours.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <set>
#include <tuple>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

/// Corners of a contour in order, as points of the lattice.
std::vector<std::pair<int, int>> corners_of(const Vectorizer& v, const Contour& contour) {
  std::vector<std::pair<int, int>> list;
  for (int k = contour.first; k < contour.first + contour.count; ++k) {
    const glm::ivec2 p = v.cells().lattice.corner_position(v.contours().corner[k]);
    list.emplace_back(p.x, p.y);
  }
  return list;
}

using CornerList = std::vector<std::pair<int, int>>;

TEST(Contours, ASquareIsOneClosedContourFromItsTopLeftEastwards) {
  Vectorizer v;
  v.vectorize(ascii_picture({"....",  //
                             ".##.",  //
                             ".##.",  //
                             "...."})
                  .view(),
              {});
  ASSERT_EQ(v.contours().list.size(), 1u);
  const Contour& contour = v.contours().list[0];
  EXPECT_TRUE(contour.closed);
  EXPECT_EQ(contour.count, 8);
  EXPECT_EQ(contour.step_count(), 8);
  EXPECT_EQ(corners_of(v, contour),
            (CornerList{{1, 1}, {2, 1}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {1, 3}, {1, 2}}));
  EXPECT_EQ(v.contours().heading[contour.first], kEast);
}

TEST(Contours, OpenContoursRunFromBorderToBorderFromTheFirstEnd) {
  Vectorizer v;
  v.vectorize(ascii_picture({"r..",  //
                             "rr.",  //
                             "rr."})
                  .view(),
              {});
  ASSERT_EQ(v.contours().list.size(), 1u);
  const Contour& contour = v.contours().list[0];
  EXPECT_FALSE(contour.closed);
  EXPECT_EQ(corners_of(v, contour), (CornerList{{1, 0}, {1, 1}, {2, 1}, {2, 2}, {2, 3}}));
  EXPECT_EQ(contour.step_count(), 4);
}

TEST(Contours, ATJunctionEndsOnTheContourThatGoesThrough) {
  Vectorizer v;
  v.vectorize(ascii_picture({"rg",  //
                             "bb"})
                  .view(),
              {});
  ASSERT_EQ(v.contours().list.size(), 2u);
  EXPECT_EQ(corners_of(v, v.contours().list[0]), (CornerList{{1, 0}, {1, 1}}));
  EXPECT_EQ(corners_of(v, v.contours().list[1]), (CornerList{{0, 1}, {1, 1}, {2, 1}}));
}

TEST(Contours, AJunctionOfFourIsPassedByTwoContours) {
  Vectorizer v;
  v.vectorize(ascii_picture({"rg",  //
                             "by"})
                  .view(),
              {});
  ASSERT_EQ(v.contours().list.size(), 2u);
  EXPECT_EQ(corners_of(v, v.contours().list[0]), (CornerList{{1, 0}, {1, 1}, {1, 2}}));
  EXPECT_EQ(corners_of(v, v.contours().list[1]), (CornerList{{0, 1}, {1, 1}, {2, 1}}));
}

TEST(Contours, ACutCornerIsPassedTwiceByAContourThatTurns) {
  // Two black pixels across a diagonal: one outline round both, which passes the corner between them twice.
  Vectorizer v;
  v.vectorize(ascii_picture({"....",  //
                             ".#..",  //
                             "..#.",  //
                             "...."})
                  .view(),
              {});
  ASSERT_EQ(v.contours().list.size(), 1u);
  EXPECT_EQ(corners_of(v, v.contours().list[0]),
            (CornerList{{1, 1}, {2, 1}, {2, 2}, {3, 2}, {3, 3}, {2, 3}, {2, 2}, {1, 2}}));
}

TEST(Contours, UniformFramesHaveNone) {
  Vectorizer v;
  v.vectorize(Picture(7, 5, palette_colour('g')).view(), {});
  EXPECT_TRUE(v.contours().list.empty());
  v.vectorize(Picture(7, 5).view(), {});
  EXPECT_TRUE(v.contours().list.empty());
}

/// An edge of the lattice by its western or northern corner and whether it leads down.
using Edge = std::tuple<int, int, bool>;

Edge edge_between(glm::ivec2 a, glm::ivec2 b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), a.x == b.x};
}

RC_GTEST_PROP(Contours, EveryVisibleEdgeIsTracedOnce, (const Picture& picture)) {
  const Options options = *random_options();
  Vectorizer v;
  v.vectorize(picture.view(), options);
  const Lattice& lattice = v.cells().lattice;
  std::set<Edge> visible;
  for (int y = 0; y <= picture.height; ++y) {
    for (int x = 0; x <= picture.width; ++x) {
      for (const Direction d : kDirections) {
        if (v.cells().corners[lattice.corner(x, y)].is_visible(d)) {
          visible.insert(edge_between({x, y}, glm::ivec2(x, y) + kStep[d]));
        }
      }
    }
  }
  std::set<Edge> traced;
  for (const Contour& contour : v.contours().list) {
    for (int k = 0; k < contour.step_count(); ++k) {
      const int node = contour.first + k;
      const glm::ivec2 from = lattice.corner_position(v.contours().corner[node]);
      const int next = k + 1 < contour.count ? node + 1 : contour.first;
      const glm::ivec2 to = lattice.corner_position(v.contours().corner[next]);
      RC_ASSERT(from + kStep[v.contours().heading[node]] == to);
      RC_ASSERT(traced.insert(edge_between(from, to)).second);
    }
  }
  RC_ASSERT(traced == visible);
}

RC_GTEST_PROP(Contours, AreMaximalAndStartCanonically, (const Picture& picture)) {
  const Options options = *random_options();
  Vectorizer v;
  v.vectorize(picture.view(), options);
  const auto raster_order = [](std::pair<int, int> p) { return std::pair(p.second, p.first); };
  bool closed_seen = false;
  int entries = 0;
  for (const Contour& contour : v.contours().list) {
    RC_ASSERT(contour.first == entries);
    entries += contour.count;
    const CornerList corners = corners_of(v, contour);
    RC_ASSERT(contour.count >= (contour.closed ? 4 : 2));
    if (contour.closed) {
      closed_seen = true;
      const auto first = *std::min_element(corners.begin(), corners.end(),
                                           [&](auto p, auto q) { return raster_order(p) < raster_order(q); });
      RC_ASSERT(corners.front() == first);
      RC_ASSERT(int(v.contours().heading[contour.first]) == int(kEast));
    } else {
      RC_ASSERT(!closed_seen);
      RC_ASSERT(raster_order(corners.front()) < raster_order(corners.back()));
      for (const auto& end : {corners.front(), corners.back()}) {
        const auto& [x, y] = end;
        const CornerCode code = v.cells().corners[v.cells().lattice.corner(x, y)];
        RC_ASSERT(x == 0 || y == 0 || x == picture.width || y == picture.height ||
                  std::popcount(static_cast<unsigned>(code.visible_edges())) == 3);
      }
    }
  }
  RC_ASSERT(entries == static_cast<int>(v.contours().corner.size()));
}

/// A contour as it was traced: its nodes' corners, their headings, and whether it is closed.
using TracedContour = std::tuple<std::vector<int>, std::vector<std::uint8_t>, bool>;

std::set<TracedContour> traced_set(const Contours& contours) {
  std::set<TracedContour> all;
  for (const Contour& c : contours.list) {
    const auto corner = contours.corner.begin() + c.first;
    const auto heading = contours.heading.begin() + c.first;
    const bool is_new =
        all.insert({{corner, corner + c.count}, {heading, heading + c.count}, c.closed}).second;
    RC_ASSERT(is_new);
  }
  return all;
}

RC_GTEST_PROP(Contours, ThroughAllCornersGoAllContours, (const Picture& picture)) {
  Vectorizer v;
  v.vectorize(picture.view(), *random_options());
  std::vector<int> corners;
  for (int y = 0; y <= picture.height; ++y) {
    for (int x = 0; x <= picture.width; ++x) corners.push_back(v.cells().lattice.corner(x, y));
  }
  Contours through;
  trace_contours_through(v.cells(), corners, through);
  RC_ASSERT(traced_set(through) == traced_set(v.contours()));
}

RC_GTEST_PROP(Contours, ThroughSomeCornersGoThoseThatPassThere, (const Picture& picture)) {
  Vectorizer v;
  v.vectorize(picture.view(), *random_options());
  const Lattice& lattice = v.cells().lattice;
  // Any, more than once, and some that nothing passes.
  std::vector<int> corners;
  for (const auto& [x, y] :
       *rc::gen::resize(6, rc::gen::arbitrary<std::vector<std::pair<unsigned, unsigned>>>())) {
    corners.push_back(lattice.corner(static_cast<int>(x % (picture.width + 1U)),
                                     static_cast<int>(y % (picture.height + 1U))));
  }
  std::set<TracedContour> expected;
  for (const TracedContour& contour : traced_set(v.contours())) {
    const std::vector<int>& nodes = std::get<0>(contour);
    const bool passes = std::any_of(corners.begin(), corners.end(), [&](int corner) {
      return std::find(nodes.begin(), nodes.end(), corner) != nodes.end();
    });
    if (passes) expected.insert(contour);
  }
  Contours through;
  trace_contours_through(v.cells(), corners, through);
  RC_ASSERT(traced_set(through) == expected);
}

}  // namespace
}  // namespace depixel::test
