#include "apps/common/frame_source.hpp"

#include <fmt/core.h>

#include <utility>

#include "apps/common/decode.hpp"
#include "apps/common/files.hpp"

namespace depixel {

std::string output_name(const std::filesystem::path& input) {
  return input == "-" ? "stdin" : input.stem().string();
}

tl::expected<std::optional<NamedFrame>, Error> FrameSource::next() {
  for (;;) {
    auto frame = next_in_file();
    if (!frame) return about_file(inputs_.files[files_opened_ - 1], frame.error());
    if (*frame) return frame;
    if (files_opened_ == inputs_.files.size()) return std::nullopt;
    if (auto opened = open_next_file(); !opened) return tl::unexpected(opened.error());
  }
}

double FrameSource::progress() const {
  const double in_file = frames_in_file_ > 0 ? double(frames_read_) / frames_in_file_ : 0;
  return (double(files_opened_) - 1 + in_file) / double(inputs_.files.size());
}

tl::expected<void, Error> FrameSource::open_next_file() {
  const std::filesystem::path& path = inputs_.files[files_opened_++];
  frames_read_ = 0;
  auto stream = open_stream(path);
  if (!stream) return tl::unexpected(stream.error());
  if (looks_like_y4m(stream->get())) {
    auto y4m = Y4mReader::open(std::move(*stream));
    if (!y4m) return about_file(path, y4m.error());
    frames_in_file_ = kUnknown;
    file_ = std::move(*y4m);
    return {};
  }
  auto file = read_rest(stream->get(), path);
  if (!file) return tl::unexpected(file.error());
  if (picture_kind(*file) == PictureKind::gif) {
    auto gif = GifReader::open(std::move(*file));
    if (!gif) return about_file(path, gif.error());
    frames_in_file_ = gif->frame_count();
    file_ = std::move(*gif);
    return {};
  }
  auto picture = decode_still(*file);
  if (!picture) return about_file(path, picture.error());
  frames_in_file_ = 1;
  file_ = std::move(*picture);
  return {};
}

/// The next frame of the open file, or none after its last. The error's sentence goes on from the file's
/// name.
tl::expected<std::optional<NamedFrame>, Error> FrameSource::next_in_file() {
  if (std::holds_alternative<std::monostate>(file_)) return std::nullopt;
  std::string name = output_name(inputs_.files[files_opened_ - 1]);
  if (frames_in_file_ != 1) name += fmt::format("_{:04}", frames_read_);
  const auto named = [&](Picture& picture) {
    ++frames_read_;
    return std::optional(NamedFrame{std::move(picture), std::move(name)});
  };
  if (auto* still = std::get_if<Picture>(&file_)) {
    auto frame = named(*still);
    file_ = {};
    return frame;
  }
  if (auto* gif = std::get_if<GifReader>(&file_)) {
    if (frames_read_ == frames_in_file_) return std::nullopt;
    auto picture = gif->next();
    if (!picture) return tl::unexpected(picture.error());
    return named(*picture);
  }
  auto picture = std::get<Y4mReader>(file_).next();
  if (!picture) return tl::unexpected(picture.error());
  if (*picture) return named(**picture);
  if (frames_read_ == 0) return tl::unexpected(Error{"holds no frames."});
  file_ = {};
  return std::nullopt;
}

}  // namespace depixel
