#include "libdepixel/stages/spline_table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <map>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel {

std::ostream& operator<<(std::ostream& out, const EdgeCurve& c) {
  for (const glm::ivec2 p : {glm::ivec2(c.p0), glm::ivec2(c.p1), glm::ivec2(c.p2), glm::ivec2(c.p3)}) {
    out << '(' << p.x << ", " << p.y << ") ";
  }
  return out;
}

namespace test {
namespace {

/// The arcs of a picture.
Arcs arcs_of(const Picture& picture, const Options& options) {
  Vectorizer v;
  v.vectorize(picture.view(), options);
  return v.arcs();
}

/// The curves at some places.
std::vector<EdgeCurve> curves_at(const SplineTable& table, int first, int count) {
  std::vector<EdgeCurve> curves(count);
  for (int k = 0; k < count; ++k) curves[k] = table.curve(table.number_at(first + k));
  return curves;
}

/// An arc's curves when it is the only one that is fitted.
std::vector<EdgeCurve> fitted_alone(std::span<const ShapeWord> words, const Arc& arc,
                                    const Options& options) {
  std::vector<EdgeCurve> curves(arc.step_count());
  std::vector<TileMask> tiles(arc.step_count());
  const ArcShape shape{words, arc.kind, curves.data(), tiles.data()};
  SplineFitter().fit(std::span(&shape, 1), options);
  return curves;
}

RC_GTEST_PROP(SplineTable, EqualShapesHaveEqualPlacesAndOthersTheirOwn, (const Picture& picture)) {
  const Options options = *random_options();
  const Arcs arcs = arcs_of(picture, options);
  SplineTable table;
  using Shape = std::tuple<std::vector<int>, bool, bool, int>;
  std::map<Shape, int> known;
  int next = 0;
  for (const Arc& arc : arcs.list) {
    std::vector<int> words;
    for (const ShapeWord w : arcs.words(arc)) {
      words.push_back(w.code().bits() | w.heading() << 8 | w.thin_sides() << 12 |
                      (w.is_text() ? 1 << 14 : 0));
    }
    const Shape shape{words, arc.kind.closed, arc.kind.interpolated, arc.kind.rounds};
    const auto [entry, is_new] = known.emplace(shape, next);
    if (is_new) next += arc.step_count();
    RC_ASSERT(table.place_of(arcs.words(arc), arc.kind) == entry->second);
  }
  RC_ASSERT(table.places() == static_cast<std::size_t>(next));
  Workers workers;
  RC_ASSERT(table.fit_added(options, workers) == static_cast<int>(known.size()));
  RC_ASSERT(table.fit_added(options, workers) == 0);
}

RC_GTEST_PROP(SplineTable, CurvesAreThoseOfArcsFittedAlone, (const Picture& picture)) {
  const Options options = *random_options();
  const Arcs arcs = arcs_of(picture, options);
  SplineTable table;
  Workers workers;
  workers.set_threads(options.threads);
  std::vector<int> first;
  for (const Arc& arc : arcs.list) first.push_back(table.place_of(arcs.words(arc), arc.kind));
  table.fit_added(options, workers);
  for (std::size_t i = 0; i < arcs.list.size(); ++i) {
    const Arc& arc = arcs.list[i];
    const auto alone = fitted_alone(arcs.words(arc), arc, options);
    RC_ASSERT(curves_at(table, first[i], arc.step_count()) == alone);
    for (int k = 0; k < arc.step_count(); ++k) {
      const int number = table.number_at(first[i] + k);
      RC_ASSERT(table.fitted(number) == number);
      RC_ASSERT(table.tiles(number) == touched_tiles(alone[k]));
    }
  }
}

RC_GTEST_PROP(SplineTable, EqualCurvesHaveEqualNumbersIfAskedFor, (const Picture& picture)) {
  const Options options = *random_options();
  const Arcs arcs = arcs_of(picture, options);
  SplineTable table(true);
  Workers workers;
  for (const Arc& arc : arcs.list) table.place_of(arcs.words(arc), arc.kind);
  table.fit_added(options, workers);
  std::map<std::array<std::int16_t, 8>, int> numbers;
  for (int place = 0; place < static_cast<int>(table.places()); ++place) {
    const int number = table.number_at(place);
    RC_ASSERT(number != 0);
    const auto points = std::bit_cast<std::array<std::int16_t, 8>>(table.curve(number));
    RC_ASSERT(numbers.emplace(points, number).first->second == number);
  }
  RC_ASSERT(numbers.size() == table.size());
}

RC_GTEST_PROP(SplineTable, ShapesAddedLaterLeaveThoseBeforeAlone, (const Picture& a, const Picture& b)) {
  const Options options = *random_lossless_options();
  const Arcs first = arcs_of(a, options), second = arcs_of(b, options);
  SplineTable table;
  Workers workers;
  const auto add = [&](const Arcs& arcs) {
    std::vector<int> places;
    for (const Arc& arc : arcs.list) places.push_back(table.place_of(arcs.words(arc), arc.kind));
    table.fit_added(options, workers);
    return places;
  };
  const std::vector<int> places = add(first);
  const std::vector<EdgeCurve> before = curves_at(table, 0, static_cast<int>(table.places()));
  add(second);
  RC_ASSERT(curves_at(table, 0, static_cast<int>(before.size())) == before);
  RC_ASSERT(add(first) == places);
}

TEST(SplineTable, ThreadsLeaveNoTrace) {
  // Noise: more shapes than one thread is given at once.
  Picture noise(96, 64);
  std::uint32_t state = 3;
  for (Rgba& c : noise.pixels) {
    state = state * 1664525 + 1013904223;
    c = palette_colour(".#r"[(state >> 24) % 3]);
  }
  const Arcs arcs = arcs_of(noise, {});
  std::vector<EdgeCurve> expected;
  for (const int threads : {1, 2, 4}) {
    SplineTable table;
    Workers workers;
    workers.set_threads(threads);
    for (const Arc& arc : arcs.list) table.place_of(arcs.words(arc), arc.kind);
    EXPECT_GT(table.fit_added(Options{}, workers), 500);
    const std::vector<EdgeCurve> curves = curves_at(table, 0, static_cast<int>(table.places()));
    if (threads == 1) expected = curves;
    EXPECT_TRUE(curves == expected);
  }
}

TEST(SplineTable, KnowsManyShapes) {
  // More than the index holds at first; arcs of level steps and turns, told apart by their headings.
  SplineTable table;
  std::vector<std::vector<ShapeWord>> shapes;
  for (int i = 0; i < 5000; ++i) {
    std::vector<ShapeWord> words(13);
    for (int bit = 0; bit < 13; ++bit)
      words[bit] = ShapeWord(CornerCode{}, i >> bit & 1 ? kEast : kSouth, 0, 0);
    shapes.push_back(words);
  }
  std::vector<int> numbers(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) numbers[i] = table.place_of(shapes[i], {});
  EXPECT_EQ(table.places(), 5000U * 12);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    EXPECT_EQ(numbers[i], 12 * static_cast<int>(i));
    EXPECT_EQ(table.place_of(shapes[i], {}), numbers[i]);
  }
  const ArcKind other{false, true, 0};
  EXPECT_NE(table.place_of(shapes[0], other), numbers[0]);
  table.clear();
  EXPECT_EQ(table.places(), 0U);
  EXPECT_EQ(table.size(), 0U);
  EXPECT_EQ(table.place_of(shapes[9], {}), 0);
}

TEST(SplineTable, JoinedCurvesAreFoundAgain) {
  const Arcs arcs = arcs_of(ascii_picture({"rg",  //
                                           "by"}),
                            {});
  SplineTable table;
  Workers workers;
  const int place = table.place_of(arcs.words(arcs.list[0]), arcs.list[0].kind);
  table.fit_added(Options{}, workers);
  const int fitted = table.number_at(place);
  const EdgeCurve curve = table.curve(fitted);
  EXPECT_EQ(table.joined(fitted, true, curve.p0, curve.p3), fitted) << "its own ends";
  const glm::i16vec2 end = curve.p3 + glm::i16vec2(100, -50);
  const int joined = table.joined(fitted, true, curve.p0, end);
  EXPECT_NE(joined, fitted);
  EXPECT_EQ(table.joined(fitted, true, curve.p0, end), joined);
  EXPECT_NE(table.joined(fitted, true, end, curve.p3), joined);
  EXPECT_EQ(table.fitted(joined), fitted);
  EXPECT_EQ(table.curve(joined), join(curve, true, curve.p0, end));
  EXPECT_EQ(table.curve(joined).p3, end);
  EXPECT_EQ(table.tiles(joined), touched_tiles(table.curve(joined)));
  EXPECT_EQ(table.curve(fitted), curve) << "stays as it was";
}

TEST(SplineTable, JoinedEndsKeepTheTangentAtTheOther) {
  const EdgeCurve curve{{0, 0}, {0, 1365}, {0, 2731}, {0, 4096}};
  const EdgeCurve joined = join(curve, true, {0, 0}, {60, 4000});
  EXPECT_EQ(joined.p0, curve.p0);
  EXPECT_EQ(joined.p1, curve.p1);
  EXPECT_EQ(joined.p3, glm::i16vec2(60, 4000));
}

}  // namespace
}  // namespace test
}  // namespace depixel
