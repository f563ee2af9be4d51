#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <tl/expected.hpp>
#include <variant>

#include "libdepixel/core/error.hpp"
#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/incremental/incremental_vectorizer.hpp"
#include "libdepixel/raster/view.hpp"

namespace depixel {

/// Finds an OpenGL function by its name, as eglGetProcAddress() and its like do.
using GlFunction = void (*)();
using GlLoader = GlFunction (*)(const char* name);

/// A framebuffer object of the current context; 0 is the window's or the host's default one.
struct GlFramebuffer {
  unsigned name = 0;
};

/// A picture in memory that nobody but the filter writes to: where it still holds what the last draw() drew,
/// only what changed since then is written. Its owner must not change it between two calls.
struct KeptPicture {
  PictureView picture;
};

/// What is drawn to: a picture in memory, or a framebuffer.
using Target = std::variant<PictureView, KeptPicture, GlFramebuffer>;

/// The picture that a target is, or nullptr where it is none.
const PictureView* picture_of(const Target& target);

/// The rectangle of a target that is drawn over, in its pixels. Zero wide or high: nothing is drawn.
struct Viewport {
  int x = 0, y = 0;  ///< from a picture's top left, from a framebuffer's bottom left
  int width = 0, height = 0;
};

/// The part of a picture under a viewport.
PictureView part_of(const PictureView& picture, const Viewport& viewport);

/// What the last submit() and draw() took.
struct FilterStats {
  std::int64_t submit_ns = 0;  ///< all of submit()
  std::int64_t prepare_ns =
      0;  ///< by the processor, for drawing: lines, tiles and uploads; 0 if there was nothing to do
  std::int64_t draw_ns = 0;       ///< the rest of draw(); of OpenGL, only until the commands were given
  std::int64_t lines = 0;         ///< in tiles, of the OpenGL filter
  std::size_t upload_bytes = 0;   ///< sent to OpenGL by the last preparation
  std::int64_t drawn_pixels = 0;  ///< by the processor
  std::int64_t moved_pixels = 0;  ///< by the processor: those copied from elsewhere in a kept picture
};

/// Turns frames to vector pictures and draws them: the one class that front ends use.
///
/// Frames are submitted, each replaces the one before, and only what changed is computed anew; then views of
/// it are drawn, as many as wanted. Both kinds of filter draw the same picture, within a few levels.
class FrameFilter {
 public:
  /// The smallest zoom that OpenGL draws, in output pixels to a source pixel along either axis: a fragment
  /// visits all tiles under its pixel. The processor draws any.
  static constexpr double kSmallestGlScale = 1.0 / 16;
  /// Coordinates of the frame's edges in the output must stay below this many pixels.
  static constexpr double kLargestCoordinate = 1 << 22;

  /// Draws by the processor, to pictures in memory.
  static std::unique_ptr<FrameFilter> cpu();

  /// Draws by OpenGL: core profile 3.3 or ES 3.0, on the context that is current now and whenever the filter
  /// is used or dropped. Draws to framebuffers, and to pictures by reading them back. \return an error if the
  /// context is too old or refuses a shader or an object, in the driver's words.
  static tl::expected<std::unique_ptr<FrameFilter>, Error> gl(GlLoader loader);

  virtual ~FrameFilter() = default;

  /// Vectorizes a frame, to be drawn from now on.
  /// \param frame  read during the call only. An empty one is an error.
  tl::expected<void, Error> submit(const FrameView& frame, const Options& options);

  /// Draws a view of the submitted frame over a viewport. Outside of the frame lies transparency, which is
  /// written like any colour: nothing is blended with what the target held. Colours have straight alpha. The
  /// OpenGL filter leaves the context's state as it was. Where the options continue the border, the frame
  /// ends at the output pixel that is nearest to its edge; else it covers a part of that pixel. \return an
  /// error if nothing was submitted, the view is out of range, the viewport is not inside the picture, or
  /// OpenGL failed.
  tl::expected<void, Error> draw(const Target& target, const Viewport& viewport, const View& view);

  /// To be called when the context was lost: all its objects are forgotten without being deleted, and are
  /// made anew, on the context that is current then, by the next draw().
  virtual void context_lost() {}

  /// A debugging aid: submit() and draw() compare what they made incrementally with what is made from
  /// scratch, and return an error where it differs. Slow.
  void check_incremental(bool wanted) { is_checking_ = wanted; }

  /// Of the frame submitted last.
  const IncrementalVectorizer& vectorizer() const { return vectorizer_; }
  const FilterStats& stats() const { return stats_; }
  /// Bytes held from frame to frame, but for OpenGL's objects.
  virtual std::size_t memory_bytes() const {
    return vectorizer_.stats().memory_bytes + changes_.memory_bytes();
  }

 protected:
  /// \param rules  all, but in tests of what is told of errors.
  explicit FrameFilter(RuleSet rules = {}) : vectorizer_(rules) {}

  /// Draws over a viewport that is inside the target. Where the frame has a margin, the view shows none of
  /// it.
  virtual tl::expected<void, Error> draw_checked(const Target& target, const Viewport& viewport,
                                                 const View& view) = 0;
  /// Makes a part of a framebuffer transparent.
  virtual tl::expected<void, Error> clear(const GlFramebuffer& framebuffer, const Viewport& part) = 0;

  IncrementalVectorizer vectorizer_;
  MapChanges changes_;  ///< of the map, until what draws takes them and sets them to nothing
  Options options_;
  bool is_checking_ = false;
  bool has_frame_ = false;
  FilterStats stats_;

 private:
  tl::expected<void, Error> check(const Target& target, const Viewport& viewport, const View& view) const;
  Viewport shown_part(const Viewport& viewport, const View& view) const;
  tl::expected<void, Error> clear_outside(const Target& target, const Viewport& viewport,
                                          const Viewport& inside);
};

}  // namespace depixel
