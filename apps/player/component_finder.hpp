#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "libdepixel/core/color.hpp"
#include "libdepixel/stages/components.hpp"
#include "libdepixel/stages/outlines.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// A component of a frame.
struct FoundComponent {
  int index = 0;
  Rgba colour;
  int size_px = 0;  ///< source pixels
};

/// Tells which component's smooth shape holds a point.
class ComponentFinder {
 public:
  /// Takes the frame that was vectorized last. \param version  another one for every other frame or options;
  /// nothing is done if it is the one of before. Cost: linear in pixels and segments.
  void take(const PlanarMap& map, const SimilarityGraph& graph, std::uint64_t version);

  /// \param point  in source pixels. \return none outside of the picture.
  std::optional<FoundComponent> at(glm::dvec2 point) const;

  /// Outlines, in subpixels of what is shown.
  std::span<const OutlineLoop> loops(int component) const;
  std::span<const OutlinePiece> pieces(const OutlineLoop& loop) const;

 private:
  bool holds(int component, glm::dvec2 point) const;
  int shown_pixel(int x, int y) const;

  std::optional<std::uint64_t> version_;
  Lattice lattice_;
  std::vector<Rgba> colours_;
  Components components_;
  Outlines outlines_;
  std::vector<int> sizes_px_;  ///< of components, without what lies in the margin
};

}  // namespace depixel
