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

void build_planar_map(const MapByEdge& from, PlanarMap& map) {
  const std::vector<int>& curve = from.edges.curve;
  map.lattice = from.edges.lattice;
  map.colours = from.colours;
  map.shading = from.shading;
  const auto hidden = std::count(curve.begin(), curve.end(), 0);
  const std::size_t visible = curve.size() - static_cast<std::size_t>(hidden);
  if (visible > map.segments.capacity()) map.segments.reserve(visible + visible / 8);
  map.segments.resize(visible);
  Segment* next = map.segments.data();
  for (int y = 0; y <= map.lattice.height(); ++y) {
    for_each_segment(from, y, [&](const Segment& segment) { *next++ = segment; });
  }
}

}  // namespace depixel
