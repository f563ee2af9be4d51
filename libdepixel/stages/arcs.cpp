#include "libdepixel/stages/arcs.hpp"

#include <algorithm>

namespace depixel {
namespace {

/// Steps that the arms of a right angle have, at least, where the spline is broken.
constexpr int kCornerArm = 3;
/// Closed contours of fewer nodes are interpolated by the adaptive kind. Source: Schapfel, section 4.6.3.
constexpr int kAdaptiveNodes = 30;
/// Averaging goes on for a round more every so many nodes. Source: Schapfel, section 4.7.
constexpr int kNodesPerRound = 20, kMaxRounds = 10;

ArcKind kind_of(const Contour& contour, SplineKind kind, Smoothing smoothing) {
  ArcKind result;
  result.interpolated = kind == SplineKind::interpolate ||
                        (kind == SplineKind::adaptive && contour.closed && contour.count < kAdaptiveNodes);
  if (smoothing == Smoothing::average) {
    result.rounds = static_cast<std::uint8_t>(std::min(1 + contour.count / kNodesPerRound, kMaxRounds));
  }
  return result;
}

class ArcCutter {
 public:
  ArcCutter(const CellGraph& cells, const Contours& contours, const std::vector<std::uint8_t>* marks,
            Arcs& arcs)
      : codes_(cells.corners.data()),
        marks_(marks == nullptr ? nullptr : marks->data()),
        contours_(contours),
        arcs_(arcs),
        left_(cells.lattice.left_offsets()) {
    arcs_.list.clear();
  }

  void cut(const Contour& contour, ArcKind kind) {
    corner_ = contours_.corner.data() + contour.first;
    heading_ = contours_.heading.data() + contour.first;
    nodes_ = contour.count;
    kind_ = kind;
    find_continuations(contour);
    const std::uint8_t* continues = arcs_.continues.data() + kCornerArm - 1;
    int from = contour.closed ? -1 : 0;
    int first_cut = from;
    const int last = contour.closed ? nodes_ : nodes_ - 1;
    for (int k = contour.closed ? 0 : 1; k < last; ++k) {
      if (continues[k] != 0 || !is_cut(continues, k)) continue;
      if (from < 0) {
        first_cut = k;
      } else {
        append(from, k);
      }
      from = k;
    }
    if (!contour.closed) {
      append(from, last);
    } else if (from < 0) {
      append_closed();
    } else {
      append(from, first_cut + nodes_);
    }
  }

 private:
  /// For each node: 1 where the contour goes straight on, else, and at open ends, 0.
  void find_continuations(const Contour& contour) {
    constexpr int kBeyond = kCornerArm - 1;
    if (static_cast<int>(arcs_.continues.size()) < nodes_ + 2 * kBeyond) {
      arcs_.continues.resize(2 * std::size_t(nodes_) + 2 * kBeyond);
    }
    std::uint8_t* continues = arcs_.continues.data() + kBeyond;
    int before = heading_[nodes_ - 1];
    for (int k = 0; k < nodes_; ++k) {
      const int heading = heading_[k];
      const bool goes_on = heading == before && !codes_[corner_[k]].is_junction_of_four();
      continues[k] = goes_on ? 1 : 0;
      before = heading;
    }
    if (!contour.closed) continues[0] = continues[nodes_ - 1] = 0;
    for (int beyond = 1; beyond <= kBeyond; ++beyond) {
      continues[-beyond] = contour.closed ? continues[wrapped(-beyond)] : 0;
      continues[nodes_ - 1 + beyond] = contour.closed ? continues[wrapped(nodes_ - 1 + beyond)] : 0;
    }
  }

  bool is_cut(const std::uint8_t* continues, int k) const {
    if (codes_[corner_[k]].is_junction_of_four()) return true;
    if (marks_ == nullptr) return false;
    bool has_arms = true;
    for (int arm = 1; arm < kCornerArm; ++arm) has_arms &= continues[k - arm] != 0 && continues[k + arm] != 0;
    return has_arms;
  }

  int wrapped(int k) const { return k < 0 ? k + nodes_ : k >= nodes_ ? k - nodes_ : k; }

  ShapeWord word(CornerCode code, int corner, Direction heading) const {
    if (marks_ == nullptr) return {code, heading, 0, 0};
    return {code, heading, marks_[corner + left_[heading]], marks_[corner + left_[(heading + 1) & 3]]};
  }

  void put(int k, bool is_end) {
    const int corner = corner_[k];
    const auto heading = static_cast<Direction>(heading_[k]);
    arcs_.corner[next_] = corner;
    arcs_.word[next_++] = word(is_end ? CornerCode{} : codes_[corner], corner, heading);
  }

  void make_room(int nodes) {
    const std::size_t wanted = static_cast<std::size_t>(next_) + nodes;
    if (wanted <= arcs_.corner.size()) return;
    // Most nodes belong to one arc.
    const std::size_t room = std::max(wanted, contours_.corner.size()) + wanted / 4;
    arcs_.corner.reserve(room);
    arcs_.word.reserve(room);
    arcs_.corner.resize(room);
    arcs_.word.resize(room);
  }

  /// Nodes from .. to, which may run beyond the end of a closed contour.
  void append(int from, int to) {
    make_room(to - from + 1);
    const int first = next_;
    put(from, true);
    int k = from + 1;
    for (const int end = std::min(to, nodes_); k < end; ++k) put(k, false);
    for (; k < to; ++k) put(k - nodes_, false);
    arcs_.corner[next_] = corner_[wrapped(to)];
    arcs_.word[next_] = ShapeWord(CornerCode{}, arcs_.word[next_ - 1].heading(), 0, 0);
    ++next_;
    arcs_.list.push_back({first, next_ - first, kind_});
  }

  void append_closed() {
    make_room(nodes_);
    const int first = next_;
    for (int k = 0; k < nodes_; ++k) put(k, false);
    arcs_.list.push_back({first, nodes_, {true, kind_.interpolated, kind_.rounds}});
  }

  const CornerCode* codes_;
  const std::uint8_t* marks_;  ///< none where right angles are not cut
  const Contours& contours_;
  Arcs& arcs_;
  std::array<int, 4> left_;
  const int* corner_ = nullptr;  ///< of the contour that is cut
  const std::uint8_t* heading_ = nullptr;
  int nodes_ = 0;
  ArcKind kind_;
  int next_ = 0;  ///< entry to be written next
};

}  // namespace

void cut_arcs(const CellGraph& cells, const Contours& contours, const std::vector<std::uint8_t>& marks,
              SplineKind kind, Smoothing smoothing, Arcs& arcs) {
  ArcCutter cutter(cells, contours, smoothing == Smoothing::energy ? &marks : nullptr, arcs);
  for (const Contour& contour : contours.list) cutter.cut(contour, kind_of(contour, kind, smoothing));
}

}  // namespace depixel
