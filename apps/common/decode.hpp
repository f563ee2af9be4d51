#pragma once

#include <cstdint>
#include <span>
#include <tl/expected.hpp>

#include "apps/common/picture.hpp"
#include "libdepixel/core/error.hpp"

namespace depixel {

using Bytes = std::span<const std::uint8_t>;

enum class PictureKind { png, bmp, jpeg, gif, unknown };

/// Tells the kind of a picture file by its first bytes; names do not matter.
PictureKind picture_kind(Bytes file);

/// Decodes a PNG, BMP or JPEG file; a GIF may be animated and is read by GifReader.
/// A file that ends early, is damaged, or holds a picture of a size that fits_limits() refuses, is an error.
/// Memory stays in proportion to the picture's size and the file's, whatever the file claims.
/// The error's sentence goes on from the file's name: "is cut short."
tl::expected<Picture, Error> decode_still(Bytes file);

/// Refuses pictures without pixels and those beyond kMaxSide and kMaxPixels; to be asked before decoding.
tl::expected<void, Error> fits_limits(std::int64_t width, std::int64_t height);

// The decoders behind decode_still(), one for each library.
tl::expected<Picture, Error> decode_with_stb(Bytes file);  ///< PNG and BMP
tl::expected<Picture, Error> decode_jpeg(Bytes file);

}  // namespace depixel
