#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/picture.hpp"

namespace depixel::test {

/// The colours that characters stand for in pictures written as text. Neighbouring greys are alike enough to
/// merge, and all that are at most three apart to make a shading contour.
constexpr std::array<std::pair<char, Rgba>, 26> kPalette{{
    {'.', {255, 255, 255, 255}}, {'#', {0, 0, 0, 255}},       {'_', {0, 0, 0, 0}},
    {'r', {220, 30, 30, 255}},   {'g', {30, 190, 60, 255}},   {'b', {40, 60, 230, 255}},
    {'y', {250, 220, 40, 255}},  {'c', {40, 210, 220, 255}},  {'m', {210, 50, 200, 255}},
    {'R', {220, 30, 30, 128}},   {'G', {30, 190, 60, 128}},   {'B', {40, 60, 230, 128}},
    {'w', {255, 255, 255, 128}}, {'k', {0, 0, 0, 128}},       {'f', {255, 255, 255, 1}},
    {'e', {1, 0, 0, 255}},       {'0', {20, 20, 20, 255}},    {'1', {45, 45, 45, 255}},
    {'2', {70, 70, 70, 255}},    {'3', {95, 95, 95, 255}},    {'4', {120, 120, 120, 255}},
    {'5', {145, 145, 145, 255}}, {'6', {170, 170, 170, 255}}, {'7', {195, 195, 195, 255}},
    {'8', {220, 220, 220, 255}}, {'9', {245, 245, 245, 255}},
}};

/// Levels of Y, in 1/1000, by which neighbouring greys of the palette are alike: those of hqx.
constexpr int kHqxLuma = 48'000;

/// Colour of a palette character; magenta of alpha 3 for what is not in the palette.
constexpr Rgba palette_colour(char character) {
  for (const auto& [name, colour] : kPalette) {
    if (name == character) return colour;
  }
  return {255, 0, 255, 3};
}

constexpr char palette_character(Rgba c) {
  for (const auto& [name, colour] : kPalette) {
    if (normalized(colour) == normalized(c)) return name;
  }
  return '?';
}

/// A picture of palette characters, one string a row, all of one length.
inline Picture ascii_picture(const std::vector<std::string_view>& rows) {
  Picture picture(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) picture.at(x, y) = palette_colour(rows[y][x]);
  }
  return picture;
}

/// Prints a picture as the call that makes it, so that a failing case can be pasted into a test.
inline std::ostream& operator<<(std::ostream& out, const Picture& picture) {
  out << "ascii_picture({";
  for (int y = 0; y < picture.height; ++y) {
    out << (y == 0 ? "\"" : ",\n               \"");
    for (int x = 0; x < picture.width; ++x) out << palette_character(picture.at(x, y));
    out << '"';
  }
  return out << "})";
}

}  // namespace depixel::test
