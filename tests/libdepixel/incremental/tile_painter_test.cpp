#include "libdepixel/incremental/tile_painter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/guarded_canvas.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

std::int64_t paint(TilePainter& painter, const IncrementalVectorizer& source, const OutputGrid& grid,
                   bool linear_light, const std::vector<std::uint8_t>& is_stale, Workers& workers) {
  if (source.is_opaque() && grid.covers_target()) {
    return linear_light ? painter.draw<OpaqueLight>(source, source.colours(), grid, is_stale, workers)
                        : painter.draw<OpaqueColour>(source, source.colours(), grid, is_stale, workers);
  }
  return linear_light ? painter.draw<Translucent<true>>(source, source.colours(), grid, is_stale, workers)
                      : painter.draw<Translucent<false>>(source, source.colours(), grid, is_stale, workers);
}

RC_GTEST_PROP(TilePainter, TilesAreThoseDrawnFromScratch, (const Picture& picture)) {
  Options options = *random_options();
  options.shading = ShadingKind::none;  // shaded tiles are not its business
  options.soft_contours = 0;
  const double scale_x = *rc::gen::element(4, 4, 6, 8, 16), scale_y = *rc::gen::element(4, 4, 6, 8, 10);
  const glm::ivec2 origin(*random_int(0, 2), *random_int(0, 2)), beyond(*random_int(0, 9), *random_int(0, 9));
  const View view{scale_x, scale_y, -double(origin.x), -double(origin.y)};
  const glm::ivec2 frame(picture.width, picture.height);
  const glm::ivec2 size = (frame + origin) * glm::ivec2(scale_x, scale_y) + beyond;
  IncrementalVectorizer source;
  source.vectorize(picture.view(), options);
  const Lattice& lattice = source.lattice();
  Picture expected(size.x, size.y);
  CpuRaster().draw(source.map(), view, options.linear_light, 1, expected.target());

  GuardedCanvas canvas(size.x, size.y);
  canvas.scribble();
  const Picture before = canvas.picture();
  const OutputGrid grid(view, lattice, canvas.target());
  RC_ASSERT(TilePainter::fits(grid));
  std::vector<std::uint8_t> is_stale(lattice.size(), 0);
  const int rarity = *random_int(1, 6);
  for (int y = 0; y < frame.y; ++y) {
    for (int x = 0; x < frame.x; ++x) is_stale[lattice.pixel(x, y)] = *random_int(0, rarity) == 0 ? 1 : 0;
  }
  Workers workers;
  workers.set_threads(*random_int(1, 4));
  TilePainter painter;
  paint(painter, source, grid, options.linear_light, is_stale, workers);
  RC_ASSERT(canvas.is_guard_whole());
  const Picture after = canvas.picture();
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::ivec2 tile = glm::ivec2(x, y) / glm::ivec2(scale_x, scale_y) - origin;
      const bool is_inside =
          x >= origin.x * scale_x && y >= origin.y * scale_y && tile.x < frame.x && tile.y < frame.y;
      const bool is_drawn = is_inside && is_stale[lattice.pixel(tile.x, tile.y)] != 0;
      // Tiles between those drawn may be drawn as well.
      if (is_drawn || (is_inside && !(after.at(x, y) == before.at(x, y)))) {
        RC_ASSERT(after.at(x, y) == expected.at(x, y));
      } else {
        RC_ASSERT(after.at(x, y) == before.at(x, y));
      }
    }
  }
}

}  // namespace
}  // namespace depixel::test
