#include "libdepixel/stages/dithers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <set>
#include <utility>

#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

Picture copied(const FrameView& frame) {
  Picture picture(frame.width, frame.height);
  for (int y = 0; y < frame.height; ++y) {
    std::memcpy(&picture.at(0, y), frame.pixels + y * frame.pitch, sizeof(Rgba) * frame.width);
  }
  return picture;
}

Picture blended(const Picture& picture, bool linear_light = false) {
  Dithers dithers;
  blend_dithers(picture.view(), linear_light, dithers);
  return copied(dithers.view());
}

Picture normalized_picture(Picture picture) {
  for (Rgba& c : picture.pixels) c = normalized(c);
  return picture;
}

/// A rectangle of a checkerboard. \param phase  which of the two colours comes first.
void paint_dither(Picture& picture, glm::ivec2 from, glm::ivec2 size, Rgba a, Rgba b, int phase = 0) {
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) picture.at(from.x + x, from.y + y) = (x + y + phase) % 2 == 0 ? a : b;
  }
}

constexpr Rgba kBlack{0, 0, 0, 255}, kWhite{255, 255, 255, 255};

/// The definition, pixel by pixel: sets of blocks, each by its north-western pixel.
class NaiveDithers {
 public:
  explicit NaiveDithers(const Picture& picture) : picture_(normalized_picture(picture)) { find_blocks(); }

  Picture blended() const {
    Picture out = picture_;
    if (out.width == 2 || out.height == 2) return out;  // a single row of checkers is no area
    for (int y = 0; y < out.height; ++y) {
      for (int x = 0; x < out.width; ++x) out.at(x, y) = blended_pixel(x, y);
    }
    return out;
  }

 private:
  using Block = std::pair<int, int>;

  bool is_checker(int x, int y) const {
    if (x < 0 || y < 0 || x + 1 >= picture_.width || y + 1 >= picture_.height) return false;
    const Rgba a = picture_.at(x, y), b = picture_.at(x + 1, y);
    return a != b && picture_.at(x + 1, y + 1) == a && picture_.at(x, y + 1) == b;
  }

  /// Beyond the border a block is what the nearest one is.
  bool is_seed(int x, int y) const {
    for (int j = y - 1; j <= y + 1; ++j) {
      for (int i = x - 1; i <= x + 1; ++i) {
        if (!is_checker(std::clamp(i, 0, picture_.width - 2), std::clamp(j, 0, picture_.height - 2))) {
          return false;
        }
      }
    }
    return true;
  }

  void find_blocks() {
    for (int y = 0; y + 1 < picture_.height; ++y) {
      for (int x = 0; x + 1 < picture_.width; ++x) {
        if (!is_seed(x, y)) continue;
        for (int j = -1; j <= 1; ++j) {
          for (int i = -1; i <= 1; ++i) {
            if (is_checker(x + i, y + j)) blocks_.emplace(x + i, y + j);
          }
        }
      }
    }
    for (int step = 0; step < Dithers::kGrowth; ++step) {
      for (const auto& [x, y] : std::set<Block>(blocks_)) {
        for (const auto& [i, j] : {Block{x - 1, y}, Block{x + 1, y}, Block{x, y - 1}, Block{x, y + 1}}) {
          if (is_checker(i, j)) blocks_.emplace(i, j);
        }
      }
    }
  }

  /// Half of it is its own colour, the rest that of those beside it in its blocks.
  Rgba blended_pixel(int x, int y) const {
    std::set<std::uint32_t> seen;
    std::vector<Rgba> others;
    for (const auto& [i, j] : {Block{x - 1, y - 1}, Block{x, y - 1}, Block{x - 1, y}, Block{x, y}}) {
      if (!blocks_.contains({i, j})) continue;
      const Rgba other = picture_.at(i < x ? i : x + 1, y);
      if (seen.insert(rgba_order(other)).second) others.push_back(other);
    }
    const Rgba own = picture_.at(x, y);
    if (others.empty()) return own;
    const Rgba parts[] = {own, own, others.front(), others.back()};
    double alpha = 0, r = 0, g = 0, b = 0;
    for (const Rgba c : parts) {
      alpha += c.a;
      r += double(c.r) * c.a;
      g += double(c.g) * c.a;
      b += double(c.b) * c.a;
    }
    const auto level = [](double v) { return static_cast<std::uint8_t>(std::floor(v + 0.5)); };
    return normalized({level(r / alpha), level(g / alpha), level(b / alpha), level(alpha / 4)});
  }

