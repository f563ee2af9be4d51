#pragma once

#include <memory>
#include <string>

#include "bench/common/picture.hpp"

struct AVFilterContext;
struct AVFilterGraph;
struct AVFrame;

namespace depixel::bench {

/// One of libavfilter's pixel-art scalers, in this process and on one thread, on frames of one size. Frames
/// are in the format that the scaler works on (BGR0 for xbr) from end to end: nothing is converted in
/// between. Alpha is dropped.
class LibavScaler {
 public:
  /// \param filter  "xbr" or "hqx".
  /// \param scale   2 to 4.
  /// Throws std::runtime_error where libavfilter refuses.
  LibavScaler(const std::string& filter, int scale, int width, int height);

  /// Copies a frame of the scaler's size in.
  void load(const FrameView& frame);
  /// Scales the loaded frame: the part to be timed.
  void run();
  /// What run() has made.
  Picture picture() const;

 private:
  struct Release {
    void operator()(AVFilterGraph* graph) const;
    void operator()(AVFrame* frame) const;
  };

  std::unique_ptr<AVFilterGraph, Release> graph_;
  AVFilterContext* source_ = nullptr;  ///< owned by the graph, and so is the sink
  AVFilterContext* sink_ = nullptr;
  std::unique_ptr<AVFrame, Release> input_, output_;
};

}  // namespace depixel::bench
