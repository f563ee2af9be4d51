#include "apps/common/frame_source.hpp"

#include <fmt/core.h>

#include <utility>

#include "apps/common/decode.hpp"
#include "apps/common/files.hpp"

namespace depixel {
namespace {

/// Completes a decoder's sentence with the name of the file.
tl::unexpected<Error> about(const std::filesystem::path& file, const Error& error) {
  const std::string name = file == "-" ? "Standard input" : file.string();
  return tl::unexpected(Error{fmt::format("{} {}", name, error.message)});
}

}  // namespace

std::string output_name(const std::filesystem::path& input) {
  return input == "-" ? "stdin" : input.stem().string();
}

tl::expected<std::optional<NamedFrame>, Error> FrameSource::next() {
  if (frames_read_ == frames_in_file_ && files_opened_ == inputs_.files.size()) return std::nullopt;
  auto frame = frames_read_ < frames_in_file_ ? next_gif_frame() : open_next_file();
  if (!frame) return tl::unexpected(frame.error());
  return std::optional(std::move(*frame));
}

double FrameSource::progress() const {
  const double in_file = frames_in_file_ > 0 ? double(frames_read_) / frames_in_file_ : 1;
  return (double(files_opened_) - 1 + in_file) / double(inputs_.files.size());
}

tl::expected<NamedFrame, Error> FrameSource::open_next_file() {
  const std::filesystem::path& path = inputs_.files[files_opened_++];
  auto file = read_file(path);
  if (!file) return tl::unexpected(file.error());
  if (picture_kind(*file) == PictureKind::gif) {
    auto gif = GifReader::open(std::move(*file));
    if (!gif) return about(path, gif.error());
    frames_in_file_ = gif->frame_count();
    frames_read_ = 0;
    gif_ = std::move(*gif);
    return next_gif_frame();
  }
  auto picture = decode_still(*file);
  if (!picture) return about(path, picture.error());
  frames_in_file_ = frames_read_ = 1;
  return NamedFrame{std::move(*picture), output_name(path)};
}

tl::expected<NamedFrame, Error> FrameSource::next_gif_frame() {
  const std::filesystem::path& path = inputs_.files[files_opened_ - 1];
  auto picture = gif_->next();
  if (!picture) return about(path, picture.error());
  std::string name = output_name(path);
  if (frames_in_file_ > 1) name += fmt::format("_{:04}", frames_read_);
  ++frames_read_;
  return NamedFrame{std::move(*picture), std::move(name)};
}

}  // namespace depixel
