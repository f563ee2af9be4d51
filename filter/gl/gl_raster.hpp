#pragma once

#include <array>
#include <tl/expected.hpp>
#include <vector>

#include "filter/frame_filter.hpp"
#include "filter/gl/gl_object.hpp"
#include "filter/gl/record_texture.hpp"
#include "libdepixel/incremental/line_tiles_updater.hpp"

namespace depixel {

/// Draws tiles of lines by OpenGL: the counterpart of CpuRaster. One fragment averages the map over its
/// pixel. State is set and not restored; that is GlStateGuard's.
class GlRaster {
 public:
  static tl::expected<GlRaster, Error> create(const GladGLContext& gl);

  /// Whether textures can hold all records of some tiles.
  bool has_room_for(const LineTiles& tiles) const;
  /// Sends a map's tiles, to be drawn from now on. \return the bytes sent.
  tl::expected<std::size_t, Error> upload(const LineTiles& tiles);
  /// Sends what the last update of tiles wrote; all else was sent before.
  tl::expected<std::size_t, Error> upload_new(const LineTilesUpdater& updater);

  /// Sends how a map is shaded, for tiles of regions. \return the bytes sent, or the driver's words.
  tl::expected<std::size_t, Error> upload_shading(const Shading& shading, const std::vector<Rgba>& colours,
                                                  const Lattice& lattice);

  /// How tiles are drawn: blended in linear light or not; and of regions, with the shading that was sent, or
  /// of colours.
  struct Style {
    bool linear_light = false, is_shaded = false;

    friend bool operator==(const Style&, const Style&) = default;
  };
  /// Draws a view of the tiles, whose origin is counted from the first of them, to the framebuffer that is
  /// bound for drawing.
  void draw(const Viewport& viewport, const View& view, Style style);

  /// Lets go of all objects, which were lost with their context.
  void forget();

 private:
  explicit GlRaster(const GladGLContext& gl, int max_texture_size);

  /// The program for one way to blend, and where its uniforms are.
  struct Program {
    GlProgram object;
    GLint frame_size, viewport, origin_tile, origin, box_size, to_full_strength;
  };
  tl::unexpected<Error> refuse(const LineTiles& tiles) const;
  static tl::expected<Program, Error> link(const GladGLContext& gl, Style style);
  static std::size_t index_of(Style style) {
    return (style.linear_light ? 1 : 0) + (style.is_shaded ? 2 : 0);
  }

  const GladGLContext* gl_;
  int max_texture_size_;
  std::array<Program, 4> programs_;  ///< by style; those for shading are linked when they are needed
  GlVertexArray no_vertices_;
  RecordTexture tiles_, lines_, shading_;
  std::vector<std::uint32_t> shading_records_;  ///< scratch
  int frame_width_ = 0, frame_height_ = 0;
};

}  // namespace depixel
