#include "tests/support/random_sequences.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace depixel::test {
namespace {

enum class StepKind {
  move_sprite,
  add_sprite,
  remove_sprite,
  set_pixel,
  paint_rectangle,
  scroll_all,
  scroll_background,
  scroll_foreground,
  change_foreground,
  change_hud,
  cycle_palette,
  fade_palette,
  restore_palette,
  repeat,
  resize,
  cut,
  change_options,
  reset
};

/// A change of the scene. Numbers are taken modulo what there is, so that every step is a valid one.
struct Step {
  StepKind kind = StepKind::repeat;
  int which = 0;
  int x = 0, y = 0, width = 1, height = 1;
  Picture picture;
  Options options;
};

/// Colours are characters of the palette until a frame is drawn; a hole shows what lies behind it.
constexpr std::string_view kColours = ".#rgb4567_R";
constexpr char kHole = '_';

int wrapped(int value, int size) {
  return (value % size + size) % size;
}

void shift(glm::ivec2& offset, const Step& step) {
  offset += glm::ivec2(step.x, step.y);
}

class Scene {
 public:
  Scene(const Picture& background, glm::ivec2 size, const Options& options)
      : background_(background), size_(size), options_(options) {
    restore_palette();
  }

  void take(const Step& step) {
    is_reset_ = false;
    switch (step.kind) {
      case StepKind::move_sprite:
        if (!sprites_.empty()) shift(sprite(step).position, step);
        return;
      case StepKind::add_sprite:
        sprites_.push_back({step.picture, {wrapped(step.x, size_.x), wrapped(step.y, size_.y)}});
        return;
      case StepKind::remove_sprite:
        if (!sprites_.empty()) sprites_.erase(sprites_.begin() + wrapped(step.which, sprite_count()));
        return;
      case StepKind::set_pixel:
        return paint(step, {1, 1});
      case StepKind::paint_rectangle:
        return paint(step, {step.width, step.height});
      case StepKind::scroll_all:
        shift(background_offset_, step);
        shift(foreground_offset_, step);
        for (Sprite& moved : sprites_) shift(moved.position, step);
        return;
      case StepKind::scroll_background:
        return shift(background_offset_, step);
      case StepKind::scroll_foreground:
        return shift(foreground_offset_, step);
      case StepKind::change_foreground:
        foreground_ = foreground_.width == 0 ? step.picture : Picture{};
        return;
      case StepKind::change_hud:
        hud_rows_ = hud_rows_ == 0 ? (step.height + 3) / 4 : 0;
        return;
      case StepKind::cycle_palette:  // what was equal stays equal, and nothing else becomes so
        std::rotate(palette_.begin(), palette_.begin() + wrapped(step.which, colour_count()), palette_.end());
        return;
      case StepKind::fade_palette:  // two colours become one
        palette_[wrapped(step.which, colour_count())] = palette_[wrapped(step.width, colour_count())];
        return;
      case StepKind::restore_palette:
        return restore_palette();
      case StepKind::repeat:
        return;
      case StepKind::resize:
        size_ = {step.width, step.height};
        return;
      case StepKind::cut:
        background_ = step.picture;
        sprites_.clear();
        return;
      case StepKind::change_options:
        options_ = step.options;
        return;
      case StepKind::reset:
        is_reset_ = true;
        return;
    }
  }

  SequenceFrame frame() const {
    Picture drawn(size_.x, size_.y);
    for (int y = 0; y < size_.y; ++y) {
      for (int x = 0; x < size_.x; ++x) {
        const bool stands_still = y < hud_rows_;
        drawn.at(x, y) =
            wrapped_pixel(background_, {x, y}, stands_still ? glm::ivec2(0) : background_offset_);
        if (foreground_.width == 0 || stands_still) continue;
        const Rgba before = wrapped_pixel(foreground_, {x, y}, foreground_offset_);
        if (palette_character(before) != kHole) drawn.at(x, y) = before;
      }
    }
    for (const Sprite& sprite : sprites_) paste(drawn, sprite.picture, sprite.position.x, sprite.position.y);
    for (Rgba& c : drawn.pixels) {
      c = palette_colour(palette_[kColours.find(palette_character(c))]);
    }
    return {drawn, options_, is_reset_};
  }

