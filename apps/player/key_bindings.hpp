#pragma once

#include <span>
#include <string_view>

#include "apps/player/player.hpp"
#include "apps/player/window.hpp"

namespace depixel {

/// What a key does. The table of them is the only place that knows keys: the help window shows it.
struct KeyBinding {
  KeyPress press;
  std::string_view name;  ///< of the key, as people call it
  std::string_view help;  ///< empty: the same as the one before
  void (*action)(Player&);
};

std::span<const KeyBinding> key_bindings();

/// Does what a key stands for, if it stands for anything.
void handle_key(const KeyPress& press, Player& player);

}  // namespace depixel
