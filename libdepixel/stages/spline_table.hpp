#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/workers.hpp"
#include "libdepixel/stages/splines.hpp"

namespace depixel {

/// The splines of all different shapes of arcs. A frame has far fewer shapes than arcs, and the next frame
/// has mostly the same ones, wherever they have moved to: so each shape is fitted once.
///
/// Curves are known by their number, which is never 0. The steps of a shape have places that follow each
/// other, and at each place stands the number of the step's curve. Numbers and places stay good until
/// clear().
class SplineTable {
 public:
  /// \param has_equal_numbers  equal curves that were fitted have equal numbers, so that numbers can be
  ///                           compared; it takes time to look each up.
  explicit SplineTable(bool has_equal_numbers = false) : has_equal_numbers_(has_equal_numbers) { clear(); }

  /// Forgets all shapes and curves.
  void clear();
  /// Makes room for the steps of shapes: with room for all, nothing is allocated that is not used.
  void reserve(std::size_t steps);

  /// The place of the first of an arc's steps. A shape that is not known is added; its curves are set by
  /// fit_added().
  int place_of(std::span<const ShapeWord> words, ArcKind kind);
  /// Fits splines to all shapes added since the last call. \return how many they were.
  int fit_added(const Options& options, Workers& workers);
  /// The number of the curve of a fitted shape's step.
  int number_at(int place) const { return numbers_[place]; }

  /// The number of a curve with other ends (see join()); of a known curve that was fitted.
  int joined(int fitted, bool southwards, glm::i16vec2 p0, glm::i16vec2 p3);
  /// The fitted curve that a joined one was made from; of a fitted curve, itself.
  int fitted(int number) const { return number < first_joined_ ? number : fitted_[number]; }

  const EdgeCurve& curve(int number) const { return curves_[number]; }
  /// Fetches a curve that will be asked for.
  void prefetch(int number) const { __builtin_prefetch(curves_.data() + number); }
  TileMask tiles(int number) const { return tiles_[number]; }
  /// Changes with clear(), and is no other table's: numbers of other generations are of other curves.
  std::uint64_t generation() const { return generation_; }
  /// Curves held, joined ones among them.
  std::size_t size() const { return curves_.size() - 1; }
  /// Places: steps of all shapes.
  std::size_t places() const { return numbers_.size(); }

  std::size_t memory_bytes() const;

 private:
  struct Shape {
    int first_word, count;
    ArcKind kind;
    int first_place;

    int step_count() const { return kind.closed ? count : count - 1; }
  };

  /// Numbers by key, in open addressing; -1 where free.
  /// \tparam Key  a word of 32 or 64 bits.
  template <typename Key>
  class Index {
   public:
    void clear();
    /// Finds an entry of this key for which is_same(number) holds; where there is none, adds `number`.
    template <typename IsSame>
    int find_or_add(Key key, int number, IsSame is_same);
    /// Fetches the place where a key may be.
    void prefetch(Key key) const;
    std::size_t memory_bytes() const { return held_bytes(entries_); }

   private:
    struct Entry {
      std::array<std::uint32_t, sizeof(Key) / 4> key;  ///< halves, so that entries need no padding
      int number;
    };
    void grow();
    std::size_t place_of(Key key) const;

    std::vector<Entry> entries_;
    std::size_t used_ = 0;
    int shift_ = 0;  ///< from a scrambled key to a place
  };

  void number_equally(std::size_t first_place, std::size_t first_number);

  bool has_equal_numbers_;
  std::uint64_t generation_ = 0;
  std::vector<ShapeWord> words_;
  std::vector<Shape> shapes_;
  std::size_t fitted_shapes_ = 0;  ///< shapes before this one have their curves
  Index<std::uint64_t> shape_index_, curve_index_;
  Index<std::uint32_t> joined_index_;
  std::vector<int> numbers_;       ///< by place
  std::vector<EdgeCurve> curves_;  ///< entry 0 is nobody's
  std::vector<TileMask> tiles_;
  std::vector<int> fitted_;  ///< by number, see fitted()
  int first_joined_ = 0;     ///< all curves before this one are fitted ones
  std::vector<ArcShape> added_;
  std::vector<SplineFitter> fitters_;  ///< one a thread
};

}  // namespace depixel
