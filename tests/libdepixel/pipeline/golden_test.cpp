#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/pipeline/verify.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

std::vector<std::filesystem::path> shipped(const char* folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(data_folder() / folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data_folder() / folder)) {
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class Golden : public testing::TestWithParam<std::filesystem::path> {};

/// Geometry and sums are the same bit for bit on every compiler; so are the pictures.
TEST_P(Golden, SpriteAtFourTimes) {
  const Picture sheet = load_picture(GetParam());
  ASSERT_GT(sheet.width, 0);
  constexpr int kSide = 64;  // of sheets of sprites, a corner is enough
  Picture sprite(std::min(sheet.width, kSide), std::min(sheet.height, kSide));
  paste(sprite, sheet, 0, 0);
  Vectorizer vectorizer;
  const PlanarMap& map = vectorizer.vectorize(sprite.view(), {});
  Picture out(4 * sprite.width, 4 * sprite.height);
  CpuRaster().draw(map, View::fit(map.lattice, out.width, out.height), false, 1, out.target());
  EXPECT_EQ(golden_mismatch(GetParam().stem().string() + "_4x", out), "");
}

class Shipped : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Shipped, EveryCentreKeepsItsColour) {
  const Picture picture = load_picture(GetParam());
  ASSERT_GT(picture.width, 0);
  Vectorizer vectorizer;
  for (const SplineKind spline : {SplineKind::adaptive, SplineKind::approximate, SplineKind::interpolate}) {
    for (const Smoothing smoothing : {Smoothing::energy, Smoothing::average, Smoothing::none}) {
      Options options;
      options.spline = spline;
      options.smoothing = smoothing;
      const PlanarMap& map = vectorizer.vectorize(picture.view(), options);
      const CentreReport report = verify_centres(map, vectorizer.graph());
      EXPECT_EQ(report.lost, 0) << "first at " << report.first_lost_x << ',' << report.first_lost_y;
      EXPECT_GE(report.nearest, (kCentreClearance - 1.0) / kSubpixels);
    }
  }
}

std::string stem_of(const testing::TestParamInfo<std::filesystem::path>& info) {
  std::string name = std::to_string(info.index) + '_' + info.param.stem().string();
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Sprites, Golden, testing::ValuesIn(shipped("sprites")), stem_of);
INSTANTIATE_TEST_SUITE_P(Sprites, Shipped, testing::ValuesIn(shipped("sprites")), stem_of);
INSTANTIATE_TEST_SUITE_P(Frames, Shipped, testing::ValuesIn(shipped("frames")), stem_of);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Golden);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Shipped);

}  // namespace
}  // namespace depixel::test
