#pragma once

#include <glad/gl.h>

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "apps/player/settings.hpp"
#include "filter/frame_filter.hpp"
#include "libdepixel/core/error.hpp"

struct GLFWwindow;

namespace depixel {

/// A key that was pressed or repeats: a character as typed, or a key that types none.
struct KeyPress {
  char32_t character = 0;  ///< 0 for the others
  int key = 0;             ///< GLFW_KEY_..., 0 for characters

  friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

/// A window with an OpenGL 3.3 core context, current for as long as it lives, and Dear ImGui upon it.
/// One at a time.
class Window {
 public:
  /// \param vsync  whether swap() waits for the display.
  /// \return an error if there is no display or OpenGL is too old.
  static tl::expected<std::unique_ptr<Window>, Error> open(const WindowSettings& settings, bool vsync);
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window();

  const GladGLContext& gl() const { return gl_; }
  /// Finds functions of the window's context.
  static GlLoader loader();

  /// Handles what happened since the last call; waits for that, if nothing did, at most so long.
  void wait_events(double seconds);
  bool should_close() const;
  void close();

  /// Starts a frame of ImGui. Everything is drawn between this and end_ui().
  void begin_ui();
  /// Draws what ImGui was told over the window's content.
  void end_ui();
  void swap();

  /// Of the content, in pixels.
  glm::ivec2 framebuffer_size() const;
  /// Framebuffer pixels to ImGui's units.
  double pixel_ratio() const;
  void set_title(const std::string& title);
  bool is_fullscreen() const;
  void toggle_fullscreen();
  /// Size and position; those of before while fullscreen.
  WindowSettings geometry() const;

  /// What was pressed and dropped since they were taken last.
  std::vector<KeyPress> take_keys();
  std::vector<std::filesystem::path> take_drops();
  /// Whether anything happened in the last wait_events(), input or exposure.
  bool had_events() const { return had_events_; }

 private:
  Window() = default;
  void install_callbacks();

  GLFWwindow* window_ = nullptr;
  bool ui_started_ = false;
  GladGLContext gl_{};
  std::vector<KeyPress> keys_;
  std::vector<std::filesystem::path> drops_;
  bool had_events_ = false;
  WindowSettings windowed_;
};

}  // namespace depixel
