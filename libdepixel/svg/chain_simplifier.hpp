#pragma once

#include <algorithm>
#include <limits>

#include "libdepixel/svg/chain_pose.hpp"
#include "libdepixel/svg/curve_fit.hpp"

namespace depixel {

/// What a written curve costs: the characters that it takes in the paths of both its sides, which go along it
/// in opposite directions, and a price for each bit of colour that it gets wrong.
class CurveCost {
 public:
  /// How many steps there are of how far the colours on both sides of a chain are apart.
  static constexpr int kWeights = 8;

  explicit CurveCost(SvgGrid grid) : grid_(grid) {}
  void set_weight(int weight) { price_ = kSvgPrice * weight / kWeights; }

  double of_line(const Fit& fit) const;
  double of_quadratic(const Fit& fit) const;
  double of_cubic(const Fit& fit) const;
  /// No curve costs less.
  static constexpr double kLeast = 4;

 private:
  SvgGrid grid_;
  double price_ = 0;
};

/// Finds the cheapest way to write a chain between two junctions, or a closed one: of all ways to part it
/// into runs and to fit a curve to each (see curve_fit.hpp), by dynamic programming.
///
/// Cost: linear in curves, for as long as runs of many curves do not fit. Source: Schapfel, section 7.1.8.
class ChainSimplifier {
 public:
  ChainSimplifier(double tolerance_px, SvgGrid grid) : cost_(grid), fitter_(tolerance_px, grid) {}

  /// Appends what replaces a chain. One that is closed starts at a corner, if it has any.
  void simplify(const Chain& chain, std::vector<Cubic>& out);

 private:
  /// The last curve of the cheapest way from the chain's start to a node.
  struct Step {
    double cost = std::numeric_limits<double>::infinity();
    int from = 0;
    Cubic curve;
  };
  /// How many runs in a row were in vain for each kind of curve.
  struct Failures {
    int line = 0, quadratic = 0, cubic = 0;
    int of_all() const { return std::min(line, std::min(quadratic, cubic)); }
  };

  void find_corners(std::span<const Cubic> chain, std::array<bool, 2> is_free);
  void find_cheapest(std::span<const Cubic> chain);
  int longest_run(int from) const;
  void try_run(int from, int to, Failures& failures);
  void offer(int from, int to, const Cubic& curve, double cost);
  void append_steps(std::vector<Cubic>& out) const;

  CurveCost cost_;
  CurveFitter fitter_;
  std::vector<Cubic> turned_;    ///< a closed chain from another start
  std::vector<char> is_corner_;  ///< of each node: curves need not keep the tangent there, or go on
  std::vector<Step> steps_;      ///< to each node
};

}  // namespace depixel
