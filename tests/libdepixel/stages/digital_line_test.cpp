#include "libdepixel/stages/digital_line.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <string_view>
#include <vector>

namespace depixel::test {
namespace {

/// Steps by their initials: N, E, S, W.
std::vector<Direction> steps_of(std::string_view initials) {
  std::vector<Direction> steps;
  for (const char c : initials) steps.push_back(static_cast<Direction>(std::string_view("NESW").find(c)));
  return steps;
}

/// The line that steps make as long as they are straight.
DigitalLine grown(std::string_view initials) {
  const std::vector<Direction> steps = steps_of(initials);
  DigitalLine line(steps[0], 1);
  for (std::size_t k = 1; k < steps.size() && line.grow(steps[k]); ++k) {
    EXPECT_EQ(line.steps(), static_cast<int>(k) + 1);
  }
  return line;
}

int length_of(std::string_view initials) {
  return grown(initials).steps();
}

TEST(DigitalLine, StartsWithARun) {
  DigitalLine line(kEast, 4);
  EXPECT_EQ(line.end(), grown("EEEE").end());
  EXPECT_TRUE(line.grow(kNorth));
  EXPECT_TRUE(line.grow(kEast));
  EXPECT_EQ(line.direction(), grown("EEEENE").direction());
  EXPECT_EQ(line.twice_offset(), grown("EEEENE").twice_offset());
}

TEST(DigitalLine, GoesOnAsLongAsRunsAreAlike) {
  EXPECT_EQ(length_of("EEEEEEEE"), 8);
  EXPECT_EQ(length_of("ENENENEN"), 8);
  EXPECT_EQ(length_of("EENEEENEENEEE"), 13);  // two and three in turns
  EXPECT_EQ(length_of("EEEENENEE"), 6);       // four, then one
  EXPECT_EQ(length_of("EENNE"), 3);           // a right angle
  EXPECT_EQ(length_of("EENW"), 3);            // there and back
  EXPECT_EQ(length_of("EW"), 1);
}

TEST(DigitalLine, LiesInTheMiddle) {
  const DigitalLine line = grown("EENEENEE");
  EXPECT_EQ(line.direction(), glm::ivec2(2, -1));
  EXPECT_EQ(line.end(), glm::ivec2(6, -2));
  // Nodes lie on three parallel lines; that in the middle goes through (1, 0).
  EXPECT_EQ(line.twice_offset(), 2 * (2 * 0 - -1 * 1));
  const DigitalLine level = grown("WWW");
  EXPECT_EQ(level.direction(), glm::ivec2(-1, 0));
  EXPECT_EQ(level.twice_offset(), 0);
}

int cross(glm::ivec2 a, glm::ivec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// Whether nodes are those of a digital straight line, by trying all directions with steps up to their
/// number.
bool is_straight(const std::vector<glm::ivec2>& nodes) {
  const int most = static_cast<int>(nodes.size());
  for (int dx = -most; dx <= most; ++dx) {
    for (int dy = -most; dy <= most; ++dy) {
      if (std::gcd(dx, dy) != 1) continue;
      int low = 0, high = 0;
      bool goes_on = true;  // never back
      for (std::size_t k = 1; k < nodes.size(); ++k) {
        const glm::ivec2 step = nodes[k] - nodes[k - 1];
        goes_on &= step.x * dx >= 0 && step.y * dy >= 0;
        low = std::min(low, cross({dx, dy}, nodes[k]));
        high = std::max(high, cross({dx, dy}, nodes[k]));
      }
      if (goes_on && high - low < std::abs(dx) + std::abs(dy)) return true;
    }
  }
  return false;
}

RC_GTEST_PROP(DigitalLine, GrowsWhereThereIsALine, ()) {
  const auto heads = *rc::gen::inRange(0, 4);
  DigitalLine line(static_cast<Direction>(heads), 1);
  std::vector<glm::ivec2> nodes{{0, 0}, kStep[heads]};
  for (int k = 0; k < 14; ++k) {
    const auto step = turned(static_cast<Direction>(heads), *rc::gen::element(0, 0, 0, 1));
    nodes.push_back(nodes.back() + kStep[step]);
    const bool is_line = is_straight(nodes);
    RC_ASSERT(line.grow(step) == is_line);
    if (!is_line) break;
    RC_ASSERT(line.end() == nodes.back());
    // The nodes lie within half a width of its middle line, on either side.
    const glm::ivec2 d = line.direction();
    for (const glm::ivec2 p : nodes) {
      RC_ASSERT(std::abs(2 * cross(d, p) - line.twice_offset()) < std::abs(d.x) + std::abs(d.y));
    }
  }
}

RC_GTEST_PROP(DigitalLine, TurnsAndFlipsWithItsSteps, ()) {
  DigitalLine line(kEast, 1), turned_line(kSouth, 1), flipped_line(kEast, 1);
  for (int k = 0; k < 14; ++k) {
    const auto step = static_cast<Direction>(*rc::gen::element(1, 1, 1, 2));
    const auto flipped = step == kSouth ? kNorth : step;
    const bool grows = line.grow(step);
    RC_ASSERT(turned_line.grow(turned(step, 1)) == grows);
    RC_ASSERT(flipped_line.grow(flipped) == grows);
    if (!grows) break;
  }
  const glm::ivec2 d = line.direction();
  RC_ASSERT(turned_line.direction() == glm::ivec2(-d.y, d.x));
  RC_ASSERT(turned_line.twice_offset() == line.twice_offset());
  RC_ASSERT(flipped_line.direction() == glm::ivec2(d.x, -d.y));
  RC_ASSERT(flipped_line.twice_offset() == -line.twice_offset());
}

}  // namespace
}  // namespace depixel::test
