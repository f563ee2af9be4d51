#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "filter/frame_filter.hpp"
#include "filter/gl/gl_raster.hpp"
#include "filter/gl/gl_state.hpp"
#include "filter/gl/readback.hpp"
#include "libdepixel/core/stopwatch.hpp"

namespace depixel {
namespace {

/// Loads the functions of the current context. \return an error if it is older than what the filter needs.
tl::expected<void, Error> load(GlLoader loader, GladGLContext& gl) {
  gl = {};
  const auto get_string = reinterpret_cast<const GLubyte* (*)(GLenum)>(loader("glGetString"));
  const auto* version =
      get_string == nullptr ? nullptr : reinterpret_cast<const char*>(get_string(GL_VERSION));
  if (version == nullptr) return tl::unexpected(Error{"There is no current OpenGL context."});
  if (std::string_view(version).starts_with("OpenGL ES")) {
    gladLoadGLES2Context(&gl, loader);
    if (gl.ES_VERSION_3_0 != 0) return {};
  } else {
    gladLoadGLContext(&gl, loader);
    if (gl.VERSION_3_3 != 0) return {};
  }
  return tl::unexpected(
      Error{fmt::format("OpenGL 3.3 or OpenGL ES 3.0 is needed, and this is {}.", version)});
}

/// What OpenGL has to complain of, or nothing. A lost context may complain for ever, so it is asked a few
/// times.
std::optional<Error> take_error(const GladGLContext& gl) {
  constexpr int kMostErrors = 16;
  const GLenum first = gl.GetError();
  if (first == GL_NO_ERROR) return std::nullopt;
  for (int i = 1; i < kMostErrors && gl.GetError() != GL_NO_ERROR; ++i) {
  }
  const std::string text = first == GL_OUT_OF_MEMORY                   ? "out of memory"
                           : first == GL_INVALID_ENUM                  ? "invalid enumerator"
                           : first == GL_INVALID_VALUE                 ? "invalid value"
                           : first == GL_INVALID_OPERATION             ? "invalid operation"
                           : first == GL_INVALID_FRAMEBUFFER_OPERATION ? "invalid framebuffer"
                                                                       : "context lost";
  return Error{fmt::format("OpenGL fails: {} ({:#x}).", text, first)};
}

class GlFilter final : public FrameFilter {
 public:
  explicit GlFilter(GlLoader loader) : loader_(loader) {}

  /// Makes all objects, on the context that is current.
  tl::expected<void, Error> start() {
    if (auto loaded = load(loader_, gl_); !loaded) return loaded;
    take_error(gl_);  // the host's
    const GlStateGuard guard(gl_);
    auto raster = GlRaster::create(gl_);
    if (!raster) return tl::unexpected(raster.error());
    if (auto error = take_error(gl_)) return tl::unexpected(*error);
    raster_ = std::move(*raster);
    is_uploaded_ = false;
    return {};
  }

  std::size_t memory_bytes() const override { return FrameFilter::memory_bytes() + updater_.memory_bytes(); }

  void context_lost() override {
    if (raster_) raster_->forget();
    readback_.forget();
    raster_.reset();
  }

 private:
  tl::expected<void, Error> draw_checked(const Target& target, const Viewport& viewport,
                                         const View& view) override {
    if (viewport.width == 0 || viewport.height == 0) return {};
    if (std::min(view.scale_x, view.scale_y) < kSmallestGlScale) {
      return tl::unexpected(Error{fmt::format("OpenGL draws at scales from {} on, and this is {} by {}.",
                                              kSmallestGlScale, view.scale_x, view.scale_y)});
    }
    if (!raster_) {
      if (auto started = start(); !started) return started;
    }
    stats_.prepare_ns = stats_.draw_ns = 0;
    stats_.upload_bytes = 0;
    take_error(gl_);  // the host's
    const GlStateGuard guard(gl_);
    const glm::dvec2 scale(view.scale_x, view.scale_y);
    if (auto prepared = prepare(scale); !prepared) return prepared;
    if (is_checking_) {
      if (auto compared = compare_with_scratch(scale); !compared) return compared;
    }
    const Stopwatch time(stats_.draw_ns);
    const View all = view.from_margin(vectorizer_.lattice());
    const PictureView* picture = picture_of(target);
    auto drawn = picture != nullptr
                     ? draw_to_picture(*picture, viewport, all, std::holds_alternative<KeptPicture>(target))
                     : draw_to(std::get<GlFramebuffer>(target), viewport, all);
    if (!drawn) return drawn;
    if (auto error = take_error(gl_)) {
      is_uploaded_ = false;  // who knows what was refused
      return tl::unexpected(*error);
    }
    return {};
  }

  tl::expected<void, Error> clear(const GlFramebuffer& framebuffer, const Viewport& part) override {
    if (!raster_) {
      if (auto started = start(); !started) return started;
    }
    const GlStateGuard guard(gl_);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.name);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(part.x, part.y, part.width, part.height);
    constexpr std::array<GLfloat, 4> kTransparent{};
    gl_.ClearBufferfv(GL_COLOR, 0, kTransparent.data());
    gl_.Disable(GL_SCISSOR_TEST);
    return {};
  }

