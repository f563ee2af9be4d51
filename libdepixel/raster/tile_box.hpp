#pragma once

#include <cstdint>

namespace depixel {

/// A rectangle of tiles, as of the source's pixels: columns west .. east - 1, rows north .. south - 1.
struct TileBox {
  int west, north, east, south;

  int width() const { return east - west; }
  int height() const { return south - north; }
  std::int64_t area() const { return std::int64_t{width()} * height(); }
};

}  // namespace depixel
