#include "libdepixel/stages/planar_map.hpp"

#include <algorithm>
#include <bit>

namespace depixel {

bool is_opaque(const Lattice& lattice, const std::vector<Rgba>& colours) {
  std::uint32_t all = ~0U;
  for (int y = 0; y < lattice.height(); ++y) {
    const Rgba* row = colours.data() + lattice.pixel(0, y);
    for (int x = 0; x < lattice.width(); ++x) all &= std::bit_cast<std::uint32_t>(row[x]);
  }
  return std::bit_cast<Rgba>(all).a == 255;
}

void build_planar_map(const EdgeMap& edges, const SplineTable& table, const std::vector<Rgba>& colours,
                      PlanarMap& map) {
  const Lattice& lattice = edges.lattice;
  map.lattice = lattice;
  map.colours = colours;
  const auto hidden = std::count(edges.curve.begin(), edges.curve.end(), 0);
  const std::size_t visible = edges.curve.size() - static_cast<std::size_t>(hidden);
  if (visible > map.segments.capacity()) map.segments.reserve(visible + visible / 8);
  map.segments.resize(visible);
  Segment* segment = map.segments.data();
  for (int y = 0; y <= lattice.height(); ++y) {
    for (int x = 0; x <= lattice.width(); ++x) {
      const int corner = lattice.corner(x, y);
      const int* curve = edges.curve.data() + edge_slot(corner, false);
      if ((curve[0] | curve[1]) == 0) continue;
      for (const int southwards : {0, 1}) {
        if (curve[southwards] == 0) continue;
        *segment++ =
            segment_of(table.curve(curve[southwards]), {x, y}, corner, southwards != 0, lattice.stride());
      }
    }
  }
}

}  // namespace depixel
