#include "filter/host/host_frame.hpp"

#include <bit>
#include <cstring>

#include "filter/red_blue.hpp"

namespace depixel {
namespace {

static_assert(std::endian::native == std::endian::little,
              "words are written as bytes of red, green, blue, alpha");

constexpr std::uint32_t kOpaque = 0xff000000U;

std::uint32_t from_word(std::uint32_t xrgb8888) {
  return kOpaque | swap_red_and_blue(xrgb8888);
}

/// The nearest of 256 levels to each of 32 and of 64: what OpenGL makes of 16 bits, so that colours are those
/// that the host shows without a filter.
constexpr std::uint32_t level_of_32(std::uint32_t bits) {
  return (bits * 527 + 23) >> 6;
}
constexpr std::uint32_t level_of_64(std::uint32_t bits) {
  return (bits * 259 + 33) >> 6;
}

std::uint32_t from_word(std::uint16_t rgb565) {
  const std::uint32_t word = rgb565;
  return kOpaque | level_of_32(word >> 11) | level_of_64(word >> 5 & 0x3f) << 8 |
         level_of_32(word & 0x1f) << 16;
}

template <typename Word>
void copy_rows(const HostFrame& frame, std::uint8_t* to) {
  const auto* row = static_cast<const std::uint8_t*>(frame.pixels);
  for (int y = 0; y < frame.height; ++y, row += frame.pitch) {
    for (int x = 0; x < frame.width; ++x, to += sizeof(std::uint32_t)) {
      Word word;
      std::memcpy(&word, row + static_cast<std::size_t>(x) * sizeof word, sizeof word);
      const std::uint32_t pixel = from_word(word);
      std::memcpy(to, &pixel, sizeof pixel);
    }
  }
}

}  // namespace

FrameView to_rgba(const HostFrame& frame, std::vector<std::uint8_t>& rgba) {
  const std::size_t pitch = static_cast<std::size_t>(frame.width) * sizeof(std::uint32_t);
  rgba.resize(pitch * static_cast<std::size_t>(frame.height));
  if (frame.format == HostFormat::rgb565) {
    copy_rows<std::uint16_t>(frame, rgba.data());
  } else {
    copy_rows<std::uint32_t>(frame, rgba.data());
  }
  return {rgba.data(), frame.width, frame.height, static_cast<std::ptrdiff_t>(pitch)};
}

}  // namespace depixel