 private:
  struct Sprite {
    Picture picture;
    glm::ivec2 position;
  };

  int sprite_count() const { return static_cast<int>(sprites_.size()); }
  int colour_count() const { return static_cast<int>(palette_.size()); }
  Sprite& sprite(const Step& step) { return sprites_[wrapped(step.which, sprite_count())]; }
  void restore_palette() { palette_ = kColours; }

  void paint(const Step& step, glm::ivec2 size) {
    const Rgba colour = palette_colour(kColours[wrapped(step.which, static_cast<int>(kColours.size()))]);
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        background_.at(wrapped(step.x + x, background_.width), wrapped(step.y + y, background_.height)) =
            colour;
      }
    }
  }

  static Rgba wrapped_pixel(const Picture& picture, glm::ivec2 at, glm::ivec2 offset) {
    return picture.at(wrapped(at.x - offset.x, picture.width), wrapped(at.y - offset.y, picture.height));
  }

  Picture background_, foreground_;
  glm::ivec2 background_offset_{0}, foreground_offset_{0};
  glm::ivec2 size_;
  int hud_rows_ = 0;
  std::vector<Sprite> sprites_;
  std::string palette_;  ///< what each colour is drawn as
  Options options_;
  bool is_reset_ = false;
};

/// A width or height: mostly a large one, shrinks to 1.
rc::Gen<int> random_size(int max_size) {
  return rc::gen::map(random_int(0, 2 * max_size), [max_size](int k) {
    return k < max_size ? k + 1 : max_size / 2 + 1 + (k - max_size) / 2;
  });
}

rc::Gen<Options> likely_options() {
  const auto with_blended_dithers = rc::gen::map(random_lossless_options(), [](Options options) {
    options.dither = DitherKind::blend;
    return options;
  });
  return rc::gen::apply(
      [](Options options, BorderKind border) {
        options.border = border;
        return options;
      },
      rc::gen::weightedOneOf<Options>(
          {{2, random_lossless_options()}, {1, with_blended_dithers}, {1, random_options()}}),
      rc::gen::weightedOneOf<BorderKind>({{3, rc::gen::just(BorderKind::fixed)}, {1, random_border()}}));
}

rc::Gen<Picture> random_background(int max_width, int max_height) {
  return rc::gen::map(random_picture({std::max(max_width, max_height), kColours}),
                      [=](const Picture& picture) {
                        Picture cut(std::min(picture.width, max_width), std::min(picture.height, max_height));
                        paste(cut, picture, 0, 0);
                        return cut;
                      });
}

/// A step without picture or options. Numbers that are mostly small make moves that can be found again.
rc::Gen<Step> plain_step(StepKind kind, int max_move, const RandomSequenceLimits& limits) {
  return rc::gen::build<Step>(rc::gen::set(&Step::kind, rc::gen::just(kind)),
                              rc::gen::set(&Step::which, random_int(0, 16)),
                              rc::gen::set(&Step::x, random_int(-max_move, max_move + 1)),
                              rc::gen::set(&Step::y, random_int(-max_move, max_move + 1)),
                              rc::gen::set(&Step::width, random_int(1, limits.max_width + 1)),
                              rc::gen::set(&Step::height, random_int(1, limits.max_height + 1)));
}

rc::Gen<Step> step_with_picture(StepKind kind, const rc::Gen<Picture>& picture,
                                const RandomSequenceLimits& limits) {
  return rc::gen::apply(
      [](Step step, const Picture& painted) {
        step.picture = painted;
        return step;
      },
      plain_step(kind, limits.max_width, limits), picture);
}

