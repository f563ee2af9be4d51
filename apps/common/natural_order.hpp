#pragma once

#include <string_view>

namespace depixel {

/// Orders names as people do: runs of digits by their value, so that frame_9 comes before frame_10.
/// \return whether a comes before b; a strict total order on different names.
bool naturally_before(std::string_view a, std::string_view b);

}  // namespace depixel
