#include "libdepixel/raster/shade_field.hpp"

#include <algorithm>
#include <cstring>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

/// Weights along an axis are in subpixels between two centres.
constexpr int kWeightBits = 12, kWeights = 1 << kWeightBits;
static_assert(kWeights == kSubpixels);

Word4 channels(Rgba c) {
  return Word4{c.r, c.g, c.b, c.a};
}

Rgba packed(const Word4& levels) {
  return std::bit_cast<Rgba>(pack_bytes(reinterpret_cast<Int4>(levels)));
}

}  // namespace

struct ShadeField::Mixture {
  bool is_even;
  Rgba colour;   ///< if it is even
  unsigned all;  ///< 0 if pixels are left out
  std::array<Word4, 4> shades;
  std::array<std::uint32_t, 4> shares;  ///< 1 or 0 where a pixel is left out

  Rgba at(int x, int y) const {
    const auto east = static_cast<std::uint32_t>(x), south = static_cast<std::uint32_t>(y);
    const std::uint32_t west = kWeights - east, north = kWeights - south;
    const std::array<std::uint32_t, 4> weights{shares[0] * west * north, shares[1] * east * north,
                                               shares[2] * west * south, shares[3] * east * south};
    const Word4 sum =
        shades[0] * weights[0] + shades[1] * weights[1] + shades[2] * weights[2] + shades[3] * weights[3];
    if (all != 0) return packed((sum + (1U << (2 * kWeightBits - 1))) >> (2 * kWeightBits));
    const std::uint32_t total = weights[0] + weights[1] + weights[2] + weights[3];
    return packed((sum + total / 2) / total);
  }
};

std::vector<ShadeField::Place>& ShadeField::place(const ToOutput& axis, int pixels, int size,
                                                  std::vector<Place>& places) {
  places.resize(pixels);
  for (int i = 0; i < pixels; ++i) {
    const std::int64_t at = axis.source(i * kRasterSubpixels + kRasterSubpixels / 2) + kSubpixels / 2;
    const std::int64_t line = at >> kWeightBits;
    places[i] = {static_cast<int>(std::clamp<std::int64_t>(line, 0, size)),
                 std::clamp(static_cast<int>(at & (kWeights - 1)), 1, kWeights - 1)};
  }
  return places;
}

void ShadeField::start(const Shading& shading, const std::vector<Rgba>& colours,
                       const std::vector<Rgba>& shades, const OutputGrid& grid) {
  shading_ = &shading;
  colours_ = &colours;
  shades_ = &shades;
  lattice_ = grid.lattice;
  place(grid.x, grid.target.width, lattice_.width(), columns_);
  place(grid.y, grid.target.height, lattice_.height(), rows_);
  is_row_shaded_.resize(lattice_.height() + 1);
  for (int y = 0; y <= lattice_.height(); ++y) {
    is_row_shaded_[y] = are_zero(shading.blocks.data() + lattice_.corner(0, y), lattice_.width() + 1) ? 0 : 1;
  }
}

bool ShadeField::is_shaded(int first_row, int end_row) const {
  const auto* first = is_row_shaded_.data() + rows_[first_row].line;
  const auto* last = is_row_shaded_.data() + rows_[end_row - 1].line;
  return std::find(first, last + 1, 1) != last + 1;
}

ShadeField::Mixture ShadeField::mixture(int block, Rgba region) const {
  Mixture mixture{true, region, 0, {}, {}};
  const std::uint8_t pairs = shading_->blocks[block];
  if (pairs == 0) return mixture;
  const std::array<int, 4> pixels{block, block + 1, block + lattice_.stride(), block + lattice_.stride() + 1};
  int own = 0;
  for (int k = 0; k < 4; ++k) own |= ((*colours_)[pixels[k]] == region ? 1 : 0) << k;
  if (own == 0) return mixture;
  const int blending = blending_pixels(pairs, own);
  mixture.colour = (*shades_)[pixels[std::countr_zero(static_cast<unsigned>(own))]];
  for (int k = 0; k < 4; ++k) {
    if ((blending >> k & 1) == 0) continue;
    const Rgba shade = (*shades_)[pixels[k]];
    mixture.is_even &= shade == mixture.colour;
    mixture.shades[k] = channels(shade);
    mixture.shares[k] = 1;
  }
  mixture.all = blending == 15 ? 1 : 0;
  return mixture;
}

Rgba ShadeField::at(int column, int row, Rgba region) const {
  const Place &x = columns_[column], &y = rows_[row];
  const Mixture here = mixture(lattice_.corner(x.line, y.line), region);
  return here.is_even ? here.colour : here.at(x.weight, y.weight);
}

void ShadeField::fill(int row, int from, int to, Rgba region, std::uint8_t* out) const {
  const Place& y = rows_[row];
  for (int x = from; x < to;) {
    const int line = columns_[x].line;
    const Mixture here = mixture(lattice_.corner(line, y.line), region);
    for (; x < to && columns_[x].line == line; ++x) {
      const Rgba colour = here.is_even ? here.colour : here.at(columns_[x].weight, y.weight);
      std::memcpy(out + 4 * std::size_t(x), &colour, sizeof colour);
    }
  }
}

}  // namespace depixel