  /// Cuts tiles of the map and sends them: those that changed, or all where the scale is new.
  tl::expected<void, Error> prepare(glm::dvec2 scale) {
    const bool is_cut = !changes_.any() && updater_.is_for(scale, encoding());
    if (is_cut && is_uploaded_) return {};
    const Stopwatch time(stats_.prepare_ns);
    if (!is_cut) {
      updater_.update(vectorizer_, changes_, scale, encoding());
      add_stale_rows();
      changes_.set_nothing();
      if (!raster_->has_room_for(updater_.tiles())) updater_.compact();
    }
    const auto bytes = is_uploaded_ ? raster_->upload_new(updater_) : raster_->upload(updater_.tiles());
    is_uploaded_ = bytes.has_value();
    if (!bytes) return tl::unexpected(bytes.error());
    stats_.lines = static_cast<std::int64_t>(updater_.tiles().used_lines());
    stats_.upload_bytes = *bytes;
    return style().is_shaded ? send_shading() : tl::expected<void, Error>{};
  }

  tl::expected<void, Error> send_shading() {
    const auto bytes =
        raster_->upload_shading(vectorizer_.shading(), vectorizer_.colours(), vectorizer_.lattice());
    is_uploaded_ = bytes.has_value();
    if (!bytes) return tl::unexpected(bytes.error());
    stats_.upload_bytes += *bytes;
    return {};
  }

  GlRaster::Style style() const { return {options_.linear_light, options_.has_shading()}; }

  TileEncoding encoding() const {
    if (options_.has_shading()) return TileEncoding::regions;
    return options_.linear_light ? TileEncoding::light : TileEncoding::levels;
  }

  tl::expected<void, Error> compare_with_scratch(glm::dvec2 scale) const {
    LineTiles scratch;
    scratch.build(vectorizer_.map(), scale, encoding());
    if (scratch == updater_.tiles()) return {};
    return tl::unexpected(Error{"The tiles that were cut incrementally are not those cut from scratch."});
  }

  tl::expected<void, Error> draw_to(const GlFramebuffer& framebuffer, const Viewport& viewport,
                                    const View& view) {
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.name);
    raster_->draw(viewport, view, style());
    return {};
  }

  void add_stale_rows() {
    if (updater_.is_all_new()) {
      drawn_ = {};
      return;
    }
    for (const TileBox& box : updater_.new_boxes()) {
      stale_.first = std::min(stale_.first, box.north);
      stale_.end = std::max(stale_.end, box.south);
    }
  }

  /// The rows of a picture that do not hold what they should.
  Readback::Rows rows_to_draw(const PictureView& part, const View& view, bool is_kept) const {
    if (!is_kept || !(drawn_ == Drawn{part, view, style()})) return {0, part.height};
    if (stale_.first >= stale_.end) return {0, 0};
    const auto row = [&](int source_y) { return (source_y - view.origin_y) * view.scale_y; };
    const double first = std::floor(row(stale_.first)) - 1, end = std::ceil(row(stale_.end)) + 1;
    return {static_cast<int>(std::clamp(first, 0.0, double(part.height))),
            static_cast<int>(std::clamp(end, 0.0, double(part.height)))};
  }

  tl::expected<void, Error> draw_to_picture(const PictureView& picture, const Viewport& viewport,
                                            const View& view, bool is_kept) {
    const PictureView part = part_of(picture, viewport);
    const Readback::Rows rows = rows_to_draw(part, view, is_kept);
    drawn_ = {};
    if (rows.first < rows.end) {
      if (auto bound = readback_.bind(gl_, part.width, part.height); !bound) return bound;
      const int band = (rows.end - rows.first + kBands - 1) / kBands;
      for (int first = rows.first; first < rows.end; first += band) {
        const Readback::Rows some{first, std::min(first + band, rows.end)};
        Readback::restrict_to(gl_, part, some);
        raster_->draw({0, 0, part.width, part.height}, view, style());
        readback_.request(gl_, part, some);
      }
      gl_.Disable(GL_SCISSOR_TEST);
      if (auto taken = readback_.take(gl_, part); !taken) return taken;
    }
    drawn_ = {part, view, style()};
    stale_ = kNoRows;
    return {};
  }

  GlLoader loader_;
  GladGLContext gl_{};
  std::optional<GlRaster> raster_;
  Readback readback_;
  /// What the picture drawn last was drawn as; a part without pixels where that is not to be relied on.
  struct Drawn {
    PictureView part;
    View view;
    GlRaster::Style style;

    friend bool operator==(const Drawn&, const Drawn&) = default;
  };

  /// Pictures are drawn and read back in so many bands.
  static constexpr int kBands = 4;
  static constexpr Readback::Rows kNoRows{std::numeric_limits<int>::max(), 0};

  Drawn drawn_;
  Readback::Rows stale_ = kNoRows;  ///< of the source, that changed since
  LineTilesUpdater updater_;
  bool is_uploaded_ = false;  ///< the context holds all tiles, as of the last update
};

}  // namespace

tl::expected<std::unique_ptr<FrameFilter>, Error> FrameFilter::gl(GlLoader loader) {
  auto filter = std::make_unique<GlFilter>(loader);
  if (auto started = filter->start(); !started) return tl::unexpected(started.error());
  return filter;
}

}  // namespace depixel
