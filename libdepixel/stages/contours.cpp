#include "libdepixel/stages/contours.hpp"

#include <bit>
#include <cstring>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

constexpr std::uint8_t kNoStep = 0xff;

/// For every corner code: the direction taken by a contour that arrives with a heading, or kNoStep where it
/// ends.
constexpr auto kNextHeading = [] {
  std::array<std::array<std::uint8_t, 4>, 128> table{};
  for (int bits = 0; bits < 128; ++bits) {
    for (const Direction heading : kDirections) {
      const CornerCode code(static_cast<std::uint8_t>(bits));
      if (code.pairing() > CornerCode::kNorthWest) continue;
      const Direction onwards = code.partner(opposite(heading));
      table[bits][heading] = code.is_visible(onwards) ? std::uint8_t{onwards} : kNoStep;
    }
  }
  return table;
}();

/// For every corner code: mask of the edges that end there.
constexpr auto kEndingEdges = [] {
  std::array<std::uint8_t, 128> table{};
  for (int bits = 0; bits < 128; ++bits) {
    const CornerCode code(static_cast<std::uint8_t>(bits));
    if (code.pairing() > CornerCode::kNorthWest) continue;
    for (const Direction d : kDirections) table[bits] |= static_cast<std::uint8_t>(code.ends(d) << d);
  }
  return table;
}();

class Tracer {
 public:
  Tracer(const CellGraph& cells, Contours& contours)
      : cells_(cells), contours_(contours), step_(cells.lattice.step_offsets()) {}

  void trace_all() {
    const int size = cells_.lattice.size();
    contours_.list.clear();
    contours_.corner.resize(contours_.corner.capacity());
    contours_.heading.resize(contours_.corner.capacity());
    contours_.through.resize(size);
    contours_.untraced.resize(size);
    constexpr std::uint8_t kOwned = 1 << kEast | 1 << kSouth;
    int i = 0;
    for (; i + static_cast<int>(sizeof(Byte16)) <= size; i += sizeof(Byte16)) {
      store_vector(contours_.untraced.data() + i, load_vector<Byte16>(cells_.corners.data() + i) & kOwned);
    }
    for (; i < size; ++i) contours_.untraced[i] = cells_.corners[i].bits() & kOwned;
    static_assert(sizeof(CornerCode) == 1);
    for_each_nonzero(reinterpret_cast<const std::uint8_t*>(cells_.corners.data()), size, [&](int corner) {
      for (unsigned ends = kEndingEdges[cells_.corners[corner].bits()]; ends != 0; ends &= ends - 1) {
        const auto heading = static_cast<Direction>(std::countr_zero(ends));
        if (is_untraced(corner, heading)) trace_open(corner, heading);
      }
    });
    for_each_nonzero(contours_.untraced.data(), size, [&](int corner) {
      while (contours_.untraced[corner] & 1 << kEast) trace_closed(corner);
    });
    contours_.corner.resize(count_);
    contours_.heading.resize(count_);
  }

 private:
  /// Calls visit(index) for the bytes that are not zero, eight bytes at a glance.
  template <typename Visit>
  static void for_each_nonzero(const std::uint8_t* bytes, int size, Visit visit) {
    int i = 0;
    for (; i + 8 <= size; i += 8) {
      std::uint64_t word;
      std::memcpy(&word, bytes + i, sizeof word);
      if (word == 0) continue;
      for (int k = i; k < i + 8; ++k) {
        if (bytes[k] != 0) visit(k);
      }
    }
    for (; i < size; ++i) {
      if (bytes[i] != 0) visit(i);
    }
  }

  /// Every edge belongs to its western or northern corner.
  int owner(int corner, Direction heading) const {
    return heading == kWest || heading == kNorth ? corner + step_[heading] : corner;
  }
  static std::uint8_t owner_bit(Direction heading) {
    return static_cast<std::uint8_t>(heading == kEast || heading == kWest ? 1 << kEast : 1 << kSouth);
  }
  bool is_untraced(int corner, Direction heading) const {
    return contours_.untraced[owner(corner, heading)] & owner_bit(heading);
  }

  /// Appends nodes from a corner on, until the contour ends or comes back to its start. Works on local
  /// pointers: stores of bytes could otherwise change any member.
  void follow(int corner, Direction heading) {
    const int start = corner;
    const Direction start_heading = heading;
    const CornerCode* codes = cells_.corners.data();
    std::uint8_t* untraced = contours_.untraced.data();
    int *through = contours_.through.data(), *corners = contours_.corner.data();
    std::uint8_t* headings = contours_.heading.data();
    const std::array<int, 4> step = step_;
    int count = count_, room = static_cast<int>(contours_.corner.size());
    for (;;) {
      if (count + 2 > room) {
        contours_.corner.resize(2 * static_cast<std::size_t>(room) + 2);
        contours_.heading.resize(contours_.corner.size());
        corners = contours_.corner.data();
        headings = contours_.heading.data();
        room = static_cast<int>(contours_.corner.size());
      }
      corners[count] = corner;
      headings[count++] = heading;
      const int next = corner + step[heading];
      const bool is_owner = heading == kEast || heading == kSouth;
      untraced[is_owner ? corner : next] &= static_cast<std::uint8_t>(~owner_bit(heading));
      corner = next;
      const std::uint8_t onwards = kNextHeading[codes[corner].bits()][heading];
      if (onwards == kNoStep) {
        corners[count] = corner;
        headings[count++] = heading;
        break;
      }
      if (corner == start && onwards == start_heading) break;
      through[corner] = count;
      heading = static_cast<Direction>(onwards);
    }
    count_ = count;
  }

  void trace_open(int corner, Direction heading) {
    const int first = count_;
    follow(corner, heading);
    contours_.list.push_back({first, count_ - first, false});
  }

  void trace_closed(int corner) {
    const int first = count_;
    contours_.through[corner] = first;
    follow(corner, kEast);
    contours_.list.push_back({first, count_ - first, true});
  }

  const CellGraph& cells_;
  Contours& contours_;
  std::array<int, 4> step_;
  int count_ = 0;  ///< nodes so far; the arrays are longer while tracing
};

}  // namespace

void trace_contours(const CellGraph& cells, Contours& contours) {
  Tracer(cells, contours).trace_all();
}

}  // namespace depixel
