#include "filter/frame_filter.hpp"

namespace depixel {

tl::expected<std::unique_ptr<FrameFilter>, Error> FrameFilter::gl(GlLoader) {
  return tl::unexpected(Error{"OpenGL is not built yet."});
}

}  // namespace depixel
