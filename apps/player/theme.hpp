#pragma once

namespace depixel {

/// Sets ImGui's font, colours and distances: calm and dark. ImGui's context must exist.
/// \param pixel_ratio  framebuffer pixels to ImGui's units.
void set_up_theme(float pixel_ratio);

/// Distances of the player's own parts, in ImGui's units.
constexpr float kPanelWidth = 310, kBarHeight = 52, kFontSize = 15;

}  // namespace depixel
