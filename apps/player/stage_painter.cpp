#include "apps/player/stage_painter.hpp"

#include "libdepixel/core/stopwatch.hpp"

namespace depixel {

bool StagePainter::paint(const FrameView& frame, std::uint64_t serial, const Options& options,
                         StageView stage, const View& view, int width, int height) {
  paint_ns_ = 0;
  const Stopwatch time(paint_ns_);
  const Drawn wanted{serial, options, stage};
  if (drawn_ != wanted) {
    make_stage_drawing(stage, frame, options, vectorizer_, drawing_);
    drawn_ = wanted;
    view_.reset();
  }
  if (view_ == view && picture_.width() == width && picture_.height() == height) return false;
  picture_.resize(width, height);
  paint_stage(drawing_, view, picture_.target());
  view_ = view;
  return true;
}

}  // namespace depixel
