#include "libdepixel/views/stage_view.hpp"

#include <algorithm>
#include <array>

namespace depixel {
namespace {

constexpr std::array<std::string_view, 10> kNames{"bitmap",     "similarity", "cells",  "simplified",
                                                  "contours",   "polygons",   "curves", "smoothed",
                                                  "components", "shaded"};

/// Line widths and radii, in source pixels.
constexpr float kHairline = 0.04f, kThin = 0.07f, kThick = 0.15f, kDot = 0.11f, kRing = 0.4f;

constexpr Rgba kBlue{70, 130, 245, 255}, kInk{45, 50, 70, 255}, kRed{225, 25, 25, 255},
    kWhite{255, 255, 255, 255}, kOrange{240, 150, 40, 255};

/// Colours that tell neighbouring contours apart, also on faint pixels.
constexpr std::array<Rgba, 10> kContourColours{{{214, 39, 40, 255},
                                                {31, 119, 180, 255},
                                                {44, 160, 44, 255},
                                                {148, 103, 189, 255},
                                                {255, 127, 14, 255},
                                                {140, 86, 75, 255},
                                                {23, 170, 187, 255},
                                                {227, 89, 174, 255},
                                                {150, 150, 20, 255},
                                                {60, 60, 60, 255}}};

/// A colour as paper under a drawing: opaque and mixed with white.
Rgba faint(Rgba c) {
  constexpr int kPart = 4;
  const auto channel = [&](std::uint8_t v) {
    return static_cast<std::uint8_t>(255 - (255 - v) * c.a / (255 * kPart));
  };
  return {channel(c.r), channel(c.g), channel(c.b), 255};
}

Stroke straight(glm::ivec2 from, glm::ivec2 to, Rgba colour, float width_px) {
  const glm::ivec2 third = (to - from) / 3;
  return {from, from + third, to - third, to, colour, width_px};
}

class Drawer {
 public:
  Drawer(const Vectorizer& stages, StageDrawing& drawing) : stages_(stages), drawing_(drawing) {}

  void draw(StageView view, const FrameView& frame, const Options& options) {
    switch (view) {
      case StageView::bitmap:
        return fill_squares(frame);
      case StageView::similarity:
        fill_squares(pixels_of(stages_.graph()));
        fade();
        return draw_links(options);
      case StageView::cells:
        return draw_cells(CellShape::accurate);
      case StageView::simplified:
        return draw_cells(CellShape::simplified);
      case StageView::contours:
        fill_polygons();
        fade();
        return draw_contours();
      case StageView::polygons:
        return fill_polygons();
      case StageView::curves:
      case StageView::components:
        return fill_components();
      case StageView::shaded:
        fill_components();
        drawing_.fill.shading = stages_.map().shading;
        return;
      case StageView::smoothed:
        fill_components();
        fade();
        return draw_curves();
    }
  }

 private:
  void fade() {
    for (Rgba& c : drawing_.fill.colours) c = faint(c);
  }

  void fill_components() {
    drawing_.graph = stages_.graph();
    drawing_.fill = stages_.map();
    drawing_.fill.shading = {};
  }

  void fill_cells(CellShape shape) {
    drawing_.cells = shape;
    build_cell_map(drawing_.graph, shape, drawing_.fill);
  }

  void remove_links() {
    std::fill(drawing_.graph.links.begin(), drawing_.graph.links.end(), std::uint8_t{0});
  }

  /// Squares are the cells of a graph without links.
  void fill_squares(const FrameView& frame) {
    drawing_.graph.resize(Lattice(frame.width, frame.height, frame.margin));
    remove_links();
    for (int y = 0; y < frame.height; ++y) take_pixels(frame, y, 0, frame.width, drawing_.graph);
    fill_cells(CellShape::simplified);
  }

  void draw_cells(CellShape shape) {
    drawing_.graph = stages_.graph();
    fill_cells(shape);
    for (const Segment& s : drawing_.fill.segments) {
      drawing_.strokes.push_back({s.p0, s.p1, s.p2, s.p3, kBlue, kHairline});
    }
  }

  glm::ivec2 pixel_centre(int pixel) const {
    return drawing_.fill.lattice.pixel_position(pixel) * kSubpixels + kSubpixels / 2;
  }

  /// The graph as it is before freezing. Links in a row are one stroke.
  void draw_links(const Options& options) {
    SimilarityGraph& graph = drawing_.graph;
    build_raw_similarity_graph(pixels_of(stages_.graph()), LinkCriteria::of(options), graph);
    const Lattice& lattice = graph.lattice;
    const int stride = lattice.stride();
    struct LinkKind {
      int link, from,
          step;  // bit in the block; its pixel, relative to the block's index; index offset of a step
    };
    const std::array<LinkKind, 4> kinds{{{kNorthSide, 0, 1},
                                         {kWestSide, 0, stride},
                                         {kMainDiagonal, 0, stride + 1},
                                         {kAntiDiagonal, 1, stride - 1}}};
    for (int y = 0; y < lattice.height(); ++y) {
      for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i) {
        for (const auto [link, from, step] : kinds) {
          if ((graph.links[i] & link) == 0 || (graph.links[i - step] & link) != 0) continue;
          int last = i;
          while (graph.links[last + step] & link) last += step;
          drawing_.strokes.push_back(
              straight(pixel_centre(i + from), pixel_centre(last + from + step), kBlue, kThin));
        }
        drawing_.circles.push_back({pixel_centre(i), kInk, kDot, 0});
      }
    }
    mark_crossings();
    remove_links();  // the pixels stay squares
  }

