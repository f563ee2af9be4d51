#include "libdepixel/svg/simplify.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "libdepixel/svg/curve_fit.hpp"
#include "libdepixel/svg/svg_document.hpp"

namespace depixel {
namespace {

/// Runs of more pieces than this are not tried, nor longer ones where so many in a row did not fit.
constexpr int kLongestRun = 48, kMostFailures = 2;

/// Long runs are tried in steps of this part of their length.
constexpr int kStep = 4;

/// What a curve takes in the paths of both its sides, which go along it in opposite directions.
struct WrittenLength {
  SvgGrid grid;

  static constexpr int kLetter = 1;

  int of_line(const Cubic& c) const {
    const glm::ivec2 by = grid.thousandths(c.p3) - grid.thousandths(c.p0);
    const int numbers = by.x == 0 ? svg_length(by.y) : by.y == 0 ? svg_length(by.x) : svg_length(by);
    return 2 * (kLetter + numbers);
  }
  int of_quadratic(const Cubic& c) const {
    const glm::ivec2 p0 = grid.thousandths(c.p0), p3 = grid.thousandths(c.p3);
    const glm::ivec2 control = grid.thousandths(svg_quadratic_control(c.p0, c.p1, c.p2, c.p3).value_or(c.p1));
    return 2 * (kLetter + svg_length(p3 - p0)) + svg_length(control - p0) + svg_length(control - p3);
  }
  int of_cubic(const Cubic& c) const {
    const glm::ivec2 p0 = grid.thousandths(c.p0), p1 = grid.thousandths(c.p1), p2 = grid.thousandths(c.p2),
                     p3 = grid.thousandths(c.p3);
    return 2 * (kLetter + svg_length(p3 - p0)) + svg_length(p1 - p0) + svg_length(p2 - p0) +
           svg_length(p1 - p3) + svg_length(p2 - p3);
  }
};

/// Finds the shortest way to write a chain.
class ChainSimplifier {
 public:
  ChainSimplifier(double tolerance_px, SvgGrid grid) : length_{grid}, fitter_(tolerance_px, grid) {}

  /// Appends what replaces a chain between two junctions.
  /// \param is_free  whether curves need not keep the tangent at the start, and at the end.
  void simplify_open(std::span<const Cubic> chain, std::array<bool, 2> is_free, std::vector<Cubic>& out) {
    find_nodes(chain, is_free);
    find_shortest(chain);
    for (int to = static_cast<int>(chain.size()); to > 0; to = steps_[to].from)
      out.push_back(steps_[to].curve);
    std::reverse(out.end() - count_steps(), out.end());
  }

  /// Turns a closed chain so that it starts at a node where the shortest way to write it has one, too.
  void turn_closed(std::vector<Cubic>& chain) {
    const auto size = static_cast<int>(chain.size());
    for (int i = 0; i < size; ++i) {
      if (is_corner(chain[(i + size - 1) % size], chain[i])) return turn(chain, i);
    }
    find_nodes(chain, {false, false});
    find_shortest(chain);
    int node = size;
    while (node > size / 2) node = steps_[node].from;
    turn(chain, node);
  }

 private:
  /// The last curve of the shortest way from the chain's start to a node.
  struct Step {
    int length = std::numeric_limits<int>::max();
    int from = 0;
    Cubic curve;
  };

  static void turn(std::vector<Cubic>& chain, int start) {
    std::rotate(chain.begin(), chain.begin() + start, chain.end());
  }

  void find_nodes(std::span<const Cubic> chain, std::array<bool, 2> is_free) {
    is_corner_.assign(chain.size() + 1, 0);
    for (std::size_t i = 1; i < chain.size(); ++i) is_corner_[i] = is_corner(chain[i - 1], chain[i]) ? 1 : 0;
    is_corner_.front() = is_free[0] ? 1 : 0;
    is_corner_.back() = is_free[1] ? 1 : 0;
  }

  void find_shortest(std::span<const Cubic> chain) {
    fitter_.set_chain(chain, is_corner_);
    const int nodes = static_cast<int>(chain.size());
    steps_.assign(nodes + 1, {});
    steps_[0].length = 0;
    for (int from = 0; from < nodes; ++from) {
      const int longest = longest_run(from);
      Failures failures;
      for (int run = 1; run <= longest && failures.of_any() < kMostFailures; run = longer(run, longest)) {
        try_run(from, from + run, failures);
      }
    }
  }

  /// Up to the next corner, or the chain's end.
  int longest_run(int from) const {
    const int most = std::min(static_cast<int>(is_corner_.size()) - 1 - from, kLongestRun);
    int run = 1;
    while (run < most && is_corner_[from + run] == 0) ++run;
    return run;
  }

