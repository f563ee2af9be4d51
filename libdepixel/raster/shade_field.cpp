#include "libdepixel/raster/shade_field.hpp"

#include <algorithm>
#include <cstring>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

/// Weights along an axis are in subpixels between two centres.
constexpr int kWeightBits = 12, kWeights = 1 << kWeightBits;
static_assert(kWeights == kSubpixels);

/// Shades are mixed, first along columns, in 1/128 of a level.
constexpr int kLevelBits = 7;

void store(std::uint8_t* row, int x, Rgba colour) {
  std::memcpy(row + 4 * std::size_t(x), &colour, sizeof colour);
}

Int4 channels(Rgba c) {
  return Int4{c.r, c.g, c.b, c.a};
}

}  // namespace

struct ShadeField::Mixture {
  bool is_even;
  Rgba colour;  ///< if it is even
  std::array<Rgba, 4> shades;
  std::array<int, 4> shares;  ///< 1, or 0 where a pixel is left out
};

/// A mixture along a row of output pixels.
class ShadeField::MixtureRow {
 public:
  MixtureRow(const Mixture& mixture, int south) {
    const int north = kWeights - south;
    const auto& [a, b, c, d] = mixture.shades;
    const auto& [share_a, share_b, share_c, share_d] = mixture.shares;
    const Int4 west = column(a, share_a * north, c, share_c * south);
    const Int4 east = column(b, share_b * north, d, share_d * south);
    west_weight_ = share_a * north + share_c * south;
    east_weight_ = share_b * north + share_d * south;
    is_whole_ = west_weight_ + east_weight_ == 2 * kWeights;
    if (is_whole_) {
      constexpr int kBits = kWeightBits - kLevelBits;
      const Int4 half = Int4{} + (1 << (kBits - 1));
      levels_ = LevelPairs((west + half) >> kBits, (east + half) >> kBits);
    } else {
      west_ = __builtin_convertvector(west, Float4);
      east_ = __builtin_convertvector(east, Float4);
    }
  }

  Rgba at(int east) const {
    constexpr int kBits = kWeightBits + kLevelBits;
    const int west = kWeights - east;
    if (is_whole_) return packed((levels_.mixed(west, east) + (1 << (kBits - 1))) >> kBits);
    // The shares that take part are not all, and may be small: a division, of which the bits are the same
    // everywhere.
    const auto west_share = static_cast<float>(west), east_share = static_cast<float>(east);
    const Float4 sum = west_ * west_share + east_ * east_share;
    const auto total = static_cast<float>(west_weight_ * west + east_weight_ * east);
    return packed(__builtin_convertvector(sum / total + 0.5F, Int4));
  }

 private:
  using Float4 = float __attribute__((vector_size(16)));

  static Rgba packed(Int4 levels) { return std::bit_cast<Rgba>(pack_bytes(levels)); }

  static Int4 column(Rgba a, int of_a, Rgba b, int of_b) {
    return LevelPairs(channels(a), channels(b)).mixed(of_a, of_b);
  }

  LevelPairs levels_;       ///< of the two columns, if all pixels take part
  Float4 west_{}, east_{};  ///< else: sums of shades times weights
  int west_weight_, east_weight_;
  bool is_whole_;
};

void ShadeField::place(const ToOutput& axis, int pixels, int size, std::vector<Place>& places) {
  places.resize(pixels);
  for (int i = 0; i < pixels; ++i) {
    const std::int64_t at = axis.source(i * kRasterSubpixels + kRasterSubpixels / 2) + kSubpixels / 2;
    const std::int64_t line = at >> kWeightBits;
    places[i] = {static_cast<int>(std::clamp<std::int64_t>(line, 0, size)),
                 std::clamp(static_cast<int>(at & (kWeights - 1)), 1, kWeights - 1)};
  }
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
  Mixture mixture{true, region, {}, {}};
  const std::uint8_t pairs = shading_->blocks[block];
  if (pairs == 0) return mixture;
  std::array<int, 4> pixels = block_pixels(lattice_.stride());
  for (int& pixel : pixels) pixel += block;
  int own = 0;
  for (int k = 0; k < 4; ++k) own |= ((*colours_)[pixels[k]] == region ? 1 : 0) << k;
  if (own == 0) return mixture;
  const int blending = blending_pixels(pairs, own);
  mixture.colour = (*shades_)[pixels[std::countr_zero(static_cast<unsigned>(own))]];
  for (int k = 0; k < 4; ++k) {
    if ((blending >> k & 1) == 0) continue;
    const Rgba shade = (*shades_)[pixels[k]];
    mixture.is_even &= shade == mixture.colour;
    mixture.shades[k] = shade;
    mixture.shares[k] = 1;
  }
  return mixture;
}

Rgba ShadeField::at(int column, int row, Rgba region) const {
  const Place &x = columns_[column], &y = rows_[row];
  const Mixture here = mixture(lattice_.corner(x.line, y.line), region);
  return here.is_even ? here.colour : MixtureRow(here, y.weight).at(x.weight);
}

void ShadeField::fill(int row, int from, int to, Rgba region, std::uint8_t* out) const {
  const Place& y = rows_[row];
  const std::uint8_t* blocks = shading_->blocks.data() + lattice_.corner(0, y.line);
  for (int x = from; x < to;) {
    const int line = columns_[x].line;
    if (blocks[line] == 0) {
      for (; x < to && blocks[columns_[x].line] == 0; ++x) store(out, x, region);
      continue;
    }
    const Mixture here = mixture(lattice_.corner(line, y.line), region);
    if (here.is_even) {
      for (; x < to && columns_[x].line == line; ++x) store(out, x, here.colour);
    } else {
      const MixtureRow mixed(here, y.weight);
      for (; x < to && columns_[x].line == line; ++x) store(out, x, mixed.at(columns_[x].weight));
    }
  }
}

}  // namespace depixel
