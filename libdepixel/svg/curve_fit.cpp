#include "libdepixel/svg/curve_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace depixel {
namespace {

constexpr int kQuarters = 4;

/// Curves are fitted to the starts of every quarter of short runs, every second one, or every fourth one of
/// long runs; how near they are is told from all.
int sample_step(int curves) {
  return curves < 3 ? 1 : curves < 6 ? 2 : kQuarters;
}

/// How often parameters, and what is fitted at them, are improved in turns; and how many tolerances a curve
/// may stray meanwhile, for more will not be made good.
constexpr int kImprovements = 3;
constexpr double kHopeless = 5.0;

/// How far a handle may reach, in lengths of the chord: longer ones make loops.
constexpr double kLongestHandle = 2.0;

constexpr double kSquarePixel = 1.0 / (double(kSubpixels) * kSubpixels);

double dot(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.x + a.y * b.y;
}
double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}
double length(glm::dvec2 a) {
  return std::sqrt(dot(a, a));
}

/// From the first of some points to the next that is elsewhere, as a unit vector; zero if there is none.
glm::dvec2 direction(const std::array<glm::ivec2, 4>& points) {
  for (const glm::ivec2 point : points) {
    const glm::dvec2 way(point - points[0]);
    if (point != points[0]) return way / length(way);
  }
  return {0, 0};
}
glm::dvec2 start_tangent(const Cubic& c) {
  return direction({c.p0, c.p1, c.p2, c.p3});
}
glm::dvec2 end_tangent(const Cubic& c) {
  return -start_tangent(c.reversed());
}

bool turns(glm::dvec2 from, glm::dvec2 to, double sine) {
  return dot(from, to) < 0 || std::abs(cross(from, to)) > sine * length(from) * length(to);
}

glm::ivec2 nearest(glm::dvec2 point) {
  return {static_cast<int>(std::lround(point.x)), static_cast<int>(std::lround(point.y))};
}

Cubic line(glm::ivec2 p0, glm::ivec2 p3) {
  const glm::dvec2 a(p0), b(p3);
  return {p0, nearest((2.0 * a + b) / 3.0), nearest((a + 2.0 * b) / 3.0), p3};
}

Cubic quadratic(glm::ivec2 p0, glm::dvec2 control, glm::ivec2 p3) {
  const glm::dvec2 a(p0), b(p3);
  return {p0, nearest((a + 2.0 * control) / 3.0), nearest((b + 2.0 * control) / 3.0), p3};
}

/// A cubic curve as a polynomial.
struct Polynomial {
  glm::dvec2 c0, c1, c2, c3;

  explicit Polynomial(const Cubic& c)
      : c0(c.p0),
        c1(3 * (c.p1 - c.p0)),
        c2(3 * (c.p0 - 2 * c.p1 + c.p2)),
        c3(c.p3 - c.p0 + 3 * (c.p1 - c.p2)) {}

  glm::dvec2 at(double t) const { return ((c3 * t + c2) * t + c1) * t + c0; }
  glm::dvec2 slope(double t) const { return (3.0 * c3 * t + 2.0 * c2) * t + c1; }
  glm::dvec2 bend(double t) const { return 6.0 * c3 * t + 2.0 * c2; }
};

/// The solution of a symmetric system of two equations.
std::optional<glm::dvec2> solve(double a11, double a12, double a22, double b1, double b2) {
  constexpr double kLeast = 1e-9;
  const double determinant = a11 * a22 - a12 * a12;
  if (determinant < kLeast) return std::nullopt;
  return glm::dvec2(b1 * a22 - b2 * a12, b2 * a11 - b1 * a12) / determinant;
}

}  // namespace

bool is_corner(const Cubic& before, const Cubic& after) {
  return turns(end_tangent(before), start_tangent(after), kSvgCorner);
}

void CurveFitter::set_chain(std::span<const Cubic> chain, std::span<const char> is_free) {
  chain_ = chain;
  is_free_ = is_free;
  quarters_.clear();
  tangents_.clear();
  double length = 0;
  for (const Cubic& curve : chain) {
    cut(curve, length);
    tangents_.push_back({start_tangent(curve), end_tangent(curve)});
  }
  const glm::dvec2 end(chain.back().p3);
  quarters_.push_back({end, end, end, length});
  parameter_.resize(quarters_.size());
}

void CurveFitter::cut(const Cubic& curve, double& length) {
  constexpr double kPart = 1.0 / kQuarters;
  const Polynomial p(curve);
  for (int i = 0; i < kQuarters; ++i) {
    const double t = i * kPart, u = (i + 1) * kPart;
    const glm::dvec2 start = p.at(t), end = p.at(u);
    quarters_.push_back({start, start + p.slope(t) * (kPart / 3), end - p.slope(u) * (kPart / 3), length});
    length += depixel::length(end - start);
  }
}

