#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "apps/common/clip.hpp"
#include "apps/player/canvas.hpp"
#include "apps/player/component_finder.hpp"
#include "apps/player/exporter.hpp"
#include "apps/player/frame_history.hpp"
#include "apps/player/playback.hpp"
#include "apps/player/settings.hpp"
#include "apps/player/view_control.hpp"
#include "libdepixel/views/stage_view.hpp"

namespace depixel {

/// What the player shows and does, without a window: keys, panels and the pointer change it, the window's
/// loop carries it out.
class Player {
 public:
  Player(Settings settings, std::unique_ptr<Canvas> canvas);

  /// Opens files, folders or patterns, or "-", in place of what is played.
  tl::expected<void, Error> open(const std::vector<std::string>& inputs);
  bool has_clip() const { return clip_ != nullptr; }
  const std::string& clip_name() const { return clip_name_; }

  /// Lets time pass, and takes the frame that is due; goes on with an export.
  void advance(double seconds);
  /// How long nothing changes of itself.
  double seconds_left() const;
  /// Shows the next frame, whatever its time is, if it has come; after the last, the first of a clip that
  /// loops.
  void show_next();
  /// Whether every frame, shown or exported, is compared with one made from scratch. Differences are told as
  /// messages, and errors of drawing with them: nothing ends.
  void check_incremental(bool wanted);
  /// What was found so, first.
  const std::optional<Error>& difference() const { return difference_; }
  /// What is wrong with the first frame that could not be shown, if there was one since start.
  const std::optional<Error>& damage() const { return damage_; }
  /// Why there is not a single frame to show, if that is so.
  const std::optional<Error>& failure() const { return failure_; }

  /// Vectorizes the frame, if it or the options are new; before that, nothing can be told of it.
  tl::expected<void, Error> vectorize();
  /// Draws what is under the panels. \param window  pixels.
  tl::expected<void, Error> draw(glm::ivec2 window);

  // What there is to do with a clip.
  void toggle_playing() { playback_.toggle(extent()); }
  void step(int by) { playback_.step(by, extent()); }
  void seek(int index) { playback_.seek(index, extent()); }
  void set_speed(double speed);
  void set_loop(bool loops);
  const Playback& playback() const { return playback_; }
  Playback::Extent extent() const;

  // How it is shown.
  Settings settings;
  ViewControl view;
  std::optional<StageView> stage;  ///< none: the filter
  void set_aspect(PixelAspect aspect);
  void set_whole_scales(bool whole);

  // Files that are written, beside where the program was started.
  void save_svg();
  void save_picture(const Picture& picture);
  void start_export();
  void cancel_export();
  const Exporter* exporter() const { return exporter_ ? &*exporter_ : nullptr; }

  // What the window is to do, asked for by keys and buttons, and done by its loop.
  bool wants_quit = false, wants_fullscreen = false, wants_screenshot = false;
  bool is_fullscreen = false;  ///< told by the window's loop
  bool shows_help = false, shows_open = false;

  /// Tells something for a while.
  void say(std::string message);
  const std::string& message() const { return message_; }

  const ClipFrame* frame() const { return frame_.get(); }
  /// Another one for every other frame.
  std::uint64_t serial() const { return serial_; }
  const Canvas& canvas() const { return *canvas_; }
  FrameHistory history;

  /// The component at a point of the source, and its outlines.
  std::optional<FoundComponent> component_at(glm::dvec2 point);
  const ComponentFinder& components() const { return components_; }

 private:
  void take_frame();
  bool tell_difference(const Error& error);
  double seconds_of(int index) const;

  std::unique_ptr<Canvas> canvas_;
  std::unique_ptr<Clip> clip_;
  std::string clip_name_;
  Playback playback_;
  std::shared_ptr<const ClipFrame> frame_;
  int frame_index_ = -1;
  std::uint64_t serial_ = 0;
  ComponentFinder components_;
  std::optional<Error> failure_, damage_;
  bool is_checking_ = false;
  std::optional<Error> difference_;
  std::optional<std::uint64_t> differing_serial_;
  std::optional<Exporter> exporter_;
  std::string message_;
  double message_seconds_ = 0;  ///< that it is still shown
};

}  // namespace depixel
