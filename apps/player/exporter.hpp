#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "apps/common/clip.hpp"
#include "filter/frame_filter.hpp"
#include "libdepixel/core/error.hpp"
#include "libdepixel/core/options.hpp"

namespace depixel {

/// A name that nothing in the folder has yet: stem.ending, stem_2.ending and so on.
std::filesystem::path unused_path(const std::filesystem::path& folder, const std::string& stem,
                                  const std::string& ending);

/// Writes a clip's frames as filtered PNG pictures, a frame at a time, so that a window stays alive
/// meanwhile.
class Exporter {
 public:
  /// \param folder  is made. \param scale  output pixels to a source pixel, by axis.
  static tl::expected<Exporter, Error> start(const std::filesystem::path& folder, const Options& options,
                                             glm::dvec2 scale);

  /// Whether every picture is compared with one made from scratch; a difference ends the export.
  void check_incremental(bool wanted) { filter_->check_incremental(wanted); }

  /// Writes the next frame, if it has come. \return whether there may be more.
  tl::expected<bool, Error> write_next(Clip& clip);

  const std::filesystem::path& folder() const { return folder_; }
  int written() const { return written_; }
  /// Of the picture written last.
  const FilterStats& stats() const { return filter_->stats(); }

 private:
  tl::expected<void, Error> write(const ClipFrame& frame);

  std::filesystem::path folder_;
  Options options_;
  glm::dvec2 scale_{1, 1};
  std::unique_ptr<FrameFilter> filter_;
  Picture picture_;
  std::optional<int> next_;
  int written_ = 0;
};

}  // namespace depixel
