#include "apps/common/decode.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "apps/common/files.hpp"
#include "apps/common/limits.hpp"

namespace depixel {

PictureKind picture_kind(Bytes file) {
  using namespace std::string_view_literals;
  constexpr std::array<std::pair<std::string_view, PictureKind>, 4> kSignatures{{
      {"\x89PNG\r\n\x1a\n"sv, PictureKind::png},
      {"BM"sv, PictureKind::bmp},
      {"\xff\xd8\xff"sv, PictureKind::jpeg},
      {"GIF8"sv, PictureKind::gif},
  }};
  for (const auto& [signature, kind] : kSignatures) {
    const Bytes expected = bytes_of(signature);
    if (file.size() >= expected.size() && std::equal(expected.begin(), expected.end(), file.begin()))
      return kind;
  }
  return PictureKind::unknown;
}

tl::expected<Picture, Error> decode_still(Bytes file) {
  switch (picture_kind(file)) {
    case PictureKind::png:
    case PictureKind::bmp:
      return decode_with_stb(file);
    case PictureKind::jpeg:
      return decode_jpeg(file);
    default:
      return tl::unexpected(Error{
          file.empty() ? "is empty." : "is not a picture that can be read: PNG, BMP, JPEG, GIF or Y4M."});
  }
}

tl::expected<void, Error> fits_limits(std::int64_t width, std::int64_t height) {
  if (width <= 0 || height <= 0) return tl::unexpected(Error{"holds a picture without pixels."});
  if (width <= kMaxSide && height <= kMaxSide && width * height <= kMaxPixels) return {};
  return tl::unexpected(Error{fmt::format(
      "holds a picture of {} x {} pixels: too large, at most {} a side and {} in all can be read.", width,
      height, kMaxSide, kMaxPixels)});
}

}  // namespace depixel
