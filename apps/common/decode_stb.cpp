// PNG and BMP through stb_image, and PNG writing through stb_image_write. Its GIF and JPEG decoders are left
// out: in the version of Debian 12 both read out of bounds on damaged files (CVE-2023-45661, CVE-2022-28042).

#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "apps/common/decode.hpp"
#include "apps/common/encode_png.hpp"
#include "apps/common/limits.hpp"

namespace {

/// The largest block that stb_image may ask for while a picture is decoded: a small deflate stream can claim
/// gigabytes.
thread_local std::size_t largest_block = 0;

void* allocate(std::size_t size) {
  return size <= largest_block ? std::malloc(size) : nullptr;
}
void* reallocate(void* block, std::size_t size) {
  return size <= largest_block ? std::realloc(block, size) : nullptr;
}

/// zlib instead of stb_image_write's own compressor: three times as fast, and a tenth smaller.
/// \return a block of `malloc`, or nullptr.
unsigned char* compress_with_zlib(unsigned char* data, int size, int* compressed_size, int /*quality*/) {
  constexpr int kLevel = 3;
  uLongf length = compressBound(static_cast<uLong>(size));
  auto* compressed = static_cast<unsigned char*>(std::malloc(length));
  if (compressed != nullptr) compress2(compressed, &length, data, static_cast<uLong>(size), kLevel);
  *compressed_size = static_cast<int>(length);
  return compressed;
}

}  // namespace

#define STBI_MALLOC(size) allocate(size)
#define STBI_REALLOC(block, size) reallocate(block, size)
#define STBI_FREE(block) std::free(block)
#define STBI_ONLY_PNG
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

#define STBIW_ZLIB_COMPRESS compress_with_zlib
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace depixel {
namespace {

/// Hands a file in memory to stb_image and notes whether it asked for more than there is.
struct Feed {
  Bytes rest;
  bool starved = false;

  static int read(void* user, char* to, int size) {
    auto& feed = *static_cast<Feed*>(user);
    const std::size_t count = std::min(static_cast<std::size_t>(size), feed.rest.size());
    feed.starved |= feed.rest.empty();
    std::copy_n(feed.rest.begin(), count, reinterpret_cast<std::uint8_t*>(to));
    feed.rest = feed.rest.subspan(count);
    return static_cast<int>(count);
  }
  static void skip(void* user, int size) {
    auto& feed = *static_cast<Feed*>(user);
    const std::size_t wanted = static_cast<std::size_t>(std::max(size, 0));
    feed.starved |= wanted > feed.rest.size();
    feed.rest = feed.rest.subspan(std::min(wanted, feed.rest.size()));
  }
  static int eof(void* user) { return static_cast<Feed*>(user)->rest.empty() ? 1 : 0; }
};

constexpr stbi_io_callbacks kFeedCallbacks{Feed::read, Feed::skip, Feed::eof};

/// Blocks of this size do for any honest picture: 16 bits a channel, doubled by the interlaced form, and the
/// file.
std::size_t honest_block(int width, int height, std::size_t file_bytes) {
  constexpr std::size_t kSmall = std::size_t{1} << 20;
  return kSmall + 16 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + 2 * file_bytes;
}

/// Checks the size in a PNG's first chunk, since stb_image does not tell why it refuses one.
tl::expected<void, Error> png_size_fits(Bytes file) {
  constexpr std::size_t kWidthAt = 16, kHeightAt = 20, kEnd = 24;
  if (file.size() < kEnd) return tl::unexpected(Error{"is cut short."});
  const auto number = [&](std::size_t at) {
    return std::int64_t{file[at]} << 24 | file[at + 1] << 16 | file[at + 2] << 8 | file[at + 3];
  };
  return fits_limits(number(kWidthAt), number(kHeightAt));
}

}  // namespace

tl::expected<Picture, Error> decode_with_stb(Bytes file) {
  if (picture_kind(file) == PictureKind::png) {
    if (const auto fits = png_size_fits(file); !fits) return tl::unexpected(fits.error());
  }
  int width = 0, height = 0, channels = 0;
  largest_block = honest_block(0, 0, file.size());
  if (stbi_info_from_memory(file.data(), static_cast<int>(file.size()), &width, &height, &channels) == 0) {
    return tl::unexpected(Error{"is cut short or damaged, or of a kind that is not supported."});
  }
  if (const auto fits = fits_limits(width, height); !fits) return tl::unexpected(fits.error());

  largest_block = honest_block(width, height, file.size());
  Feed feed{file};
  stbi_uc* pixels = stbi_load_from_callbacks(&kFeedCallbacks, &feed, &width, &height, &channels, 4);
  if (pixels == nullptr || feed.starved) {
    stbi_image_free(pixels);
    return tl::unexpected(
        Error{feed.starved ? "is cut short." : "is damaged or of a kind that is not supported."});
  }
  Picture picture(width, height);
  std::memcpy(picture.row(0), pixels,
              static_cast<std::size_t>(picture.pitch()) * static_cast<std::size_t>(height));
  stbi_image_free(pixels);
  return picture;
}

std::vector<std::uint8_t> encode_png(const FrameView& picture) {
  std::vector<std::uint8_t> file;
  const auto append = [](void* user, void* data, int size) {
    auto& bytes = *static_cast<std::vector<std::uint8_t>*>(user);
    const auto* begin = static_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
  };
  stbi_write_force_png_filter = 0;  // areas of one colour compress best as they are
  stbi_write_png_to_func(append, &file, picture.width, picture.height, 4, picture.pixels,
                         static_cast<int>(picture.pitch));
  return file;
}

}  // namespace depixel
