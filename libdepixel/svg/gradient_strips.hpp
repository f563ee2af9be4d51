#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "libdepixel/stages/planar_map.hpp"

namespace depixel {

/// The mixtures of shades inside groups of components, as strips of linear gradients: one from centre to
/// centre along each row of pixels, two pixels high. Strips of even rows are opaque and meet at the centres
/// of odd rows. Those of odd rows lie on top, under a mask that is opaque at their centres and lets the even
/// rows through at theirs. So what a block shows is bilinear, as in the raster, and nothing reaches further
/// than its block. Where a pixel takes no part, a mean of the block's others stands in for it. Stops that a
/// line through others comes within a level of are left out. Source: own; the mixtures are those of Shading.
class GradientStrips {
 public:
  /// \param group  of each pixel; negative where it has none. Cost: that of sorting the shaded blocks.
  GradientStrips(const PlanarMap& map, const std::vector<int>& group);

  /// Groups that have strips, ascending.
  const std::vector<int>& groups() const { return groups_; }
  /// Appends definitions of what all strips share: the mask, and the units of gradients.
  void append_definitions(std::string& out) const;
  static constexpr const char* kMaskName = "between";

  /// Appends a group's strips of even or odd rows, each gradient where it is first used; nothing if it has
  /// none.
  void append(int group, bool is_odd, std::string& out);

  /// A colour at a place along a row: half a pixel west of a column's west side.
  struct Stop {
    int x;
    Rgba colour;
  };

 private:
  /// Which part of a row's height: the half above its centre, that below, or all.
  enum Part : std::uint8_t { kUpper, kLower, kWhole };

  /// A row's colours in one block: along x, in pixels, from x - 1/2 to x + 1/2.
  struct Piece {
    bool is_odd;
    int group, row, x;
    Part part;
    Rgba left, right;
  };

  void find_pieces(const std::vector<int>& group);
  void add_block(int block, glm::ivec2 at, int group, int taking_part);
  void join_halves();
  std::span<const Piece> pieces_of(int group, bool is_odd) const;
  static std::vector<Stop> stops_of(std::span<const Piece> run);
  void append_gradient_run(std::span<const Piece> run, const std::string& gradient, std::string& out);
  static void append_boxes(std::span<const std::span<const Piece>> runs, std::string& out);

  const PlanarMap& map_;
  std::vector<Piece> pieces_;
  std::vector<int> groups_;
  std::unordered_map<std::string, int> gradients_;  ///< numbers of those written, by their stops
};

}  // namespace depixel
