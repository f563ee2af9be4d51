#include <cstring>

#include "tests/retroarch/games/games.hpp"
#include "tests/retroarch/games/pixel_art.hpp"

namespace depixel::test {
namespace {

constexpr int kWidth = 240, kHeight = 160;
constexpr std::size_t kProgram = 0xc0, kPicture = 0x140, kFixedByte = 0xb2, kHeaderSum = 0xbd;
constexpr std::uint16_t kColours[4] = {0x7fff, 0x0008, 0x03ff, 0x7c1f};  // five bits each: blue, green, red

// ARM instructions, from kProgram on.
constexpr std::uint32_t kCode[] = {
    0xe3a00301,  // mov r0,#0x04000000     registers
    0xe3a01b01,  // mov r1,#0x400
    0xe3811003,  // orr r1,r1,#3
    0xe1c010b0,  // strh r1,[r0]           DISPCNT: bitmap of 15 bits a pixel, layer 2
    0xe3a02406,  // mov r2,#0x06000000     its pixels
    0xe28f3064,  // add r3,pc,#0x64        the picture
    0xe3a04c96,  // mov r4,#38400          its pixels
    0xe0d310b2,  // copy: ldrh r1,[r3],#2
    0xe0c210b2,  //   strh r1,[r2],#2
    0xe2544001,  //   subs r4,r4,#1
    0x1afffffb,  //   bne copy
    0xe3a05000,  // mov r5,#0
    0xe1d010b6,  // frame: ldrh r1,[r0,#6] VCOUNT
    0xe35100a0,  //   cmp r1,#160
    0x1afffffc,  //   bne frame
    0xe2855c01,  // add r5,r5,#0x100       a pixel
    0xe2055c3f,  // and r5,r5,#0x3f00      up to 63
    0xe5805028,  // str r5,[r0,#0x28]      BG2X
    0xe1d010b6,  // line: ldrh r1,[r0,#6]
    0xe35100a1,  //   cmp r1,#161
    0x1afffffc,  //   bne line
    0xeafffff5,  // b frame
};

}  // namespace

Rom game_boy_advance_rom() {
  Rom rom(kPicture + 2 * kWidth * kHeight, 0);
  const std::uint32_t branch_to_program = 0xea00002e;
  std::memcpy(rom.data(), &branch_to_program, sizeof branch_to_program);
  rom[kFixedByte] = 0x96;
  std::uint8_t sum = 0;
  for (std::size_t i = 0xa0; i < kHeaderSum; ++i) sum = static_cast<std::uint8_t>(sum - rom[i]);
  rom[kHeaderSum] = static_cast<std::uint8_t>(sum - 0x19);
  std::memcpy(rom.data() + kProgram, kCode, sizeof kCode);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::uint16_t colour = kColours[face_colour(x, y)];
      std::memcpy(rom.data() + kPicture + 2 * static_cast<std::size_t>(y * kWidth + x), &colour,
                  sizeof colour);
    }
  }
  return rom;
}

}  // namespace depixel::test
