#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "apps/common/files.hpp"
#include "apps/common/picture.hpp"
#include "libdepixel/core/error.hpp"

namespace depixel {

/// Whether a stream goes on as YUV4MPEG2 does, told by its first byte, which no picture file has. Nothing is
/// taken from the stream.
bool looks_like_y4m(std::FILE* stream);

/// Reads the frames of a YUV4MPEG2 stream one after the other, as they come: of 8 bits, progressive or taken
/// as such, in BT.601. Chroma is enlarged by repeating, so that streams without subsampling keep every
/// pixel's colour and others blur no edge. Errors' sentences go on from the stream's name. Source: the
/// yuv4mpeg(5) manual of mjpegtools; ITU-R BT.601.
class Y4mReader {
 public:
  /// Reads the stream's header.
  static tl::expected<Y4mReader, Error> open(Stream stream);

  /// The next frame, or none at the stream's end.
  tl::expected<std::optional<Picture>, Error> next();
  /// Passes over a frame. \return false at the stream's end or where it is cut short.
  bool skip();

  double frame_seconds() const { return frame_seconds_; }
  /// Width of a pixel over its height, if the stream says.
  std::optional<double> pixel_aspect() const { return pixel_aspect_; }

 private:
  Y4mReader() = default;
  bool take_parameter(std::string_view parameter);
  bool take_chroma(std::string_view name);
  tl::expected<bool, Error> start_frame();
  void convert(Picture& picture) const;

  Stream stream_;
  int width_ = 0, height_ = 0;
  int chroma_shift_x_ = 1, chroma_shift_y_ = 1;
  bool is_mono_ = false, is_full_range_ = false;
  double frame_seconds_ = 1.0 / 25;
  std::optional<double> pixel_aspect_;
  std::vector<std::uint8_t> planes_;  ///< Y, then U and V, of one frame
};

}  // namespace depixel
