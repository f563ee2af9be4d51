#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

/// Put before a function: it is compiled once for all processors and once for those with AVX2, and the right
/// one is chosen when the program starts. Results are the same bits. Not with ThreadSanitizer: the choice is
/// made before it has begun.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define DEPIXEL_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define DEPIXEL_VECTOR_CLONES
#endif

namespace depixel {

/// Vectors from and to memory of any alignment.
template <typename Vector>
Vector load_vector(const void* p) {
  Vector v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
template <typename Vector>
void store_vector(void* p, Vector v) {
  std::memcpy(p, &v, sizeof v);
}

/// Eight bytes as one word, the first lowest.
inline std::uint64_t load_bytes(const void* p) {
  auto word = load_vector<std::uint64_t>(p);
  if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
  return word;
}

/// Whether all of a vector's sixteen bytes are 0.
template <typename Vector>
bool is_zero(Vector v) {
  static_assert(sizeof v == 2 * sizeof(std::uint64_t));
  std::uint64_t halves[2];
  std::memcpy(halves, &v, sizeof v);
  return (halves[0] | halves[1]) == 0;
}

/// Eight floats that are worked on together; operators act on each lane. Plain IEEE arithmetic, so the bits
/// are those of scalar code.
using Float8 = float __attribute__((vector_size(32)));
constexpr int kFloatLanes = 8;

inline Float8 load8(const float* p) {
  return load_vector<Float8>(p);
}
inline void store8(float* p, Float8 v) {
  store_vector(p, v);
}
inline Float8 max8(Float8 a, Float8 b) {
  return a > b ? a : b;
}
inline Float8 abs8(Float8 v) {
  return max8(v, -v);
}
inline Float8 clamp8(Float8 v, float low, float high) {
  const Float8 lows = Float8{} + low, highs = Float8{} + high;
  v = v < lows ? lows : v;
  return v > highs ? highs : v;
}

/// Eight integers of 32 or 16 bits that are worked on together.
using Int8 = std::int32_t __attribute__((vector_size(32)));
using Short8 = std::int16_t __attribute__((vector_size(16)));

/// Two doubles that are worked on together.
using Double2 = double __attribute__((vector_size(16)));

/// Both as the nearest integers, of two the even one.
inline std::array<std::int32_t, 2> nearest_integers(Double2 v) {
#ifdef __SSE2__
  return std::bit_cast<std::array<std::int32_t, 2>>(
      _mm_cvtsi128_si64(_mm_cvtpd_epi32(reinterpret_cast<__m128d>(v))));
#else
  return {static_cast<std::int32_t>(std::lrint(v[0])), static_cast<std::int32_t>(std::lrint(v[1]))};
#endif
}

/// Four integers that are worked on together.
using Int4 = std::int32_t __attribute__((vector_size(16)));

/// Four integers as bytes, the first lowest in memory; those beyond 0..255 become the nearest of these.
inline std::uint32_t pack_bytes(Int4 v) {
#ifdef __SSE2__
  const auto words = _mm_packs_epi32(reinterpret_cast<__m128i>(v), reinterpret_cast<__m128i>(v));
  return static_cast<std::uint32_t>(_mm_cvtsi128_si32(_mm_packus_epi16(words, words)));
#else
  const auto byte = [](std::int32_t value) { return static_cast<std::uint8_t>(std::clamp(value, 0, 255)); };
  const std::uint8_t bytes[4] = {byte(v[0]), byte(v[1]), byte(v[2]), byte(v[3])};
  return load_vector<std::uint32_t>(bytes);
#endif
}

/// Two times four integers of -32768..32767, ready to be mixed: (a, b) times two factors of that range, added
/// up.
class LevelPairs {
 public:
  LevelPairs() = default;
  LevelPairs(Int4 a, Int4 b) {
#ifdef __SSE2__
    pairs_ = (a & 0xffff) | b << 16;
#else
    a_ = a;
    b_ = b;
#endif
  }
  Int4 mixed(int of_a, int of_b) const {
#ifdef __SSE2__
    const auto factors = _mm_set1_epi32((of_a & 0xffff) | of_b << 16);
    return reinterpret_cast<Int4>(_mm_madd_epi16(reinterpret_cast<__m128i>(pairs_), factors));
#else
    return a_ * of_a + b_ * of_b;
#endif
  }

 private:
#ifdef __SSE2__
  Int4 pairs_{};
#else
  Int4 a_{}, b_{};
#endif
};

/// Four differences of -255..255, ready to be multiplied by a common factor of at most 2^17 in magnitude.
class LevelDifference {
 public:
  explicit LevelDifference(Int4 difference) {
#ifdef __SSE2__
    // Pairs of 16 bits: 128 times the difference for the factor's upper bits, and the difference for its
    // lower seven.
    pairs_ = (difference << 7 & 0xffff) | difference << 16;
#else
    pairs_ = difference;
#endif
  }
  Int4 times(int factor) const {
#ifdef __SSE2__
    const auto split = _mm_set1_epi32((factor >> 7 & 0xffff) | (factor & 127) << 16);
    return reinterpret_cast<Int4>(_mm_madd_epi16(reinterpret_cast<__m128i>(pairs_), split));
#else
    return pairs_ * factor;
#endif
  }
  LevelDifference operator-() const {
    LevelDifference negated(*this);
#ifdef __SSE2__
    negated.pairs_ =
        reinterpret_cast<Int4>(_mm_sub_epi16(_mm_setzero_si128(), reinterpret_cast<__m128i>(pairs_)));
#else
    negated.pairs_ = -pairs_;
#endif
    return negated;
  }

 private:
  Int4 pairs_;
};

/// Sixteen bytes, and four words of 32 bits.
constexpr int kWordLanes = 4;
using Byte16 = std::uint8_t __attribute__((vector_size(16)));
using Word4 = std::uint32_t __attribute__((vector_size(16)));

/// Sixteen words of at most 255 as bytes, in order.
inline Byte16 pack_words(Word4 a, Word4 b, Word4 c, Word4 d) {
#ifdef __SSE2__
  const auto low = _mm_packs_epi32(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b));
  const auto high = _mm_packs_epi32(reinterpret_cast<__m128i>(c), reinterpret_cast<__m128i>(d));
  return reinterpret_cast<Byte16>(_mm_packus_epi16(low, high));
#else
  Byte16 bytes;
  for (int i = 0; i < kWordLanes; ++i) {
    bytes[i] = static_cast<std::uint8_t>(a[i]);
    bytes[i + kWordLanes] = static_cast<std::uint8_t>(b[i]);
    bytes[i + 2 * kWordLanes] = static_cast<std::uint8_t>(c[i]);
    bytes[i + 3 * kWordLanes] = static_cast<std::uint8_t>(d[i]);
  }
  return bytes;
#endif
}

/// Sixteen integers as bytes, in order; those below 0 as 0, those above 255 as 255.
inline Byte16 pack_levels(Int4 a, Int4 b, Int4 c, Int4 d) {
#ifdef __SSE2__
  const auto low = _mm_packs_epi32(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b));
  const auto high = _mm_packs_epi32(reinterpret_cast<__m128i>(c), reinterpret_cast<__m128i>(d));
  return reinterpret_cast<Byte16>(_mm_packus_epi16(low, high));
#else
  Byte16 bytes;
  const Int4 all[] = {a, b, c, d};
  for (int i = 0; i < 16; ++i) {
    const std::int32_t v = all[i / kWordLanes][i % kWordLanes];
    bytes[i] = static_cast<std::uint8_t>(v < 0 ? 0 : v > 255 ? 255 : v);
  }
  return bytes;
#endif
}

/// One bit of each of sixteen bytes, the first byte's lowest.
inline std::uint32_t gather_bits(Byte16 bytes, int bit) {
#ifdef __SSE2__
  const auto moved = _mm_slli_epi16(reinterpret_cast<__m128i>(bytes), 7 - bit);
  return static_cast<std::uint32_t>(_mm_movemask_epi8(moved));
#else
  std::uint32_t bits = 0;
  for (int i = 0; i < 16; ++i) bits |= static_cast<std::uint32_t>(bytes[i] >> bit & 1) << i;
  return bits;
#endif
}

}  // namespace depixel
