#pragma once

#include "apps/player/player.hpp"

namespace depixel {

/// What the pointer does to the picture: the wheel zooms, dragging pans or moves the divider of the split
/// view, resting outlines a component and tells of it. Keeps what is being dragged.
class Pointer {
 public:
  /// Between Window::begin_ui() and end_ui(). \param pixel_ratio  output pixels to ImGui's units.
  void handle(Player& player, double pixel_ratio);

 private:
  enum class Drag { none, picture, divider };

  bool is_at_divider(const Player& player, glm::dvec2 position) const;
  void show_component(Player& player, glm::dvec2 position, double pixel_ratio) const;

  Drag drag_ = Drag::none;
};

}  // namespace depixel
