#include "libdepixel/svg/svg_document.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "libdepixel/core/tolerances.hpp"

namespace depixel {
namespace {

constexpr int kThousand = 1000;

int to_thousandths(int subpixels) {
  constexpr int kHalf = kSubpixels / 2;
  const std::int64_t scaled = std::int64_t{subpixels} * kThousand + kHalf;
  return static_cast<int>(scaled >= 0 ? scaled / kSubpixels : (scaled - kSubpixels + 1) / kSubpixels);
}

glm::ivec2 to_thousandths(glm::ivec2 subpixels) {
  return {to_thousandths(subpixels.x), to_thousandths(subpixels.y)};
}

/// True where a control point is as near to a third of the chord as rounding allows.
bool lies_on_third(glm::ivec2 control, glm::ivec2 near, glm::ivec2 far) {
  const glm::ivec2 off = 3 * (control - near) - (far - near);
  return std::abs(off.x) <= 2 && std::abs(off.y) <= 2;
}

void append_integer(std::string& out, int value) {
  char digits[12];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  out.append(digits, end);
}

void append_hex(std::string& out, std::uint8_t value) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  out += kDigits[value >> 4];
  out += kDigits[value & 15];
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

void append_svg_paint(std::string& out, std::string_view what, Rgba colour) {
  out.append(" ").append(what).append("=\"#");
  for (const std::uint8_t channel : {colour.r, colour.g, colour.b}) append_hex(out, channel);
  out += '"';
  if (colour.a == 255) return;
  out.append(" ").append(what).append("-opacity=\"");
  append_svg_number(out, (colour.a * kThousand + 127) / 255);
  out += '"';
}

void SvgPathData::command(char letter) {
  if (letter != last_) {
    out_ += letter;
    needs_space_ = false;
  }
  last_ = letter;
}

void SvgPathData::number(int thousandths) {
  if (needs_space_ && thousandths >= 0) out_ += ' ';
  append_svg_number(out_, thousandths);
  needs_space_ = true;
}

void SvgPathData::move_to(glm::ivec2 to_subpixels) {
  last_ = 0;
  command('M');
  at_ = to_thousandths(to_subpixels);
  exact_ = to_subpixels;
  number(at_.x);
  number(at_.y);
}

void SvgPathData::line_to(glm::ivec2 to_subpixels) {
  const glm::ivec2 to = to_thousandths(to_subpixels), by = to - at_;
  exact_ = to_subpixels;
  at_ = to;
  if (by.x != 0 || by.y != 0) command(by.y == 0 ? 'h' : by.x == 0 ? 'v' : 'l');
  if (by.x != 0) number(by.x);
  if (by.y != 0) number(by.y);
}

void SvgPathData::curve_to(glm::ivec2 p1_subpixels, glm::ivec2 p2_subpixels, glm::ivec2 to_subpixels) {
  if (lies_on_third(p1_subpixels, exact_, to_subpixels) &&
      lies_on_third(p2_subpixels, to_subpixels, exact_)) {
    line_to(to_subpixels);
    return;
  }
  command('c');
  const glm::ivec2 from = at_;
  for (const glm::ivec2 p : {p1_subpixels, p2_subpixels, to_subpixels}) {
    at_ = to_thousandths(p);
    number(at_.x - from.x);
    number(at_.y - from.y);
  }
  exact_ = to_subpixels;
}

void SvgDocument::add_shape(Rgba colour, std::string_view path_data) {
  if (colour.a == 255) {
    opaque_.push_back({colour, path_data.size()});
    opaque_data_ += path_data;
    return;
  }
  beside_data_ += path_data;
  if (colour.a == 0) return;
  translucent_ += "<path";
  append_svg_paint(translucent_, "fill", colour);
  translucent_.append(" d=\"").append(path_data).append("\"/>\n");
}

std::string SvgDocument::finish() const {
  const std::string width = std::to_string(width_), height = std::to_string(height_);
  std::string size(" width=\"");
  size.append(width).append("\" height=\"").append(height).append("\"");
  const bool masked = !opaque_.empty() && !beside_data_.empty();
  std::string svg;
  svg.reserve(opaque_data_.size() + 64 * opaque_.size() + translucent_.size() + beside_data_.size() +
              overlay_.size() + 1024);
  svg.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"");
  svg.append(" xmlns:xlink=\"http://www.w3.org/1999/xlink\"").append(size);
  svg.append(" viewBox=\"0 0 ").append(width).append(" ").append(height).append("\">\n");
  svg.append("<defs>\n<g id=\"shapes\" fill-rule=\"evenodd\">\n");
  std::string_view data = opaque_data_;
  for (const Shape& shape : opaque_) {
    svg.append("<path");
    append_svg_paint(svg, "fill", shape.colour);
    svg.append(" d=\"").append(data.substr(0, shape.data_bytes)).append("\"/>\n");
    data.remove_prefix(shape.data_bytes);
  }
  svg.append("</g>\n");
  constexpr std::string_view kCrisp = " shape-rendering=\"crispEdges\"";
  if (masked) {  // its stroke takes away pixels that the silhouette crosses, at scales up to 8
    svg.append("<mask id=\"inside\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\"").append(size);
    svg.append(">\n<rect").append(size).append(" fill=\"#fff\"/>\n<path").append(kCrisp);
    svg.append(" stroke=\"#000\" stroke-width=\".06\" stroke-linejoin=\"round\" d=\"");
    svg.append(beside_data_).append("\"/>\n</mask>\n");
  }
  svg.append("</defs>\n<use xlink:href=\"#shapes\"").append(kCrisp);
  if (masked) svg.append(" mask=\"url(#inside)\"");
  svg.append("/>\n<use xlink:href=\"#shapes\"/>\n");
  if (!translucent_.empty()) svg.append("<g fill-rule=\"evenodd\">\n").append(translucent_).append("</g>\n");
  svg.append(overlay_).append("</svg>\n");
  return svg;
}

}  // namespace depixel
