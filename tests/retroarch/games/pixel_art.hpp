#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace depixel::test {

/// A face of 16 x 16 pixels of four colours, numbered by characters: what our games show.
constexpr std::array<std::string_view, 16> kFace{
    "................", ".....111111.....", "...1122222211...", "..122222222221..",
    ".12222222222221.", ".12233222233221.", "1222332222332221", "1222222222222221",
    "1222222222222221", "1223222222223221", ".12232222223221.", ".12223333332221.",
    "..122222222221..", "...1122222211...", ".....111111.....", "................"};

/// The number, 0..3, of a pixel of the face, which repeats all over.
constexpr unsigned face_colour(int x, int y) {
  const char c = kFace[static_cast<std::size_t>(y) % 16][static_cast<std::size_t>(x) % 16];
  return c == '.' ? 0U : static_cast<unsigned>(c - '0');
}

/// Eight rows of a tile of the face as the consoles store them: for every row a byte of the colours' low
/// bits, then one of their high bits; the leftmost pixel is the highest bit.
inline std::vector<std::uint8_t> face_tile(int tile_x, int tile_y) {
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < 8; ++y) {
    for (const unsigned plane : {0U, 1U}) {
      unsigned byte = 0;
      for (int x = 0; x < 8; ++x)
        byte = byte * 2 + (face_colour(8 * tile_x + x, 8 * tile_y + y) >> plane & 1);
      bytes.push_back(static_cast<std::uint8_t>(byte));
    }
  }
  return bytes;
}

}  // namespace depixel::test
