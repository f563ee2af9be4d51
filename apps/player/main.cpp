#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "apps/common/encode_png.hpp"
#include "apps/common/exit_codes.hpp"
#include "apps/common/files.hpp"
#include "apps/common/input_guard.hpp"
#include "apps/common/inputs.hpp"
#include "apps/player/command_line.hpp"
#include "apps/player/key_bindings.hpp"
#include "apps/player/panels.hpp"
#include "apps/player/pointer.hpp"
#include "apps/player/window.hpp"

namespace depixel {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

int fail(const Error& error) {
  fmt::print(stderr, "depixel-player: {}\n", error.message);
  return kExitFailed;
}

/// The window and what is played in it, until its end.
class Session {
 public:
  Session(const PlayerArguments& arguments, Window& window, Player& player)
      : arguments_(arguments), window_(window), player_(player) {}

  tl::expected<void, Error> run() {
    int shown = 0;
    auto last_drawn = Clock::now();
    for (auto last = last_drawn; !window_.should_close();) {
      const bool is_counting = arguments_.frames > 0;
      const bool is_busy = is_counting || settling_ > 0 || player_.exporter() != nullptr;
      window_.wait_events(is_busy ? 0 : player_.seconds_left());
      const auto now = Clock::now();
      const double passed = seconds_between(std::exchange(last, now), now);
      take_input();
      if (is_counting) {
        if (shown > 0 || player_.frame() == nullptr) player_.show_next();
      } else {
        player_.advance(passed);
      }
      if (player_.failure() && !arguments_.inputs.empty()) return tl::unexpected(*player_.failure());
      if (!must_draw() && !is_counting) continue;
      if (auto drawn = draw(); !drawn) return drawn;
      if (is_counting && player_.difference()) return tl::unexpected(*player_.difference());
      shown += player_.frame() != nullptr ? 1 : 0;
      const bool is_last = is_counting && shown == arguments_.frames;
      if (is_last && !arguments_.screenshot.empty()) {
        if (auto saved = write_file(arguments_.screenshot, encode_png(screenshot().view())); !saved)
          return saved;
      }
      if (std::exchange(player_.wants_screenshot, false)) player_.save_picture(screenshot());
      window_.swap();
      player_.history.add(1000 * seconds_between(now, Clock::now()),
                          1000 * seconds_between(std::exchange(last_drawn, now), now));
      if (is_last || player_.wants_quit) window_.close();
    }
    return {};
  }

 private:
  struct Seen {
    std::uint64_t serial = 0;
    std::string message;
    friend bool operator==(const Seen&, const Seen&) = default;
  };

  void take_input() {
    const auto drops = window_.take_drops();
    if (!drops.empty()) {
      const std::vector<std::string> inputs(drops.begin(), drops.end());
      if (auto opened = player_.open(inputs); !opened) player_.say(opened.error().message);
    }
    for (const KeyPress& press : window_.take_keys()) {
      const bool is_typing = ImGui::GetIO().WantTextInput;  // a number, into a slider
      if (!is_typing) handle_key(press, player_);
    }
    if (std::exchange(player_.wants_fullscreen, false)) window_.toggle_fullscreen();
    player_.is_fullscreen = window_.is_fullscreen();
    const std::string title =
        player_.has_clip() ? fmt::format("{} - Depixel", player_.clip_name()) : "Depixel";
    if (title != title_) window_.set_title(title_ = title);
  }

  /// Whether anything changed since the window was drawn: a paused picture costs nothing.
  bool must_draw() {
    constexpr int kSettling = 3;  // what follows from input is seen in ImGui's next frames only
    Seen now{player_.serial(), player_.message()};
    if (std::exchange(seen_, now) != now || player_.exporter() != nullptr) settling_ = std::max(settling_, 1);
    if (window_.had_events()) settling_ = kSettling;
    return settling_ > 0 && settling_-- > 0;
  }

  tl::expected<void, Error> draw() {
    const glm::ivec2 size = window_.framebuffer_size();
    const double ratio = window_.pixel_ratio();
    const bool has_panels = player_.settings.look.panels && !arguments_.hide_ui;
    LookSettings look = player_.settings.look;
    look.panels = has_panels;
    const PixelRect area = area_beside_panels(look, glm::ivec2(glm::dvec2(size) / ratio));
    const auto pixels = [ratio](int units) { return static_cast<int>(units * ratio); };
    player_.view.set_area({0, 0, pixels(area.width), pixels(area.height)});
    if (arguments_.scale && !std::exchange(has_scale_, true)) player_.view.set_scale(*arguments_.scale);

    if (auto taken = player_.vectorize(); !taken) return taken;
    window_.begin_ui();
    if (!arguments_.hide_ui) {
      pointer_.handle(player_, ratio);
      show_dialogs(player_);
    }
    if (has_panels) {
      show_control_bar(player_);
      show_side_panel(player_);
    }
    auto drawn = player_.draw(size);
    window_.end_ui();
    return drawn;
  }

