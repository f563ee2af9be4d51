#include "bench/peers/libav_scaler.hpp"

#include <fmt/core.h>

#include <stdexcept>

extern "C" {
#include <libavfilter/avfilter.h>
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
#include <libavutil/frame.h>
#include <libavutil/log.h>
}

namespace depixel::bench {
namespace {

/// Throws where a libav function returned an error.
void check(int result, std::string_view doing) {
  if (result >= 0) return;
  char reason[AV_ERROR_MAX_STRING_SIZE];
  av_strerror(result, reason, sizeof reason);
  throw std::runtime_error(fmt::format("libavfilter cannot {}: {}.", doing, reason));
}

AVFilterContext* add_filter(AVFilterGraph* graph, const std::string& name, const std::string& arguments) {
  AVFilterContext* context = nullptr;
  const AVFilter* filter = avfilter_get_by_name(name.c_str());
  if (!filter) throw std::runtime_error(fmt::format("This libavfilter has no filter {}.", name));
  check(avfilter_graph_create_filter(&context, filter, name.c_str(), arguments.c_str(), nullptr, graph),
        "add the filter " + name);
  return context;
}

/// The one format that a scaler works on: four bytes, blue first; hqx calls the last one alpha, xbr ignores
/// it.
AVPixelFormat format_of(const std::string& filter) {
  return filter == "hqx" ? AV_PIX_FMT_BGRA : AV_PIX_FMT_BGR0;
}

}  // namespace

void LibavScaler::Release::operator()(AVFilterGraph* graph) const {
  avfilter_graph_free(&graph);
}

void LibavScaler::Release::operator()(AVFrame* frame) const {
  av_frame_free(&frame);
}

LibavScaler::LibavScaler(const std::string& filter, int scale, int width, int height)
    : graph_(avfilter_graph_alloc()), input_(av_frame_alloc()), output_(av_frame_alloc()) {
  av_log_set_level(AV_LOG_ERROR);
  graph_->nb_threads = 1;
  avfilter_graph_set_auto_convert(graph_.get(), AVFILTER_AUTO_CONVERT_NONE);
  source_ = add_filter(
      graph_.get(), "buffer",
      fmt::format("video_size={}x{}:pix_fmt={}:time_base=1/60", width, height, int{format_of(filter)}));
  AVFilterContext* scaler = add_filter(graph_.get(), filter, fmt::format("n={}", scale));
  sink_ = add_filter(graph_.get(), "buffersink", "");
  check(avfilter_link(source_, 0, scaler, 0), "link its source");
  check(avfilter_link(scaler, 0, sink_, 0), "link its sink");
  check(avfilter_graph_config(graph_.get(), nullptr), "set up " + filter);

  input_->format = format_of(filter);
  input_->width = width;
  input_->height = height;
  check(av_frame_get_buffer(input_.get(), 0), "make a frame");
}

void LibavScaler::load(const FrameView& frame) {
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* from = frame.pixels + y * frame.pitch;
    std::uint8_t* to = input_->data[0] + std::ptrdiff_t{y} * input_->linesize[0];
    for (int x = 0; x < frame.width; ++x, from += 4, to += 4) {
      to[0] = from[2];
      to[1] = from[1];
      to[2] = from[0];
      to[3] = 255;
    }
  }
}

void LibavScaler::run() {
  av_frame_unref(output_.get());
  ++input_->pts;
  check(av_buffersrc_add_frame_flags(source_, input_.get(), AV_BUFFERSRC_FLAG_KEEP_REF), "take a frame");
  check(av_buffersink_get_frame(sink_, output_.get()), "scale a frame");
}

Picture LibavScaler::picture() const {
  Picture picture(output_->width, output_->height);
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* from = output_->data[0] + std::ptrdiff_t{y} * output_->linesize[0];
    for (int x = 0; x < picture.width(); ++x, from += 4) picture.at(x, y) = {from[2], from[1], from[0], 255};
  }
  return picture;
}

}  // namespace depixel::bench
