#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench/common/picture.hpp"
#include "libretro_glue/softfilter_interface.hpp"

namespace depixel::bench {

/// An opened library with one of RetroArch's video filters.
struct SoftFilterLibrary {
  std::string name;              ///< the filter's short_ident
  std::shared_ptr<void> handle;  ///< keeps the library open
  const softfilter::Implementation* implementation = nullptr;
};

/// Opens a filter's library. Throws std::runtime_error where it is none.
SoftFilterLibrary open_softfilter(const std::filesystem::path& library);

/// The shared libraries in a folder, in order of their names; none where there is no such folder.
std::vector<std::filesystem::path> list_softfilters(const std::filesystem::path& folder);

/// One of RetroArch's video filters with its default settings, in this process and on one thread, on frames
/// of one size. Enlarges by its own factor. Alpha is dropped; filters that know 16 bits a pixel only get
/// those.
class SoftFilter {
 public:
  /// Throws std::runtime_error where the filter refuses.
  SoftFilter(const SoftFilterLibrary& library, int width, int height);

  const std::string& name() const { return library_.name; }
  /// Copies a frame of the filter's size in.
  void load(const FrameView& frame);
  /// Filters the loaded frame: the part to be timed.
  void run();
  /// The size of what run() has made: the frame's where the filter passes frames of this size on unchanged.
  int out_width() const { return static_cast<int>(out_width_); }
  int out_height() const { return static_cast<int>(out_height_); }

 private:
  struct Destroy {
    void (*destroy)(void* data);
    void operator()(void* data) const { destroy(data); }
  };

  SoftFilterLibrary library_;
  unsigned width_, height_, out_width_ = 0, out_height_ = 0;
  unsigned in_format_, out_format_;
  std::unique_ptr<void, Destroy> data_;
  std::vector<softfilter::Packet> packets_;
  std::vector<std::uint8_t> input_, output_;  ///< with a margin of some rows above and below
};

}  // namespace depixel::bench