  Picture picture_;
  std::set<Block> blocks_;
};

TEST(Dithers, ALoneCheckerIsAWholePictureAtMost) {
  for (const glm::ivec2 size : {glm::ivec2(2, 2), glm::ivec2(2, 9), glm::ivec2(9, 2)}) {
    Picture picture(size.x, size.y);
    paint_dither(picture, {0, 0}, size, kBlack, kWhite);
    EXPECT_EQ(blended(picture), picture);
  }
}

TEST(Dithers, BecomeTheColourBetween) {
  Picture picture(8, 6, kBlack);
  paint_dither(picture, {0, 0}, {8, 6}, kBlack, kWhite);
  EXPECT_EQ(blended(picture), Picture(8, 6, {128, 128, 128, 255}));
  EXPECT_EQ(blended(picture, true), Picture(8, 6, {188, 188, 188, 255}));
}

TEST(Dithers, WithTransparencyBecomeTranslucent) {
  Picture picture(6, 6);
  paint_dither(picture, {0, 0}, {6, 6}, {200, 10, 30, 255}, {});
  EXPECT_EQ(blended(picture), Picture(6, 6, {200, 10, 30, 128}));
}

TEST(Dithers, OnAGroundOfOneOfTheirColoursKeepTheirShape) {
  Picture picture(14, 12, kWhite), expected = picture;
  paint_dither(picture, {4, 3}, {6, 5}, kBlack, kWhite);
  paste(expected, Picture(6, 5, {128, 128, 128, 255}), 4, 3);
  EXPECT_EQ(blended(picture), expected);
}

TEST(Dithers, ReachIntoNarrowParts) {
  const Picture picture = ascii_picture({"rrrrrrrrrrr",  //
                                         "rr.#.#rrrrr",  //
                                         "rr#.#.rrrrr",  //
                                         "rr.#.#.#rrr",  //
                                         "rr#.#.#.rrr",  //
                                         "rrrrr#.rrrr",  //
                                         "rrrrr.#rrrr",  //
                                         "rrrrrrrrrrr"});
  Dithers dithers;
  blend_dithers(picture.view(), false, dithers);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      EXPECT_EQ(dithers.is_dithered(x, y), picture.at(x, y) != palette_colour('r')) << x << ' ' << y;
    }
  }
}

TEST(Dithers, AreNeitherTextNorOutlinesNorLoneCheckers) {
  for (const Picture& picture : {ascii_picture({"............",  //
                                                ".#.#.......",   //
                                                "..#........",   //
                                                ".#.#.......",   //
                                                "..........."}),
                                 ascii_picture({".................",  //
                                                ".#.#.####.#...#..",  //
                                                ".#.#.#....##.##..",  //
                                                "..#..###..#.#.#..",  //
                                                ".#.#.#....#...#..",  //
                                                ".#.#.####.#...#..",  //
                                                "................."}),
                                 ascii_picture({"..............",  //
                                                ".#.#.#.#.#.#..",  //
                                                "..#.#.#.#.#.#.",  //
                                                ".#.#.#.#.#.#..",  //
                                                ".............."}),
                                 ascii_picture({"rrrrrrrr",  //
                                                "r#.#rrrr",  //
                                                "r.#.#rrr",  //
                                                "rr.#.#rr",  //
                                                "rrr.#.#r",  //
                                                "rrrr.#.r",  //
                                                "rrrrrrrr"}),
                                 ascii_picture({"#.rrrr",  //
                                                ".#rrrr",  //
                                                "rrrrrr",  //
                                                "rrr#.#",  //
                                                "rrr.#."})}) {
    EXPECT_EQ(blended(picture), picture);
  }
}

