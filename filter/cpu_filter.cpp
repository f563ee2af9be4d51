#include "filter/frame_filter.hpp"
#include "libdepixel/core/stopwatch.hpp"
#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel {
namespace {

class CpuFilter final : public FrameFilter {
 public:
  tl::expected<void, Error> draw(const Target& target, const Viewport& viewport, const View& view) override {
    if (auto checked = check(target, viewport, view); !checked) return checked;
    const auto* picture = std::get_if<PictureView>(&target);
    if (picture == nullptr) {
      return tl::unexpected(Error{"The filter that draws by the processor draws to pictures only."});
    }
    stats_.draw_ns = 0;
    const Stopwatch time(stats_.draw_ns);
    const PictureView part{picture->pixels + viewport.y * picture->pitch + std::ptrdiff_t{4} * viewport.x,
                           viewport.width, viewport.height, picture->pitch};
    raster_.draw(vectorizer_.map(), view, options_.linear_light, options_.threads, part);
    return {};
  }

 private:
  CpuRaster raster_;
};

}  // namespace

std::unique_ptr<FrameFilter> FrameFilter::cpu() {
  return std::make_unique<CpuFilter>();
}

}  // namespace depixel
