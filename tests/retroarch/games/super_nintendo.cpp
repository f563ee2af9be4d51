#include <algorithm>
#include <cstddef>

#include "tests/retroarch/games/games.hpp"
#include "tests/retroarch/games/pixel_art.hpp"

namespace depixel::test {
namespace {

constexpr std::size_t kRomSize = 32768, kBase = 0x8000;  // where the console sees its first byte
constexpr std::size_t kTiles = 0x400, kHeader = 0x7fc0, kReset = 0x7ffc;

void put(Rom& rom, std::size_t at, const std::vector<std::uint8_t>& bytes) {
  std::copy(bytes.begin(), bytes.end(), rom.begin() + static_cast<std::ptrdiff_t>(at));
}

// From $8000 on. Layer 1 in mode 0 has four colours; its tiles are at word 0 of the video memory, its map of
// 32 x 32 at word $0400.
const std::vector<std::uint8_t> kCode{
    0x78,              // sei
    0x18, 0xfb,        // clc; xce              65816's own mode
    0xe2, 0x30,        // sep #$30              8 bits
    0xa9, 0x8f,        // lda #$8f
    0x8d, 0x00, 0x21,  // sta INIDISP           screen off
    0x9c, 0x05, 0x21,  // stz BGMODE            mode 0
    0xa9, 0x04,        // lda #$04
    0x8d, 0x07, 0x21,  // sta BG1SC             map at $0400
    0x9c, 0x0b, 0x21,  // stz BG12NBA           tiles at 0
    0xa9, 0x01,        // lda #$01
    0x8d, 0x2c, 0x21,  // sta TM                layer 1
    0x9c, 0x21, 0x21,  // stz CGADD
    0xa2, 0x00,        // ldx #0
    0xbd, 0x60, 0x84,  // colours: lda $8460,x
    0x8d, 0x22, 0x21,  //   sta CGDATA
    0xe8,              //   inx
    0xe0, 0x08,        //   cpx #8
    0xd0, 0xf5,        //   bne colours
    0xa9, 0x80,        // lda #$80
    0x8d, 0x15, 0x21,  // sta VMAIN             words
    0x9c, 0x16, 0x21,  // stz VMADDL
    0x9c, 0x17, 0x21,  // stz VMADDH
    0xa2, 0x00,        // ldx #0
    0xbd, 0x00, 0x84,  // tiles: lda kTiles,x
    0x8d, 0x18, 0x21,  //   sta VMDATAL
    0xe8,              //   inx
    0xbd, 0x00, 0x84,  //   lda kTiles,x
    0x8d, 0x19, 0x21,  //   sta VMDATAH
    0xe8,              //   inx
    0xe0, 0x40,        //   cpx #64
    0xd0, 0xee,        //   bne tiles
    0x9c, 0x16, 0x21,  // stz VMADDL
    0xa9, 0x04,        // lda #$04
    0x8d, 0x17, 0x21,  // sta VMADDH            $0400
    0xa0, 0x00,        // ldy #0                rows
    0xa2, 0x00,        // row: ldx #0           columns
    0x8a,              // column: txa
    0x29, 0x01,        //   and #1
    0x85, 0x00,        //   sta 0
    0x98,              //   tya
    0x29, 0x01,        //   and #1
    0x0a,              //   asl
    0x05, 0x00,        //   ora 0
    0x8d, 0x18, 0x21,  //   sta VMDATAL         tile 0..3
    0x9c, 0x19, 0x21,  //   stz VMDATAH
    0xe8,              //   inx
    0xe0, 0x20,        //   cpx #32
    0xd0, 0xea,        //   bne column
    0xc8,              //   iny
    0xc0, 0x20,        //   cpy #32
    0xd0, 0xe3,        //   bne row
    0xa9, 0x0f,        // lda #$0f
    0x8d, 0x00, 0x21,  // sta INIDISP           on, full brightness
    0x64, 0x01,        // stz 1
    0xad, 0x12, 0x42,  // frame: lda HVBJOY
    0x10, 0xfb,        //   bpl frame           until the blank
    0xe6, 0x01,        // inc 1
    0xa5, 0x01,        // lda 1
    0x8d, 0x0d, 0x21,  // sta BG1HOFS           a pixel to the left
    0x9c, 0x0d, 0x21,  // stz BG1HOFS
    0xad, 0x12, 0x42,  // line: lda HVBJOY
    0x30, 0xfb,        //   bmi line            until the picture
    0x80, 0xea,        // bra frame
};

}  // namespace

Rom super_nintendo_rom() {
  Rom rom(kRomSize, 0);
  put(rom, 0, kCode);
  for (const int tile : {0, 1, 2, 3}) {
    put(rom, kTiles + 16 * static_cast<std::size_t>(tile), face_tile(tile % 2, tile / 2));
  }
  put(rom, kTiles + 0x60, {0xff, 0x7f, 0x08, 0x00, 0xff, 0x03, 0x1f, 0x7c});  // colours of the palette
  Rom header(0x15, ' ');
  const std::vector<std::uint8_t> name{'F', 'A', 'C', 'E', 'S'};
  std::copy(name.begin(), name.end(), header.begin());
  // LoROM; no more than a ROM; 32 KiB; no RAM; region; nobody; version; and the sums, which fit no bits set.
  for (const int byte : {0x20, 0x00, 0x05, 0x00, 0x01, 0x00, 0x00, 0xff, 0xff, 0x00, 0x00}) {
    header.push_back(static_cast<std::uint8_t>(byte));
  }
  put(rom, kHeader, header);
  put(rom, kReset, {kBase & 0xff, kBase >> 8});
  return rom;
}

}  // namespace depixel::test
