#include "apps/common/gif_reader.hpp"

#include <gif_lib.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tests/apps/pictures.hpp"

namespace depixel::test {
namespace {

/// Where a frame lies, its pixels as palette indices 0..3, and how it is shown.
struct Frame {
  int left, top, width, height;
  std::string pixels;
  int disposal = DISPOSE_DO_NOT, transparent = NO_TRANSPARENT_COLOR;
  bool interlaced = false;
};

int append(GifFileType* gif, const GifByteType* bytes, int size) {
  auto& file = *static_cast<std::vector<std::uint8_t>*>(gif->UserData);
  file.insert(file.end(), bytes, bytes + size);
  return size;
}

std::vector<std::uint8_t> gif_of_frames(int width, int height, const std::vector<Frame>& frames) {
  std::vector<std::uint8_t> file;
  GifFileType* gif = EGifOpen(&file, append, nullptr);
  constexpr std::array<GifColorType, 4> kColours{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}};
  ColorMapObject* colours = GifMakeMapObject(4, kColours.data());
  EGifSetGifVersion(gif, true);
  EGifPutScreenDesc(gif, width, height, 8, 0, colours);
  for (const Frame& frame : frames) {
    const GraphicsControlBlock control{frame.disposal, false, 0, frame.transparent};
    std::array<GifByteType, 4> extension{};
    EGifGCBToExtension(&control, extension.data());
    EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, 4, extension.data());
    EGifPutImageDesc(gif, frame.left, frame.top, frame.width, frame.height, frame.interlaced, nullptr);
    std::vector<GifByteType> indices;
    for (const char digit : frame.pixels) indices.push_back(static_cast<GifByteType>(digit - '0'));
    EGifPutLine(gif, indices.data(), static_cast<int>(indices.size()));
  }
  EGifCloseFile(gif, nullptr);
  GifFreeMapObject(colours);
  return file;
}

/// All frames as text: digits for colours, '.' for transparent.
std::vector<std::string> shown(const std::vector<std::uint8_t>& file) {
  std::vector<std::string> pictures;
  auto reader = GifReader::open(file);
  if (!reader) return {reader.error().message};
  for (int i = 0; i < reader->frame_count(); ++i) {
    const Picture picture = reader->next().value_or(Picture());
    std::string text;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        const Rgba colour = pixel(picture, x, y);
        text += colour.a == 0 ? '.' : static_cast<char>('0' + colour.r);
      }
    }
    pictures.push_back(text);
  }
  return pictures;
}

using Shown = std::vector<std::string>;

TEST(GifReader, FramesLieOverTheOnesBefore) {
  EXPECT_EQ(shown(gif_of_frames(3, 2, {{0, 0, 3, 2, "111111"}, {1, 0, 2, 1, "23"}})),
            (Shown{"111111", "123111"}));
}

TEST(GifReader, TransparentPixelsShowWhatIsBelow) {
  const std::vector<Frame> frames{{0, 0, 2, 1, "13", DISPOSE_DO_NOT, 3},
                                  {0, 0, 2, 1, "32", DISPOSE_DO_NOT, 3}};
  EXPECT_EQ(shown(gif_of_frames(2, 1, frames)), (Shown{"1.", "12"}));
}

TEST(GifReader, ClearsToTheBackground) {
  const std::vector<Frame> frames{
      {0, 0, 3, 1, "111"}, {1, 0, 1, 1, "2", DISPOSE_BACKGROUND}, {0, 0, 1, 1, "3"}};
  EXPECT_EQ(shown(gif_of_frames(3, 1, frames)), (Shown{"111", "121", "3.1"}));
}

TEST(GifReader, GoesBackToTheFrameBefore) {
  const std::vector<Frame> frames{{0, 0, 3, 1, "111"},
                                  {1, 0, 1, 1, "2", DISPOSE_PREVIOUS},
                                  {0, 0, 1, 1, "3", DISPOSE_PREVIOUS},
                                  {2, 0, 1, 1, "0"}};
  EXPECT_EQ(shown(gif_of_frames(3, 1, frames)), (Shown{"111", "121", "311", "110"}));
}

TEST(GifReader, InterlacedRowsFindTheirPlace) {
  // Rows as stored: 0 8, then 4, then 2 6, then the odd ones.
  const std::vector<Frame> frames{{0, 0, 1, 9, "012301230", DISPOSE_DO_NOT, NO_TRANSPARENT_COLOR, true}};
  EXPECT_EQ(shown(gif_of_frames(1, 9, frames)), Shown{"013223001"});
}

TEST(GifReader, WhatLiesOutsideIsCutOff) {
  EXPECT_EQ(shown(gif_of_frames(2, 2, {{0, 0, 2, 2, "1111"}, {1, 1, 3, 2, "222333"}, {9, 9, 1, 1, "3"}})),
            (Shown{"1111", "1112", "1112"}));
}

}  // namespace
}  // namespace depixel::test
