#include "tests/support/naive_graph.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace depixel::test {
namespace {

/// Differences of two colours in YUV, in levels; by the formulas of the specification.
std::array<double, 3> yuv(Rgba p, Rgba q) {
  const double r = double(p.r) - q.r, g = double(p.g) - q.g, b = double(p.b) - q.b;
  return {0.299 * r + 0.587 * g + 0.114 * b, -0.169 * r - 0.331 * g + 0.5 * b,
          0.5 * r - 0.419 * g - 0.081 * b};
}

constexpr double kRounding = 1e-9;

bool similar(Rgba p, Rgba q, const Options& options) {
  if (p.a == 0 && q.a == 0) return true;
  if (options.similarity == Similarity::exact) return p == q;
  const auto d = yuv(p, q);
  return p.a == q.a && std::abs(d[0]) <= options.merge_luma + kRounding && std::abs(d[1]) <= 7 + kRounding &&
         std::abs(d[2]) <= 6 + kRounding;
}

bool near(Rgba p, Rgba q) {
  const auto d = yuv(p, q);
  return p.a == q.a && std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) <= 100 + kRounding;
}

}  // namespace

NaiveGraph::NaiveGraph(const Picture& picture, const Options& options) : picture_(picture) {
  for (Rgba& c : picture_.pixels) c = normalized(c);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}}) {
        if (!picture.contains(x + dx, y + dy)) continue;
        if (similar(picture.at(x, y), picture.at(x + dx, y + dy), options)) {
          links_.insert(link({x, y}, {x + dx, y + dy}));
        }
      }
    }
  }
}

template <typename Visit>
void NaiveGraph::for_each_block(Visit visit) const {
  for (int y = 0; y + 1 < picture_.height; ++y) {
    for (int x = 0; x + 1 < picture_.width; ++x) visit(x, y);
  }
}

std::vector<NaiveGraph::Point> NaiveGraph::neighbours(Point p) const {
  std::vector<Point> list;
  for (int y = p.second - 1; y <= p.second + 1; ++y) {
    for (int x = p.first - 1; x <= p.first + 1; ++x) {
      if (linked(p, {x, y})) list.emplace_back(x, y);
    }
  }
  return list;
}

std::set<NaiveGraph::Point> NaiveGraph::reachable(Point from,
                                                  const std::function<bool(Point)>& inside) const {
  std::set<Point> seen{from};
  std::queue<Point> open;
  for (open.push(from); !open.empty(); open.pop()) {
    for (const Point& next : neighbours(open.front())) {
      if (inside(next) && seen.insert(next).second) open.push(next);
    }
  }
  return seen;
}

std::vector<std::vector<NaiveGraph::Point>> NaiveGraph::components() const {
  const auto before = [](Point p, Point q) {
    return std::pair(p.second, p.first) < std::pair(q.second, q.first);
  };
  std::vector<std::vector<Point>> list;
  std::set<Point> seen;
  for (int y = 0; y < picture_.height; ++y) {
    for (int x = 0; x < picture_.width; ++x) {
      if (seen.contains({x, y})) continue;
      const std::set<Point> component = reachable({x, y}, [](Point) { return true; });
      seen.insert(component.begin(), component.end());
      list.emplace_back(component.begin(), component.end());
      std::sort(list.back().begin(), list.back().end(), before);
    }
  }
  return list;
}

void NaiveGraph::connect_lines() {
  const auto list = components();
  const auto component_of = [&](Point p) {
    return std::find_if(list.begin(), list.end(),
                        [&](const auto& c) { return std::find(c.begin(), c.end(), p) != c.end(); });
  };
  const auto is_line = [&](const std::vector<Point>& c) {
    return std::all_of(c.begin(), c.end(), [&](Point p) { return neighbours(p).size() <= 2; });
  };
  std::vector<Link> joins;
  const auto try_join = [&](Point p, Point q) {
    if (!near(picture_.at(p.first, p.second), picture_.at(q.first, q.second))) return;
    const auto a = component_of(p), b = component_of(q);
    if (a != b && is_line(*a) && is_line(*b)) joins.push_back(link(p, q));
  };
  for_each_block([&](int x, int y) {
    try_join({x, y}, {x + 1, y + 1});
    try_join({x + 1, y}, {x, y + 1});
  });
  links_.insert(joins.begin(), joins.end());
}

