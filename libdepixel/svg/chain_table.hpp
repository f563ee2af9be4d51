#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "libdepixel/svg/chain_pose.hpp"
#include "libdepixel/svg/chain_simplifier.hpp"

namespace depixel {

/// Simplifies chains, and remembers the results by their shapes: in pixel art the same ones recur, moved by
/// whole pixels, flipped and turned. So however a picture lies, its chains are simplified alike.
class ChainTable {
 public:
  /// \param grid  all points of simplified chains lie on it.
  ChainTable(double tolerance_px, SvgGrid grid) : simplifier_(tolerance_px, grid) {}

  /// Appends the curves that stand for a chain, in its direction; those of a closed chain may start at any of
  /// its nodes.
  void simplify(const Chain& chain, std::vector<Cubic>& out);

 private:
  /// Some of the curves.
  struct Range {
    std::size_t first, count;
  };
  struct Hash {
    using is_transparent = void;  // NOLINT(readability-identifier-naming): as the standard has it
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };

  void find_starts(const Chain& chain);
  void write_key();

  ChainSimplifier simplifier_;
  std::unordered_map<std::string, Range, Hash, std::equal_to<>> known_;
  std::vector<Cubic> curves_;  ///< of all known shapes, one after the other
  std::vector<int> starts_;    ///< scratch
  Chain posed_;
  std::string key_;
};

}  // namespace depixel
