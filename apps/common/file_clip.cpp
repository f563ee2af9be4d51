#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <variant>
#include <vector>

#include "apps/common/clip.hpp"
#include "apps/common/decode.hpp"
#include "apps/common/files.hpp"
#include "apps/common/frame_source.hpp"
#include "apps/common/gif_reader.hpp"
#include "apps/common/y4m_reader.hpp"

namespace depixel {
namespace {

constexpr double kStillSeconds = 1.0 / 60;  ///< of a picture in a sequence: consoles' frames

class FileClip final : public Clip {
 public:
  FileClip(const Inputs& inputs, std::size_t budget_bytes)
      : files_(inputs.files), budget_bytes_(budget_bytes) {}

  /// Finds out where each file's frames begin.
  tl::expected<void, Error> count() {
    for (const auto& file : files_) {
      first_.push_back(count_);
      const auto frames = count_in(file);
      if (!frames) return tl::unexpected(frames.error());
      count_ += *frames;
    }
    return {};
  }

  std::optional<int> frame_count() override { return count_; }
  int first_frame() override { return 0; }
  bool has_frame(int index) override { return index >= 0 && index < count_; }
  std::optional<double> pixel_aspect() override { return pixel_aspect_; }

  tl::expected<std::shared_ptr<const ClipFrame>, Error> frame(int index) override {
    if (const auto kept = kept_.find(index); kept != kept_.end()) return kept->second;
    const auto file = std::size_t(std::upper_bound(first_.begin(), first_.end(), index) - first_.begin()) - 1;
    if (file != open_file_ || index < next_) {
      if (auto opened = open(file); !opened) return about_file(files_[file], opened.error());
    }
    for (;; ++next_) {
      auto frame = read_next();
      if (!frame) return about_file(files_[file], frame.error());
      keep(next_, *frame, index);
      if (next_ == index) {
        ++next_;
        return *frame;
      }
    }
  }

 private:
  tl::expected<int, Error> count_in(const std::filesystem::path& path) {
    auto stream = open_stream(path);
    if (!stream) return tl::unexpected(stream.error());
    if (looks_like_y4m(stream->get())) {
      auto y4m = Y4mReader::open(std::move(*stream));
      if (!y4m) return about_file(path, y4m.error());
      if (!pixel_aspect_) pixel_aspect_ = y4m->pixel_aspect();
      int frames = 0;
      while (y4m->skip()) ++frames;
      if (frames == 0) return about_file(path, {"holds no whole frame."});
      return frames;
    }
    std::array<std::uint8_t, 8> start{};
    const std::size_t size = std::fread(start.data(), 1, start.size(), stream->get());
    if (picture_kind({start.data(), size}) != PictureKind::gif) return 1;
    auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto gif = GifReader::open(std::move(*bytes));
    if (!gif) return about_file(path, gif.error());
    return gif->frame_count();
  }

  /// Starts a file from its first frame. The error's sentence goes on from its name.
  tl::expected<void, Error> open(std::size_t file) {
    open_file_.reset();
    next_ = first_[file];
    auto stream = open_stream(files_[file]);
    if (!stream) return tl::unexpected(Error{"cannot be read any more."});
    if (looks_like_y4m(stream->get())) {
      auto y4m = Y4mReader::open(std::move(*stream));
      if (!y4m) return tl::unexpected(y4m.error());
      reader_ = std::move(*y4m);
    } else {
      auto bytes = read_rest(stream->get(), files_[file]);
      if (!bytes) return tl::unexpected(Error{"cannot be read any more."});
      if (picture_kind(*bytes) == PictureKind::gif) {
        auto gif = GifReader::open(std::move(*bytes));
        if (!gif) return tl::unexpected(gif.error());
        reader_ = std::move(*gif);
      } else {
        reader_ = std::move(*bytes);
      }
    }
    open_file_ = file;
    return {};
  }

  tl::expected<std::shared_ptr<const ClipFrame>, Error> read_next() {
    ClipFrame frame{{}, output_name(files_[*open_file_]), kStillSeconds};
    const std::size_t after = *open_file_ + 1;
    const int frames = (after < first_.size() ? first_[after] : count_) - first_[*open_file_];
    if (frames > 1) frame.name += fmt::format("_{:04}", next_ - first_[*open_file_]);
    if (auto* y4m = std::get_if<Y4mReader>(&reader_)) {
      auto picture = y4m->next();
      if (!picture) return tl::unexpected(picture.error());
      if (!*picture) return tl::unexpected(Error{"has become shorter."});
      frame.picture = std::move(**picture);
      frame.seconds = y4m->frame_seconds();
    } else if (auto* gif = std::get_if<GifReader>(&reader_)) {
      auto picture = gif->next();
      if (!picture) return tl::unexpected(picture.error());
      frame.picture = std::move(*picture);
      frame.seconds = gif->frame_seconds();
    } else {
      auto picture = decode_still(std::get<std::vector<std::uint8_t>>(reader_));
      open_file_.reset();
      if (!picture) return tl::unexpected(picture.error());
      frame.picture = std::move(*picture);
    }
    return std::make_shared<const ClipFrame>(std::move(frame));
  }

  /// Keeps a frame; those farthest from the one asked for go where the budget is used up.
  void keep(int index, const std::shared_ptr<const ClipFrame>& frame, int asked_for) {
    kept_bytes_ += kept_.emplace(index, frame).second ? bytes_of_frame(*frame) : 0;
    while (kept_bytes_ > budget_bytes_ && kept_.size() > 1) {
      const auto first = kept_.begin(), last = std::prev(kept_.end());
      const auto farthest = asked_for - first->first > last->first - asked_for ? first : last;
      kept_bytes_ -= bytes_of_frame(*farthest->second);
      kept_.erase(farthest);
    }
  }

  static std::size_t bytes_of_frame(const ClipFrame& frame) {
    return sizeof(Rgba) * frame.picture.pixel_count();
  }

  std::vector<std::filesystem::path> files_;
  std::size_t budget_bytes_;
  std::vector<int> first_;  ///< frame of each file
  int count_ = 0;
  std::optional<double> pixel_aspect_;

  std::map<int, std::shared_ptr<const ClipFrame>> kept_;
  std::size_t kept_bytes_ = 0;
  std::variant<std::vector<std::uint8_t>, GifReader, Y4mReader> reader_;  ///< of the open file
  std::optional<std::size_t> open_file_;
  int next_ = 0;  ///< the frame that the reader gives next
};

}  // namespace

tl::expected<std::unique_ptr<Clip>, Error> open_file_clip(const Inputs& inputs, std::size_t budget_bytes) {
  auto clip = std::make_unique<FileClip>(inputs, budget_bytes);
  if (auto counted = clip->count(); !counted) return tl::unexpected(counted.error());
  return clip;
}

}  // namespace depixel
