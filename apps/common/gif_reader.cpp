#include "apps/common/gif_reader.hpp"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <utility>

#include "apps/common/decode.hpp"

namespace depixel {
namespace {

/// The rows of an interlaced image come in four passes.
struct Pass {
  int first, step;
};
constexpr std::array<Pass, 4> kInterlaced{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
constexpr std::array<Pass, 1> kStraight{{{0, 1}}};

std::span<const Pass> passes_of(const GifImageDesc& image) {
  if (image.Interlace) return kInterlaced;
  return kStraight;
}

bool skip_pixels(GifFileType* gif) {
  int code_size = 0;
  GifByteType* block = nullptr;
  if (DGifGetCode(gif, &code_size, &block) == GIF_ERROR) return false;
  while (block != nullptr) {
    if (DGifGetCodeNext(gif, &block) == GIF_ERROR) return false;
  }
  return true;
}

}  // namespace

void GifReader::Close::operator()(GifFileType* gif) const {
  DGifCloseFile(gif, nullptr);
}

int GifReader::feed(GifFileType* gif, std::uint8_t* to, int size) {
  auto& cursor = *static_cast<Cursor*>(gif->UserData);
  const std::size_t count = std::min(static_cast<std::size_t>(size), cursor.file.size() - cursor.position);
  std::copy_n(cursor.file.begin() + static_cast<std::ptrdiff_t>(cursor.position), count, to);
  cursor.position += count;
  return static_cast<int>(count);
}

tl::expected<GifReader, Error> GifReader::open(std::vector<std::uint8_t> file) {
  const auto damaged = tl::unexpected(Error{"is cut short or damaged."});
  GifReader reader;
  reader.cursor_ = std::make_unique<Cursor>();
  reader.cursor_->file = std::move(file);
  if (!reader.rewind()) return damaged;
  const int width = reader.gif_->SWidth, height = reader.gif_->SHeight;
  if (const auto fits = fits_limits(width, height); !fits) return tl::unexpected(fits.error());

  for (Control control; reader.skip_to_image(control); ++reader.frame_count_) {
    const GifImageDesc& image = reader.gif_->Image;
    if (!fits_limits(image.Width, image.Height) || !skip_pixels(reader.gif_.get())) return damaged;
  }
  if (reader.gif_->Error != 0 || reader.frame_count_ == 0 || !reader.rewind()) return damaged;
  reader.canvas_ = Picture(width, height);
  return reader;
}

tl::expected<Picture, Error> GifReader::next() {
  dispose();
  if (!skip_to_image(control_) || !draw_image(control_)) {
    return tl::unexpected(Error{"is damaged: a frame cannot be decoded."});
  }
  return canvas_;
}

double GifReader::frame_seconds() const {
  constexpr int kShortest = 2, kUsual = 10;  // as browsers do: shorter delays are not meant
  return (control_.delay < kShortest ? kUsual : control_.delay) / 100.0;
}

bool GifReader::rewind() {
  cursor_->position = 0;
  gif_.reset(DGifOpen(cursor_.get(), &GifReader::feed, nullptr));
  return gif_ != nullptr;
}

/// Goes on to the next image and reads its description. \return false at the end or where the file is
/// damaged.
bool GifReader::skip_to_image(Control& control) {
  control = {};
  GifRecordType record = UNDEFINED_RECORD_TYPE;
  while (DGifGetRecordType(gif_.get(), &record) != GIF_ERROR && record != TERMINATE_RECORD_TYPE) {
    if (record == IMAGE_DESC_RECORD_TYPE) return DGifGetImageDesc(gif_.get()) != GIF_ERROR;
    int code = 0;
    GifByteType* block = nullptr;
    if (DGifGetExtension(gif_.get(), &code, &block) == GIF_ERROR) return false;
    while (block != nullptr) {
      GraphicsControlBlock shown;
      if (code == GRAPHICS_EXT_FUNC_CODE && DGifExtensionToGCB(block[0], block + 1, &shown) != GIF_ERROR) {
        control = {shown.TransparentColor, shown.DisposalMode, shown.DelayTime};
      }
      if (DGifGetExtensionNext(gif_.get(), &block) == GIF_ERROR) return false;
    }
  }
  return false;
}

bool GifReader::draw_image(const Control& control) {
  const GifImageDesc& image = gif_->Image;
  if (control.disposal == DISPOSE_PREVIOUS) before_ = canvas_;
  indices_.resize(static_cast<std::size_t>(image.Width));
  for (const Pass pass : passes_of(image)) {
    for (int row = pass.first; row < image.Height; row += pass.step) {
      if (!draw_row(row, control.transparent_index)) return false;
    }
  }
  return true;
}

/// Decodes a row of the image and lays what lies on the canvas over it.
bool GifReader::draw_row(int row, int transparent_index) {
  const GifImageDesc& image = gif_->Image;
  const ColorMapObject* colours = image.ColorMap != nullptr ? image.ColorMap : gif_->SColorMap;
  if (colours == nullptr || DGifGetLine(gif_.get(), indices_.data(), image.Width) == GIF_ERROR) return false;
  const int y = image.Top + row;
  if (y < 0 || y >= canvas_.height()) return true;

  const int first = std::max(0, -image.Left), last = std::min(image.Width, canvas_.width() - image.Left);
  std::uint8_t* canvas_row = canvas_.row(y);
  for (int x = first; x < last; ++x) {
    const int index = indices_[static_cast<std::size_t>(x)];
    if (index == transparent_index || index >= colours->ColorCount) continue;
    const GifColorType colour = colours->Colors[index];
    const std::array<std::uint8_t, 4> rgba{colour.Red, colour.Green, colour.Blue, 255};
    std::memcpy(canvas_row + std::ptrdiff_t{4} * (image.Left + x), rgba.data(), rgba.size());
  }
  return true;
}

/// Does what the frame drawn last asks for before the next is drawn.
void GifReader::dispose() {
  const GifImageDesc& image = gif_->Image;
  if (control_.disposal == DISPOSE_PREVIOUS) std::swap(canvas_, before_);
  if (control_.disposal != DISPOSE_BACKGROUND) return;
  const int left = std::clamp(image.Left, 0, canvas_.width());
  const int right = std::clamp(image.Left + image.Width, left, canvas_.width());
  const int bottom = std::min(image.Top + image.Height, canvas_.height());
  for (int y = std::max(image.Top, 0); y < bottom; ++y) {
    std::fill(canvas_.row(y) + std::ptrdiff_t{4} * left, canvas_.row(y) + std::ptrdiff_t{4} * right,
              std::uint8_t{0});
  }
}

}  // namespace depixel
