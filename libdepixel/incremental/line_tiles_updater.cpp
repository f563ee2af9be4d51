#include "libdepixel/incremental/line_tiles_updater.hpp"

#include <algorithm>

namespace depixel {
namespace {

/// Where more than this part of the tiles is new, all are cut.
constexpr double kMostCut = 1.0 / 3;
/// Boxes are told as one where that adds no more tiles than this to them: each costs whoever copies the tiles
/// a call.
constexpr int kMostAdded = 64;
/// A run is added to one of this many boxes, the last ones, or becomes a box.
constexpr std::ptrdiff_t kOpenBoxes = 8;
/// Lines are moved together when tiles have fewer than this part of them.
constexpr double kLeastUsed = 0.5;

static_assert(MapChanges::kSame == LineTiles::kKept && MapChanges::kNew == LineTiles::kCut &&
              MapChanges::kMoved == LineTiles::kMoved);

TileBox united(const TileBox& a, const TileBox& b) {
  return {std::min(a.west, b.west), std::min(a.north, b.north), std::max(a.east, b.east),
          std::max(a.south, b.south)};
}

}  // namespace

void LineTilesUpdater::update(const IncrementalVectorizer& source, const MapChanges& changes,
                              glm::dvec2 scale, TileEncoding encoding) {
  const Lattice& lattice = source.lattice();
  is_all_new_ = changes.everything || !is_for(scale, encoding) || lattice != lattice_ ||
                changes.new_tiles > kMostCut * lattice.width() * lattice.height();
  lattice_ = lattice;
  scale_ = scale;
  encoding_ = encoding;
  new_boxes_.clear();
  first_new_line_ = is_all_new_ ? 0 : tiles_.lines().size();
  if (is_all_new_) {
    tiles_.build(source.map(), scale, encoding);
    return;
  }
  if (!changes.any()) return;
  tiles_.update(source.edges(), source.table(), source.colours(), changes.tiles, changes.moves);
  if (static_cast<double>(tiles_.used_lines()) < kLeastUsed * static_cast<double>(tiles_.lines().size())) {
    compact();
  } else {
    find_boxes(lattice, changes.tiles);
  }
}

void LineTilesUpdater::compact() {
  tiles_.compact();
  is_all_new_ = true;
}

void LineTilesUpdater::find_boxes(const Lattice& lattice, const std::vector<std::uint8_t>& fates) {
  for (int y = 0; y < lattice.height(); ++y) {
    const std::uint8_t* row = fates.data() + lattice.pixel(0, y);
    if (are_zero(row, lattice.width())) continue;
    for (int x = 0; x < lattice.width();) {
      const int from = x;
      while (x < lattice.width() && (row[x] == MapChanges::kSame) == (row[from] == MapChanges::kSame)) ++x;
      if (row[from] != MapChanges::kSame) add_run({from, y, x, y + 1});
    }
  }
}

void LineTilesUpdater::add_run(const TileBox& run) {
  const auto added = [&](const TileBox& box) { return united(box, run).area() - box.area() - run.area(); };
  const auto open = new_boxes_.end() - std::min(kOpenBoxes, std::ssize(new_boxes_));
  const auto best = std::min_element(open, new_boxes_.end(),
                                     [&](const TileBox& a, const TileBox& b) { return added(a) < added(b); });
  if (best != new_boxes_.end() && added(*best) <= kMostAdded) {
    *best = united(*best, run);
  } else {
    new_boxes_.push_back(run);
  }
}

}  // namespace depixel
