#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "filter/frame_filter.hpp"
#include "filter/host/gl_thread.hpp"
#include "filter/host/host_frame.hpp"
#include "filter/host/host_settings.hpp"

namespace depixel {

/// The filter as an emulator's plug-in runs it: the host's frames in, opaque pictures of XRGB8888 words out,
/// in the host's own memory.
///
/// The host keeps its buffer's contents from frame to frame: where address, pitch and size are those of the
/// call before, only what changed is written. May be called from any thread, by one at a time.
class HostFilter {
 public:
  /// Hosts make square textures of powers of two for the largest output; these are the largest that can be
  /// relied on.
  static constexpr int kMaxOutputSide = 16384;

  /// \param max_width, max_height  of frames: at least 1. Where the scale makes more of them than
  ///                               kMaxOutputSide, it is lowered.
  /// \param warn  is told what is not as the settings want it, now and later.
  HostFilter(const HostSettings& settings, int max_width, int max_height, Warn warn);

  struct Size {
    int width, height;
    friend bool operator==(const Size&, const Size&) = default;
  };
  /// Of the picture that is made of a frame. A frame is taken as no larger than the largest, and no smaller
  /// than a pixel.
  Size output_size(int width, int height) const;

  /// Draws a frame; of one that is larger than the largest, its top left.
  /// \param frame       where its pitch is less than a row, as hosts have it after a duplicate, nothing is
  ///                    known of its rows, and the frame before is drawn again if it was as large.
  /// \param output      output_size() pixels.
  /// \param pitch       bytes; where they are fewer than a row, nothing is drawn.
  void draw(HostFrame frame, void* output, std::size_t pitch);

 private:
  void choose_backend();
  tl::expected<void, Error> draw_by(FrameFilter& filter, const std::optional<FrameView>& frame,
                                    const PictureView& picture) const;
  tl::expected<void, Error> draw_by_backend(const std::optional<FrameView>& frame,
                                            const PictureView& picture);
  void warn_once(const std::string& sentence);

  HostSettings settings_;
  int max_width_, max_height_;
  Warn warn_;
  bool has_warned_ = false;
  std::unique_ptr<FrameFilter> cpu_;
  std::unique_ptr<GlThread> gl_;
  std::vector<std::uint8_t> rgba_;  ///< the frame drawn last
  Size size_{0, 0};                 ///< of it
};

}  // namespace depixel
