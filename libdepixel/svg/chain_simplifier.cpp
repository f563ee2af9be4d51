#include "libdepixel/svg/chain_simplifier.hpp"

#include <algorithm>

#include "libdepixel/svg/svg_document.hpp"

namespace depixel {
namespace {

/// Runs of more pieces than this are not tried, nor longer ones where so many in a row did not fit.
constexpr int kLongestRun = 48, kMostFailures = 2;

/// Long runs are tried in steps of this part of their length.
constexpr int kRunParts = 3;

/// Of long runs some lengths will do, besides the longest.
int longer(int run, int longest) {
  return run == longest ? longest + 1 : std::min(run + std::max(1, run / kRunParts), longest);
}

constexpr int kLetter = 1;

}  // namespace

double CurveCost::of_line(const Fit& fit) const {
  const Cubic& c = fit.curve;
  const glm::ivec2 by = grid_.thousandths(c.p3) - grid_.thousandths(c.p0);
  const int numbers = by.x == 0 ? svg_length(by.y) : by.y == 0 ? svg_length(by.x) : svg_length(by);
  return 2 * (kLetter + numbers) + price_ * fit.area_px;
}

double CurveCost::of_quadratic(const Fit& fit) const {
  const Cubic& c = fit.curve;
  const glm::ivec2 p0 = grid_.thousandths(c.p0), p3 = grid_.thousandths(c.p3);
  const glm::ivec2 control = grid_.thousandths(svg_quadratic_control(c.p0, c.p1, c.p2, c.p3).value_or(c.p1));
  return 2 * (kLetter + svg_length(p3 - p0)) + svg_length(control - p0) + svg_length(control - p3) +
         price_ * fit.area_px;
}

double CurveCost::of_cubic(const Fit& fit) const {
  const Cubic& c = fit.curve;
  const glm::ivec2 p0 = grid_.thousandths(c.p0), p1 = grid_.thousandths(c.p1), p2 = grid_.thousandths(c.p2),
                   p3 = grid_.thousandths(c.p3);
  return 2 * (kLetter + svg_length(p3 - p0)) + svg_length(p1 - p0) + svg_length(p2 - p0) +
         svg_length(p1 - p3) + svg_length(p2 - p3) + price_ * fit.area_px;
}

/// Of a closed chain without corners, the way found first tells where to start, and all is done once more.
void ChainSimplifier::simplify(const Chain& chain, std::vector<Cubic>& out) {
  cost_.set_weight(chain.weight);
  std::array<bool, 2> is_free = chain.is_free;
  const bool has_corner = chain.is_closed && is_corner(chain.curves.back(), chain.curves.front());
  if (has_corner) is_free = {true, true};
  find_corners(chain.curves, is_free);
  find_cheapest(chain.curves);
  if (chain.is_closed && !has_corner) {
    const auto size = static_cast<int>(chain.curves.size());
    int node = size;
    while (node > size / 2) node = steps_[node].from;
    turned_ = chain.curves;
    std::rotate(turned_.begin(), turned_.begin() + node, turned_.end());
    find_corners(turned_, is_free);
    find_cheapest(turned_);
  }
  append_steps(out);
}

void ChainSimplifier::find_corners(std::span<const Cubic> chain, std::array<bool, 2> is_free) {
  is_corner_.assign(chain.size() + 1, 0);
  for (std::size_t i = 1; i < chain.size(); ++i) is_corner_[i] = is_corner(chain[i - 1], chain[i]) ? 1 : 0;
  is_corner_.front() = is_free[0] ? 1 : 0;
  is_corner_.back() = is_free[1] ? 1 : 0;
}

void ChainSimplifier::find_cheapest(std::span<const Cubic> chain) {
  fitter_.set_chain(chain, is_corner_);
  const int nodes = static_cast<int>(chain.size());
  steps_.assign(nodes + 1, {});
  steps_[0].cost = 0;
  for (int from = 0; from < nodes; ++from) {
    if (steps_[from].cost + CurveCost::kLeast >= steps_[nodes].cost) continue;
    const int longest = longest_run(from);
    Failures failures;
    for (int run = 1; run <= longest && failures.of_all() < kMostFailures; run = longer(run, longest)) {
      try_run(from, from + run, failures);
    }
  }
}

/// Up to the next corner, or the chain's end.
int ChainSimplifier::longest_run(int from) const {
  const int most = std::min(static_cast<int>(is_corner_.size()) - 1 - from, kLongestRun);
  int run = 1;
  while (run < most && is_corner_[from + run] == 0) ++run;
  return run;
}

/// Where a line fits, nothing else is tried, nor a cubic curve where a quadratic one does.
void ChainSimplifier::try_run(int from, int to, Failures& failures) {
  const auto attempt = [&](int& failed, auto fit_curve, auto cost) {
    if (failed >= kMostFailures) return false;
    const std::optional<Fit> fit = (fitter_.*fit_curve)(from, to);
    failed = fit ? 0 : failed + 1;
    if (fit) offer(from, to, fit->curve, (cost_.*cost)(*fit));
    return fit.has_value();
  };
  if (attempt(failures.line, &CurveFitter::fit_line, &CurveCost::of_line)) return;
  if (attempt(failures.quadratic, &CurveFitter::fit_quadratic, &CurveCost::of_quadratic)) return;
  attempt(failures.cubic, &CurveFitter::fit_cubic, &CurveCost::of_cubic);
}

void ChainSimplifier::offer(int from, int to, const Cubic& curve, double cost) {
  const double whole = steps_[from].cost + cost;
  if (whole < steps_[to].cost) steps_[to] = {whole, from, curve};
}

void ChainSimplifier::append_steps(std::vector<Cubic>& out) const {
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  for (int to = static_cast<int>(steps_.size()) - 1; to > 0; to = steps_[to].from) {
    out.push_back(steps_[to].curve);
  }
  std::reverse(out.begin() + first, out.end());
}

}  // namespace depixel
