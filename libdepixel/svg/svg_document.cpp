#include "libdepixel/svg/svg_document.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "libdepixel/core/tolerances.hpp"

namespace depixel {
namespace {

constexpr int kThousand = 1000;

/// True where a control point is as near to a third of the chord as rounding allows.
bool lies_on_third(glm::ivec2 control, glm::ivec2 near, glm::ivec2 far) {
  const glm::ivec2 off = 3 * (control - near) - (far - near);
  return std::abs(off.x) <= 2 && std::abs(off.y) <= 2;
}

/// Whether a line goes straight on in a direction.
bool goes_on(glm::ivec2 line, glm::ivec2 by) {
  const std::int64_t x = line.x, y = line.y;
  return x * by.y == y * by.x && x * by.x + y * by.y >= 0;
}

void append_integer(std::string& out, int value) {
  char digits[12];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  out.append(digits, end);
}

char hex_digit(int value) {
  return "0123456789abcdef"[value];
}

}  // namespace

int svg_thousandths(double pixels) {
  return static_cast<int>(std::lround(pixels * kThousand));
}

void append_svg_number(std::string& out, int thousandths) {
  if (thousandths < 0) out += '-';
  const int magnitude = std::abs(thousandths), fraction = magnitude % kThousand;
  if (magnitude >= kThousand || fraction == 0) append_integer(out, magnitude / kThousand);
  if (fraction == 0) return;
  out += '.';
  for (int rest = fraction, place = kThousand / 10; rest != 0; rest %= place, place /= 10) {
    out += static_cast<char>('0' + rest / place);
    if (place == 1) break;
  }
}

int svg_length(int thousandths) {
  const int magnitude = std::abs(thousandths), fraction = magnitude % kThousand;
  int length = 1;  // the sign, or what separates it
  if (fraction != 0) length += fraction % 100 == 0 ? 2 : fraction % 10 == 0 ? 3 : 4;
  if (fraction != 0 && magnitude < kThousand) return length;
  for (int rest = magnitude; rest >= kThousand || length == 1; rest /= 10) ++length;
  return length;
}

bool is_svg_line(glm::ivec2 p0, glm::ivec2 p1, glm::ivec2 p2, glm::ivec2 p3) {
  return lies_on_third(p1, p0, p3) && lies_on_third(p2, p3, p0);
}

std::optional<glm::ivec2> svg_quadratic_control(glm::ivec2 p0, glm::ivec2 p1, glm::ivec2 p2, glm::ivec2 p3) {
  const glm::ivec2 by_start = 3 * p1 - p0, by_end = 3 * p2 - p3, off = by_start - by_end;
  if (std::abs(off.x) > 3 || std::abs(off.y) > 3) return std::nullopt;
  const glm::ivec2 sum = by_start + by_end;  // is four times the control point
  return glm::ivec2((sum.x + 2) >> 2, (sum.y + 2) >> 2);
}

void append_svg_paint(std::string& out, std::string_view what, Rgba colour) {
  const std::array<std::uint8_t, 3> channels{colour.r, colour.g, colour.b};
  const bool is_short = std::all_of(channels.begin(), channels.end(), [](int c) { return c % 17 == 0; });
  out.append(" ").append(what).append("=\"#");
  for (const std::uint8_t channel : channels) {
    if (!is_short) out += hex_digit(channel >> 4);
    out += hex_digit(channel & 15);
  }
  out += '"';
  if (colour.a == 255) return;
  out.append(" ").append(what).append("-opacity=\"");
  append_svg_number(out, (colour.a * kThousand + 127) / 255);
  out += '"';
}

void SvgPathData::command(char letter) {
  if (letter != last_) {
    out_ += letter;
    after_number_ = false;
  }
  last_ = letter;
}

/// A sign or a second decimal point separates numbers as well as a space does.
void SvgPathData::number(int thousandths) {
  const int magnitude = std::abs(thousandths);
  const bool has_fraction = magnitude % kThousand != 0;
  const bool starts_with_point = has_fraction && magnitude < kThousand;
  if (after_number_ && thousandths >= 0 && !(starts_with_point && after_fraction_)) out_ += ' ';
  append_svg_number(out_, thousandths);
  after_number_ = true;
  after_fraction_ = has_fraction;
}

void SvgPathData::vector(glm::ivec2 by) {
  number(by.x);
  number(by.y);
}

void SvgPathData::move_to(glm::ivec2 to_subpixels) {
  write_line();
  const glm::ivec2 to = grid_.thousandths(to_subpixels);
  const bool is_first = last_ == 0;
  last_ = 0;
  command(is_first ? 'M' : 'm');
  vector(is_first ? to : to - at_);
  last_ = is_first ? 'L' : 'l';  // what more numbers after a move would mean
  exact_ = to_subpixels;
  start_ = at_ = cubic_next_ = quadratic_next_ = to;
}

void SvgPathData::line_to(glm::ivec2 to_subpixels) {
  const glm::ivec2 to = grid_.thousandths(to_subpixels), by = to - at_;
  exact_ = to_subpixels;
  if (by == glm::ivec2(0)) return;
  if (!goes_on(line_, by)) write_line();
  line_ += by;
  at_ = cubic_next_ = quadratic_next_ = to;
}

void SvgPathData::write_line() {
  if (line_.x != 0 || line_.y != 0) command(line_.y == 0 ? 'h' : line_.x == 0 ? 'v' : 'l');
  if (line_.x != 0) number(line_.x);
  if (line_.y != 0) number(line_.y);
  line_ = {0, 0};
}

void SvgPathData::curve_to(glm::ivec2 p1_subpixels, glm::ivec2 p2_subpixels, glm::ivec2 to_subpixels) {
  const glm::ivec2 from_subpixels = exact_;
  if (is_svg_line(from_subpixels, p1_subpixels, p2_subpixels, to_subpixels)) {
    line_to(to_subpixels);
    return;
  }
  write_line();
  const auto control = svg_quadratic_control(from_subpixels, p1_subpixels, p2_subpixels, to_subpixels);
  if (control) {
    write_quadratic(grid_.thousandths(*control));
  } else {
    write_cubic(grid_.thousandths(p1_subpixels), grid_.thousandths(p2_subpixels));
  }
  const glm::ivec2 to = grid_.thousandths(to_subpixels);
  vector(to - at_);
  cubic_next_ = control ? to : 2 * to - grid_.thousandths(p2_subpixels);
  quadratic_next_ = control ? 2 * to - grid_.thousandths(*control) : to;
  at_ = to;
  exact_ = to_subpixels;
}

void SvgPathData::write_cubic(glm::ivec2 p1, glm::ivec2 p2) {
  command(p1 == cubic_next_ ? 's' : 'c');
  if (p1 != cubic_next_) vector(p1 - at_);
  vector(p2 - at_);
}

void SvgPathData::write_quadratic(glm::ivec2 control) {
  command(control == quadratic_next_ ? 't' : 'q');
  if (control != quadratic_next_) vector(control - at_);
}

void SvgPathData::close() {
  if (at_ == start_) line_ = {0, 0};
  write_line();
  command('z');
  at_ = start_;
}

SvgPathData& SvgDocument::path(Rgba colour) {
  Shapes*& shapes = of_colour_[std::bit_cast<std::uint32_t>(colour)];
  if (shapes == nullptr) shapes = &shapes_.emplace_back(colour, grid_);
  return shapes->path;
}

std::string SvgDocument::finish() const {
  const std::string width = std::to_string(width_), height = std::to_string(height_);
  const std::string margin = std::to_string(margin_), origin = " x=\"" + margin + "\" y=\"" + margin + "\"";
  std::string size(" width=\"");
  size.append(width).append("\" height=\"").append(height).append("\"");
  std::string opaque, translucent, beside;
  for (const Shapes& shapes : shapes_) {
    if (shapes.colour.a < 255) beside += shapes.data;
    if (shapes.colour.a == 0) continue;
    std::string& out = shapes.colour.a == 255 ? opaque : translucent;
    out += "<path";
    append_svg_paint(out, "fill", shapes.colour);
    out.append(" d=\"").append(shapes.data).append("\"/>\n");
  }
  const bool masked = !opaque.empty() && !beside.empty();
  std::string svg;
  svg.reserve(opaque.size() + translucent.size() + beside.size() + overlay_.size() + 1024);
  svg.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"");
  svg.append(" xmlns:xlink=\"http://www.w3.org/1999/xlink\"").append(size);
  svg.append(" viewBox=\"").append(margin).append(" ").append(margin).append(" ").append(width);
  svg.append(" ").append(height).append("\">\n");
  svg.append("<defs>\n<g id=\"shapes\">\n").append(opaque).append("</g>\n");
  constexpr std::string_view kCrisp = " shape-rendering=\"crispEdges\"";
  if (masked) {  // its stroke takes away pixels that the silhouette crosses, at scales up to 8
    svg.append("<mask id=\"inside\" maskUnits=\"userSpaceOnUse\"").append(origin).append(size);
    svg.append(">\n<rect").append(margin_ > 0 ? origin : "").append(size);
    svg.append(" fill=\"#fff\"/>\n<path").append(kCrisp);
    svg.append(" stroke=\"#000\" stroke-width=\".06\" stroke-linejoin=\"round\" d=\"");
    svg.append(beside).append("\"/>\n</mask>\n");
  }
  svg.append("</defs>\n<use xlink:href=\"#shapes\"").append(kCrisp);
  if (masked) svg.append(" mask=\"url(#inside)\"");
  svg.append("/>\n<use xlink:href=\"#shapes\"/>\n");
  svg.append(translucent).append(overlay_).append("</svg>\n");
  return svg;
}

}  // namespace depixel