rc::Gen<Step> random_step(const RandomSequenceLimits& limits) {
  constexpr int kNear = 3;
  const int far = limits.max_width;
  const auto plain = [&](StepKind kind, int max_move) { return plain_step(kind, max_move, limits); };
  const auto sprite = random_picture({10, kColours});
  const auto background = random_background(limits.max_width, limits.max_height);
  const auto options_step =
      rc::gen::build<Step>(rc::gen::set(&Step::kind, rc::gen::just(StepKind::change_options)),
                           rc::gen::set(&Step::options, likely_options()));
  return rc::gen::weightedOneOf<Step>({
      {8, plain(StepKind::move_sprite, kNear)},
      {2, plain(StepKind::move_sprite, far)},
      {5, step_with_picture(StepKind::add_sprite, sprite, limits)},
      {1, plain(StepKind::remove_sprite, 0)},
      {6, plain(StepKind::set_pixel, far)},
      {2, plain(StepKind::paint_rectangle, far)},
      {3, plain(StepKind::scroll_all, kNear)},
      {5, plain(StepKind::scroll_background, kNear)},
      {2, plain(StepKind::scroll_background, far)},
      {3, plain(StepKind::scroll_foreground, kNear)},
      {2, step_with_picture(StepKind::change_foreground, background, limits)},
      {1, plain(StepKind::change_hud, 0)},
      {2, plain(StepKind::cycle_palette, 0)},
      {1, plain(StepKind::fade_palette, 0)},
      {1, plain(StepKind::restore_palette, 0)},
      {1, plain(StepKind::repeat, 0)},
      {1, plain(StepKind::resize, 0)},
      {1, step_with_picture(StepKind::cut, background, limits)},
      {1, options_step},
      {1, plain(StepKind::reset, 0)},
  });
}

std::string_view name_of(bool value) {
  return value ? "true" : "false";
}

void print(std::ostream& out, const Options& options) {
  constexpr std::array<std::string_view, 2> kSimilarities{"exact", "merge"};
  constexpr std::array<std::string_view, 2> kDithers{"keep", "blend"};
  constexpr std::array<std::string_view, 3> kSplines{"adaptive", "approximate", "interpolate"};
  constexpr std::array<std::string_view, 3> kSmoothings{"energy", "average", "none"};
  constexpr std::array<std::string_view, 4> kShadings{"none", "gradient", "discs", "blur"};
  constexpr std::array<std::string_view, 3> kBorders{"fixed", "repeat", "mirror"};
  out << "{.similarity = Similarity::" << kSimilarities[static_cast<int>(options.similarity)]
      << ", .merge_luma = " << options.merge_luma << ", .connect_lines = " << name_of(options.connect_lines)
      << ", .dither = DitherKind::" << kDithers[static_cast<int>(options.dither)]
      << ", .spline = SplineKind::" << kSplines[static_cast<int>(options.spline)]
      << ", .smoothing = Smoothing::" << kSmoothings[static_cast<int>(options.smoothing)]
      << ", .corners = Corners::" << (options.corners == Corners::round ? "round" : "sharp")
      << ", .curve_rule = CurveRule::"
      << (options.curve_rule == CurveRule::valence ? "valence" : "continuity")
      << ", .border = BorderKind::" << kBorders[static_cast<int>(options.border)]
      << ", .text_safe = " << name_of(options.text_safe)
      << ", .shading = ShadingKind::" << kShadings[static_cast<int>(options.shading)]
      << ", .soft_contours = " << options.soft_contours
      << ", .linear_light = " << name_of(options.linear_light) << ", .threads = " << options.threads << '}';
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Sequence& sequence) {
  out << "Sequence{{";
  for (const SequenceFrame& frame : sequence.frames) {
    out << "\n{" << frame.picture << ",\n ";
    print(out, frame.options);
    out << ", " << name_of(frame.is_reset) << "},";
  }
  return out << "}}\n";
}

rc::Gen<Sequence> random_sequence(const RandomSequenceLimits& limits) {
  constexpr int kSteps = 20;
  const auto step = random_step(limits);
  const auto steps = limits.steps > 0 ? rc::gen::container<std::vector<Step>>(limits.steps, step)
                                      : rc::gen::resize(kSteps, rc::gen::container<std::vector<Step>>(step));
  return rc::gen::apply(
      [](const Picture& background, int width, int height, const Options& options,
         const std::vector<Step>& list) {
        Scene scene(background, {width, height}, options);
        Sequence sequence{{scene.frame()}};
        for (const Step& next : list) {
          scene.take(next);
          sequence.frames.push_back(scene.frame());
        }
        return sequence;
      },
      random_background(limits.max_width, limits.max_height), random_size(limits.max_width),
      random_size(limits.max_height), likely_options(), steps);
}

Sequence fixed_sequence(unsigned seed, const RandomSequenceLimits& limits) {
  return random_sequence(limits)(rc::Random(seed), rc::kNominalSize).value();
}

}  // namespace depixel::test
