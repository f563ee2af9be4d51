#include "libdepixel/svg/soft_groups.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

struct Grouped {
  Vectorizer vectorizer;
  Components components;
  std::vector<int> group;

  Grouped(const Picture& picture, double softness) {
    const PlanarMap& map = vectorizer.vectorize(picture.view(), Options{.soft_contours = softness});
    label_components(vectorizer.graph(), components);
    if (map.shading.any) group = find_soft_groups(map, components);
  }
  int of_pixel(int x, int y) const { return group[components.label[vectorizer.map().lattice.pixel(x, y)]]; }
};

/// A row of grey levels, three pixels high.
Picture greys(const std::vector<int>& levels) {
  Picture picture(static_cast<int>(levels.size()), 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto level = static_cast<std::uint8_t>(levels[x]);
      picture.at(x, y) = {level, level, level, 255};
    }
  }
  return picture;
}

TEST(SoftGroups, HoldWhatBlends) {
  const Grouped grouped(greys({100, 110, 120, 240, 250}), 20);
  ASSERT_FALSE(grouped.group.empty());
  EXPECT_EQ(grouped.of_pixel(0, 0), grouped.of_pixel(1, 0));
  EXPECT_EQ(grouped.of_pixel(0, 0), grouped.of_pixel(2, 0));
  EXPECT_EQ(grouped.of_pixel(3, 0), grouped.of_pixel(4, 0));
  EXPECT_NE(grouped.of_pixel(2, 0), grouped.of_pixel(3, 0));
}

RC_GTEST_PROP(SoftGroups, HoldNoSharpContour, ()) {
  const Picture picture = *random_picture({.colours = ".4567#"});
  const Grouped grouped(picture, *rc::gen::element(10.0, 30.0, 60.0));
  if (grouped.group.empty()) return;
  const PlanarMap& map = grouped.vectorizer.map();
  for (const Segment& s : map.segments) {
    const int a = grouped.components.label[s.left], b = grouped.components.label[s.right];
    if (a == b || grouped.group[a] != grouped.group[b]) continue;
    const int stride = map.lattice.stride(), first = std::min(s.left, s.right);
    const bool side_by_side = std::abs(s.left - s.right) == 1;
    const int block = side_by_side ? first - stride : first - 1;  // one of the two that both pixels are in
    RC_ASSERT((map.shading.blocks[block] & (side_by_side ? kSouthPair : kEastPair)) != 0);
  }
}

}  // namespace
}  // namespace depixel::test
