#include "apps/player/window.hpp"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>
// After glad, whose declarations of OpenGL it must find.
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "apps/player/theme.hpp"

namespace depixel {
namespace {

tl::unexpected<Error> failed(const char* what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  std::string text = reason == nullptr ? "the window system does not say why" : reason;
  if (text.ends_with('.')) text.pop_back();
  return tl::unexpected(Error{fmt::format("{}: {}.", what, text)});
}

Window& window_of(GLFWwindow* window) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

/// The monitor that most of the window lies on.
GLFWmonitor* monitor_of(const WindowSettings& window) {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  const auto shared_area = [&window](GLFWmonitor* monitor) {
    PixelRect screen;
    glfwGetMonitorWorkarea(monitor, &screen.x, &screen.y, &screen.width, &screen.height);
    const PixelRect shared = intersection(screen, {window.x, window.y, window.width, window.height});
    return shared.width * shared.height;
  };
  return count == 0 ? nullptr : *std::ranges::max_element(monitors, monitors + count, {}, shared_area);
}

void set_hints() {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_ALPHA_BITS, 0);  // the desktop must not shine through transparent pictures
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "depixel-player");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "depixel-player");
}

}  // namespace

tl::expected<std::unique_ptr<Window>, Error> Window::open(const WindowSettings& settings, bool vsync) {
  if (glfwInit() != GLFW_TRUE) return failed("No window can be opened");
  std::unique_ptr<Window> window(new Window);  // from here on its destructor ends GLFW
  set_hints();
  window->window_ = glfwCreateWindow(settings.width, settings.height, "Depixel", nullptr, nullptr);
  if (window->window_ == nullptr) return failed("No window with OpenGL 3.3 can be opened");
  if (settings.has_position) glfwSetWindowPos(window->window_, settings.x, settings.y);
  window->windowed_ = window->geometry();
  glfwMakeContextCurrent(window->window_);
  glfwSwapInterval(vsync ? 1 : 0);
  if (gladLoadGLContext(&window->gl_, glfwGetProcAddress) == 0) {
    return tl::unexpected(Error{"OpenGL's functions cannot be found."});
  }
  window->install_callbacks();

  ImGui::CreateContext();
  set_up_theme(static_cast<float>(window->pixel_ratio()));
  ImGui_ImplGlfw_InitForOpenGL(window->window_, /*install_callbacks=*/true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
  window->ui_started_ = true;
  return window;
}

Window::~Window() {
  if (ui_started_) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  if (window_ != nullptr) glfwDestroyWindow(window_);
  glfwTerminate();
}

GlLoader Window::loader() {
  return [](const char* name) { return reinterpret_cast<GlFunction>(glfwGetProcAddress(name)); };
}

// ImGui calls these in turn, after its own.
void Window::install_callbacks() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned character) {
    window_of(window).keys_.push_back({static_cast<char32_t>(character), 0});
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int) {
    const bool types_character = key < GLFW_KEY_ESCAPE;
    if (action != GLFW_RELEASE && !types_character) window_of(window).keys_.push_back({0, key});
    window_of(window).had_events_ = true;
  });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    window_of(window).drops_.assign(paths, paths + count);
    window_of(window).had_events_ = true;
  });
  const auto note = [](GLFWwindow* window) { window_of(window).had_events_ = true; };
  glfwSetWindowRefreshCallback(window_, note);
  glfwSetWindowCloseCallback(window_, note);
  glfwSetCursorPosCallback(window_,
                           [](GLFWwindow* window, double, double) { window_of(window).had_events_ = true; });
  glfwSetScrollCallback(window_,
                        [](GLFWwindow* window, double, double) { window_of(window).had_events_ = true; });
  glfwSetMouseButtonCallback(window_,
                             [](GLFWwindow* window, int, int, int) { window_of(window).had_events_ = true; });
  glfwSetFramebufferSizeCallback(window_,
                                 [](GLFWwindow* window, int, int) { window_of(window).had_events_ = true; });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int) { window_of(window).had_events_ = true; });
}

void Window::wait_events(double seconds) {
  had_events_ = false;
  if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
}

bool Window::should_close() const {
  return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::close() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::begin_ui() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Window::end_ui() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::swap() {
  glfwSwapBuffers(window_);
}

glm::ivec2 Window::framebuffer_size() const {
  glm::ivec2 size;
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

double Window::pixel_ratio() const {
  int width = 0, height = 0;
  glfwGetWindowSize(window_, &width, &height);
  return width > 0 ? double(framebuffer_size().x) / width : 1;
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

bool Window::is_fullscreen() const {
  return glfwGetWindowMonitor(window_) != nullptr;
}

void Window::toggle_fullscreen() {
  if (is_fullscreen()) {
    glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.width, windowed_.height,
                         GLFW_DONT_CARE);
    return;
  }
  windowed_ = geometry();
  GLFWmonitor* monitor = monitor_of(windowed_);
  if (monitor == nullptr) return;
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

WindowSettings Window::geometry() const {
  if (is_fullscreen()) return windowed_;
  WindowSettings now;
  glfwGetWindowSize(window_, &now.width, &now.height);
  glfwGetWindowPos(window_, &now.x, &now.y);
  now.has_position = true;
  return now;
}

std::vector<KeyPress> Window::take_keys() {
  return std::exchange(keys_, {});
}

std::vector<std::filesystem::path> Window::take_drops() {
  return std::exchange(drops_, {});
}

}  // namespace depixel
