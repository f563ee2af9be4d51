#include "libdepixel/svg/gradient_strips.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <map>
#include <span>
#include <string_view>
#include <tuple>

#include "libdepixel/svg/svg_document.hpp"

namespace depixel {
namespace {

using Levels = std::array<int, 4>;

Levels levels(Rgba c) {
  return {c.r, c.g, c.b, c.a};
}

Rgba mean(Rgba p, Rgba q) {
  const auto between = [](int a, int b) { return static_cast<std::uint8_t>((a + b + 1) / 2); };
  return {between(p.r, q.r), between(p.g, q.g), between(p.b, q.b), between(p.a, q.a)};
}

using Stop = GradientStrips::Stop;

/// Whether a gradient between two stops is within a level of a third's colour at its place.
bool lies_between(const Stop& stop, const Stop& first, const Stop& last) {
  const Levels at = levels(stop.colour), a = levels(first.colour), b = levels(last.colour);
  const int length = last.x - first.x, along = stop.x - first.x;
  for (int k = 0; k < 4; ++k) {
    if (std::abs((b[k] - a[k]) * along - (at[k] - a[k]) * length) > length) return false;
  }
  return true;
}

/// Bounds the work, which is quadratic.
constexpr std::size_t kMostLeftOut = 64;

/// The stops that gradients need, of those of a run; two at one place are a jump.
std::vector<Stop> needed(const std::vector<Stop>& stops) {
  std::vector<Stop> kept{stops.front()};
  std::size_t from = 0;
  for (std::size_t to = 2; to < stops.size(); ++to) {
    const auto is_straight = [&] {
      if (stops[to].x == stops[to - 1].x || to - from > kMostLeftOut) return false;
      for (std::size_t i = from + 1; i < to; ++i) {
        if (!lies_between(stops[i], stops[from], stops[to])) return false;
      }
      return true;
    };
    if (stops[to - 1].x != stops[from].x && is_straight()) continue;
    from = to - 1;
    kept.push_back(stops[from]);
  }
  kept.push_back(stops.back());
  return kept;
}

/// What gradients take their units from.
constexpr std::string_view kUnitsName = "u";
/// Strips up to which gradients are in parts of their box, in pixels.
constexpr int kLongestInBox = 16;

/// Strips that are drawn later hide the seams: subpixels by which one goes on to the east, and by which half
/// a strip goes on beyond the centres of its row.
constexpr int kOverlap = kSubpixels / 10;

/// A part of a whole, in percent, as exact as a strip's length asks for.
void append_offset(std::string& out, int part, int whole) {
  constexpr std::int64_t kAll = 100'000;  // thousandths of a percent
  const int unit = whole < 20 * kSubpixels ? 100 : 10;
  append_svg_number(out, static_cast<int>((part * kAll / whole + unit / 2) / unit * unit));
  out += '%';
}

/// The place of a stop in the document, west of a column of pixels: the centres of the last one.
std::string place(int x) {
  std::string out;
  append_svg_number(out, x * 1000 - 500);
  return out;
}

/// A gradient along a strip from pixel `first` on: the rest of its start tag, and its stops.
std::string gradient(std::span<const Stop> stops, int first, int length) {
  std::string out;
  // Short ones in parts of a strip's box, which can be shared; cairo's matrices are too coarse for long ones.
  const bool is_short = length <= kLongestInBox;
  if (!is_short) {
    out.append(" xlink:href=\"#").append(kUnitsName).append("\" x1=\"").append(place(first));
    out.append("\" x2=\"").append(place(first + length)).append("\"");
  }
  out += '>';
  const int whole = length * kSubpixels + (is_short ? kOverlap : 0);
  for (const Stop& stop : stops) {
    out += "<stop";
    if (stop.x != first) {
      out += " offset=\"";
      append_offset(out, (stop.x - first) * kSubpixels, whole);
      out += '"';
    }
    append_svg_paint(out, "stop-color", {stop.colour.r, stop.colour.g, stop.colour.b, 255});
    if (stop.colour.a != 255) {
      out += " stop-opacity=\"";
      append_svg_number(out, (stop.colour.a * 1000 + 127) / 255);
      out += '"';
    }
    out += "/>";
  }
  return out;
}

}  // namespace

GradientStrips::GradientStrips(const PlanarMap& map, const std::vector<int>& group) : map_(map) {
  find_pieces(group);
  join_halves();
  const auto key = [](const Piece& p) { return std::tie(p.is_odd, p.group, p.row, p.part, p.x); };
  std::sort(pieces_.begin(), pieces_.end(), [&](const Piece& p, const Piece& q) { return key(p) < key(q); });
  for (const Piece& p : pieces_) groups_.push_back(p.group);
  std::sort(groups_.begin(), groups_.end());
  groups_.erase(std::unique(groups_.begin(), groups_.end()), groups_.end());
}

void GradientStrips::find_pieces(const std::vector<int>& group) {
  const Lattice& lattice = map_.lattice;
  const std::array<int, 4> offset = block_pixels(lattice.stride());
  for (int y = 0; y <= lattice.height(); ++y) {
    for (int x = 0; x <= lattice.width(); ++x) {
      const int block = lattice.corner(x, y);
      const PairMask pairs = map_.shading.blocks[block];
      if (pairs == 0) continue;
      int opaque = 0;
      for (int k = 0; k < 4; ++k) {
        const int pixel = block + offset[k];
        opaque |= (group[pixel] >= 0 && map_.colours[pixel].a == 255 ? 1 : 0) << k;
      }
      for (int rest = opaque; rest != 0;) {
        const int g = group[block + offset[std::countr_zero(static_cast<unsigned>(rest))]];
        int own = 0;
        for (int k = 0; k < 4; ++k)
          own |= ((rest >> k & 1) != 0 && group[block + offset[k]] == g ? 1 : 0) << k;
        rest &= ~own;
        add_block(block, {x, y}, g, blending_pixels(pairs, own) & opaque);
      }
    }
  }
}

void GradientStrips::add_block(int block, glm::ivec2 at, int group, int taking_part) {
  const std::array<int, 4> offset = block_pixels(map_.lattice.stride());
  const auto has = [&](int k) { return (taking_part >> k & 1) != 0; };
  std::array<Rgba, 4> shades{};
  bool is_flat = true;
  for (int k = 0; k < 4; ++k) {
    if (!has(k)) continue;
    shades[k] = map_.shading.shades[block + offset[k]];
    is_flat = is_flat && shades[k] == map_.colours[block + offset[k]];
  }
  const std::array<Rgba, 4> own = shades;
  for (int k = 0; k < 4; ++k) {
    if (has(k)) continue;
    const int level = k ^ 1, upright = k ^ 2, across = k ^ 3;  // of the block's pixels, seen from this one
    shades[k] = has(level) && has(upright) ? mean(own[level], own[upright])
                : has(level)               ? own[level]
                : has(upright)             ? own[upright]
                                           : own[across];
  }
  if (is_flat && std::all_of(shades.begin(), shades.end(), [&](Rgba c) { return c == shades[0]; })) return;
  for (const int south : {0, 1}) {
    const int row = at.y - 1 + south, west = 2 * south;
    const bool is_odd = (row & 1) != 0;
    if (is_odd && !has(west) && !has(west + 1)) continue;  // what the even row shows
    pieces_.push_back(
        {is_odd, group, row, at.x, south != 0 ? kUpper : kLower, shades[west], shades[west + 1]});
  }
}

/// Halves that have the same colours become one strip.
void GradientStrips::join_halves() {
  const auto key = [](const Piece& p) { return std::tie(p.is_odd, p.group, p.row, p.x, p.part); };
  std::sort(pieces_.begin(), pieces_.end(), [&](const Piece& p, const Piece& q) { return key(p) < key(q); });
  std::size_t count = 0;
  for (const Piece& p : pieces_) {
    if (count > 0) {
      Piece& last = pieces_[count - 1];
      if (last.group == p.group && last.row == p.row && last.x == p.x && last.left == p.left &&
          last.right == p.right) {
        last.part = kWhole;
        continue;
      }
    }
    pieces_[count++] = p;
  }
  pieces_.resize(count);
}

std::span<const GradientStrips::Piece> GradientStrips::pieces_of(int group, bool is_odd) const {
  const std::pair wanted(is_odd, group);
  const auto key = [](const Piece& p) { return std::pair(p.is_odd, p.group); };
  const auto first =
      std::partition_point(pieces_.begin(), pieces_.end(), [&](const Piece& p) { return key(p) < wanted; });
  const auto last =
      std::partition_point(first, pieces_.end(), [&](const Piece& p) { return key(p) == wanted; });
  return {first, last};
}

void GradientStrips::append_definitions(std::string& out) const {
  const Lattice& lattice = map_.lattice;
  const std::string size = " width=\"" + std::to_string(lattice.width()) + "\" height=\"" +
                           std::to_string(lattice.height()) + "\"";
  out +=
      "<linearGradient id=\"fade\" gradientUnits=\"userSpaceOnUse\" x1=\"0\" x2=\"0\" y1=\".5\" y2=\"1.5\" "
      "spreadMethod=\"reflect\"><stop stop-color=\"#fff\" stop-opacity=\"0\"/><stop offset=\"1\" "
      "stop-color=\"#fff\"/></linearGradient>\n";
  out.append("<linearGradient id=\"").append(kUnitsName).append("\" gradientUnits=\"userSpaceOnUse\"/>\n");
  out.append("<mask id=\"").append(kMaskName).append("\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\"");
  out.append(size).append("><rect").append(size).append(" fill=\"url(#fade)\"/></mask>\n");
}

void GradientStrips::append(int group, bool is_odd, std::string& out) {
  std::map<std::uint32_t, std::vector<std::span<const Piece>>> even;  // by colour
  const std::span<const Piece> pieces = pieces_of(group, is_odd);
  for (std::size_t from = 0, to; from < pieces.size(); from = to) {
    const Piece& first = pieces[from];
    for (to = from + 1; to < pieces.size(); ++to) {
      const Piece& piece = pieces[to];
      if (piece.row != first.row || piece.part != first.part || piece.x != pieces[to - 1].x + 1) break;
    }
    const std::span<const Piece> run = pieces.subspan(from, to - from);
    const std::vector<Stop> stops = needed(stops_of(run));
    const Rgba colour = stops.front().colour;
    if (std::all_of(stops.begin(), stops.end(), [&](const Stop& s) { return s.colour == colour; })) {
      even[rgba_order(colour)].push_back(run);
    } else {
      append_gradient_run(run, gradient(stops, first.x, static_cast<int>(run.size())), out);
    }
  }
  for (const auto& [order, runs] : even) {
    out += "<path";
    append_svg_paint(out, "fill", runs.front().front().left);
    append_boxes(runs, out);
  }
}

std::vector<GradientStrips::Stop> GradientStrips::stops_of(std::span<const Piece> run) {
  std::vector<Stop> stops;
  for (const Piece& piece : run) {
    if (stops.empty() || stops.back().colour != piece.left) stops.push_back({piece.x, piece.left});
    stops.push_back({piece.x + 1, piece.right});
  }
  return stops;
}

void GradientStrips::append_gradient_run(std::span<const Piece> run, const std::string& gradient,
                                         std::string& out) {
  const auto [known, is_new] = gradients_.emplace(gradient, static_cast<int>(gradients_.size()));
  const std::string name = "s" + std::to_string(known->second);
  if (is_new) {
    out.append("<linearGradient id=\"").append(name).append("\"").append(gradient);
    out += "</linearGradient>\n";
  }
  out.append("<path fill=\"url(#").append(name).append(")\"");
  append_boxes(std::span(&run, 1), out);
}

/// Appends the rest of a path.
void GradientStrips::append_boxes(std::span<const std::span<const Piece>> runs, std::string& out) {
  out += " d=\"";
  SvgPathData path(out);
  for (const std::span<const Piece> run : runs) {
    const Piece& first = run.front();
    const int centre = first.row * kSubpixels + kSubpixels / 2;
    const int top = first.part == kLower ? centre - kOverlap : centre - kSubpixels;
    const int bottom = first.part == kUpper ? centre + kOverlap : centre + kSubpixels;
    const int left = first.x * kSubpixels - kSubpixels / 2;
    const int right = left + static_cast<int>(run.size()) * kSubpixels + kOverlap;
    path.move_to({left, top});
    path.line_to({right, top});
    path.line_to({right, bottom});
    path.line_to({left, bottom});
    path.close();
  }
  out += "\"/>\n";
}

}  // namespace depixel
