#pragma once

#include "bench/common/picture.hpp"

namespace depixel::bench {

/// True where the program xbrzscale (Debian package xbrzscale) is on the search path.
bool has_xbrzscale();

/// Scales a picture by xbrzscale, run as a process on temporary files.
/// \param scale  2 to 6.
/// Throws std::runtime_error where it fails.
Picture run_xbrzscale(const Picture& picture, int scale);

}  // namespace depixel::bench
