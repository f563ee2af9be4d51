#include "libdepixel/svg/soft_groups.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <numeric>
#include <utility>

namespace depixel {
namespace {

class SoftGroups {
 public:
  SoftGroups(const PlanarMap& map, const Components& components) : map_(map), label_(components.label) {
    leader_.resize(components.count);
    std::iota(leader_.begin(), leader_.end(), 0);
    apart_.resize(components.count);
  }

  std::vector<int> find() {
    find_meetings();
    for (const Meeting& m : meetings_) {
      if (m.is_soft) continue;
      apart_[m.a].push_back(m.b);
      apart_[m.b].push_back(m.a);
    }
    for (const Meeting& m : meetings_) {
      if (m.is_soft) join(leader(m.a), leader(m.b));
    }
    return numbered();
  }

 private:
  /// Two components side by side, or across a corner; where they meet more than once, a sharp contour counts.
  struct Meeting {
    int a, b;
    bool is_soft;

    friend auto operator<=>(const Meeting&, const Meeting&) = default;
  };

  void find_meetings() {
    for_each_pixel_pair(map_.lattice, [&](int block, const PixelPair& pair, int a, int b) {
      if (label_[a] == label_[b] || !is_opaque(a) || !is_opaque(b)) return;
      const auto [least, most] = std::minmax(label_[a], label_[b]);
      meetings_.push_back({least, most, (map_.shading.blocks[block] & pair.bit) != 0});
    });
    std::sort(meetings_.begin(), meetings_.end());
    const auto is_same = [](const Meeting& m, const Meeting& n) { return m.a == n.a && m.b == n.b; };
    meetings_.erase(std::unique(meetings_.begin(), meetings_.end(), is_same), meetings_.end());
  }

  bool is_opaque(int pixel) const { return label_[pixel] >= 0 && map_.colours[pixel].a == 255; }

  int leader(int component) {
    while (leader_[component] != component) {
      leader_[component] = leader_[leader_[component]];
      component = leader_[component];
    }
    return component;
  }

  /// The group with fewer that must be apart from it is joined to the other one.
  void join(int a, int b) {
    if (a == b) return;
    if (apart_[a].size() < apart_[b].size()) std::swap(a, b);
    for (const int other : apart_[b]) {
      if (leader(other) == a) return;
    }
    leader_[b] = a;
    apart_[a].insert(apart_[a].end(), apart_[b].begin(), apart_[b].end());
    apart_[b] = {};
  }

  std::vector<int> numbered() {
    std::vector<int> number(leader_.size(), -1), group(leader_.size());
    int count = 0;
    for (int c = 0; c < static_cast<int>(leader_.size()); ++c) {
      int& n = number[leader(c)];
      if (n < 0) n = count++;
      group[c] = n;
    }
    return group;
  }

  const PlanarMap& map_;
  const std::vector<int>& label_;
  std::vector<int> leader_;              ///< of each component's group, or nearer to it
  std::vector<std::vector<int>> apart_;  ///< of each leader: what must not come to its group
  std::vector<Meeting> meetings_;
};

}  // namespace

std::vector<int> find_soft_groups(const PlanarMap& map, const Components& components) {
  return SoftGroups(map, components).find();
}

}  // namespace depixel
