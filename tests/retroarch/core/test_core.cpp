// A libretro core that plays a script of pictures (script.hpp), so that tests decide what a front end and its
// filters are given, and benchmarks pay for nothing but what these make of it.

#include <libretro-common/libretro.h>

#include <cstdarg>
#include <cstdio>
#include <memory>
#include <utility>

#include "tests/retroarch/core/frame_times.hpp"
#include "tests/retroarch/core/script.hpp"

namespace depixel::test {
namespace {

constexpr double kFramesPerSecond = 60, kSamplesPerSecond = 48'000;

/// What the front end is asked through.
struct FrontEnd {
  retro_environment_t environment = nullptr;
  retro_video_refresh_t video_refresh = nullptr;
  retro_input_poll_t input_poll = nullptr;
  retro_log_printf_t log = nullptr;
};
FrontEnd front_end;  // NOLINT(readability-identifier-naming): libretro has no context to keep it in

retro_game_geometry libretro_geometry(const Geometry& geometry) {
  return {geometry.base.width, geometry.base.height, geometry.maximum.width, geometry.maximum.height,
          static_cast<float>(geometry.base.width) / static_cast<float>(geometry.base.height)};
}

retro_system_av_info libretro_av_info(const Geometry& geometry) {
  return {libretro_geometry(geometry), {kFramesPerSecond, kSamplesPerSecond}};
}

retro_pixel_format libretro_format(PixelFormat format) {
  switch (format) {
    case PixelFormat::rgb565:
      return RETRO_PIXEL_FORMAT_RGB565;
    case PixelFormat::xrgb1555:
      return RETRO_PIXEL_FORMAT_0RGB1555;
    default:
      return RETRO_PIXEL_FORMAT_XRGB8888;
  }
}

/// A script being played. After its last action, the frame shown last is shown on.
class Player {
 public:
  explicit Player(Script script) : script_(std::move(script)), geometry_(script_.geometry) {}

  bool set_format() const {
    retro_pixel_format format = libretro_format(script_.format);
    return front_end.environment(RETRO_ENVIRONMENT_SET_PIXEL_FORMAT, &format);
  }

  retro_system_av_info av_info() const { return libretro_av_info(geometry_); }
  FrameTimes::Summary times() const { return times_.summary(); }

  /// Does what the script says, until there is a frame or word that there is none.
  void run() {
    times_.frame_starts();
    has_frame_ = false;
    while (!has_frame_ && next_ < script_.actions.size()) {
      std::visit([this](const auto& action) { obey(action); }, script_.actions[next_++]);
    }
    if (!has_frame_) show(*shown_);
  }

 private:
  void show(const CoreFrame& frame) {
    front_end.video_refresh(frame.bytes.data(), frame.width, frame.height, frame.pitch);
    shown_ = &frame;
    has_frame_ = true;
  }

  void obey(const ShowFrame& action) { show(script_.frames[action.index]); }

  void obey(const Duplicate&) {
    front_end.video_refresh(nullptr, shown_->width, shown_->height, shown_->pitch);
    has_frame_ = true;
  }

  void obey(const SetGeometry& action) {
    geometry_.base = action.base;
    retro_game_geometry geometry = libretro_geometry(geometry_);
    front_end.environment(RETRO_ENVIRONMENT_SET_GEOMETRY, &geometry);
  }

  void obey(const SetAvInfo& action) {
    geometry_ = action.geometry;
    retro_system_av_info info = av_info();
    front_end.environment(RETRO_ENVIRONMENT_SET_SYSTEM_AV_INFO, &info);
  }

  void obey(const SetRotation& action) {
    unsigned turns = action.quarter_turns;
    front_end.environment(RETRO_ENVIRONMENT_SET_ROTATION, &turns);
  }

  Script script_;
  Geometry geometry_;
  FrameTimes times_;
  std::size_t next_ = 0;  ///< of the actions
  const CoreFrame* shown_ = script_.frames.data();
  bool has_frame_ = false;  ///< this turn
};

std::unique_ptr<Player> player;  // NOLINT(readability-identifier-naming)

void log_to_stderr(retro_log_level, const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::vfprintf(stderr, format, arguments);
  va_end(arguments);
}

bool load(const char* path) {
  auto script = load_script(path);
  if (!script) {
    front_end.log(RETRO_LOG_ERROR, "[depixel-test] %s\n", script.error().message.c_str());
    return false;
  }
  player = std::make_unique<Player>(std::move(*script));
  return player->set_format();
}

void unload() {
  if (!player) return;
  const FrameTimes::Summary times = player->times();
  front_end.log(RETRO_LOG_INFO,
                "[depixel-test] %zu frames, %.4f ms a frame in the median, %.4f ms on average\n",
                times.frames, times.median_ms, times.mean_ms);
  player.reset();
}

}  // namespace
}  // namespace depixel::test

using depixel::test::front_end;
using depixel::test::player;

extern "C" {

unsigned retro_api_version() {
  return RETRO_API_VERSION;
}

void retro_set_environment(retro_environment_t environment) {
  front_end.environment = environment;
  retro_log_callback log{};
  const bool has_log = environment(RETRO_ENVIRONMENT_GET_LOG_INTERFACE, &log);
  front_end.log = has_log ? log.log : depixel::test::log_to_stderr;
}

void retro_set_video_refresh(retro_video_refresh_t video_refresh) {
  front_end.video_refresh = video_refresh;
}

void retro_set_input_poll(retro_input_poll_t input_poll) {
  front_end.input_poll = input_poll;
}

void retro_get_system_info(retro_system_info* info) {
  *info = {"Depixel test core", "1", "frames", true, true};
}

void retro_get_system_av_info(retro_system_av_info* info) {
  *info = player->av_info();
}

bool retro_load_game(const retro_game_info* game) {
  return game != nullptr && game->path != nullptr && depixel::test::load(game->path);
}

void retro_unload_game() {
  depixel::test::unload();
}

void retro_run() {
  front_end.input_poll();
  player->run();
}

// What a core of pictures has no use for.
void retro_set_audio_sample(retro_audio_sample_t) {}
void retro_set_audio_sample_batch(retro_audio_sample_batch_t) {}
void retro_set_input_state(retro_input_state_t) {}
void retro_init() {}
void retro_deinit() {}
void retro_set_controller_port_device(unsigned, unsigned) {}
void retro_reset() {}
std::size_t retro_serialize_size() {
  return 0;
}
bool retro_serialize(void*, std::size_t) {
  return false;
}
bool retro_unserialize(const void*, std::size_t) {
  return false;
}
void retro_cheat_reset() {}
void retro_cheat_set(unsigned, bool, const char*) {}
bool retro_load_game_special(unsigned, const retro_game_info*, std::size_t) {
  return false;
}
unsigned retro_get_region() {
  return RETRO_REGION_NTSC;
}
void* retro_get_memory_data(unsigned) {
  return nullptr;
}
std::size_t retro_get_memory_size(unsigned) {
  return 0;
}

}  // extern "C"
