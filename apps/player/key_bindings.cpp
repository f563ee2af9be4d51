#include "apps/player/key_bindings.hpp"

#include <array>

// After glad, whose declarations of OpenGL it must find.
#include <GLFW/glfw3.h>

namespace depixel {
namespace {

constexpr double kZoomStep = 1.25;

template <int kStage>
void show_stage(Player& player) {
  player.stage = static_cast<StageView>(kStage);
}

void show_filter(Player& player) {
  player.stage.reset();
}
void toggle_playing(Player& player) {
  player.toggle_playing();
}
void step_on(Player& player) {
  player.step(1);
}
void step_back(Player& player) {
  player.step(-1);
}
void go_to_first(Player& player) {
  player.seek(0);
}
void go_to_last(Player& player) {
  player.seek(player.extent().arrived - 1);
}
void play_slower(Player& player) {
  player.set_speed(player.playback().speed() / 2);
}
void play_faster(Player& player) {
  player.set_speed(player.playback().speed() * 2);
}
void toggle_loop(Player& player) {
  player.set_loop(!player.playback().loops());
}
void zoom(Player& player, double factor) {
  const PixelRect& area = player.view.area();
  player.view.zoom_about({area.x + area.width / 2.0, area.y + area.height / 2.0}, factor);
}
void zoom_in(Player& player) {
  zoom(player, kZoomStep);
}
void zoom_out(Player& player) {
  zoom(player, 1 / kZoomStep);
}
void fit(Player& player) {
  player.view.fit();
}
void toggle_whole_scales(Player& player) {
  player.set_whole_scales(!player.settings.look.whole_scales);
}
void next_aspect(Player& player) {
  player.set_aspect(static_cast<PixelAspect>((static_cast<int>(player.settings.look.aspect) + 1) % 3));
}
void toggle_split(Player& player) {
  player.settings.look.split = !player.settings.look.split;
}
void toggle_raw(Player& player) {
  RawSampling& raw = player.settings.look.raw;
  raw = raw == RawSampling::nearest ? RawSampling::bilinear : RawSampling::nearest;
}
void toggle_outline(Player& player) {
  player.settings.look.outline = !player.settings.look.outline;
}
void toggle_panels(Player& player) {
  player.settings.look.panels = !player.settings.look.panels;
}
void open_files(Player& player) {
  player.shows_open = !player.shows_open;
  player.shows_help = false;
}
void take_screenshot(Player& player) {
  player.wants_screenshot = true;
}
void save_svg(Player& player) {
  player.save_svg();
}
void export_clip(Player& player) {
  player.start_export();
}
void toggle_fullscreen(Player& player) {
  player.wants_fullscreen = true;
}
void toggle_help(Player& player) {
  player.shows_help = !player.shows_help;
}
/// Closes what is open, one thing after the other.
void escape(Player& player) {
  const bool has_dialog = player.shows_help || player.shows_open || player.exporter() != nullptr;
  player.wants_fullscreen = player.is_fullscreen && !has_dialog;
  player.shows_help = player.shows_open = false;
  player.cancel_export();
}
void quit(Player& player) {
  player.wants_quit = true;
}

constexpr std::array kBindings{
    KeyBinding{{' ', 0}, "Space", "play, pause", toggle_playing},
    KeyBinding{{'.', 0}, ".", "a frame on", step_on},
    KeyBinding{{0, GLFW_KEY_RIGHT}, "Right", "", step_on},
    KeyBinding{{',', 0}, ",", "a frame back", step_back},
    KeyBinding{{0, GLFW_KEY_LEFT}, "Left", "", step_back},
    KeyBinding{{0, GLFW_KEY_HOME}, "Home", "the first frame", go_to_first},
    KeyBinding{{0, GLFW_KEY_END}, "End", "the last frame", go_to_last},
    KeyBinding{{'[', 0}, "[", "half the speed", play_slower},
    KeyBinding{{']', 0}, "]", "twice the speed", play_faster},
    KeyBinding{{'l', 0}, "l", "play in a loop, or once", toggle_loop},
    KeyBinding{{'v', 0}, "v", "the vector picture", show_filter},
    KeyBinding{{'0', 0}, "0", "step: the bitmap", show_stage<0>},
    KeyBinding{{'1', 0}, "1", "step: similarity graph", show_stage<1>},
    KeyBinding{{'2', 0}, "2", "step: accurate cells", show_stage<2>},
    KeyBinding{{'3', 0}, "3", "step: simplified cells", show_stage<3>},
    KeyBinding{{'4', 0}, "4", "step: contours", show_stage<4>},
    KeyBinding{{'5', 0}, "5", "step: polygons", show_stage<5>},
    KeyBinding{{'6', 0}, "6", "step: curves", show_stage<6>},
    KeyBinding{{'7', 0}, "7", "step: smoothed curves", show_stage<7>},
    KeyBinding{{'8', 0}, "8", "step: components", show_stage<8>},
    KeyBinding{{'9', 0}, "9", "step: shaded components", show_stage<9>},
    KeyBinding{{'+', 0}, "+", "nearer (or the wheel)", zoom_in},
    KeyBinding{{'=', 0}, "=", "", zoom_in},
    KeyBinding{{'-', 0}, "-", "farther", zoom_out},
    KeyBinding{{'z', 0}, "z", "the whole picture", fit},
    KeyBinding{{'i', 0}, "i", "whole scales only, or any", toggle_whole_scales},
    KeyBinding{{'a', 0}, "a", "pixels square, 8:7, or the picture 4:3", next_aspect},
    KeyBinding{{'s', 0}, "s", "split: the raw frame beside", toggle_split},
    KeyBinding{{'b', 0}, "b", "the raw frame nearest or bilinear", toggle_raw},
    KeyBinding{{'h', 0}, "h", "outline what is under the pointer", toggle_outline},
    KeyBinding{{0, GLFW_KEY_TAB}, "Tab", "show or hide the panels", toggle_panels},
    KeyBinding{{'o', 0}, "o", "open files (or drop them)", open_files},
    KeyBinding{{'c', 0}, "c", "save what the window shows", take_screenshot},
    KeyBinding{{'w', 0}, "w", "write this frame as SVG", save_svg},
    KeyBinding{{'e', 0}, "e", "write all frames as PNG", export_clip},
    KeyBinding{{'f', 0}, "f", "fullscreen", toggle_fullscreen},
    KeyBinding{{0, GLFW_KEY_F11}, "F11", "", toggle_fullscreen},
    KeyBinding{{'?', 0}, "?", "these keys", toggle_help},
    KeyBinding{{0, GLFW_KEY_F1}, "F1", "", toggle_help},
    KeyBinding{{0, GLFW_KEY_ESCAPE}, "Escape", "close, stop, leave fullscreen", escape},
    KeyBinding{{'q', 0}, "q", "quit", quit},
};

}  // namespace

std::span<const KeyBinding> key_bindings() {
  return kBindings;
}

void handle_key(const KeyPress& press, Player& player) {
  for (const KeyBinding& binding : kBindings) {
    if (binding.press == press) binding.action(player);
  }
}

}  // namespace depixel