  Picture screenshot() const {
    const glm::ivec2 size = window_.framebuffer_size();
    Picture picture(size.x, size.y);
    const GladGLContext& gl = window_.gl();
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    for (int y = 0; y < size.y; ++y) {
      gl.ReadPixels(0, size.y - 1 - y, size.x, 1, GL_RGBA, GL_UNSIGNED_BYTE, picture.row(y));
    }
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) picture.at(x, y).a = 255;  // windows are
    }
    return picture;
  }

  const PlayerArguments& arguments_;
  Window& window_;
  Player& player_;
  Pointer pointer_;
  std::string title_;
  bool has_scale_ = false;
  Seen seen_;
  int settling_ = 1;  ///< times that the window is still to be drawn
};

void print_stats(const Player& player) {
  const VectorizeStats& stats = player.canvas().filter().vectorizer().stats();
  std::int64_t vectorize_ns = 0;
  for (const std::int64_t ns : stats.stage_ns) vectorize_ns += ns;
  const double median = player.history.median_work_ms();
  fmt::print(
      "{{\"frames\": {}, \"median_frame_ms\": {:.3f}, \"frames_a_second\": {:.1f}, \"last_vectorize_ms\": "
      "{:.3f}, \"counts\": {{{}}}}}\n",
      player.history.frames(), median, median > 0 ? 1000 / median : 0.0, double(vectorize_ns) * 1e-6,
      json_members(player.canvas().counts()));
}

/// Refuses a screenshot that would replace an input.
tl::expected<void, Error> check_screenshot(const PlayerArguments& arguments) {
  if (arguments.screenshot.empty()) return {};
  const auto inputs = find_inputs(arguments.inputs);
  if (!inputs) return tl::unexpected(inputs.error());
  return InputGuard(inputs->files).allows(arguments.screenshot);
}

int play(const PlayerArguments& arguments, Settings settings,
         const std::optional<std::filesystem::path>& config) {
  if (const auto allowed = check_screenshot(arguments); !allowed) return fail(allowed.error());
  if (arguments.window_size) {
    settings.window.width = arguments.window_size->width;
    settings.window.height = arguments.window_size->height;
  }
  auto window = Window::open(settings.window, /*vsync=*/arguments.frames == 0);
  if (!window) return fail(window.error());
  auto canvas = Canvas::make((*window)->gl(), Window::loader());
  if (!canvas) return fail(canvas.error());
  Player player(std::move(settings), std::move(*canvas));
  player.stage = arguments.stage;
  player.check_incremental(arguments.check_incremental);
  if (!arguments.inputs.empty()) {
    if (auto opened = player.open(arguments.inputs); !opened) return fail(opened.error());
  } else if (arguments.frames > 0) {
    return fail({"There is nothing to show frames of."});
  }
  if (auto done = Session(arguments, **window, player).run(); !done) return fail(done.error());
  if (arguments.print_stats) print_stats(player);
  if (arguments.frames > 0) {
    if (player.damage()) return fail(*player.damage());
    return kExitDone;  // nothing is remembered
  }
  if (config) {
    player.settings.window = (*window)->geometry();
    if (auto saved = save_settings(player.settings, *config); !saved) return fail(saved.error());
  }
  return kExitDone;
}

int run(int argc, char** argv) {
  const auto config = wants_no_config(argc, argv) ? std::nullopt : settings_path();
  Settings settings;
  if (config) {
    if (auto loaded = load_settings(*config)) {
      settings = std::move(*loaded);
    } else {
      fmt::print(stderr, "depixel-player: {}\n", loaded.error().message);
    }
  }
  const auto parsed = parse_player_command_line(argc, argv, settings.options);
  if (const int* exit_code = std::get_if<int>(&parsed)) return *exit_code;
  return play(std::get<PlayerArguments>(parsed), std::move(settings), config);
}

}  // namespace
}  // namespace depixel

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error like any other
  try {
    return depixel::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("depixel-player: There is not enough memory.\n", stderr);
  } catch (const std::exception& error) {
    fmt::print(stderr, "depixel-player: Something unexpected happened: {}.\n", error.what());
  }
  return depixel::kExitFailed;
}