  void mark_crossings() {
    const SimilarityGraph& graph = drawing_.graph;
    for (int i = 0; i < graph.lattice.size(); ++i) {
      if ((graph.links[i] & kBothDiagonals) != kBothDiagonals || !graph.is_crossing(i)) continue;
      drawing_.circles.push_back({graph.lattice.corner_position(i) * kSubpixels, kRed, kRing, kThin});
    }
  }

  /// Where a contour's node lies in the cell graph.
  glm::ivec2 cell_node(int node) const {
    const int corner = stages_.contours().corner[node];
    const auto heading = static_cast<Direction>(stages_.contours().heading[node]);
    const glm::ivec2 quarters = stages_.cells().corners[corner].node_quarters(heading);
    return stages_.cells().lattice.corner_position(corner) * kSubpixels + quarters * (kSubpixels / 4);
  }

  /// Calls visit(contour, step) for every step of every contour: a straight segment between two nodes of the
  /// cell graph.
  template <typename Visit>
  void for_each_step(Visit visit) {
    const Contours& contours = stages_.contours();
    const std::array<int, 4> left = stages_.map().lattice.left_offsets();
    for (int c = 0; c < static_cast<int>(contours.list.size()); ++c) {
      const Contour& contour = contours.list[c];
      for (int k = 0; k < contour.step_count(); ++k) {
        const int node = contour.first + k, next = contour.first + (k + 1) % contour.count;
        const int corner = contours.corner[node], heading = contours.heading[node];
        const glm::ivec2 from = cell_node(node), to = cell_node(next), third = (to - from) / 3;
        visit(c, Segment{from, from + third, to - third, to, corner + left[heading],
                         corner + left[(heading + 1) & 3]});
      }
    }
  }

  void fill_polygons() {
    fill_components();
    drawing_.fill.segments.clear();
    for_each_step([&](int, const Segment& step) { drawing_.fill.segments.push_back(step); });
  }

  void draw_contours() {
    const PlanarMap& map = stages_.map();
    for_each_step([&](int contour, const Segment& step) {
      const bool shading = near_yuv(map.left_colour(step), map.right_colour(step));
      drawing_.strokes.push_back(straight(step.p0, step.p3, kContourColours[contour % kContourColours.size()],
                                          shading ? kThin : kThick));
    });
    const Contours& contours = stages_.contours();
    for (const Contour& contour : contours.list) {
      if (contour.closed) continue;
      for (const int end : {contour.first, contour.first + contour.count - 1}) mark_junction(cell_node(end));
    }
  }

  void mark_junction(glm::ivec2 at) {
    drawing_.circles.push_back({at, kWhite, kThick, 0});
    drawing_.circles.push_back({at, kInk, kThick, kHairline});
  }

  void draw_curves() {
    for (const Segment& s : stages_.map().segments) {
      drawing_.strokes.push_back({s.p0, s.p1, s.p2, s.p3, kInk, kThin});
      for (const glm::ivec2 control : {s.p1, s.p2})
        drawing_.circles.push_back({control, kOrange, kThin / 2, 0});
      drawing_.circles.push_back({s.p0, kRed, kThin, 0});
    }
  }

  const Vectorizer& stages_;
  StageDrawing& drawing_;
};

}  // namespace

std::span<const std::string_view> stage_view_names() {
  return kNames;
}

std::optional<StageView> stage_view_by_name(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<StageView>(found - kNames.begin());
}

void make_stage_drawing(StageView view, const FrameView& frame, const Options& options,
                        Vectorizer& vectorizer, StageDrawing& drawing) {
  Options used = options;
  if (view == StageView::curves) used.smoothing = Smoothing::none;
  if (view == StageView::shaded && used.shading == ShadingKind::none) used.shading = ShadingKind::gradient;
  vectorizer.vectorize(frame, used);
  drawing.cells.reset();
  drawing.linear_light = options.linear_light;
  drawing.strokes.clear();
  drawing.circles.clear();
  Drawer(vectorizer, drawing).draw(view, frame, options);
}

StageDrawing make_stage_drawing(StageView view, const FrameView& frame, const Options& options) {
  Vectorizer vectorizer;
  StageDrawing drawing;
  make_stage_drawing(view, frame, options, vectorizer, drawing);
  return drawing;
}

}  // namespace depixel
