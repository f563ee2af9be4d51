#include "libdepixel/svg/simplify.hpp"

#include <algorithm>
#include <cstdlib>

#include "libdepixel/svg/chain_table.hpp"

namespace depixel {
namespace {

/// How far two colours are apart, in steps of CurveCost; at least one.
int weight_between(Rgba a, Rgba b) {
  const auto difference = [](int x, int x_alpha, int y, int y_alpha) {
    return std::abs(x * x_alpha - y * y_alpha) / 255;
  };
  int sum = difference(a.r, a.a, b.r, b.a) + difference(a.g, a.a, b.g, b.a) + difference(a.b, a.a, b.b, b.a);
  int most = 3 * 255;
  if (a.a != 255 || b.a != 255) {
    sum += std::abs(a.a - b.a);
    most += 255;
  }
  return std::max(1, (sum * CurveCost::kWeights + most / 2) / most);
}

/// The outlines as a planar graph: each piece has a twin, the same way in the other direction.
class OutlineSimplifier {
 public:
  OutlineSimplifier(const PlanarMap& map, double tolerance_px, SvgGrid grid, Outlines& outlines)
      : map_(map), outlines_(outlines), pieces_(outlines.pieces), chains_(tolerance_px, grid) {}

  void simplify() {
    link();
    replacements_.assign(pieces_.size(), {});
    is_done_.assign(pieces_.size(), 0);
    for (int i = 0; i < size(); ++i) {
      if (twin_[i] != kNone && !goes_on(previous_[i])) simplify_chain(i, false);
    }
    for (int i = 0; i < size(); ++i) {
      if (twin_[i] != kNone) simplify_chain(i, true);
    }
    replace();
  }

 private:
  static constexpr int kNone = -1;

  /// The curves that stand for a chain, in the outline that it starts with a piece.
  struct Replacement {
    int first = 0, count = 0;
    bool is_reversed = false;
  };

  int size() const { return static_cast<int>(pieces_.size()); }
  Cubic curve(int piece) const {
    return {pieces_[previous_[piece]].p3, pieces_[piece].p1, pieces_[piece].p2, pieces_[piece].p3};
  }

  void link() {
    next_.resize(pieces_.size());
    previous_.resize(pieces_.size());
    twin_.assign(pieces_.size(), kNone);
    std::vector<int> on_segment(pieces_.size(), kNone);
    for (const OutlineLoop& loop : outlines_.loops) {
      for (int i = 0; i < loop.count; ++i) {
        const int piece = loop.first + i;
        next_[piece] = loop.first + (i + 1) % loop.count;
        previous_[next_[piece]] = piece;
        const int segment = pieces_[piece].segment;
        if (segment == OutlinePiece::kBorder) continue;
        if (on_segment[segment] != kNone) {
          twin_[piece] = on_segment[segment];
          twin_[twin_[piece]] = piece;
        }
        on_segment[segment] = piece;
      }
    }
  }

  /// Whether no other contour meets the end of a piece, so that both outlines go the same way on.
  bool goes_on(int piece) const {
    const int next = next_[piece];
    return twin_[piece] != kNone && twin_[next] != kNone && next_[twin_[next]] == twin_[piece];
  }

  /// Whether neither outline goes on smoothly from the end of a piece.
  bool is_free_end(int piece) const {
    const Cubic before = curve(piece);
    const int left = next_[piece], right = previous_[twin_[piece]];
    return is_corner(before, curve(left)) && is_corner(before, curve(right).reversed());
  }

  void simplify_chain(int first, bool is_closed) {
    if (is_done_[first] != 0) return;
    const int last = gather(first);
    chain_.is_closed = is_closed;
    chain_.is_free = {false, false};
    if (!is_closed) chain_.is_free = {is_free_end(twin_[first]), is_free_end(last)};
    const Segment& segment = map_.segments[pieces_[first].segment];
    chain_.weight = weight_between(map_.colours[segment.left], map_.colours[segment.right]);
    Replacement replacement{static_cast<int>(curves_.size()), 0, false};
    chains_.simplify(chain_, curves_);
    replacement.count = static_cast<int>(curves_.size()) - replacement.first;
    replacements_[first] = replacement;
    replacement.is_reversed = true;
    replacements_[twin_[last]] = replacement;
  }

  /// Gathers the chain that starts with a piece, or all of a closed one. \return its last piece.
  int gather(int first) {
    chain_.curves.clear();
    int piece = first, last = first;
    do {
      is_done_[piece] = is_done_[twin_[piece]] = 1;
      chain_.curves.push_back(curve(piece));
      last = piece;
      piece = next_[piece];
    } while (goes_on(last) && piece != first);
    return last;
  }

  void replace() {
    std::vector<OutlinePiece> replaced;
    for (OutlineLoop& loop : outlines_.loops) {
      const int first = static_cast<int>(replaced.size());
      int start = loop.first;
      while (replacements_[start].count == 0 && pieces_[start].segment != OutlinePiece::kBorder) ++start;
      int piece = start;
      do {
        append(piece, replaced);
        piece = next_[piece];
      } while (piece != start);
      loop.first = first;
      loop.count = static_cast<int>(replaced.size()) - first;
    }
    pieces_ = std::move(replaced);
  }

  /// Appends what stands for the chain that starts with a piece; nothing for a piece within one.
  void append(int piece, std::vector<OutlinePiece>& replaced) const {
    if (pieces_[piece].segment == OutlinePiece::kBorder) replaced.push_back(pieces_[piece]);
    const Replacement& r = replacements_[piece];
    for (int i = 0; i < r.count; ++i) {
      const Cubic c = r.is_reversed ? curves_[r.first + r.count - 1 - i].reversed() : curves_[r.first + i];
      replaced.push_back({c.p1, c.p2, c.p3, pieces_[piece].segment});
    }
  }

  const PlanarMap& map_;
  Outlines& outlines_;
  std::vector<OutlinePiece>& pieces_;
  ChainTable chains_;
  std::vector<int> next_, previous_, twin_;  ///< pieces round each loop; kNone along the picture's border
  std::vector<char> is_done_;
  std::vector<Replacement> replacements_;  ///< of the chains that start with a piece
  Chain chain_;
  std::vector<Cubic> curves_;
};

}  // namespace

void simplify_outlines(const PlanarMap& map, double tolerance_px, SvgGrid grid, Outlines& outlines) {
  OutlineSimplifier(map, tolerance_px, grid, outlines).simplify();
}

}  // namespace depixel
