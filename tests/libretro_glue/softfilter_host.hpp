#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "libretro_glue/softfilter_interface.hpp"
#include "tests/support/picture.hpp"

namespace depixel::test {

/// A preset's keys, without the prefix, and their values.
using Preset = std::map<std::string, std::string>;

/// A frame as a core hands it out: words of a format, in rows with room after them.
struct CoreFrame {
  unsigned width = 0, height = 0;
  std::size_t pitch = 0;  ///< bytes
  std::vector<std::uint8_t> bytes;
};

/// Packs a picture's colours to a format. \param padding  bytes after each row.
CoreFrame pack(const Picture& picture, unsigned format, std::size_t padding);
/// The picture that a frame shows, opaque.
Picture unpack(const CoreFrame& frame, unsigned format);

/// The plug-in's library, opened as RetroArch opens it.
class SoftfilterLibrary {
 public:
  explicit SoftfilterLibrary(const std::string& file);
  const softfilter::Implementation& operator*() const { return *implementation_; }
  const softfilter::Implementation* operator->() const { return implementation_; }

 private:
  std::shared_ptr<void> handle_;
  const softfilter::Implementation* implementation_;
};

/// Drives the plug-in as RetroArch does: settings that are gone after create(), a buffer for the largest
/// output, packets on workers of its own, which outlive the filter.
class SoftfilterHost {
 public:
  /// \param library  stays open as long as the host. Throws where the plug-in makes no filter.
  SoftfilterHost(const SoftfilterLibrary& library, const Preset& preset, unsigned format, unsigned max_width,
                 unsigned max_height, unsigned threads = 1);
  ~SoftfilterHost();

  /// Filters a frame. \return the picture in the buffer; it throws where anything beside it was written to.
  Picture filter(const CoreFrame& frame);
  /// The same with another pitch than the frame's.
  Picture filter(const CoreFrame& frame, std::size_t claimed_pitch);

  /// Fills the buffer with what was never drawn.
  void scribble();
  /// Puts the buffer elsewhere, with what is in it.
  void move_buffer();
  /// All that is in the buffer.
  const std::vector<std::uint8_t>& buffer() const { return *buffer_; }

 private:
  static constexpr std::size_t kGuardBytes = 4096;
  static constexpr std::uint8_t kGuard = 0xa5;

  SoftfilterLibrary library_;
  unsigned format_;
  void* data_;
  std::unique_ptr<std::vector<std::uint8_t>> buffer_;
};

}  // namespace depixel::test