glm::ivec2 CurveFitter::snapped(glm::dvec2 point) const {
  return grid_.snapped(nearest(point));
}

/// \param start, end  directions of a fitted curve at its ends.
bool CurveFitter::keeps_tangents(int from, int to, glm::dvec2 start, glm::dvec2 end) const {
  return (is_free_[from] != 0 || !turns(tangents_[from].start, start, kSvgKink)) &&
         (is_free_[to] != 0 || !turns(tangents_[to - 1].end, end, kSvgKink));
}

/// All points so near to the line are one convex shape, round at its ends, so a curve lies in it if its
/// control points do.
std::optional<Fit> CurveFitter::fit_line(int from, int to) const {
  const glm::ivec2 p0 = snapped_start(from), p3 = snapped_end(to);
  const glm::dvec2 chord(p3 - p0);
  if (p0 == p3 || !keeps_tangents(from, to, chord, chord)) return std::nullopt;
  const auto is_off = [&](glm::ivec2 point) {
    const glm::dvec2 way(point - p0);
    const double part = std::clamp(dot(way, chord) / dot(chord, chord), 0.0, 1.0);
    return length(way - part * chord) > tolerance_;
  };
  for (int i = from; i < to; ++i) {
    const Cubic& c = chain_[i];
    if (is_off(c.p0) || is_off(c.p1) || is_off(c.p2) || is_off(c.p3)) return std::nullopt;
  }
  double area = 0;
  for (int i = kQuarters * from; i < kQuarters * to; ++i) {
    area += std::abs(cross(quarters_[i].start - glm::dvec2(p0), chord)) * quarter_length(i);
  }
  return Fit{line(p0, p3), area / length(chord) * kSquarePixel};
}

/// The nearest one if that keeps the tangents, else the one that has them.
std::optional<Fit> CurveFitter::fit_quadratic(int from, int to) {
  const std::optional<Cubic> best = least_squares_quadratic(from, to);
  if (!best) return std::nullopt;
  const bool is_smooth = keeps_tangents(from, to, best->p1 - best->p0, best->p3 - best->p2);
  if (is_smooth) {
    if (const std::optional<Fit> fit = fit_if_near(from, to, *best)) return fit;
  }
  const std::optional<Cubic> smooth = tangent_quadratic(from, to);
  return smooth ? fit_if_near(from, to, *smooth) : std::nullopt;
}

std::optional<Cubic> CurveFitter::least_squares_quadratic(int from, int to) {
  const glm::ivec2 p0 = snapped_start(from), p3 = snapped_end(to);
  set_parameters_by_length(from, to);
  glm::dvec2 control(0);
  for (int i = 0; i < kImprovements; ++i) {
    control = least_squares_control(from, to, p0, p3);
    if (!improve_parameters(from, to, quadratic(p0, control, p3))) return std::nullopt;
  }
  return quadratic(p0, snapped(control), p3);
}

/// Its control point is where the tangents meet.
std::optional<Cubic> CurveFitter::tangent_quadratic(int from, int to) const {
  const glm::ivec2 p0 = snapped_start(from), p3 = snapped_end(to);
  const glm::dvec2 start = tangents_[from].start, end = tangents_[to - 1].end, chord(p3 - p0);
  const double turn = cross(start, end), longest = kLongestHandle * length(chord) * std::abs(turn);
  const double by_start = turn > 0 ? cross(chord, end) : -cross(chord, end);
  const double by_end = turn > 0 ? cross(start, chord) : -cross(start, chord);
  if (by_start <= 0 || by_end <= 0 || by_start > longest || by_end > longest) return std::nullopt;
  return quadratic(p0, snapped(glm::dvec2(p0) + start * (by_start / std::abs(turn))), p3);
}

std::optional<Fit> CurveFitter::fit_cubic(int from, int to) {
  const glm::ivec2 p0 = snapped_start(from), p3 = snapped_end(to);
  if (to - from == 1) {
    return Fit{{p0, grid_.snapped(chain_[from].p1), grid_.snapped(chain_[from].p2), p3}, 0};
  }
  set_parameters_by_length(from, to);
  std::optional<Cubic> curve;
  for (int i = 0; i < kImprovements; ++i) {
    curve = least_squares_handles(from, to, p0, p3);
    if (!curve || !improve_parameters(from, to, *curve)) return std::nullopt;
  }
  curve->p1 = grid_.snapped(curve->p1);
  curve->p2 = grid_.snapped(curve->p2);
  return fit_if_near(from, to, *curve);
}

void CurveFitter::set_parameters_by_length(int from, int to) {
  const int first = kQuarters * from, last = kQuarters * to;
  step_ = sample_step(to - from);
  const double start = quarters_[first].length_before, whole = quarters_[last].length_before - start;
  for (int i = first; i < last; i += step_) parameter_[i] = (quarters_[i].length_before - start) / whole;
  parameter_[last] = 1;
}

