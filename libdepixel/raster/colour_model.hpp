#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>

#include "libdepixel/core/color.hpp"
#include "libdepixel/core/light.hpp"
#include "libdepixel/core/simd.hpp"
#include "libdepixel/core/tolerances.hpp"

namespace depixel {

/// What the rasteriser sums up for a colour, and how sums become pixels again. A model has
///   Sums    four integers, one a channel: what is summed
///   Change  a difference of two colours, prepared for multiplying
///   encode(c), change(from, to), times(change, factor), decode(sums)
/// where decode() takes a colour times kFullCoverage.

/// Whether a model has a decode() of four sums, which takes little.
template <typename Model>
constexpr bool kDecodesFour = requires(const typename Model::Sums& sums) {
  Model::decode(sums, sums, sums, sums);
};

/// Four colours at once, by any model.
template <typename Model>
Byte16 decode_four(const typename Model::Sums& a, const typename Model::Sums& b,
                   const typename Model::Sums& c, const typename Model::Sums& d) {
  if constexpr (kDecodesFour<Model>) {
    return Model::decode(a, b, c, d);
  } else {
    return std::bit_cast<Byte16>(
        std::array<Rgba, 4>{Model::decode(a), Model::decode(b), Model::decode(c), Model::decode(d)});
  }
}

/// An output pixel covered fully: kRasterSubpixels rows times twice as many columns (areas are sums of two
/// abscissas).
constexpr int kFullCoverageBits = 17;
constexpr int kFullCoverage = 1 << kFullCoverageBits;
static_assert(2 * kRasterSubpixels * kRasterSubpixels == kFullCoverage);

using Sums32 = std::int32_t __attribute__((vector_size(16)));
using Sums64 = std::int64_t __attribute__((vector_size(32)));

/// Opaque pictures, blended as they are.
struct OpaqueColour {
  using Sums = Sums32;
  using Change = LevelDifference;
  static Change change(Rgba from, Rgba to) {
    return LevelDifference(Sums{to.r - from.r, to.g - from.g, to.b - from.b, to.a - from.a});
  }
  static Sums times(const Change& change, int factor) { return change.times(factor); }
  static Rgba decode(const Sums& sums) { return std::bit_cast<Rgba>(pack_bytes(rounded(sums))); }
  /// Four colours at once.
  static Byte16 decode(const Sums& a, const Sums& b, const Sums& c, const Sums& d) {
    return pack_levels(rounded(a), rounded(b), rounded(c), rounded(d));
  }

 private:
  static Sums rounded(const Sums& sums) { return (sums + kFullCoverage / 2) >> kFullCoverageBits; }
};

/// Opaque pictures in linear light.
struct OpaqueLight {
  using Sums = Sums32;
  using Change = Sums;
  static Sums encode(Rgba c) { return Sums{to_light(c.r), to_light(c.g), to_light(c.b), c.a}; }
  static Change change(Rgba from, Rgba to) { return encode(to) - encode(from); }
  static Sums times(const Change& change, int factor) { return change * factor; }
  static Rgba decode(const Sums& sums) {
    const Sums rounded = (sums + kFullCoverage / 2) >> kFullCoverageBits;
    return {from_light(rounded[0]), from_light(rounded[1]), from_light(rounded[2]),
            static_cast<std::uint8_t>(rounded[3])};
  }
};

/// Pictures with alpha: colours are premultiplied, so that what is transparent has no weight.
template <bool kLight>
struct Translucent {
  using Sums = Sums64;
  using Change = Sums;
  static Sums encode(Rgba c) {
    const auto channel = [&](std::uint8_t v) { return std::int64_t{c.a} * (kLight ? to_light(v) : v); };
    return Sums{channel(c.r), channel(c.g), channel(c.b), c.a};
  }
  static Change change(Rgba from, Rgba to) { return encode(to) - encode(from); }
  static Sums times(const Change& change, int factor) { return change * factor; }
  static Rgba decode(const Sums& sums) {
    // Where curves overlap by a hair, sums leave the range.
    const std::int64_t alpha = sums[3];
    const auto a = static_cast<std::uint8_t>(
        std::clamp<std::int64_t>((alpha + kFullCoverage / 2) >> kFullCoverageBits, 0, 255));
    if (a == 0) return {};
    const auto channel = [&](std::int64_t v) {
      const auto level = static_cast<int>((v + alpha / 2) / alpha);
      return kLight ? from_light(level) : static_cast<std::uint8_t>(std::clamp(level, 0, 255));
    };
    return {channel(sums[0]), channel(sums[1]), channel(sums[2]), a};
  }
};

}  // namespace depixel
