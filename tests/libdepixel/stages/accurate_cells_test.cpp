#include "libdepixel/stages/accurate_cells.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "libdepixel/stages/crossings.hpp"
#include "tests/support/random_pictures.hpp"
#include "tests/support/svg_tools.hpp"

namespace depixel::test {
namespace {

constexpr std::array<CellShape, 2> kShapes{CellShape::accurate, CellShape::simplified};

SimilarityGraph resolved_graph(const Picture& picture) {
  SimilarityGraph graph;
  build_similarity_graph(picture.view(), {}, graph);
  CrossingScratch scratch;
  resolve_crossings(graph, {}, scratch);
  return graph;
}

/// Random noise of two to four colours: every kind of block occurs.
Picture random_noise(int max_size) {
  const int width = *rc::gen::inRange(1, max_size + 1), height = *rc::gen::inRange(1, max_size + 1);
  const int colours = *rc::gen::inRange(2, 5);
  const auto choices =
      *rc::gen::container<std::vector<int>>(std::size_t(width) * height, rc::gen::inRange(0, colours));
  Picture picture(width, height);
  for (std::size_t i = 0; i < choices.size(); ++i) picture.pixels[i] = palette_colour("#.rb"[choices[i]]);
  return picture;
}

double distance_to_line(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(p, a + t * along);
}

/// Distance, in pixels, from a point to a pixel's node and half-links: the definition of the diagram.
double site_distance(const SimilarityGraph& graph, int x, int y, glm::dvec2 p) {
  constexpr std::array<glm::ivec2, 8> kNeighbours{
      {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};
  const glm::dvec2 node = glm::dvec2(x, y) + 0.5;
  double distance = glm::distance(p, node);
  const int linked = graph.neighbours(graph.lattice.pixel(x, y));
  for (int k = 0; k < 8; ++k) {
    if (linked >> k & 1)
      distance = std::min(distance, distance_to_line(p, node, node + 0.5 * glm::dvec2(kNeighbours[k])));
  }
  return distance;
}

/// The two nearest sites of a point, by looking at all.
struct Nearest {
  glm::ivec2 pixel{0, 0};
  double distance = std::numeric_limits<double>::max(), next_distance = distance;
};

Nearest nearest_site(const SimilarityGraph& graph, glm::dvec2 p) {
  Nearest nearest;
  for (int y = 0; y < graph.lattice.height(); ++y) {
    for (int x = 0; x < graph.lattice.width(); ++x) {
      const double distance = site_distance(graph, x, y, p);
      if (distance < nearest.distance) {
        nearest = {{x, y}, distance, nearest.distance};
      } else {
        nearest.next_distance = std::min(nearest.next_distance, distance);
      }
    }
  }
  return nearest;
}

std::vector<glm::ivec2> cell(const SimilarityGraph& graph, CellShape shape, int x, int y) {
  std::vector<glm::ivec2> polygon;
  find_cell_polygon(graph, shape, graph.lattice.pixel(x, y), polygon);
  return polygon;
}

Polygon in_pixels(const std::vector<glm::ivec2>& cell) {
  Polygon polygon;
  for (const glm::ivec2 p : cell) polygon.push_back(glm::dvec2(p) / double(kSubpixels));
  return polygon;
}

std::int64_t doubled_area(const std::vector<glm::ivec2>& polygon) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::i64vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    area += a.x * b.y - a.y * b.x;
  }
  return area;
}

TEST(AccurateCells, WithoutLinksTheyAreSquares) {
  const SimilarityGraph graph = resolved_graph(ascii_picture({"#r", "gb"}));
  const std::vector<glm::ivec2> square{{0, 0}, {kSubpixels, 0}, {kSubpixels, kSubpixels}, {0, kSubpixels}};
  EXPECT_EQ(cell(graph, CellShape::simplified, 0, 0), square);
  EXPECT_EQ(doubled_area(cell(graph, CellShape::accurate, 0, 0)), 2 * kSubpixels * kSubpixels);
}

TEST(AccurateCells, ADiagonalLinkSplitsACorner) {
  const SimilarityGraph graph = resolved_graph(ascii_picture({"#r", "b#"}));
  constexpr int kQuarter = kSubpixels / 4;
  const std::vector<glm::ivec2> north_west{{0, 0},
                                           {kSubpixels, 0},
                                           {kSubpixels + kQuarter, kSubpixels - kQuarter},
                                           {kSubpixels - kQuarter, kSubpixels + kQuarter},
                                           {0, kSubpixels}};
  EXPECT_EQ(cell(graph, CellShape::simplified, 0, 0), north_west);
  EXPECT_EQ(cell(graph, CellShape::simplified, 1, 0).size(), 4u);
}

TEST(AccurateCells, ALoneLinkPushesAJunctionByAnEighth) {
  const SimilarityGraph graph = resolved_graph(ascii_picture({"##", "rb"}));
  const std::vector<glm::ivec2> polygon = cell(graph, CellShape::accurate, 0, 0);
  EXPECT_NE(std::find(polygon.begin(), polygon.end(), glm::ivec2(kSubpixels, kSubpixels + kSubpixels / 8)),
            polygon.end());
}

RC_GTEST_PROP(AccurateCells, HoldWhatLiesNearestToTheirSites, ()) {
  constexpr double kTolerance = 0.125;
  constexpr int kSamples =
      7;  // a pixel and axis; odd, so that samples lie on no line of symmetry but the centre's
  const Picture picture = random_noise(6);
  const SimilarityGraph graph = resolved_graph(picture);
  std::vector<std::vector<Polygon>> cells;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x)
      cells.push_back({in_pixels(cell(graph, CellShape::accurate, x, y))});
  }
  for (int j = 0; j < kSamples * picture.height; ++j) {
    for (int i = 0; i < kSamples * picture.width; ++i) {
      const glm::dvec2 p = (glm::dvec2(i, j) + 0.5) / double(kSamples);
      const Nearest nearest = nearest_site(graph, p);
      if (nearest.next_distance - nearest.distance <= kTolerance) continue;
      for (int c = 0; c < static_cast<int>(cells.size()); ++c) {
        const bool expected = glm::ivec2(c % picture.width, c / picture.width) == nearest.pixel;
        if (is_inside(p, cells[c]) == expected) continue;
        std::ostringstream where;
        where << picture << " at " << p.x << ' ' << p.y << ", cell " << c << ", distances "
              << nearest.distance << ' ' << nearest.next_distance;
        RC_FAIL(where.str());
      }
    }
  }
}

