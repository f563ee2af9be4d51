#pragma once

#include <tl/expected.hpp>

#include "apps/common/picture.hpp"
#include "filter/frame_filter.hpp"
#include "libdepixel/core/error.hpp"

namespace depixel {

/// Draws all of the submitted frame over a picture of that size, and only what changed where the picture has
/// it already.
/// \param picture  that nobody but this filter writes to, by this function.
tl::expected<void, Error> draw_kept(FrameFilter& filter, Picture& picture, int width, int height);

}  // namespace depixel
