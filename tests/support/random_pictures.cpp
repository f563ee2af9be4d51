#include "tests/support/random_pictures.hpp"

#include <variant>

#include "libdepixel/core/options.hpp"

namespace depixel {

void showValue(const Options& options, std::ostream& out) {
  for (const OptionInfo& info : option_table()) {
    out << "--" << info.name << ' ';
    if (const auto* choice = std::get_if<ChoiceOption>(&info.kind))
      out << choice->names[choice->get(options)];
    if (const auto* flag = std::get_if<SwitchOption>(&info.kind)) out << options.*flag->value;
    if (const auto* number = std::get_if<NumberOption>(&info.kind)) out << options.*number->value;
    if (const auto* count = std::get_if<CountOption>(&info.kind)) out << options.*count->value;
    out << ' ';
  }
}

namespace test {

rc::Gen<int> random_int(int from, int end) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(from, end));
}

namespace {

enum class Brush { spot, rectangle, falling_line, rising_line, checkerboard, dither, noise, sprite };
constexpr int kBrushes = 8;

/// One thing painted. Positions and sizes are taken modulo the picture's, so that every stroke is a valid
/// one.
struct Stroke {
  Brush brush;
  int x, y, width, height;
  std::uint32_t seed;
  std::vector<int> colours;  ///< indices into the palette characters; never empty
};

/// A pattern by position, not by order, so that shrinking a size leaves the rest as it was.
std::uint32_t scrambled(std::uint32_t seed, int x, int y) {
  std::uint32_t v = seed ^ (std::uint32_t(x) * 0x9e3779b1u) ^ (std::uint32_t(y) * 0x85ebca77u);
  v = (v ^ v >> 15) * 0x2c1b3c6du;
  v = (v ^ v >> 12) * 0x297a2d39u;
  return v ^ v >> 15;
}

/// Whether a stroke paints its pixel (x, y), and with which of its colours.
int colour_of(const Stroke& s, int x, int y) {
  constexpr int kNothing = -1;
  constexpr std::array<int, 16> kBayer{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  const int count = static_cast<int>(s.colours.size());
  switch (s.brush) {
    case Brush::spot:
      return x == 0 && y == 0 ? 0 : kNothing;
    case Brush::rectangle:
      return 0;
    case Brush::falling_line:
      return x == y ? (x / 3) % count : kNothing;
    case Brush::rising_line:
      return x + y + 1 == s.width ? (x / 3) % count : kNothing;
    case Brush::checkerboard:
      return (x + y) % 2 == 0 ? 0 : count > 1 ? 1 : kNothing;
    case Brush::dither:
      return kBayer[y % 4 * 4 + x % 4] * s.width < 16 * x ? 0 : count > 1 ? 1 : kNothing;
    case Brush::noise:
      return static_cast<int>(scrambled(s.seed, x, y) % static_cast<std::uint32_t>(count));
    case Brush::sprite: {  // a symmetric blob, as many sprites are
      const int half = std::min(x, s.width - 1 - x);
      const auto v = static_cast<int>(scrambled(s.seed, half, y) % static_cast<std::uint32_t>(2 * count));
      return v < count ? v : kNothing;
    }
  }
  return kNothing;
}

void paint(Picture& picture, const Stroke& stroke, std::string_view palette) {
  const int x0 = stroke.x % picture.width, y0 = stroke.y % picture.height;
  for (int y = 0; y < stroke.height && y0 + y < picture.height; ++y) {
    for (int x = 0; x < stroke.width && x0 + x < picture.width; ++x) {
      const int which = colour_of(stroke, x, y);
      if (which >= 0) picture.at(x0 + x, y0 + y) = palette_colour(palette[stroke.colours[which]]);
    }
  }
}

rc::Gen<Stroke> random_stroke(int max_size, int colours) {
  const auto size = rc::gen::inRange(1, max_size + 1), position = rc::gen::inRange(0, max_size);
  const auto colour = random_int(0, colours);
  const auto stroke = rc::gen::build<Stroke>(
      rc::gen::set(&Stroke::brush,
                   rc::gen::map(rc::gen::inRange(0, kBrushes), [](int b) { return Brush(b); })),
      rc::gen::set(&Stroke::x, position), rc::gen::set(&Stroke::y, position),
      rc::gen::set(&Stroke::width, size), rc::gen::set(&Stroke::height, size),
      rc::gen::set(&Stroke::seed, rc::gen::arbitrary<std::uint32_t>()),
      rc::gen::set(&Stroke::colours,
                   rc::gen::nonEmpty(rc::gen::resize(3, rc::gen::container<std::vector<int>>(colour)))));
  return rc::gen::resize(rc::kNominalSize, stroke);
}

template <typename Enum>
rc::Gen<Enum> random_enum(int count) {
  return rc::gen::map(random_int(0, count), [](int v) { return static_cast<Enum>(v); });
}

}  // namespace

rc::Gen<Picture> random_picture(const RandomPictureLimits& limits) {
  const auto size = random_int(1, limits.max_size + 1);
  const auto strokes = rc::gen::resize(12, rc::gen::container<std::vector<Stroke>>(random_stroke(
                                               limits.max_size, static_cast<int>(limits.colours.size()))));
  return rc::gen::map(rc::gen::tuple(size, size, strokes), [limits](const auto& recipe) {
    const auto& [width, height, list] = recipe;
    Picture picture(width, height, palette_colour(limits.colours.front()));
    for (const Stroke& stroke : list) paint(picture, stroke, limits.colours);
    return picture;
  });
}

rc::Gen<Options> random_lossless_options() {
  return rc::gen::build<Options>(rc::gen::set(&Options::spline, random_enum<SplineKind>(3)),
                                 rc::gen::set(&Options::smoothing, random_enum<Smoothing>(3)),
                                 rc::gen::set(&Options::corners, random_enum<Corners>(2)),
                                 rc::gen::set(&Options::curve_rule, random_enum<CurveRule>(2)));
}

rc::Gen<Options> random_options() {
  return rc::gen::build<Options>(rc::gen::set(&Options::similarity, random_enum<Similarity>(2)),
                                 rc::gen::set(&Options::merge_luma, rc::gen::element(48.0, 25.0)),
                                 rc::gen::set(&Options::connect_lines, rc::gen::arbitrary<bool>()),
                                 rc::gen::set(&Options::dither, random_enum<DitherKind>(2)),
                                 rc::gen::set(&Options::spline, random_enum<SplineKind>(3)),
                                 rc::gen::set(&Options::smoothing, random_enum<Smoothing>(3)),
                                 rc::gen::set(&Options::text_safe, rc::gen::arbitrary<bool>()),
                                 rc::gen::set(&Options::corners, random_enum<Corners>(2)),
                                 rc::gen::set(&Options::shading, random_enum<ShadingKind>(4)),
                                 rc::gen::set(&Options::soft_contours, rc::gen::element(0.0, 0.0, 30.0)),
                                 rc::gen::set(&Options::curve_rule, random_enum<CurveRule>(2)),
                                 rc::gen::set(&Options::linear_light, rc::gen::arbitrary<bool>()),
                                 rc::gen::set(&Options::threads, rc::gen::element(1, 2, 3, 4)));
}

rc::Gen<BorderKind> random_border() {
  return random_enum<BorderKind>(3);
}

}  // namespace test
}  // namespace depixel
