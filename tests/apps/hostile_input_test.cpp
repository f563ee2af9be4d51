// Inputs that are damaged, cut short, out of proportion, or no pictures: a clear sentence or a right picture,
// never a crash or a hang.

#include <gtest/gtest.h>

#include <random>

#include "apps/common/limits.hpp"
#include "tests/apps/pictures.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {
namespace {

Ended draw(std::string_view file, std::vector<std::string> flags = {}) {
  flags.insert(flags.end(), {"-", "-o", "-"});
  return run_depixel(flags, file);
}

void expect_refusal(const Ended& run) {
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(run.is_one_sentence()) << run.err;
  EXPECT_EQ(run.out, "");
}

/// A PNG whose header claims a size; nothing follows it.
std::string png_header(std::uint32_t width, std::uint32_t height) {
  std::string file = png_of(plain_picture(1, 1, {}));
  for (int i = 0; i < 4; ++i) {
    file[static_cast<std::size_t>(16 + i)] = static_cast<char>(width >> (24 - 8 * i) & 0xff);
    file[static_cast<std::size_t>(20 + i)] = static_cast<char>(height >> (24 - 8 * i) & 0xff);
  }
  return file;
}

std::string random_bytes(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::string bytes(size, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

TEST(HostileInput, FilesCutShortAreRefusedAtEveryLength) {
  const Picture picture = sample_picture(9, 5);
  for (const std::string& file : {png_of(picture), bmp_of(picture), gif_of({picture, picture})}) {
    const std::size_t step = file.size() / 24 + 1;
    for (std::size_t length = 0; length < file.size(); length += step)
      expect_refusal(draw(file.substr(0, length)));
    expect_refusal(draw(file.substr(0, file.size() - 1)));
  }
  const std::string jpeg = read_text(DEPIXEL_TEST_DATA "/formats/red.jpg");
  for (std::size_t length = 0; length < jpeg.size(); length += 40)
    expect_refusal(draw(jpeg.substr(0, length)));
}

TEST(HostileInput, WhatIsNoPictureIsRefused) {
  expect_refusal(draw("hello"));
  expect_refusal(draw("<svg xmlns=\"http://www.w3.org/2000/svg\"/>"));
  expect_refusal(draw("P6 1 1 255\n\1\2\3"));
  for (unsigned seed = 0; seed < 4; ++seed) expect_refusal(draw(random_bytes(1000, seed)));
}

TEST(HostileInput, RandomBytesBehindASignatureAreRefused) {
  for (const char* signature : {"\x89PNG\r\n\x1a\n", "BM", "\xff\xd8\xff", "GIF89a"}) {
    for (unsigned seed = 0; seed < 8; ++seed) expect_refusal(draw(signature + random_bytes(600, seed)));
  }
}

TEST(HostileInput, DamagedFilesEndOrderly) {
  const Picture picture = sample_picture(9, 5);
  std::mt19937 random(7);
  for (const std::string& whole : {png_of(picture), bmp_of(picture), gif_of({picture}),
                                   read_text(DEPIXEL_TEST_DATA "/formats/red.jpg")}) {
    for (int i = 0; i < 24; ++i) {
      std::string file = whole;
      for (int bytes = 0; bytes < 3; ++bytes) file[random() % file.size()] = static_cast<char>(random());
      const Ended run = draw(file, {"-s", "1"});
      if (run.exit_code != 0) expect_refusal(run);
    }
  }
}

TEST(HostileInput, SizesBeyondTheLimitsAreRefusedBeforeDecoding) {
  for (const auto& [width, height] : {std::pair{0U, 5U},
                                      {5U, 0U},
                                      {8192U, 8192U},
                                      {16385U, 1U},
                                      {1U, 100000U},
                                      {0xffffffffU, 0xffffffffU}}) {
    expect_refusal(draw(png_header(width, height)));
  }
}

TEST(HostileInput, ADeflateBombTakesNoMemory) {
  const Picture wide = plain_picture(4096, 4096, {1, 2, 3, 255});
  std::string bomb = png_of(wide);  // inflates to 64 MiB
  const std::string header = png_header(1, 1);
  bomb.replace(16, 8, header, 16, 8);
  expect_refusal(draw(bomb));
}

TEST(HostileInput, ThinPicturesAreDrawn) {
  for (const auto& [width, height] :
       {std::pair{1, 1}, {1, 300}, {300, 1}, {2, 1}, {kMaxSide, 1}, {1, kMaxSide}}) {
    const Ended run = draw(png_of(sample_picture(width, height)), {"-s", "1", "--verify", "--quiet"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Picture picture = decoded(run.out);
    EXPECT_EQ(picture.width(), width);
    EXPECT_EQ(picture.height(), height);
  }
}

TEST(HostileInput, OutputsBeyondTheLimitsAreRefused) {
  const std::string wide = png_of(sample_picture(kMaxSide, 1));
  expect_refusal(draw(wide));
  expect_refusal(draw(png_of(sample_picture(3, 3)), {"--size", "16384x16384"}));
  expect_refusal(draw(png_of(sample_picture(3, 3)), {"-s", "0.1"}));
  EXPECT_EQ(draw(wide, {"--format", "svg"}).exit_code, 0) << "an SVG has no size to be too large";
}

}  // namespace
}  // namespace depixel::test
