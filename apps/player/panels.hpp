#pragma once

#include "apps/player/player.hpp"

namespace depixel {

/// What the panels leave of the window for the picture, in ImGui's units.
PixelRect area_beside_panels(const LookSettings& look, glm::ivec2 window);

/// The panel at the side: how the picture is shown, the vectorizer's options, statistics.
void show_side_panel(Player& player);
/// The bar at the bottom: playing, seeking, speed.
void show_control_bar(Player& player);
/// Windows that are open now and then: help, opening files, progress; and messages.
void show_dialogs(Player& player);

}  // namespace depixel
