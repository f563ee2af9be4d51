#pragma once

#include <cstdint>
#include <optional>

#include "apps/common/picture.hpp"
#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/raster/view.hpp"
#include "libdepixel/views/stage_view.hpp"

namespace depixel {

/// Paints a step on the way, and only again when something that it depends on changed.
class StagePainter {
 public:
  /// Makes the picture of a part of the frame's drawing. \param serial  another one for every other frame.
  /// \param view, width, height  the part, as paint_stage() takes it.
  /// \return whether the picture is another than before.
  bool paint(const FrameView& frame, std::uint64_t serial, const Options& options, StageView stage,
             const View& view, int width, int height);

  const Picture& picture() const { return picture_; }
  /// The last painting's time; 0 if there was nothing to paint.
  std::int64_t paint_ns() const { return paint_ns_; }

 private:
  struct Drawn {
    std::uint64_t serial;
    Options options;
    StageView stage;
    friend bool operator==(const Drawn&, const Drawn&) = default;
  };

  Vectorizer vectorizer_;
  StageDrawing drawing_;
  std::optional<Drawn> drawn_;
  std::optional<View> view_;  ///< none: not painted since drawn
  Picture picture_;
  std::int64_t paint_ns_ = 0;
};

}  // namespace depixel
