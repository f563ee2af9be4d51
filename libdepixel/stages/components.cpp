#include "libdepixel/stages/components.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace depixel {
namespace {

/// Root of a pixel's tree; halves the path on the way.
int find_root(std::vector<int>& parent, int p) {
  while (parent[p] != p) {
    parent[p] = parent[parent[p]];
    p = parent[p];
  }
  return p;
}

/// Joins two trees under the smaller index, so that a root is the first pixel of its component.
void join(std::vector<int>& parent, int p, int q) {
  p = find_root(parent, p);
  q = find_root(parent, q);
  if (p < q) parent[q] = p;
  if (q < p) parent[p] = q;
}

}  // namespace

void label_components(const SimilarityGraph& graph, Components& components) {
  const Lattice& lattice = graph.lattice;
  const int stride = lattice.stride();
  std::vector<int>& label = components.label;
  label.resize(lattice.size());
  std::iota(label.begin(), label.end(), 0);
  for (int y = 0; y < lattice.height(); ++y) {
    for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i) {
      const int links = graph.links[i];
      if (links & kNorthSide) join(label, i, i + 1);
      if (links & kWestSide) join(label, i, i + stride);
      if (links & kMainDiagonal) join(label, i, i + stride + 1);
      if (links & kAntiDiagonal) join(label, i + 1, i + stride);
    }
  }
  components.size.clear();
  components.colour.clear();
  for (int i = 0; i < lattice.size(); ++i) {
    const glm::ivec2 at = lattice.pixel_position(i);
    if (at.x < 0 || at.y < 0 || at.x >= lattice.width() || at.y >= lattice.height()) {
      label[i] = -1;
    } else if (label[i] == i) {
      label[i] = static_cast<int>(components.size.size());
      components.size.push_back(1);
    } else {
      label[i] = label[label[i]];  // a parent has a lower index, so it holds its final label already
      ++components.size[label[i]];
    }
  }
  components.count = static_cast<int>(components.size.size());
}

void find_majority_colours(const SimilarityGraph& graph, Components& components) {
  const Lattice& lattice = graph.lattice;
  std::vector<std::uint64_t> keys;  // component in the high half, colour in the low half
  keys.reserve(static_cast<std::size_t>(lattice.width()) * lattice.height());
  std::vector<std::uint8_t> is_shown(components.count, 0);
  const auto vote = [&](int i) {
    keys.push_back(std::uint64_t(components.label[i]) << 32 | rgba_order(graph.pixels[i]));
  };
  const int margin = lattice.margin();
  for (int y = margin; y < lattice.height() - margin; ++y) {
    for (int i = lattice.pixel(margin, y), end = i + lattice.shown_width(); i < end; ++i) {
      vote(i);
      is_shown[components.label[i]] = 1;
    }
  }
  if (margin > 0) {
    for (int y = 0; y < lattice.height(); ++y) {
      for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i) {
        if (is_shown[components.label[i]] == 0) vote(i);
      }
    }
  }
  std::sort(keys.begin(), keys.end());
  components.colour.assign(components.count, Rgba{});
  std::vector<std::size_t> best(components.count, 0);
  for (std::size_t i = 0; i < keys.size();) {
    std::size_t end = i;
    while (end < keys.size() && keys[end] == keys[i]) ++end;
    const std::size_t component = keys[i] >> 32;
    if (end - i > best[component]) {
      best[component] = end - i;
      const auto c = static_cast<std::uint32_t>(keys[i]);
      components.colour[component] = {static_cast<std::uint8_t>(c >> 24), static_cast<std::uint8_t>(c >> 16),
                                      static_cast<std::uint8_t>(c >> 8), static_cast<std::uint8_t>(c)};
    }
    i = end;
  }
}

}  // namespace depixel
