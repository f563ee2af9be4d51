#include "libdepixel/stages/pixel_marks.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/map_segments.hpp"
#include "tests/support/random_pictures.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

/// Marks of a picture's pixels, row by row, and the graph that they were found in.
struct Marked {
  explicit Marked(const Picture& picture, bool text_safe = true) {
    vectorizer.vectorize(picture.view(), {});
    find_pixel_marks(vectorizer.graph(), text_safe, marks);
  }
  PixelMarks at(int x, int y) const { return marks[vectorizer.graph().lattice.pixel(x, y)]; }

  Vectorizer vectorizer;
  std::vector<PixelMarks> marks;
};

/// The pixels of a colour that are marked, '#', and those that are not, '-'.
std::vector<std::string> drawn_marks(const std::vector<std::string_view>& rows, PixelMarks mark,
                                     char colour = '#') {
  const Marked marked(ascii_picture(rows));
  std::vector<std::string> drawn(rows.begin(), rows.end());
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      if (rows[y][x] != colour) continue;
      drawn[y][x] = (marked.at(static_cast<int>(x), static_cast<int>(y)) & mark) != 0 ? '#' : '-';
    }
  }
  return drawn;
}

TEST(PixelMarks, LettersAreText) {
  const std::vector<std::string_view> letters{".....................",  //
                                              ".####..#..#...##.###.",  //
                                              ".#.....##.#..#...#...",  //
                                              ".###...#.##...#..###.",  //
                                              ".#.....#..#....#...#.",  //
                                              ".####..#..#..##..##..",  //
                                              "....................."};
  const auto text = drawn_marks(letters, kText);
  // All of the E and the N, but for corners with two arms, which are real ones anyway.
  EXPECT_EQ(text[1].substr(0, 12), ".-###..#..#.");
  EXPECT_EQ(text[5].substr(0, 12), ".-###..#..#.");
  for (const std::size_t y : {2, 3, 4}) EXPECT_EQ(text[y].substr(0, 12), letters[y].substr(0, 12));
}

TEST(PixelMarks, TextIsDrawnAsTheCellGraphHasIt) {
  const Picture letter = ascii_picture({"...........",  //
                                        ".#.......#.",  //
                                        ".##......#.",  //
                                        ".#.#.....#.",  //
                                        ".#..#....#.",  //
                                        ".#...#...#.",  //
                                        ".#....#..#.",  //
                                        ".#.....#.#.",  //
                                        ".#......##.",  //
                                        ".#.......#.",  //
                                        "..........."});
  const auto drawn = [&](const Options& options) {
    Picture out(8 * letter.width, 8 * letter.height);
    const PlanarMap map = vectorized(letter, options);
    CpuRaster().draw(map, View::fit(map.lattice, out.width, out.height), false, 1, out.target());
    return out;
  };
  const Picture plain = drawn({.smoothing = Smoothing::none});
  const double smoothed = compare(plain, drawn({})).mean;
  EXPECT_LT(compare(plain, drawn({.text_safe = true})).mean, 0.4 * smoothed);
}

TEST(PixelMarks, SpikesAndDiscsAreNot) {
  const auto count = [](const std::vector<std::string>& drawn) {
    int pixels = 0;
    for (const std::string& row : drawn) pixels += static_cast<int>(std::count(row.begin(), row.end(), '#'));
    return pixels;
  };
  EXPECT_EQ(count(drawn_marks({".........",  //
                               "....#....",  //
                               "....#....",  //
                               "...###...",  //
                               "...###...",  //
                               "..#####..",  //
                               "..#####..",  //
                               ".#######."},
                              kText)),
            0);
  EXPECT_EQ(count(drawn_marks({".........",  //
                               "...###...",  //
                               "..#####..",  //
                               ".#######.",  //
                               ".#######.",  //
                               ".#######.",  //
                               "..#####..",  //
                               "...###...",  //
                               "........."},
                              kText)),
            0);
}

TEST(PixelMarks, ABarHasOneGroundOnBothSides) {
  EXPECT_EQ(drawn_marks({".#4", ".#4", ".#4", ".#4"}, kStroke),
            (std::vector<std::string>{".-4", ".-4", ".-4", ".-4"}));
  EXPECT_EQ(drawn_marks({".#.", ".#.", "4#4"}, kBar), (std::vector<std::string>{".-.", ".-.", "4-4"}));
  EXPECT_EQ(drawn_marks({"4.#.", "4.#.", "4.#."}, kBar), (std::vector<std::string>{"4.#.", "4.#.", "4.#."}));
}

