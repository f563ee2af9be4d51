#include <turbojpeg.h>

#include <memory>

#include "apps/common/decode.hpp"

namespace depixel {
namespace {

struct Close {
  void operator()(void* decoder) const { tjDestroy(decoder); }
};

}  // namespace

tl::expected<Picture, Error> decode_jpeg(Bytes file) {
  const auto damaged = tl::unexpected(Error{"is cut short, damaged or of a kind that is not supported."});
  const std::unique_ptr<void, Close> decoder(tjInitDecompress());
  int width = 0, height = 0, subsampling = 0, colourspace = 0;
  if (!decoder || tjDecompressHeader3(decoder.get(), file.data(), file.size(), &width, &height, &subsampling,
                                      &colourspace) != 0) {
    return damaged;
  }
  if (const auto fits = fits_limits(width, height); !fits) return tl::unexpected(fits.error());

  Picture picture(width, height);
  const int status = tjDecompress2(decoder.get(), file.data(), file.size(), picture.row(0), width,
                                   static_cast<int>(picture.pitch()), height, TJPF_RGBA,
                                   TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS);
  if (status != 0) return damaged;
  return picture;
}

}  // namespace depixel
