#include "libdepixel/stages/dithers.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>
#include <functional>
#include <utility>

#include "libdepixel/core/light.hpp"
#include "libdepixel/core/normalized_pixels.hpp"

namespace depixel {
namespace {

using Word = BitRows::Word;
constexpr int kMargin = BitRows::kMargin, kBits = BitRows::kBits;

/// Which of 64 blocks are checkers, from the one on whose north-western pixel is `row`'s first.
Word checkers_from(const Rgba* row, int stride) {
  Word bits = 0;
  for (int x = 0; x < kBits; x += sizeof(Byte16)) {
    const auto four = [&](int k) -> Word4 {
      const Rgba* at = row + x + k * kWordLanes;
      const auto nw = load_vector<Word4>(at), ne = load_vector<Word4>(at + 1);
      const auto sw = load_vector<Word4>(at + stride), se = load_vector<Word4>(at + stride + 1);
      const Word4 is_checker = (nw == se) & (ne == sw) & (nw != ne);
      return is_checker & 1;
    };
    bits |= Word{gather_bits(pack_words(four(0), four(1), four(2), four(3)), 0)} << x;
  }
  return bits;
}

/// Calls visit(y) for each row of a grid and of its margin but the outermost one.
template <typename Visit>
void for_each_row(const BitRows& bits, Visit visit) {
  for (int y = 1 - kMargin; y < bits.height() + kMargin - 1; ++y) visit(y);
}

/// Combines each entry with its eight neighbours. \param columns  scratch.
template <typename Combine>
void combine_3x3(Combine combine, BitRows& columns, BitRows& bits) {
  for_each_row(bits, [&](int y) {
    const Word *above = bits.row(y - 1), *here = bits.row(y), *below = bits.row(y + 1);
    Word* row = columns.row(y);
    for (int i = 0; i < bits.words(); ++i) row[i] = combine(combine(above[i], here[i]), below[i]);
  });
  for_each_row(bits, [&](int y) {
    const Word* column = columns.row(y);
    Word* row = bits.row(y);
    for (int i = 0; i < bits.words(); ++i) {
      row[i] = combine(combine(west_of(column + i), column[i]), east_of(column + i));
    }
  });
}

/// Repeats the outermost entries of a grid beside them, in its margin.
void extend(BitRows& bits) {
  const int last_x = bits.width() - 1, last_y = bits.height() - 1;
  for (int y = 0; y <= last_y; ++y) {
    if (bits.has(0, y)) bits.set(-1, y);
    if (bits.has(last_x, y)) bits.set(last_x + 1, y);
  }
  std::copy_n(bits.row(0), bits.words(), bits.row(-1));
  std::copy_n(bits.row(last_y), bits.words(), bits.row(last_y + 1));
}

/// Adds the checkers that share a side with one that is in already.
void grow(const BitRows& checkers, const BitRows& from, BitRows& to) {
  for_each_row(from, [&](int y) {
    const Word *above = from.row(y - 1), *here = from.row(y), *below = from.row(y + 1);
    const Word* allowed = checkers.row(y);
    Word* row = to.row(y);
    for (int i = 0; i < from.words(); ++i) {
      row[i] = allowed[i] & (above[i] | west_of(here + i) | here[i] | east_of(here + i) | below[i]);
    }
  });
}

/// The mean of colours, each as visible as its alpha says.
Rgba mean_of(const std::array<Rgba, 4>& colours, bool linear_light) {
  const auto level = [&](std::uint8_t srgb) { return linear_light ? to_light(srgb) : int{srgb}; };
  int alpha = 0;
  std::array<int, 3> sum{};
  for (const Rgba c : colours) {
    alpha += c.a;
    sum[0] += level(c.r) * c.a;
    sum[1] += level(c.g) * c.a;
    sum[2] += level(c.b) * c.a;
  }
  if (alpha == 0) return {};
  const auto mean = [&](int channel) {
    const int rounded = (sum[channel] + alpha / 2) / alpha;
    return linear_light ? from_light(rounded) : static_cast<std::uint8_t>(rounded);
  };
  return normalized({mean(0), mean(1), mean(2), static_cast<std::uint8_t>((alpha + 2) / 4)});
}

/// Mixes pixels with their neighbours in checkers; those along a row are mostly alike.
class Mixer {
 public:
  explicit Mixer(bool linear_light) : linear_light_(linear_light) {}

