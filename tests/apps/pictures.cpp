#include "tests/apps/pictures.hpp"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "apps/common/decode.hpp"
#include "apps/common/encode_png.hpp"
#include "apps/common/files.hpp"

namespace depixel::test {
namespace {

constexpr std::array<Rgba, 4> kPalette{
    {{20, 30, 60, 255}, {230, 80, 40, 255}, {250, 220, 90, 255}, {60, 160, 90, 255}}};

void set_pixel(Picture& picture, int x, int y, Rgba colour) {
  std::memcpy(picture.row(y) + std::ptrdiff_t{4} * x, &colour, sizeof colour);
}

void append_number(std::string& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
}

int append_bytes(GifFileType* gif, const GifByteType* bytes, int size) {
  static_cast<std::string*>(gif->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  return size;
}

std::vector<GifByteType> palette_indices(const Picture& frame) {
  std::vector<GifByteType> indices;
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 0; x < frame.width(); ++x) {
      const auto found = std::find(kPalette.begin(), kPalette.end(), pixel(frame, x, y));
      indices.push_back(static_cast<GifByteType>(found - kPalette.begin()));
    }
  }
  return indices;
}

}  // namespace

Picture sample_picture(int width, int height) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool disc =
          (2 * x - width) * (2 * x - width) + (2 * y - height) * (2 * y - height) < width * height / 2;
      const std::size_t colour = disc ? 1 : x > 2 * y ? 2 : x + 3 * y > 2 * width ? 3 : 0;
      set_pixel(picture, x, y, kPalette[colour]);
    }
  }
  return picture;
}

std::vector<Picture> sample_frames(int width, int height, int count) {
  constexpr int kStill = 4;  // every fourth frame is the one before
  std::vector<Picture> frames;
  for (int i = 0; i < count; ++i) {
    const int time = i - (i + 1) / kStill;
    Picture frame(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const int u = x + 2 * time, dx = x - (3 + time), dy = y - (height / 2 + time % 3);
        const bool disc = dx * dx + dy * dy < height;
        const std::size_t colour = disc ? 1 : (u * u / 7 + 3 * y) % 16 < 5 ? 2 : (u + y / 2) % 11 < 3 ? 3 : 0;
        set_pixel(frame, x, y, kPalette[colour]);
      }
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

Picture plain_picture(int width, int height, Rgba colour) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) set_pixel(picture, x, y, colour);
  }
  return picture;
}

std::string png_of(const Picture& picture) {
  const auto file = encode_png(picture.view());
  return {file.begin(), file.end()};
}

std::string bmp_of(const Picture& picture) {
  constexpr std::uint32_t kHeader = 54;
  const auto width = static_cast<std::uint32_t>(picture.width()),
             height = static_cast<std::uint32_t>(picture.height());
  const std::uint32_t gap = (4 - width * 3 % 4) % 4;
  const std::uint32_t data = (width * 3 + gap) * height;
  std::string file = "BM";
  for (const std::uint32_t value : {kHeader + data, 0U, kHeader, 40U, width, height})
    append_number(file, value, 4);
  append_number(file, 1, 2);
  append_number(file, 24, 2);
  for (const std::uint32_t value : {0U, data, 0U, 0U, 0U, 0U}) append_number(file, value, 4);
  for (int y = picture.height() - 1; y >= 0; --y) {
    for (int x = 0; x < picture.width(); ++x) {
      const Rgba c = pixel(picture, x, y);
      for (const std::uint8_t channel : {c.b, c.g, c.r}) append_number(file, channel, 1);
    }
    append_number(file, 0, static_cast<int>(gap));
  }
  return file;
}

std::string gif_of(const std::vector<Picture>& frames) {
  std::string file;
  GifFileType* gif = EGifOpen(&file, append_bytes, nullptr);
  ColorMapObject* colours = GifMakeMapObject(static_cast<int>(kPalette.size()), nullptr);
  for (std::size_t i = 0; i < kPalette.size(); ++i)
    colours->Colors[i] = {kPalette[i].r, kPalette[i].g, kPalette[i].b};
  EGifPutScreenDesc(gif, frames[0].width(), frames[0].height(), 8, 0, colours);
  for (const Picture& frame : frames) {
    std::vector<GifByteType> indices = palette_indices(frame);
    EGifPutImageDesc(gif, 0, 0, frame.width(), frame.height(), false, nullptr);
    EGifPutLine(gif, indices.data(), static_cast<int>(indices.size()));
  }
  EGifCloseFile(gif, nullptr);
  GifFreeMapObject(colours);
  return file;
}

Picture decoded(std::string_view file) {
  return decode_still(bytes_of(file)).value_or(Picture());
}

Rgba pixel(const Picture& picture, int x, int y) {
  Rgba colour;
  std::memcpy(&colour, picture.view().pixels + y * picture.pitch() + std::ptrdiff_t{4} * x, sizeof colour);
  return colour;
}

}  // namespace depixel::test
