#include <algorithm>

#include "tests/retroarch/games/games.hpp"
#include "tests/retroarch/games/pixel_art.hpp"

namespace depixel::test {
namespace {

constexpr std::size_t kRomSize = 32768, kEntry = 0x100, kProgram = 0x150, kTiles = 0x400;
constexpr std::size_t kHeaderFirst = 0x134, kHeaderLast = 0x14c, kHeaderSum = 0x14d;

void put(Rom& rom, std::size_t at, const std::vector<std::uint8_t>& bytes) {
  std::copy(bytes.begin(), bytes.end(), rom.begin() + static_cast<std::ptrdiff_t>(at));
}

// Four tiles make the face; the background repeats them, even columns and rows first.
const std::vector<std::uint8_t> kCode{
    0xf3,              // di
    0xf0, 0x44,        // wait: ldh a,(LY)
    0xfe, 0x90,        //   cp 144
    0x20, 0xfa,        //   jr nz,wait            the screen may be switched off in the blank only
    0xaf,              // xor a
    0xe0, 0x40,        // ldh (LCDC),a            off
    0x3e, 0xe4,        // ld a,%11100100
    0xe0, 0x47,        // ldh (BGP),a             colours 0..3 from light to dark
    0x21, 0x00, 0x80,  // ld hl,$8000             tiles
    0x11, 0x00, 0x04,  // ld de,kTiles
    0x06, 0x40,        // ld b,64                 bytes of four tiles
    0x1a,              // copy: ld a,(de)
    0x13,              //   inc de
    0x22,              //   ld (hl+),a
    0x05,              //   dec b
    0x20, 0xfa,        //   jr nz,copy
    0x21, 0x00, 0x98,  // ld hl,$9800             the map: 32 x 32
    0x7d,              // fill: ld a,l
    0xe6, 0x01,        //   and 1                 odd columns
    0x47,              //   ld b,a
    0x7d,              //   ld a,l
    0xe6, 0x20,        //   and 32                odd rows
    0x28, 0x02,        //   jr z,even
    0x3e, 0x02,        //   ld a,2
    0xb0,              // even: or b              (a is 0 or 2)
    0x22,              //   ld (hl+),a
    0x7c,              //   ld a,h
    0xfe, 0x9c,        //   cp $9c
    0x20, 0xed,        //   jr nz,fill
    0x3e, 0x91,        // ld a,%10010001
    0xe0, 0x40,        // ldh (LCDC),a            on, with the background
    0xf0, 0x44,        // frame: ldh a,(LY)
    0xfe, 0x90,        //   cp 144
    0x20, 0xfa,        //   jr nz,frame
    0xf0, 0x43,        // ldh a,(SCX)
    0x3c,              // inc a
    0xe0, 0x43,        // ldh (SCX),a             a pixel to the left
    0xf0, 0x44,        // line: ldh a,(LY)
    0xfe, 0x91,        //   cp 145
    0x20, 0xfa,        //   jr nz,line
    0x18, 0xed,        // jr frame
};

}  // namespace

Rom game_boy_rom() {
  Rom rom(kRomSize, 0);
  put(rom, kEntry, {0x00, 0xc3, 0x50, 0x01});  // nop; jp kProgram
  put(rom, kHeaderFirst, {'F', 'A', 'C', 'E', 'S'});
  put(rom, kProgram, kCode);
  for (const int tile : {0, 1, 2, 3}) {
    put(rom, kTiles + 16 * static_cast<std::size_t>(tile), face_tile(tile % 2, tile / 2));
  }
  unsigned sum = 0;
  for (std::size_t i = kHeaderFirst; i <= kHeaderLast; ++i) sum = sum - rom[i] - 1;
  rom[kHeaderSum] = static_cast<std::uint8_t>(sum);
  return rom;
}

}  // namespace depixel::test