/// The definitions in words, by counting along lines of a picture.
class NaiveMarks {
 public:
  explicit NaiveMarks(const Picture& picture) : picture_(picture) {}

  bool is_text(int x, int y) const {
    if (!is_stroke({x, y})) return false;
    for (int by = -4; by <= 4; ++by) {
      for (int bx = -4; bx <= 4; ++bx) {
        const glm::ivec2 at(x + bx, y + by);
        if (picture_.contains(at.x, at.y) && colour(at) == colour({x, y}) && is_bar(at)) return true;
      }
    }
    return false;
  }

 private:
  Rgba colour(glm::ivec2 p) const {
    return picture_.contains(p.x, p.y) ? normalized(picture_.at(p.x, p.y)) : Rgba{};
  }
  /// The first and the last pixel of the stroke across an axis; none if it is no stroke.
  std::optional<std::pair<glm::ivec2, glm::ivec2>> stroke(glm::ivec2 p, glm::ivec2 across) const {
    glm::ivec2 first = p, last = p;
    for (int i = 0; i < 4 && colour(first - across) == colour(p); ++i) first -= across;
    for (int i = 0; i < 4 && colour(last + across) == colour(p); ++i) last += across;
    const glm::ivec2 size = last - first;
    if (size.x + size.y > 2 || colour(first - across) != colour(last + across)) return std::nullopt;
    return std::pair(first, last);
  }
  bool is_stroke(glm::ivec2 p) const { return stroke(p, {1, 0}) || stroke(p, {0, 1}); }
  bool is_bar(glm::ivec2 p) const {
    for (const glm::ivec2 across : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
      const glm::ivec2 along(across.y, across.x);
      const auto found = stroke(p, across);
      if (!found) continue;
      const auto goes_on = [&](glm::ivec2 by) {
        for (glm::ivec2 q = found->first - across; q != found->second + 2 * across; q += across) {
          if (colour(q + by) != colour(q)) return false;
        }
        return true;
      };
      const bool before = goes_on(-along), after = goes_on(along);
      if ((before && after) || (before && goes_on(-2 * along)) || (after && goes_on(2 * along))) return true;
    }
    return false;
  }

  const Picture& picture_;
};

RC_GTEST_PROP(PixelMarks, AreThoseOfTheDefinitions, (const Picture& picture)) {
  const Marked marked(picture);
  const NaiveMarks naive(picture);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      RC_ASSERT(((marked.at(x, y) & kText) != 0) == naive.is_text(x, y));
    }
  }
}

RC_GTEST_PROP(PixelMarks, DoNotDependOnHowAPictureIsTurned, (const Picture& picture)) {
  const Marked marked(picture);
  for (const Symmetry& symmetry : kSymmetries) {
    const Marked turned(symmetry(picture));
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const glm::ivec2 to = symmetry.pixel({x, y}, {picture.width, picture.height});
        RC_ASSERT(turned.at(to.x, to.y) == marked.at(x, y));
      }
    }
  }
}

RC_GTEST_PROP(PixelMarks, PartsAreMarkedAsTheWhole, (const Picture& picture)) {
  const Marked marked(picture);
  const SimilarityGraph& graph = marked.vectorizer.graph();
  const int from = *rc::gen::inRange(0, picture.width), to = *rc::gen::inRange(from, picture.width) + 1;
  std::vector<PixelMarks> marks = marked.marks;
  for (int y = 0; y < picture.height; ++y) mark_lines(graph, true, y, from, to, marks);
  for (int y = 0; y < picture.height; ++y) mark_text(graph, y, from, to, marks);
  RC_ASSERT(marks == marked.marks);
}

RC_GTEST_PROP(PixelMarks, TextIsMarkedOnlyIfAskedFor, (const Picture& picture)) {
  const Marked with(picture), without(picture, false);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) RC_ASSERT(without.at(x, y) == (with.at(x, y) & kThinLine));
  }
}

}  // namespace
}  // namespace depixel::test