  Rgba mixed(Rgba own, Rgba west, Rgba east) {
    if (west == east && rgba_order(own) > rgba_order(west)) std::swap(own, west), east = west;
    const std::array<Rgba, 4> colours{own, own, west, east};
    if (colours != colours_) {
      colours_ = colours;
      mean_ = mean_of(colours, linear_light_);
    }
    return mean_;
  }

 private:
  bool linear_light_;
  std::array<Rgba, 4> colours_{};  ///< of the pixel before
  Rgba mean_;
};

}  // namespace

void Dithers::resize(const Lattice& size) {
  pixels.assign(size.size(), Rgba{});
  blended.assign(size.size(), Rgba{});
  for (BitRows* bits : {&checkers, &areas, &scratch[0], &scratch[1]}) {
    bits->reset(size.width() - 1, size.height() - 1);
  }
  lattice = size;
}

FrameView Dithers::view() const {
  return {reinterpret_cast<const std::uint8_t*>(blended.data() + lattice.pixel(0, 0)), lattice.width(),
          lattice.height(), std::ptrdiff_t{sizeof(Rgba)} * lattice.stride()};
}

void take_row(const FrameView& frame, int y, Dithers& dithers) {
  take_normalized(frame.pixels + y * frame.pitch, frame.width,
                  dithers.pixels.data() + dithers.lattice.pixel(0, y));
}

void find_checkers(int y, Dithers& dithers) {
  const int stride = dithers.lattice.stride(), count = dithers.checkers.width();
  const Rgba* pixels = dithers.pixels.data() + dithers.lattice.pixel(0, y);
  Word* row = dithers.checkers.row(y);
  std::fill_n(row, dithers.checkers.words(), 0);
  for (int x = 0, i = 0; x < count; x += kBits, ++i) {
    Word bits = checkers_from(pixels + x, stride);
    if (count - x < kBits) bits &= (Word{1} << (count - x)) - 1;  // those beyond lie in the next row
    row[i] |= bits << kMargin;
    if (const Word rest = bits >> (kBits - kMargin); rest != 0) row[i + 1] |= rest;
  }
}

void find_dithered_areas(Dithers& dithers) {
  // Continued to both sides, a single checker would fill a square.
  if (dithers.checkers.width() < 2 || dithers.checkers.height() < 2) return;
  auto& [bits, columns] = dithers.scratch;
  // Nine checkers in a square are a square of 4x4 pixels.
  bits = dithers.checkers;
  extend(bits);
  combine_3x3(std::bit_and<Word>(), columns, bits);
  combine_3x3(std::bit_or<Word>(), columns, bits);
  for (int i = 0; i < Dithers::kGrowth; ++i) {
    grow(dithers.checkers, bits, dithers.areas);
    std::swap(bits, dithers.areas);
  }
  std::swap(bits, dithers.areas);
}

void blend_row(int y, bool linear_light, Dithers& dithers) {
  const Lattice& lattice = dithers.lattice;
  const Rgba* pixels = dithers.pixels.data() + lattice.pixel(0, y);
  Rgba* blended = dithers.blended.data() + lattice.pixel(0, y);
  std::copy_n(pixels, lattice.width(), blended);
  const Word *above = dithers.areas.row(y - 1), *below = dithers.areas.row(y);
  Mixer mixer(linear_light);
  for (int i = 0; i < dithers.areas.words(); ++i) {
    // Bit x of the blocks is the one to the east of pixel x, the one before it that to the west.
    const std::array<Word, 2> blocks{above[i - 1] | below[i - 1], above[i] | below[i]};
    const Word is_east = blocks[1], is_west = west_of(&blocks[1]);
    for (Word bits = is_west | is_east; bits != 0; bits &= bits - 1) {
      const int bit = std::countr_zero(bits), x = i * kBits + bit - kMargin;
      const bool has_west = (is_west >> bit & 1) != 0, has_east = (is_east >> bit & 1) != 0;
      const Rgba west = pixels[has_west ? x - 1 : x + 1], east = pixels[has_east ? x + 1 : x - 1];
      blended[x] = mixer.mixed(pixels[x], west, east);
    }
  }
}

void blend_dithers(const FrameView& frame, bool linear_light, Dithers& dithers) {
  assert(frame.width > 0 && frame.height > 0);
  const Lattice size(frame.width, frame.height);
  if (dithers.lattice != size) dithers.resize(size);
  for (int y = 0; y < frame.height; ++y) take_row(frame, y, dithers);
  for (int y = 0; y + 1 < frame.height; ++y) find_checkers(y, dithers);
  find_dithered_areas(dithers);
  for (int y = 0; y < frame.height; ++y) blend_row(y, linear_light, dithers);
}

}  // namespace depixel
