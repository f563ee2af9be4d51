#include "filter/gl/gl_raster.hpp"

#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <span>
#include <string>

#include "filter/gl/gl_program.hpp"
#include "shaders/embedded.hpp"

namespace depixel {
namespace {

constexpr GLint kTilesUnit = 0, kLinesUnit = 1, kShadingUnit = 2;

void use_unit(const GladGLContext& gl, GLint unit) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
}

}  // namespace

GlRaster::GlRaster(const GladGLContext& gl, int max_texture_size)
    : gl_(&gl),
      max_texture_size_(max_texture_size),
      tiles_(max_texture_size),
      lines_(max_texture_size),
      shading_(max_texture_size) {}

tl::expected<GlRaster, Error> GlRaster::create(const GladGLContext& gl) {
  GLint max_texture_size = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_texture_size);
  GlRaster raster(gl, max_texture_size);
  for (const bool linear_light : {false, true}) {
    const Style style{linear_light, false};
    auto program = link(gl, style);
    if (!program) return tl::unexpected(program.error());
    raster.programs_[index_of(style)] = std::move(*program);
  }
  GLuint vertex_array = 0;
  gl.GenVertexArrays(1, &vertex_array);
  raster.no_vertices_ = GlVertexArray(gl, vertex_array);
  return raster;
}

tl::expected<GlRaster::Program, Error> GlRaster::link(const GladGLContext& gl, Style style) {
  std::string defines = style.linear_light ? "#define LINEAR_LIGHT\n" : "";
  if (style.is_shaded) defines += "#define SHADED\n";
  auto linked = link_program(gl, shaders::tiles_vert, defines + std::string(shaders::tiles_frag));
  if (!linked) return tl::unexpected(linked.error());
  const auto location = [name = linked->name(), &gl](const char* uniform) {
    return gl.GetUniformLocation(name, uniform);
  };
  gl.UseProgram(linked->name());
  gl.Uniform1i(location("tiles"), kTilesUnit);
  gl.Uniform1i(location("lines"), kLinesUnit);
  gl.Uniform1i(location("shading"), kShadingUnit);  // of no effect where there is none
  gl.Uniform2i(location("lines_layout"), RecordTexture::kColumns - 1, RecordTexture::kColumnBits);
  return Program{std::move(*linked),          location("frame_size"), location("viewport"),
                 location("origin_tile"),     location("origin"),     location("box_size"),
                 location("to_full_strength")};
}

bool GlRaster::has_room_for(const LineTiles& tiles) const {
  const auto max_lines = std::size_t{RecordTexture::kColumns} * static_cast<std::size_t>(max_texture_size_);
  return tiles.width() <= max_texture_size_ && tiles.height() <= max_texture_size_ &&
         tiles.lines().size() <= max_lines;
}

tl::unexpected<Error> GlRaster::refuse(const LineTiles& tiles) const {
  return tl::unexpected(Error{fmt::format(
      "A frame of {} x {} pixels and {} lines is too large for this OpenGL, whose textures have {} a side.",
      tiles.width(), tiles.height(), tiles.lines().size(), max_texture_size_)});
}

tl::expected<std::size_t, Error> GlRaster::upload(const LineTiles& tiles) {
  if (!has_room_for(tiles)) return refuse(tiles);
  frame_width_ = tiles.width();
  frame_height_ = tiles.height();
  use_unit(*gl_, kTilesUnit);
  std::size_t bytes =
      tiles_.upload(*gl_, std::as_bytes(std::span(tiles.tiles())), frame_width_, frame_height_);
  use_unit(*gl_, kLinesUnit);
  bytes += lines_.upload(*gl_, std::as_bytes(std::span(tiles.lines())));
  return bytes;
}

tl::expected<std::size_t, Error> GlRaster::upload_new(const LineTilesUpdater& updater) {
  const LineTiles& tiles = updater.tiles();
  if (updater.is_all_new()) return upload(tiles);
  if (!has_room_for(tiles)) return refuse(tiles);
  std::size_t bytes = 0;
  use_unit(*gl_, kTilesUnit);
  for (const TileBox& box : updater.new_boxes()) {
    bytes += tiles_.upload_box(*gl_, std::as_bytes(std::span(tiles.tiles())), box);
  }
  use_unit(*gl_, kLinesUnit);
  bytes += lines_.upload(*gl_, std::as_bytes(std::span(tiles.lines())), updater.first_new_line());
  return bytes;
}

tl::expected<std::size_t, Error> GlRaster::upload_shading(const Shading& shading,
                                                          const std::vector<Rgba>& colours,
                                                          const Lattice& lattice) {
  for (const bool linear_light : {false, true}) {
    const Style style{linear_light, true};
    if (programs_[index_of(style)].object.name() != 0) continue;
    auto program = link(*gl_, style);
    if (!program) return tl::unexpected(program.error());
    programs_[index_of(style)] = std::move(*program);
  }
  // A record a block: its north-western pixel's shade and region, and its pairs. Beyond the frame, pixels are
  // empty.
  const int width = lattice.width() + 2, height = lattice.height() + 2;
  shading_records_.clear();
  for (int y = -1; y <= lattice.height(); ++y) {
    for (int i = lattice.pixel(-1, y), end = i + width; i < end; ++i) {
      shading_records_.insert(shading_records_.end(),
                              {std::bit_cast<std::uint32_t>(shading.shades[i]),
                               std::bit_cast<std::uint32_t>(colours[i]), shading.blocks[i], 0});
    }
  }
  use_unit(*gl_, kShadingUnit);
  return shading_.upload(*gl_, std::as_bytes(std::span(shading_records_)), width, height);
}

void GlRaster::draw(const Viewport& viewport, const View& view, Style style) {
  const double tile_x = std::floor(view.origin_x), tile_y = std::floor(view.origin_y);
  const Program& program = programs_[index_of(style)];
  gl_->UseProgram(program.object.name());
  gl_->Uniform2i(program.frame_size, frame_width_, frame_height_);
  gl_->Uniform3i(program.viewport, viewport.x, viewport.y, viewport.height);
  gl_->Uniform2i(program.origin_tile, static_cast<GLint>(tile_x), static_cast<GLint>(tile_y));
  gl_->Uniform2f(program.origin, static_cast<float>(view.origin_x - tile_x),
                 static_cast<float>(view.origin_y - tile_y));
  gl_->Uniform2f(program.box_size, static_cast<float>(1 / view.scale_x),
                 static_cast<float>(1 / view.scale_y));
  const double area = double{kTileUnits} * kTileUnits / (view.scale_x * view.scale_y);
  const double levels = style.is_shaded ? 1.0 : style.linear_light ? kTileLightLevels : kTileLevels;
  gl_->Uniform1f(program.to_full_strength, static_cast<float>(1 / (area * levels)));
  use_unit(*gl_, kTilesUnit);
  gl_->BindTexture(GL_TEXTURE_2D, tiles_.name());
  use_unit(*gl_, kLinesUnit);
  gl_->BindTexture(GL_TEXTURE_2D, lines_.name());
  if (style.is_shaded) {
    use_unit(*gl_, kShadingUnit);
    gl_->BindTexture(GL_TEXTURE_2D, shading_.name());
  }
  gl_->BindVertexArray(no_vertices_.name());
  gl_->Viewport(viewport.x, viewport.y, viewport.width, viewport.height);
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

void GlRaster::forget() {
  for (Program& program : programs_) program.object.forget();
  no_vertices_.forget();
  tiles_.forget();
  lines_.forget();
  shading_.forget();
}

}  // namespace depixel
