#pragma once

#include <cstdint>
#include <vector>

namespace depixel::test {

using Rom = std::vector<std::uint8_t>;

// Our own small programs for consoles: a screen full of faces in four colours, which scrolls a pixel a frame.

/// For the Game Boy: 32 KiB.
Rom game_boy_rom();
/// For the Game Boy Advance.
Rom game_boy_advance_rom();
/// For the Super Nintendo: 32 KiB, LoROM.
Rom super_nintendo_rom();

}  // namespace depixel::test
