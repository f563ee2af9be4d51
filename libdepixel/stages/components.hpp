#pragma once

#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// Connected components of a similarity graph.
struct Components {
  int count = 0;
  std::vector<int> label;    ///< padded; 0..count-1 in order of each component's first pixel, padding -1
  std::vector<int> size;     ///< pixels of each component
  std::vector<Rgba> colour;  ///< majority colour of each component (see find_majority_colours)

  std::size_t memory_bytes() const { return held_bytes(label, size, colour); }
};

/// Labels the connected components of a graph by union-find.
/// \param components  overwritten; colours are left empty.
/// Cost: practically linear in pixels. Source: Schapfel, section 4.1.1.
void label_components(const SimilarityGraph& graph, Components& components);

/// Gives every component the colour that most of its pixels have; of colours that tie, the lowest RGBA value.
void find_majority_colours(const SimilarityGraph& graph, Components& components);

}  // namespace depixel