TEST(Dithers, ThatMeetHaveTheirOwnColoursEach) {
  Picture picture(12, 8);
  paint_dither(picture, {0, 0}, {6, 8}, kBlack, {100, 100, 100, 255});
  paint_dither(picture, {6, 0}, {6, 8}, {200, 200, 200, 255}, {100, 100, 100, 255});
  Picture expected(12, 8, {50, 50, 50, 255});
  paste(expected, Picture(6, 8, {150, 150, 150, 255}), 6, 0);
  EXPECT_EQ(blended(picture), expected);
}

TEST(Dithers, AreSeenAsSoonAsTheyScrollIn) {
  for (const int width : {1, 2, 3, 4}) {
    Picture picture(12, 12, palette_colour('r'));
    paint_dither(picture, {0, 0}, {width, 12}, kBlack, kWhite);
    const bool is_seen = width >= 3;
    for (const Symmetry& symmetry : kSymmetries)
      EXPECT_EQ(blended(symmetry(picture)) != symmetry(picture), is_seen);
  }
}

RC_GTEST_PROP(Dithers, DoNotDependOnWhichColourComesFirst, ()) {
  const glm::ivec2 size(*rc::gen::inRange(4, 80), *rc::gen::inRange(4, 12));
  const auto character = rc::gen::element('.', '#', '_', 'r', 'R');
  const Rgba a = palette_colour(*character), b = palette_colour(*character),
             ground = palette_colour(*character);
  Picture one(size.x + 6, size.y + 6, ground), other = one;
  paint_dither(one, {3, 3}, size, a, b, 0);
  paint_dither(other, {3, 3}, size, a, b, 1);
  RC_ASSERT(blended(one) == blended(other));
}

/// Large pictures of few colours have many checkers.
rc::Gen<Picture> random_dithers() {
  return random_picture({80, ".#_rR"});
}

RC_GTEST_PROP(Dithers, EqualTheNaiveOnes, ()) {
  const Picture picture = *random_dithers();
  RC_ASSERT(blended(picture) == NaiveDithers(picture).blended());
}

RC_GTEST_PROP(Dithers, FlipsAndTurnsCommute, ()) {
  const Picture picture = *random_dithers();
  const bool linear_light = *rc::gen::arbitrary<bool>();
  const Picture expected = blended(picture, linear_light);
  for (const Symmetry& symmetry : kSymmetries) {
    RC_ASSERT(blended(symmetry(picture), linear_light) == symmetry(expected));
  }
}

RC_GTEST_PROP(Dithers, TranslationsCommute, ()) {
  const Picture picture = *random_dithers();
  const glm::ivec2 shift(*rc::gen::inRange(0, 70), *rc::gen::inRange(0, 9));
  const Rgba ground = palette_colour(*rc::gen::element('.', 'b', '_'));
  const auto placed = [&](glm::ivec2 at) {
    Picture whole(picture.width + 74, picture.height + 13, ground);
    paste(whole, picture, 2 + at.x, 2 + at.y);
    return blended(whole);
  };
  const auto part = [&](const Picture& whole, glm::ivec2 at) {
    Picture cut(picture.width + 4, picture.height + 4);
    paste(cut, whole, -at.x, -at.y);
    return cut;
  };
  RC_ASSERT(part(placed({0, 0}), {0, 0}) == part(placed(shift), shift));
}

RC_GTEST_PROP(Dithers, FramesBeforeLeaveNoTrace, (const Picture& first)) {
  Picture second(first.width, first.height, palette_colour('b'));
  paste(second, *random_dithers(), 0, 0);
  Dithers dithers;
  blend_dithers(first.view(), false, dithers);
  blend_dithers(second.view(), false, dithers);
  RC_ASSERT(copied(dithers.view()) == blended(second));
}

}  // namespace
}  // namespace depixel::test
