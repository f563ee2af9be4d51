#include "filter/frame_filter.hpp"
#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel {
namespace {

/// Leaves edges in the map that are gone from the frame. Draws to pictures only, and nothing elsewhere.
class FaultyFilter final : public FrameFilter {
 public:
  FaultyFilter() : FrameFilter(RuleSet().without(Rule::edges_by_codes)) {}

 private:
  tl::expected<void, Error> draw_checked(const Target& target, const Viewport&, const View& view) override {
    if (const PictureView* picture = picture_of(target)) {
      CpuRaster().draw(vectorizer_.map(), view, options_.linear_light, 1, *picture);
    }
    return {};
  }
  tl::expected<void, Error> clear(const GlFramebuffer&, const Viewport&) override { return {}; }
};

}  // namespace

std::unique_ptr<FrameFilter> FrameFilter::cpu() {
  return std::make_unique<FaultyFilter>();
}

tl::expected<std::unique_ptr<FrameFilter>, Error> FrameFilter::gl(GlLoader) {
  return std::make_unique<FaultyFilter>();
}

}  // namespace depixel
