#include "apps/player/exporter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "apps/common/about_frame.hpp"
#include "apps/common/draw_kept.hpp"
#include "apps/common/encode_png.hpp"
#include "apps/common/files.hpp"
#include "apps/common/limits.hpp"

namespace depixel {

std::filesystem::path unused_path(const std::filesystem::path& folder, const std::string& stem,
                                  const std::string& ending) {
  std::error_code ignored;
  std::filesystem::path path = folder / (stem + ending);
  for (int i = 2; std::filesystem::exists(path, ignored); ++i) {
    path = folder / fmt::format("{}_{}{}", stem, i, ending);
  }
  return path;
}

tl::expected<Exporter, Error> Exporter::start(const std::filesystem::path& folder, const Options& options,
                                              glm::dvec2 scale) {
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (error) {
    return tl::unexpected(
        Error{fmt::format("The folder {} cannot be made: {}.", folder.string(), error.message())});
  }
  Exporter exporter;
  exporter.folder_ = folder;
  exporter.options_ = options;
  exporter.scale_ = scale;
  exporter.filter_ = FrameFilter::cpu();
  return exporter;
}

tl::expected<bool, Error> Exporter::write_next(Clip& clip) {
  const int index = std::max(next_.value_or(0), clip.first_frame());
  const auto count = clip.frame_count();
  if (count && index >= *count) return false;
  if (!clip.has_frame(index)) return true;
  const auto frame = clip.frame(index);
  if (!frame) return tl::unexpected(frame.error());
  if (auto written = write(**frame); !written) {
    return tl::unexpected(about_frame((*frame)->name, written.error()));
  }
  next_ = index + 1;
  ++written_;
  return true;
}

tl::expected<void, Error> Exporter::write(const ClipFrame& frame) {
  const Picture& source = frame.picture;
  const double width = std::round(source.width() * scale_.x), height = std::round(source.height() * scale_.y);
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide ||
      width * height > double(kMaxOutputPixels)) {
    return tl::unexpected(Error{fmt::format("Pictures of {} x {} pixels cannot be written.", width, height)});
  }
  if (auto submitted = filter_->submit(source.view(), options_); !submitted) return submitted;
  if (auto drawn = draw_kept(*filter_, picture_, static_cast<int>(width), static_cast<int>(height)); !drawn) {
    return drawn;
  }
  return write_file(unused_path(folder_, frame.name, ".png"), encode_png(picture_.view()));
}

}  // namespace depixel
