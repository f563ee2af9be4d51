#pragma once

#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "libdepixel/stages/crossings.hpp"
#include "tests/support/picture.hpp"

namespace depixel::test {

/// The similarity graph as the textbook has it: a set of links between points, everything looked up and
/// walked anew. Slow and simple; shares no code with the library's stages.
class NaiveGraph {
 public:
  using Point = std::pair<int, int>;  ///< x, y
  using Link = std::pair<Point, Point>;

  NaiveGraph(const Picture& picture, const Options& options);

  /// Joins lines of like colour across diagonals (spec: "connect lines").
  void connect_lines();
  /// Drops both diagonals of blocks that are one piece through their sides.
  void freeze();
  /// Votes at every crossing, then cuts.
  /// \return the number of crossings.
  int resolve(const CrossingVotes& votes);

  bool linked(Point p, Point q) const { return links_.contains(link(p, q)); }
  /// Points grouped by connection, in raster order of their first points; each group in raster order too.
  std::vector<std::vector<Point>> components() const;

 private:
  static Link link(Point p, Point q) { return {std::min(p, q), std::max(p, q)}; }

  std::vector<Point> neighbours(Point p) const;
  /// Everything that links which stay inside the area lead to from a point.
  std::set<Point> reachable(Point from, const std::function<bool(Point)>& inside) const;
  /// Where a curve that comes from a point goes on, if anywhere.
  std::optional<Point> onward(Point from, Point at, CurveRule rule) const;
  /// The neighbour that lies straight ahead, or the only one that is half a right angle off; if there is one.
  std::optional<Point> straightest(Point from, Point at) const;
  bool is_in_area(Point p) const;
  bool is_diagonal_junction(Point p) const;
  int curve_length(Point p, Point q, CurveRule rule) const;
  int window_size(Point from, Point block) const;
  double vote(Point p, Point q, Point block, const CrossingVotes& votes) const;
  template <typename Visit>
  void for_each_block(Visit visit) const;

  Picture picture_;
  std::set<Link> links_;
};

}  // namespace depixel::test
