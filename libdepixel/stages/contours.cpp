#include "libdepixel/stages/contours.hpp"

#include <algorithm>
#include <bit>

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

/// Calls visit(index) for the bytes of a that are not zero, and are not wholly masked out by those of b,
/// eight at a glance. The arrays may change meanwhile.
template <typename Visit>
void for_each_nonzero(const std::uint8_t* a, std::uint8_t wanted_bits, const std::uint8_t* masked_out,
                      int size, Visit visit) {
  constexpr std::uint64_t kOnes = 0x0101010101010101;
  const std::uint64_t wanted = kOnes * wanted_bits;
  int i = 0;
  for (; i + 8 <= size; i += 8) {
    if ((load_vector<std::uint64_t>(a + i) & wanted & ~load_vector<std::uint64_t>(masked_out + i)) == 0)
      continue;
    for (int k = i; k < i + 8; ++k) {
      if ((a[k] & wanted_bits & ~masked_out[k]) != 0) visit(k);
    }
  }
  for (; i < size; ++i) {
    if ((a[i] & wanted_bits & ~masked_out[i]) != 0) visit(i);
  }
}

class Tracer {
 public:
  Tracer(const CellGraph& cells, Contours& contours)
      : cells_(cells), contours_(contours), step_(cells.lattice.step_offsets()) {
    contours_.list.clear();
    contours_.corner.resize(contours_.corner.capacity());
    contours_.heading.resize(contours_.corner.capacity());
  }

  void trace_all() {
    const int size = cells_.lattice.size();
    contours_.traced.assign(size, 0);
    static_assert(sizeof(CornerCode) == 1);
    const auto* codes = reinterpret_cast<const std::uint8_t*>(cells_.corners.data());
    constexpr std::uint8_t kEdges = 15, kEastEdge = 1 << kEast;
    for_each_nonzero(codes, kEdges, contours_.traced.data(), size,
                     [&](int corner) { trace_ending_at(corner); });
    for_each_nonzero(codes, kEastEdge, contours_.traced.data(), size,
                     [&](int corner) { trace_closed(corner); });
    finish();
  }

  void trace_through(std::span<const int> corners) {
    contours_.traced.assign(cells_.lattice.size(), 0);
    for (const int corner : corners) trace_ending_at(corner);
    for (const int corner : corners) {
      while (const unsigned edges = untraced_edges(corner)) {
        trace_passing(corner, static_cast<Direction>(std::countr_zero(edges)));
      }
    }
    finish();
  }

 private:
  /// Every edge belongs to its western or northern corner.
  int owner(int corner, Direction heading) const {
    return heading == kWest || heading == kNorth ? corner + step_[heading] : corner;
  }
  static std::uint8_t owner_bit(Direction heading) {
    return static_cast<std::uint8_t>(heading == kEast || heading == kWest ? 1 << kEast : 1 << kSouth);
  }
  bool is_untraced(int corner, Direction heading) const {
    return (contours_.traced[owner(corner, heading)] & owner_bit(heading)) == 0;
  }

  /// Mask of the visible edges round a corner that are not traced.
  unsigned untraced_edges(int corner) const {
    const std::uint8_t* traced = contours_.traced.data() + corner;
    const int done = (traced[0] & (1 << kEast | 1 << kSouth)) |
                     (traced[step_[kNorth]] >> kSouth & 1) << kNorth |
                     (traced[step_[kWest]] >> kEast & 1) << kWest;
    return static_cast<unsigned>(cells_.corners[corner].visible_edges() & ~done);
  }

  /// Appends nodes from a corner on, until the contour ends or comes back to its start. Works on local
  /// pointers: stores of bytes could otherwise change any member.
  void follow(int corner, Direction heading) {
    const int start = corner;
    const Direction start_heading = heading;
    const CornerCode* codes = cells_.corners.data();
    std::uint8_t* traced = contours_.traced.data();
    int* corners = contours_.corner.data();
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
      traced[is_owner ? corner : next] |= owner_bit(heading);
      corner = next;
      const std::uint8_t onwards = kNextHeading[codes[corner].bits()][heading];
      if (onwards == kNoStep) {
        corners[count] = corner;
        headings[count++] = heading;
        break;
      }
      heading = static_cast<Direction>(onwards);
      if (corner == start && heading == start_heading) break;
    }
    count_ = count;
  }

  void trace_ending_at(int corner) {
    for (unsigned ends = kEndingEdges[cells_.corners[corner].bits()]; ends != 0; ends &= ends - 1) {
      const auto heading = static_cast<Direction>(std::countr_zero(ends));
      if (is_untraced(corner, heading)) trace_open(corner, heading);
    }
  }

  /// From an end; a contour that ends at an earlier corner is turned round.
  void trace_open(int corner, Direction heading) {
    const int first = count_;
    follow(corner, heading);
    contours_.list.push_back({first, count_ - first, false});
    if (contours_.corner[count_ - 1] < corner) turn_round(contours_.list.back());
  }

  void trace_closed(int topmost_left) {
    const int first = count_;
    follow(topmost_left, kEast);
    contours_.list.push_back({first, count_ - first, true});
  }

  /// From somewhere in the middle: goes back to where the contour starts.
  void trace_passing(int corner, Direction heading) {
    const CornerCode* codes = cells_.corners.data();
    int at = corner, topmost_left = corner;
    Direction back = codes[corner].partner(heading);
    const Direction first_back = back;
    for (;;) {
      at += step_[back];
      const std::uint8_t onwards = kNextHeading[codes[at].bits()][back];
      if (onwards == kNoStep) return trace_open(at, opposite(back));
      back = static_cast<Direction>(onwards);
      if (at == corner && back == first_back) return trace_closed(topmost_left);
      topmost_left = std::min(topmost_left, at);
    }
  }

  void turn_round(const Contour& contour) {
    const auto corner = contours_.corner.begin() + contour.first;
    const auto heading = contours_.heading.begin() + contour.first;
    std::reverse(corner, corner + contour.count);
    std::reverse(heading, heading + contour.count - 1);
    for (int k = 0; k < contour.count - 1; ++k) {
      heading[k] = opposite(static_cast<Direction>(heading[k]));
    }
    heading[contour.count - 1] = heading[contour.count - 2];
  }

  void finish() {
    contours_.corner.resize(count_);
    contours_.heading.resize(count_);
  }

  const CellGraph& cells_;
  Contours& contours_;
  std::array<int, 4> step_;
  int count_ = 0;  ///< nodes so far; the arrays are longer while tracing
};

}  // namespace

void trace_contours_through(const CellGraph& cells, std::span<const int> corners, Contours& contours) {
  Tracer(cells, contours).trace_through(corners);
}

void trace_contours(const CellGraph& cells, Contours& contours) {
  Tracer(cells, contours).trace_all();
}

}  // namespace depixel
