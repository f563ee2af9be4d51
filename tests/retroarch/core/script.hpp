#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "libdepixel/core/error.hpp"

namespace depixel::test {

enum class PixelFormat { xrgb8888, rgb565, xrgb1555 };

/// A frame in the core's pixel format, as front ends are given it.
struct CoreFrame {
  std::vector<std::uint8_t> bytes;
  unsigned width = 0, height = 0;
  std::size_t pitch = 0;  ///< bytes from one row to the next; what follows a row is not to be read
};

struct Size {
  unsigned width = 0, height = 0;
};

/// What a core says of its frames: their size, and the largest there will be.
struct Geometry {
  Size base, maximum;
};

struct ShowFrame {
  std::size_t index;  ///< in Script::frames
};
struct Duplicate {};
struct SetGeometry {
  Size base;
};
struct SetAvInfo {
  Geometry geometry;
};
struct SetRotation {
  unsigned quarter_turns;  ///< counter-clockwise
};

/// One thing that the core does. ShowFrame and Duplicate end a turn of retro_run().
using Action = std::variant<ShowFrame, Duplicate, SetGeometry, SetAvInfo, SetRotation>;

/// What the core plays, all pictures decoded and converted.
struct Script {
  PixelFormat format = PixelFormat::xrgb8888;
  Geometry geometry;
  std::vector<CoreFrame> frames;
  std::vector<Action> actions;
};

/// Reads a script: one action a line, `#` begins a comment. First come what holds for all of it,
///
///     format xrgb8888|rgb565|0rgb1555    the first unless told otherwise
///     geometry 320x240 [640x480]         base, and maximum if it is larger
///
/// then, in any order,
///
///     show PICTURES [TIMES]      a picture, or the frames of a folder, of a pattern such as %04d.png, or of
///                                a GIF; each has its own size, also one that the geometry does not allow
///     duplicate [TIMES]          the frame before once more, told by giving none
///     padding BYTES              after each row of the pictures that follow, a whole number of pixels
///     resize 160x120             SET_GEOMETRY
///     av_info 640x480 [640x480]  SET_SYSTEM_AV_INFO
///     rotate 0|90|180|270        SET_ROTATION, counter-clockwise
///
/// Paths are relative to the script's folder and hold no spaces. \return an error that names file and line.
tl::expected<Script, Error> load_script(const std::filesystem::path& file);

}  // namespace depixel::test
