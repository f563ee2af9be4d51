#include "libdepixel/stages/outlines.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/random_pictures.hpp"
#include "tests/support/svg_tools.hpp"

namespace depixel::test {
namespace {

struct Traced {
  Vectorizer vectorizer;
  Components components;
  Outlines outlines;

  Traced(const Picture& picture, const Options& options) {
    const PlanarMap& map = vectorizer.vectorize(picture.view(), options);
    label_components(vectorizer.graph(), components);
    trace_outlines(map, vectorizer.graph(), components, outlines);
  }

  int loop_count(int component) const {
    return outlines.first_loop[component + 1] - outlines.first_loop[component];
  }
};

/// Calls visit(start, piece) for the pieces of a loop.
template <typename Visit>
void for_each_piece(const Outlines& outlines, const OutlineLoop& loop, Visit visit) {
  glm::ivec2 start = outlines.pieces[loop.first + loop.count - 1].p3;
  for (int i = loop.first; i < loop.first + loop.count; ++i) {
    visit(start, outlines.pieces[i]);
    start = outlines.pieces[i].p3;
  }
}

std::int64_t loop_area_20(const Outlines& outlines, const OutlineLoop& loop) {
  std::int64_t area = 0;
  for_each_piece(outlines, loop, [&](glm::ivec2 start, const OutlinePiece& piece) {
    if (piece.segment == OutlinePiece::kBorder) {
      area += 10 * (std::int64_t{start.y} * piece.p3.x - std::int64_t{start.x} * piece.p3.y);
    } else {
      area += area_20(start, piece.p1, piece.p2, piece.p3);
    }
  });
  return area;
}

std::vector<Polygon> flattened(const Outlines& outlines, int component) {
  std::vector<Polygon> polygons;
  for (int i = outlines.first_loop[component]; i < outlines.first_loop[component + 1]; ++i) {
    Polygon& polygon = polygons.emplace_back();
    for_each_piece(outlines, outlines.loops[i], [&](glm::ivec2 start, const OutlinePiece& piece) {
      if (piece.segment == OutlinePiece::kBorder) {
        polygon.emplace_back(piece.p3);
      } else {
        append_curve(start, piece.p1, piece.p2, piece.p3, polygon);
      }
    });
  }
  return polygons;
}

constexpr std::int64_t kPixelArea20 = std::int64_t{20} * kSubpixels * kSubpixels;

TEST(Outlines, OneColourIsItsFrame) {
  const Traced traced(ascii_picture({"###", "###"}), {});
  ASSERT_EQ(traced.outlines.loops.size(), 1u);
  EXPECT_EQ(traced.outlines.loops[0].count, 4);  // each side one line
  EXPECT_EQ(loop_area_20(traced.outlines, traced.outlines.loops[0]), 6 * kPixelArea20);
}

TEST(Outlines, ARingHasAHole) {
  const Traced traced(
      ascii_picture({".......", ".#####.", ".#...#.", ".#...#.", ".#...#.", ".#####.", "......."}), {});
  ASSERT_EQ(traced.components.count, 3);
  EXPECT_EQ(traced.loop_count(0), 2);
  EXPECT_EQ(traced.loop_count(1), 2);
  EXPECT_EQ(traced.loop_count(2), 1);
  const OutlineLoop* ring = &traced.outlines.loops[traced.outlines.first_loop[1]];
  EXPECT_GT(loop_area_20(traced.outlines, ring[0]), 0);
  EXPECT_LT(loop_area_20(traced.outlines, ring[1]), 0);
}

TEST(Outlines, LinkedDiagonalIsOneLoopAndATieIsFour) {
  EXPECT_EQ(Traced(ascii_picture({"#..", ".#.", "..#"}), {}).outlines.loops.size(), 3u);
  EXPECT_EQ(Traced(ascii_picture({"#.", ".#"}), {}).outlines.loops.size(), 4u);
}

TEST(Outlines, BordersAreCutWhereContoursEnd) {
  const Traced traced(ascii_picture({"##.."}), {});
  ASSERT_EQ(traced.outlines.loops.size(), 2u);
  for (const OutlineLoop& loop : traced.outlines.loops) EXPECT_EQ(loop.count, 4);
}

RC_GTEST_PROP(Outlines, EverySegmentBoundsTwoComponents, (const Picture& picture)) {
  const Traced traced(picture, *random_options());
  const PlanarMap& map = traced.vectorizer.map();
  std::vector<int> uses(map.segments.size(), 0);
  for (const OutlineLoop& loop : traced.outlines.loops) {
    for_each_piece(traced.outlines, loop, [&](glm::ivec2 start, const OutlinePiece& piece) {
      if (piece.segment == OutlinePiece::kBorder) return;
      ++uses[piece.segment];
      const Segment& s = map.segments[piece.segment];
      const bool forwards = traced.components.label[s.left] == loop.component;
      RC_ASSERT(start == (forwards ? s.p0 : s.p3));
      RC_ASSERT(piece.p3 == (forwards ? s.p3 : s.p0));
    });
  }
  for (const int count : uses) RC_ASSERT(count == 2);
}

RC_GTEST_PROP(Outlines, AreasAddUpToTheFrame, (const Picture& picture)) {
  const Traced traced(picture, *random_options());
  std::int64_t area = 0;
  for (const OutlineLoop& loop : traced.outlines.loops) area += loop_area_20(traced.outlines, loop);
  RC_ASSERT(area == kPixelArea20 * picture.width * picture.height);
}

RC_GTEST_PROP(Outlines, EveryPixelCentreLiesInItsComponentAlone, ()) {
  const Picture picture = *random_picture({.max_size = 12});
  const Traced traced(picture, *random_lossless_options());
  const Lattice& lattice = traced.vectorizer.map().lattice;
  for (int component = 0; component < traced.components.count; ++component) {
    const std::vector<Polygon> polygons = flattened(traced.outlines, component);
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const glm::dvec2 centre = (glm::dvec2(x, y) + 0.5) * double(kSubpixels);
        RC_ASSERT(is_inside(centre, polygons) == (traced.components.label[lattice.pixel(x, y)] == component));
      }
    }
  }
}

RC_GTEST_PROP(Outlines, BuffersCanBeUsedAgain, (const Picture& first, const Picture& second)) {
  const Traced fresh(second, {});
  Traced used(first, {});
  const PlanarMap& map = used.vectorizer.vectorize(second.view(), {});
  label_components(used.vectorizer.graph(), used.components);
  trace_outlines(map, used.vectorizer.graph(), used.components, used.outlines);
  RC_ASSERT(used.outlines.first_loop == fresh.outlines.first_loop);
  RC_ASSERT(used.outlines.pieces.size() == fresh.outlines.pieces.size());
  for (std::size_t i = 0; i < fresh.outlines.pieces.size(); ++i) {
    RC_ASSERT(used.outlines.pieces[i].p3 == fresh.outlines.pieces[i].p3);
  }
}

}  // namespace
}  // namespace depixel::test
