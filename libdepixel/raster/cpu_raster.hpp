#pragma once

#include <tuple>
#include <vector>

#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/core/workers.hpp"
#include "libdepixel/raster/band_sums.hpp"
#include "libdepixel/raster/ordered_colours.hpp"
#include "libdepixel/raster/output_grid.hpp"
#include "libdepixel/raster/region_sums.hpp"
#include "libdepixel/raster/shade_field.hpp"
#include "libdepixel/stages/planar_map.hpp"

namespace depixel {

/// A thread's sums for one way to blend: of maps without shading, and with.
template <typename Model>
struct RasterSums {
  BandSums<Model> even;
  RegionSums<Model> shaded;

  std::size_t memory_bytes() const { return even.memory_bytes() + shaded.memory_bytes(); }
};

/// Sums for each way to blend, one a thread.
using SumsOfModels =
    std::tuple<std::vector<RasterSums<OpaqueColour>>, std::vector<RasterSums<OpaqueLight>>,
               std::vector<RasterSums<Translucent<false>>>, std::vector<RasterSums<Translucent<true>>>>;

/// Bytes that they hold.
std::size_t memory_bytes(const SumsOfModels& sums);

/// Draws planar maps with exact box-filter anti-aliasing; where they are shaded, each region counts with the
/// colour that it has at the centre of the output pixel. Sums are integers, so the result is bit-identical
/// whatever the order of work, the number of threads and the compiler. Keeps its buffers from call to call.
class CpuRaster {
 public:
  /// Draws a view of the map over the whole target; outside of the map lies transparency.
  /// \param view          coordinates of the frame's edges in the output stay below 2^22 pixels.
  /// \param linear_light  blend colours in linear light instead of in sRGB values.
  /// Cost: linear in segments and target pixels; pixels that no curve crosses cost a store.
  void draw(const MapByEdge& map, const View& view, bool linear_light, int threads,
            const PictureView& target);
  /// The same of any list of segments. Takes 12 bytes and more a segment to sort them.
  void draw(const PlanarMap& map, const View& view, bool linear_light, int threads,
            const PictureView& target);

  std::size_t memory_bytes() const;

 private:
  struct BandRange {
    int from, to;  ///< bands that a segment touches, both included; none when from > to
  };

  void sort_into_bands(const PlanarMap& map, const OutputGrid& grid, int bands);
  template <typename Sums>
  void add_curves(const PlanarMap& map, const std::vector<Rgba>& colours, const OutputGrid& grid, int band,
                  Sums& sums) const;
  template <typename Sums>
  void add_curves(const MapByEdge& map, const std::vector<Rgba>& colours, const OutputGrid& grid, int band,
                  Sums& sums) const;
  template <typename Sums>
  void add_row(const MapByEdge& map, const std::vector<Rgba>& colours, const OutputGrid& grid, int y,
               int band, Sums& sums) const;
  template <typename Map>
  void draw_by_model(const Map& map, const OutputGrid& grid, bool linear_light);
  template <typename Model, typename Map>
  void draw_bands(const Map& map, const std::vector<Rgba>& colours, const OutputGrid& grid);
  template <typename Map, typename Sums>
  void draw_band(const Map& map, const std::vector<Rgba>& colours, const OutputGrid& grid, int band,
                 Sums& sums) const;

  Workers workers_;
  std::vector<BandRange> ranges_;  ///< by segment
  std::vector<int> order_;         ///< segments, band after band
  std::vector<int> first_;         ///< of each band in order_, and the end
  std::vector<int> next_;
  OrderedColours colours_, shades_;
  ShadeField field_;
  SumsOfModels sums_;
  bool is_drawing_ = false;
};

}  // namespace depixel
