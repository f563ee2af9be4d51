#include "filter/host/host_filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace depixel {

HostFilter::HostFilter(const HostSettings& settings, int max_width, int max_height, Warn warn)
    : settings_(settings), max_width_(max_width), max_height_(max_height), warn_(std::move(warn)) {
  const double most = static_cast<double>(kMaxOutputSide) / std::max(max_width, max_height);
  if (settings_.scale > most) {
    settings_.scale = most;
    warn_(fmt::format(
        "Frames of up to {} x {} pixels are drawn at {:.3g} times their size instead of {:.3g}, the most "
        "that textures hold.",
        max_width, max_height, settings_.scale, settings.scale));
  }
  choose_backend();
}

void HostFilter::choose_backend() {
  if (settings_.backend != HostBackend::cpu) {
    auto gl = GlThread::start();
    if (gl && (settings_.backend == HostBackend::gl || !(*gl)->is_software())) {
      gl_ = std::move(*gl);
      return;
    }
    if (!gl && settings_.backend == HostBackend::gl) {
      warn_(fmt::format("The processor draws instead of OpenGL. {}", gl.error().message));
    }
  }
  cpu_ = FrameFilter::cpu();
}

HostFilter::Size HostFilter::output_size(int width, int height) const {
  const auto scaled = [&](int side, int most) {
    return static_cast<int>(std::lround(std::clamp(side, 1, most) * settings_.scale));
  };
  return {scaled(width, max_width_), scaled(height, max_height_)};
}

void HostFilter::draw(HostFrame frame, void* output, std::size_t pitch) {
  if (frame.pixels == nullptr || output == nullptr || frame.width < 1 || frame.height < 1) return;
  const Size size = output_size(frame.width, frame.height);
  if (pitch < 4 * static_cast<std::size_t>(size.width)) {
    warn_once(fmt::format("Rows of {} bytes have no room for pictures of {} pixels.", pitch, size.width));
    return;
  }
  const bool has_pitch = frame.pitch >= frame.row_bytes();
  if (!has_pitch) frame.pitch = frame.row_bytes();  // the least that it can be
  frame.width = std::min(frame.width, max_width_);
  frame.height = std::min(frame.height, max_height_);
  const Size frame_size{frame.width, frame.height};
  std::optional<FrameView> view;
  if (has_pitch || frame_size != size_) view = to_rgba(frame, rgba_);
  size_ = frame_size;
  const PictureView picture{static_cast<std::uint8_t*>(output), size.width, size.height,
                            static_cast<std::ptrdiff_t>(pitch), ChannelOrder::bgra};
  auto drawn = draw_by_backend(view, picture);
  if (!drawn && gl_ != nullptr) {
    warn_once(fmt::format("The processor draws from here on. {}", drawn.error().message));
    gl_.reset();
    cpu_ = FrameFilter::cpu();
    const FrameView last{rgba_.data(), size_.width, size_.height, std::ptrdiff_t{4} * size_.width};
    drawn = draw_by_backend(last, picture);
  }
  if (!drawn) warn_once(drawn.error().message);
}

tl::expected<void, Error> HostFilter::draw_by(FrameFilter& filter, const std::optional<FrameView>& frame,
                                              const PictureView& picture) const {
  if (frame) {
    if (auto submitted = filter.submit(*frame, settings_.options); !submitted) return submitted;
  }
  return filter.draw(KeptPicture{picture}, {0, 0, picture.width, picture.height},
                     View::fit(filter.vectorizer().lattice(), picture.width, picture.height));
}

tl::expected<void, Error> HostFilter::draw_by_backend(const std::optional<FrameView>& frame,
                                                      const PictureView& picture) {
  if (gl_ == nullptr) return draw_by(*cpu_, frame, picture);
  tl::expected<void, Error> result;
  gl_->run([&](FrameFilter& filter) { result = draw_by(filter, frame, picture); });
  return result;
}

void HostFilter::warn_once(const std::string& sentence) {
  if (!std::exchange(has_warned_, true)) warn_(sentence);
}

}  // namespace depixel
