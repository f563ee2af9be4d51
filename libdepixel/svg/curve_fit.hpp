#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "libdepixel/svg/svg_grid.hpp"

namespace depixel {

/// A cubic Bezier curve, in subpixels.
struct Cubic {
  glm::ivec2 p0, p1, p2, p3;

  Cubic reversed() const { return {p3, p2, p1, p0}; }
  friend bool operator==(const Cubic&, const Cubic&) = default;
};

/// A curve that stands for a run of others.
struct Fit {
  Cubic curve;
  double area_px;  ///< roughly, between it and them, in square pixels
};

/// Whether one curve goes on from another at an angle; curves as short as a point do not.
bool is_corner(const Cubic& before, const Cubic& after);

/// Fits single curves to runs of a chain of curves: a line, a quadratic curve, or a cubic one, with all
/// points on a grid. All come as cubics.
///
/// A fitted curve strays from its run by at most the tolerance, and the run from it. To tell so, both are cut
/// to as many parts, where they are nearest to each other: the difference of two cubic curves of one
/// parameter is a cubic curve, too, and lies within the hull of its control points.
///
/// Source: Schneider, "An Algorithm for Automatically Fitting Digitized Curves", Graphics Gems, 1990.
class CurveFitter {
 public:
  /// \param tolerance_px  includes what rounding to the grid adds.
  CurveFitter(double tolerance_px, SvgGrid grid) : tolerance_(tolerance_px * kSubpixels), grid_(grid) {}

  /// Chooses the chain whose runs are fitted.
  /// \param chain  each curve starts where the one before ends; read until another one is chosen.
  /// \param is_free  of each node, and so one more than curves: fitted curves need not keep the tangent
  /// there.
  void set_chain(std::span<const Cubic> chain, std::span<const char> is_free);

  /// Fit a curve to the curves from .. to - 1 of the chain; none if that strays too far, which one curve by
  /// itself, as a cubic, never does.
  std::optional<Fit> fit_line(int from, int to) const;
  std::optional<Fit> fit_quadratic(int from, int to);
  std::optional<Fit> fit_cubic(int from, int to);

 private:
  /// A quarter of a curve of the chain, without its end, which is where the next starts.
  struct Quarter {
    glm::dvec2 start, p1, p2;
    double length_before;  ///< along the chain
  };
  struct Tangents {
    glm::dvec2 start, end;  ///< unit vectors in the direction of travel
  };

  void cut(const Cubic& curve, double& length);
  glm::ivec2 snapped(glm::dvec2 point) const;
  glm::ivec2 snapped_start(int from) const { return grid_.snapped(chain_[from].p0); }
  glm::ivec2 snapped_end(int to) const { return grid_.snapped(chain_[to - 1].p3); }
  double quarter_length(int i) const { return quarters_[i + 1].length_before - quarters_[i].length_before; }
  bool keeps_tangents(int from, int to, glm::dvec2 start, glm::dvec2 end) const;
  std::optional<Fit> fit_if_near(int from, int to, const Cubic& curve);
  void set_parameters_by_length(int from, int to);
  bool improve_parameters(int from, int to, const Cubic& curve);
  void refine_parameters(int from, int to);
  std::optional<Cubic> least_squares_quadratic(int from, int to);
  std::optional<Cubic> tangent_quadratic(int from, int to) const;
  glm::dvec2 least_squares_control(int from, int to, glm::dvec2 p0, glm::dvec2 p3) const;
  std::optional<Cubic> least_squares_handles(int from, int to, glm::ivec2 p0, glm::ivec2 p3) const;

  double tolerance_;  ///< in subpixels
  SvgGrid grid_;
  std::span<const Cubic> chain_;
  std::span<const char> is_free_;
  std::vector<Quarter> quarters_;  ///< four a curve, and one that starts where the chain ends
  std::vector<Tangents> tangents_;
  std::vector<double> parameter_;  ///< scratch: where a fitted curve is nearest to the start of each quarter
  int step_ = 1;                   ///< scratch: of how many quarters one has its parameter
};

}  // namespace depixel