/// One step of Newton's towards where a curve is nearest to the start of each quarter that it is fitted to.
/// \return whether there is hope that the curve is near.
bool CurveFitter::improve_parameters(int from, int to, const Cubic& curve) {
  const Polynomial p(curve);
  const double hopeless = kHopeless * kHopeless * tolerance_ * tolerance_;
  for (int i = kQuarters * from + step_; i < kQuarters * to; i += step_) {
    const double t = parameter_[i];
    const glm::dvec2 off = p.at(t) - quarters_[i].start, slope = p.slope(t);
    if (dot(off, off) > hopeless) return false;
    const double rise = dot(slope, slope) + dot(off, p.bend(t));
    if (rise > 0) parameter_[i] = std::clamp(t - dot(off, slope) / rise, parameter_[i - step_], 1.0);
  }
  return true;
}

/// Fills in the parameters between those that a curve was fitted at, by the lengths.
void CurveFitter::refine_parameters(int from, int to) {
  for (int i = kQuarters * from; i < kQuarters * to; i += step_) {
    const double start = quarters_[i].length_before, whole = quarters_[i + step_].length_before - start;
    const double scale = whole > 0 ? (parameter_[i + step_] - parameter_[i]) / whole : 0;
    for (int j = i + 1; j < i + step_; ++j) {
      parameter_[j] = parameter_[i] + scale * (quarters_[j].length_before - start);
    }
  }
  step_ = 1;
}

/// The control point for which a quadratic curve, at its parameters, is nearest to the starts of quarters.
glm::dvec2 CurveFitter::least_squares_control(int from, int to, glm::dvec2 p0, glm::dvec2 p3) const {
  double weight = 0;
  glm::dvec2 sum(0);
  for (int i = kQuarters * from + step_; i < kQuarters * to; i += step_) {
    const double t = parameter_[i], s = 1 - t, b = 2 * s * t;
    sum += b * (quarters_[i].start - s * s * p0 - t * t * p3);
    weight += b * b;
  }
  return weight > 0 ? sum / weight : 0.5 * (p0 + p3);
}

/// The cubic curve with the run's tangents that, at its parameters, is nearest to the starts of quarters.
std::optional<Cubic> CurveFitter::least_squares_handles(int from, int to, glm::ivec2 p0,
                                                        glm::ivec2 p3) const {
  const glm::dvec2 a(p0), b(p3), start = tangents_[from].start, end = -tangents_[to - 1].end;
  double c11 = 0, c12 = 0, c22 = 0, x1 = 0, x2 = 0;
  for (int i = kQuarters * from + step_; i < kQuarters * to; i += step_) {
    const double t = parameter_[i], s = 1 - t, b1 = 3 * s * s * t, b2 = 3 * s * t * t;
    const glm::dvec2 rest = quarters_[i].start - a * (s * s * s + b1) - b * (t * t * t + b2);
    c11 += b1 * b1;
    c12 += b1 * b2;
    c22 += b2 * b2;
    x1 += b1 * dot(start, rest);
    x2 += b2 * dot(end, rest);
  }
  const auto handles = solve(c11, c12 * dot(start, end), c22, x1, x2);
  const double longest = kLongestHandle * length(b - a);
  const auto is_possible = [longest](double handle) { return handle > 0 && handle <= longest; };
  if (!handles || !is_possible(handles->x) || !is_possible(handles->y)) return std::nullopt;
  return Cubic{p0, nearest(a + handles->x * start), nearest(b + handles->y * end), p3};
}

/// A curve, unless it strays from a run more than it may. Parameters are those of a curve near this one.
std::optional<Fit> CurveFitter::fit_if_near(int from, int to, const Cubic& curve) {
  refine_parameters(from, to);
  if (!improve_parameters(from, to, curve)) return std::nullopt;
  const Polynomial p(curve);
  const auto is_off = [this](glm::dvec2 off) { return !(dot(off, off) <= tolerance_ * tolerance_); };
  glm::dvec2 at(curve.p0), slope = p.slope(0);
  double area = 0;
  for (int i = kQuarters * from; i < kQuarters * to; ++i) {
    const double third = (parameter_[i + 1] - parameter_[i]) / 3;
    const glm::dvec2 next_at = p.at(parameter_[i + 1]), next_slope = p.slope(parameter_[i + 1]);
    if (is_off(at - quarters_[i].start) || is_off(at + slope * third - quarters_[i].p1) ||
        is_off(next_at - next_slope * third - quarters_[i].p2) || is_off(next_at - quarters_[i + 1].start)) {
      return std::nullopt;
    }
    area += length(at - quarters_[i].start) * quarter_length(i);
    at = next_at;
    slope = next_slope;
  }
  return Fit{curve, area * kSquarePixel};
}

}  // namespace depixel