void NaiveGraph::freeze() {
  for_each_block([&](int x, int y) {
    const Point nw{x, y}, ne{x + 1, y}, sw{x, y + 1}, se{x + 1, y + 1};
    if (linked(nw, ne) + linked(ne, se) + linked(se, sw) + linked(sw, nw) < 3) return;
    links_.erase(link(nw, se));
    links_.erase(link(ne, sw));
  });
}

std::optional<NaiveGraph::Point> NaiveGraph::straightest(Point from, Point at) const {
  const int dx = at.first - from.first, dy = at.second - from.second;
  std::vector<Point> slightly_bent;
  for (const Point& next : neighbours(at)) {
    const int ex = next.first - at.first, ey = next.second - at.second;
    if (ex == dx && ey == dy) return next;
    const int dot = dx * ex + dy * ey, cross = dx * ey - dy * ex;
    if (dot > 0 && std::abs(cross) == 1) slightly_bent.push_back(next);
  }
  if (slightly_bent.size() != 1) return std::nullopt;
  return slightly_bent.front();
}

bool NaiveGraph::is_in_area(Point p) const {
  for (const int dx : {-1, 1}) {
    for (const int dy : {-1, 1}) {
      const Point a{p.first + dx, p.second}, b{p.first, p.second + dy}, c{p.first + dx, p.second + dy};
      if (linked(p, a) && linked(p, b) && (linked(a, c) || linked(b, c))) return true;
    }
  }
  return false;
}

bool NaiveGraph::is_diagonal_junction(Point p) const {
  const std::vector<Point> around = neighbours(p);
  return around.size() > 2 && std::all_of(around.begin(), around.end(), [&](Point q) {
           return q.first != p.first && q.second != p.second;
         });
}

std::optional<NaiveGraph::Point> NaiveGraph::onward(Point from, Point at, CurveRule rule) const {
  const std::vector<Point> around = neighbours(at);
  if (around.size() == 2) return around[0] == from ? around[1] : around[0];
  if (rule == CurveRule::valence || around.size() > 4 || is_in_area(at)) return std::nullopt;
  const bool is_in_dither =
      is_diagonal_junction(at) &&
      std::any_of(around.begin(), around.end(), [&](Point p) { return is_diagonal_junction(p); });
  if (is_in_dither) return std::nullopt;
  const std::optional<Point> next = straightest(from, at);
  if (!next || straightest(*next, at) != from) return std::nullopt;
  return next;
}

int NaiveGraph::curve_length(Point p, Point q, CurveRule rule) const {
  std::set<Link> curve{link(p, q)};
  for (auto [from, to] : {std::pair{p, q}, {q, p}}) {
    while (const auto next = onward(from, to, rule)) {
      if (!curve.insert(link(to, *next)).second) break;
      from = to;
      to = *next;
    }
  }
  return static_cast<int>(curve.size());
}

int NaiveGraph::window_size(Point from, Point block) const {
  const auto inside = [&](Point p) {
    const int dx = p.first - block.first, dy = p.second - block.second;
    return dx >= -3 && dx <= 4 && dy >= -3 && dy <= 4;
  };
  return static_cast<int>(reachable(from, inside).size());
}

double NaiveGraph::vote(Point p, Point q, Point block, const CrossingVotes& votes) const {
  const bool island = neighbours(p).size() == 1 || neighbours(q).size() == 1;
  return votes.curve * curve_length(p, q, votes.curve_rule) - votes.sparse * window_size(p, block) +
         (island ? votes.island : 0);
}

int NaiveGraph::resolve(const CrossingVotes& votes) {
  std::vector<Link> cuts;
  int crossings = 0;
  for_each_block([&](int x, int y) {
    const Point nw{x, y}, ne{x + 1, y}, sw{x, y + 1}, se{x + 1, y + 1};
    if (!linked(nw, se) || !linked(ne, sw)) return;
    ++crossings;
    const double difference = vote(nw, se, nw, votes) - vote(ne, sw, nw, votes);
    if (difference <= 0) cuts.push_back(link(nw, se));
    if (difference >= 0) cuts.push_back(link(ne, sw));
  });
  for (const Link& cut : cuts) links_.erase(cut);
  return crossings;
}

}  // namespace depixel::test
