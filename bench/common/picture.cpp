#include "bench/common/picture.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "apps/common/decode.hpp"
#include "apps/common/encode_png.hpp"
#include "apps/common/files.hpp"

namespace depixel::bench {

FrameView crop(const FrameView& frame, int x, int y, int width, int height) {
  return {frame.pixels + y * frame.pitch + std::ptrdiff_t{4} * x, width, height, frame.pitch};
}

Picture read_picture(const std::filesystem::path& path) {
  const auto file = read_file(path);
  if (!file) throw std::runtime_error(file.error().message);
  auto picture = decode_still(*file);
  if (!picture) throw std::runtime_error(fmt::format("{} {}", path.string(), picture.error().message));
  return *std::move(picture);
}

void write_png(const Picture& picture, const std::filesystem::path& path) {
  const auto written = write_file(path, encode_png(picture.view()));
  if (!written) throw std::runtime_error(written.error().message);
}

Picture enlarge_nearest(const Picture& picture, int scale) {
  Picture out(picture.width() * scale, picture.height() * scale);
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) out.at(x, y) = picture.at(x / scale, y / scale);
  }
  return out;
}

}  // namespace depixel::bench
