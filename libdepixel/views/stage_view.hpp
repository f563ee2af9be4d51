#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/raster/view.hpp"
#include "libdepixel/stages/accurate_cells.hpp"

namespace depixel {

/// The intermediate steps that can be looked at, in the order of the pipeline. Source: Schapfel, figure 62.
enum class StageView {
  bitmap,      ///< square pixels, as they came: dithers are not blended
  similarity,  ///< faint pixels, their nodes and links before freezing; crossings ringed in red
  cells,       ///< accurate cells
  simplified,  ///< simplified cells
  contours,    ///< each contour in a colour of its own, shading ones thin; junctions dotted
  polygons,    ///< components as polygonal paths
  curves,      ///< components as curved paths, without smoothing
  smoothed,    ///< the smoothed curves as lines, with their knots and Bezier control points
  components,  ///< each component in one colour
  shaded       ///< the same with shadings: by gradients, where the options have none
};

/// Names as on the command line; names[i] stands for enumerator i.
std::span<const std::string_view> stage_view_names();
std::optional<StageView> stage_view_by_name(std::string_view name);

/// A line drawn along a cubic curve, with round ends.
struct Stroke {
  glm::ivec2 p0, p1, p2, p3;  ///< subpixels
  Rgba colour;
  float width_px = 0;
};

/// A disc, or a ring where ring_px is the width of its line.
struct Circle {
  glm::ivec2 centre;  ///< subpixels
  Rgba colour;
  float radius_px = 0;
  float ring_px = 0;
};

/// What a view shows, in source pixels: regions that divide the picture, then strokes, then circles on top.
struct StageDrawing {
  PlanarMap fill;
  SimilarityGraph graph;           ///< the one that the regions of the fill are the cells or components of
  std::optional<CellShape> cells;  ///< the regions are single cells of this shape; else components
  bool linear_light = false;
  std::vector<Stroke> strokes;
  std::vector<Circle> circles;
};

/// Makes the drawing of a view; buffers of the vectorizer and the drawing are reused.
/// \param frame  at least 1x1 pixels; read during the call only.
/// Cost: that of vectorizing and some more linear in pixels.
void make_stage_drawing(StageView view, const FrameView& frame, const Options& options,
                        Vectorizer& vectorizer, StageDrawing& drawing);
StageDrawing make_stage_drawing(StageView view, const FrameView& frame, const Options& options);

/// Writes a drawing as an SVG document with a viewBox in source pixels.
std::string write_stage_svg(const StageDrawing& drawing);

/// Paints a drawing over the whole target, stretched to fit it, anti-aliased and without seams between
/// regions.
void paint_stage(const StageDrawing& drawing, const PictureView& target);
/// Paints the part of a drawing that a view shows; the whole one is painted alike by both.
void paint_stage(const StageDrawing& drawing, const View& view, const PictureView& target);

}  // namespace depixel
