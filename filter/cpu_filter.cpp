#include <cstring>
#include <vector>

#include "filter/frame_filter.hpp"
#include "libdepixel/core/stopwatch.hpp"
#include "libdepixel/incremental/picture_updater.hpp"

namespace depixel {
namespace {

class CpuFilter final : public FrameFilter {
 public:
  std::size_t memory_bytes() const override { return FrameFilter::memory_bytes() + updater_.memory_bytes(); }

 private:
  static tl::unexpected<Error> refuse_framebuffer() {
    return tl::unexpected(Error{"The filter that draws by the processor draws to pictures only."});
  }

  tl::expected<void, Error> draw_checked(const Target& target, const Viewport& viewport,
                                         const View& view) override {
    const PictureView* picture = picture_of(target);
    if (picture == nullptr) return refuse_framebuffer();
    const PictureView part = part_of(*picture, viewport);
    const bool is_kept = std::holds_alternative<KeptPicture>(target);
    {
      stats_.draw_ns = 0;
      const Stopwatch time(stats_.draw_ns);
      updater_.draw(vectorizer_, changes_, view, options_.linear_light, options_.threads, part, is_kept);
    }
    changes_.set_nothing();
    stats_.drawn_pixels = updater_.drawn_pixels();
    stats_.moved_pixels = updater_.moved_pixels();
    if (is_checking_) return compare_with_scratch(part, view);
    return {};
  }

  tl::expected<void, Error> clear(const GlFramebuffer&, const Viewport&) override {
    return refuse_framebuffer();
  }

  tl::expected<void, Error> compare_with_scratch(const PictureView& drawn, const View& view) const {
    const std::size_t row = std::size_t{4} * drawn.width;
    std::vector<std::uint8_t> pixels(row * drawn.height);
    CpuRaster().draw(
        vectorizer_.map(), view, options_.linear_light, 1,
        {pixels.data(), drawn.width, drawn.height, static_cast<std::ptrdiff_t>(row), drawn.order});
    for (int y = 0; y < drawn.height; ++y) {
      if (std::memcmp(drawn.pixels + y * drawn.pitch, pixels.data() + row * y, row) != 0) {
        return tl::unexpected(
            Error{"The picture that was drawn incrementally is not the one drawn from scratch."});
      }
    }
    return {};
  }

  PictureUpdater updater_;
};

}  // namespace

std::unique_ptr<FrameFilter> FrameFilter::cpu() {
  return std::make_unique<CpuFilter>();
}

}  // namespace depixel