  /// Of long runs some lengths will do, besides the longest.
  static int longer(int run, int longest) {
    return run == longest ? longest + 1 : std::min(run + std::max(1, run / kStep), longest);
  }

  /// How many runs in a row were in vain for each kind of curve.
  struct Failures {
    int line = 0, quadratic = 0, cubic = 0;
    int of_any() const { return std::min(line, std::min(quadratic, cubic)); }
  };

  /// A line is the shortest; a cubic curve may be so even where a quadratic one fits.
  void try_run(int from, int to, Failures& failures) {
    const auto attempt = [&](int& failed, auto fit, auto length) {
      if (failed >= kMostFailures) return false;
      const std::optional<Cubic> curve = (fitter_.*fit)(from, to);
      failed = curve ? 0 : failed + 1;
      if (curve) offer(from, to, *curve, (length_.*length)(*curve));
      return curve.has_value();
    };
    if (attempt(failures.line, &CurveFitter::fit_line, &WrittenLength::of_line)) return;
    attempt(failures.quadratic, &CurveFitter::fit_quadratic, &WrittenLength::of_quadratic);
    attempt(failures.cubic, &CurveFitter::fit_cubic, &WrittenLength::of_cubic);
  }

  void offer(int from, int to, const Cubic& curve, int length) {
    const int whole = steps_[from].length + length;
    if (whole < steps_[to].length) steps_[to] = {whole, from, curve};
  }

  int count_steps() const {
    int count = 0;
    for (int to = static_cast<int>(steps_.size()) - 1; to > 0; to = steps_[to].from) ++count;
    return count;
  }

  WrittenLength length_;
  CurveFitter fitter_;
  std::vector<char> is_corner_;  ///< of each node: curves need not keep the tangent there, or go on
  std::vector<Step> steps_;      ///< to each node
};

/// The outlines as a planar graph: each piece has a twin, the same way in the other direction.
class OutlineSimplifier {
 public:
  OutlineSimplifier(double tolerance_px, SvgGrid grid, Outlines& outlines)
      : outlines_(outlines), pieces_(outlines.pieces), chains_(tolerance_px, grid) {}

  void simplify() {
    link();
    replacements_.assign(pieces_.size(), {});
    is_done_.assign(pieces_.size(), 0);
    for (int i = 0; i < size(); ++i) {
      if (twin_[i] != kNone && !goes_on(previous_[i])) simplify_open(i);
    }
    for (int i = 0; i < size(); ++i) {
      if (twin_[i] != kNone) simplify_closed(i);
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

  void simplify_open(int first) {
    const int last = gather(first);
    const Replacement replacement = begin_replacement();
    chains_.simplify_open(chain_, {is_free_end(twin_[first]), is_free_end(last)}, curves_);
    end_replacement(replacement, first, twin_[last]);
  }

  void simplify_closed(int first) {
    if (is_done_[first] != 0) return;
    const int last = gather(first);
    chains_.turn_closed(chain_);
    const bool has_corner = is_corner(chain_.back(), chain_.front());
    const Replacement replacement = begin_replacement();
    chains_.simplify_open(chain_, {has_corner, has_corner}, curves_);
    end_replacement(replacement, first, twin_[last]);
  }

  /// Gathers the chain that starts with a piece, or all of a closed one. \return its last piece.
  int gather(int first) {
    chain_.clear();
    int piece = first, last = first;
    do {
      is_done_[piece] = is_done_[twin_[piece]] = 1;
      chain_.push_back(curve(piece));
      last = piece;
      piece = next_[piece];
    } while (goes_on(last) && piece != first);
    return last;
  }

  Replacement begin_replacement() const { return {static_cast<int>(curves_.size()), 0, false}; }
  void end_replacement(Replacement replacement, int first, int first_of_twins) {
    replacement.count = static_cast<int>(curves_.size()) - replacement.first;
    replacements_[first] = replacement;
    replacement.is_reversed = true;
    replacements_[first_of_twins] = replacement;
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

  Outlines& outlines_;
  std::vector<OutlinePiece>& pieces_;
  ChainSimplifier chains_;
  std::vector<int> next_, previous_, twin_;  ///< pieces round each loop; kNone along the picture's border
  std::vector<char> is_done_;
  std::vector<Replacement> replacements_;  ///< of the chains that start with a piece
  std::vector<Cubic> chain_, curves_;
};

}  // namespace

void simplify_outlines(double tolerance_px, SvgGrid grid, Outlines& outlines) {
  OutlineSimplifier(tolerance_px, grid, outlines).simplify();
}

}  // namespace depixel