RC_GTEST_PROP(AccurateCells, CoverTheFrame, ()) {
  const Picture picture = random_noise(12);
  const SimilarityGraph graph = resolved_graph(picture);
  for (const CellShape shape : kShapes) {
    std::int64_t area = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const std::vector<glm::ivec2> polygon = cell(graph, shape, x, y);
        RC_ASSERT(is_inside(glm::dvec2(x, y) + 0.5, {in_pixels(polygon)}));
        area += doubled_area(polygon);
      }
    }
    RC_ASSERT(area == 2 * std::int64_t{kSubpixels} * kSubpixels * picture.width * picture.height);
  }
}

/// A cell's edges inside the frame, from smaller to larger end, each with the pixel.
using CellEdge = std::array<int, 5>;
CellEdge edge(glm::ivec2 a, glm::ivec2 b, int pixel) {
  if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) std::swap(a, b);
  return {a.x, a.y, b.x, b.y, pixel};
}

RC_GTEST_PROP(AccurateCells, TheMapHasTheEdgesOfThePolygons, ()) {
  const Picture picture = random_noise(8);
  const SimilarityGraph graph = resolved_graph(picture);
  const glm::ivec2 size = glm::ivec2(picture.width, picture.height) * kSubpixels;
  for (const CellShape shape : kShapes) {
    std::multiset<CellEdge> of_polygons, of_map;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const std::vector<glm::ivec2> polygon = cell(graph, shape, x, y);
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          const glm::ivec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
          const bool on_border =
              (a.x == b.x && (a.x == 0 || a.x == size.x)) || (a.y == b.y && (a.y == 0 || a.y == size.y));
          if (!on_border) of_polygons.insert(edge(a, b, graph.lattice.pixel(x, y)));
        }
      }
    }
    PlanarMap map;
    build_cell_map(graph, shape, map);
    for (const Segment& s : map.segments) {
      of_map.insert(edge(s.p0, s.p3, s.left));
      of_map.insert(edge(s.p0, s.p3, s.right));
    }
    RC_ASSERT(of_map == of_polygons);
  }
}

}  // namespace
}  // namespace depixel::test
