#include "libdepixel/svg/svg_shading.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <map>
#include <span>
#include <string_view>

#include "libdepixel/svg/gradient_strips.hpp"
#include "libdepixel/svg/soft_groups.hpp"
#include "libdepixel/svg/svg_document.hpp"

namespace depixel {
namespace {

/// A disc is opaque in its middle and fades out, three pixels wide, so that little of it reaches the next
/// centres.
struct FadingStop {
  std::string_view offset, opacity;
};
constexpr std::array<FadingStop, 4> kFading{{{"0", "1"}, {".33", ".6"}, {".67", ".12"}, {"1", "0"}}};
/// In pixels: as soft as the mixture between two centres is.
constexpr std::string_view kDeviation = ".35";

std::string colour_name(Rgba colour) {
  std::string name;
  append_svg_paint(name, "", colour);
  const std::size_t from = name.find('#') + 1;
  return name.substr(from, name.find('"', from) - from);
}

class ShadingWriter {
 public:
  ShadingWriter(const PlanarMap& map, const Components& components, const ComponentPath& append_path,
                std::string& out)
      : map_(map), append_path_(append_path), label_(components.label), out_(out) {
    const std::vector<int> group = find_soft_groups(map, components);
    members_.resize(components.count);
    for (int c = 0; c < components.count; ++c) members_[group[c]].push_back(c);
    group_.assign(label_.size(), kNone);
    for (std::size_t i = 0; i < label_.size(); ++i) {
      if (label_[i] >= 0) group_[i] = group[label_[i]];
    }
    seen_in_.assign(label_.size(), kNone);
  }

  void write() {
    out_ += "<g id=\"shading\">\n";
    map_.shading.kind == ShadingKind::gradient ? write_gradients() : write_pixels();
    out_ += "</g>\n";
  }

 private:
  static constexpr int kNone = -1;

  struct Pixel {
    int group;    ///< in which it is seen
    bool is_own;  ///< it lies there, not beyond a soft contour
    int index;

    friend auto operator<=>(const Pixel&, const Pixel&) = default;
  };

  /// Groups' even rows, then, under one mask, their odd rows.
  void write_gradients() {
    GradientStrips strips(map_, group_);
    out_ += "<defs>\n";
    strips.append_definitions(out_);
    for (const int group : strips.groups()) define_clip(group);
    out_ += "</defs>\n";
    for (const bool is_odd : {false, true}) {
      out_ += "<g";
      if (is_odd) out_.append(" mask=\"url(#").append(GradientStrips::kMaskName).append(")\"");
      out_ += ">\n";
      for (const int group : strips.groups()) {
        std::string drawn;
        strips.append(group, is_odd, drawn);
        if (drawn.empty()) continue;
        start_clipped(group);
        out_.append(">\n").append(drawn).append("</g>\n");
      }
      out_ += "</g>\n";
    }
  }

  void write_pixels() {
    const bool are_discs = map_.shading.kind == ShadingKind::discs;
    find_own();
    find_beyond();
    std::sort(pixels_.begin(), pixels_.end());
    pixels_.erase(std::unique(pixels_.begin(), pixels_.end()), pixels_.end());
    out_ += "<defs>\n";
    are_discs ? define_discs() : define_blur();
    out_ += "</defs>\n";
    for (auto from = pixels_.begin(); from != pixels_.end();) {
      const auto to =
          std::find_if(from, pixels_.end(), [&](const Pixel& p) { return p.group != from->group; });
      define_clip(from->group);
      are_discs ? put_discs({from, to}) : put_blurred({from, to});
      out_ += "</g>\n";
      from = to;
    }
  }

  void find_own() {
    const Lattice& lattice = map_.lattice;
    for (int y = 0; y < lattice.height(); ++y) {
      for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i) {
        if (map_.colours[i].a != 255 || !map_.shading.is_shaded(i, lattice.stride())) continue;
        pixels_.push_back({group_[i], true, i});
      }
    }
  }

  /// Pixels on the other sides of soft contours.
  void find_beyond() {
    for_each_pixel_pair(map_.lattice, [&](int block, const PixelPair& pair, int a, int b) {
      if ((map_.shading.blocks[block] & pair.bit) == 0) return;
      if (group_[a] == group_[b] || map_.colours[a].a != 255) return;
      pixels_.push_back({group_[a], false, b});
      pixels_.push_back({group_[b], false, a});
    });
  }

  Rgba shade(const Pixel& pixel) const { return map_.shading.shades[pixel.index]; }

  void define_discs() {
    std::map<std::uint32_t, Rgba> colours;
    for (const Pixel& pixel : pixels_) colours.emplace(rgba_order(shade(pixel)), shade(pixel));
    for (const auto& [order, colour] : colours) {
      const std::string name = colour_name(colour);
      out_.append("<radialGradient id=\"g").append(name).append("\">");
      for (const FadingStop& stop : kFading) {
        out_.append("<stop offset=\"").append(stop.offset).append("\" stop-opacity=\"").append(stop.opacity);
        out_.append("\" stop-color=\"#").append(name).append("\"/>");
      }
      out_.append("</radialGradient>\n<circle id=\"d").append(name);
      out_.append("\" cx=\".5\" cy=\".5\" r=\"1.5\" fill=\"url(#g").append(name).append(")\"/>\n");
    }
  }

  void define_blur() {
    out_ +=
        "<filter id=\"blur\" x=\"-1\" y=\"-1\" width=\"3\" height=\"3\" "
        "color-interpolation-filters=\"sRGB\">";
    out_.append("<feGaussianBlur stdDeviation=\"").append(kDeviation).append("\"/></filter>\n");
  }

  void define_clip(int group) {
    out_.append("<clipPath id=\"c").append(std::to_string(group)).append("\"><path d=\"");
    SvgPathData path(out_, append_path_.grid);
    for (const int component : members_[group]) append_path_.append(component, path);
    out_ += "\"/></clipPath>\n";
  }

  void start_clipped(int group) {
    out_.append("<g clip-path=\"url(#c").append(std::to_string(group)).append(")\"");
  }

  /// On squares of the same colours, for discs let something through.
  void put_discs(std::span<const Pixel> pixels) {
    start_clipped(pixels.front().group);
    out_ += ">\n";
    put_squares(pixels, 0);
    for (const Pixel& pixel : pixels) {
      const glm::ivec2 at = map_.lattice.pixel_position(pixel.index);
      out_.append("<use xlink:href=\"#d").append(colour_name(shade(pixel))).append("\" x=\"");
      out_.append(std::to_string(at.x)).append("\" y=\"").append(std::to_string(at.y)).append("\"/>\n");
    }
  }

  /// What lies beyond a sharp contour takes part in the blur, and is what is nearest inside.
  void put_blurred(std::span<const Pixel> pixels) {
    start_clipped(pixels.front().group);
    out_ += " filter=\"url(#blur)\">\n";
    put_squares(edge_pixels(pixels), 1);
    put_squares(pixels, 0);
  }

  /// Those of a group's own pixels beside which there is one that the group does not see.
  std::vector<Pixel> edge_pixels(std::span<const Pixel> pixels) {
    for (const Pixel& pixel : pixels) seen_in_[pixel.index] = pixel.group;
    std::vector<Pixel> edge;
    const int stride = map_.lattice.stride();
    for (const Pixel& pixel : pixels) {
      const auto is_unseen = [&](int i) { return seen_in_[i] != pixel.group; };
      bool is_edge = false;
      for (const int row : {pixel.index - stride, pixel.index, pixel.index + stride}) {
        is_edge = is_edge || is_unseen(row - 1) || is_unseen(row) || is_unseen(row + 1);
      }
      if (pixel.is_own && is_edge) edge.push_back(pixel);
    }
    return edge;
  }

  /// Rows of squares of one colour are thick lines. \param margin  in pixels, round each square.
  void put_squares(std::span<const Pixel> pixels, int margin) {
    std::map<std::uint32_t, std::vector<int>> by_colour;
    for (const Pixel& pixel : pixels) by_colour[rgba_order(shade(pixel))].push_back(pixel.index);
    if (by_colour.empty()) return;
    out_.append("<g stroke-width=\"").append(std::to_string(1 + 2 * margin)).append("\">\n");
    for (auto& [order, same] : by_colour) {
      std::sort(same.begin(), same.end());
      out_ += "<path";
      append_svg_paint(out_, "stroke", map_.shading.shades[same.front()]);
      out_ += " d=\"";
      SvgPathData path(out_);
      for (std::size_t i = 0; i < same.size();) {
        const std::size_t first = i++;
        while (i < same.size() && same[i] == same[i - 1] + 1) ++i;
        const glm::ivec2 from = map_.lattice.pixel_position(same[first]) * kSubpixels;
        const int length = static_cast<int>(i - first) + margin;
        path.move_to(from + glm::ivec2(-margin * kSubpixels, kSubpixels / 2));
        path.line_to(from + glm::ivec2(length * kSubpixels, kSubpixels / 2));
      }
      path.end();
      out_ += "\"/>\n";
    }
    out_ += "</g>\n";
  }

  const PlanarMap& map_;
  const ComponentPath& append_path_;
  const std::vector<int>& label_;
  std::vector<std::vector<int>> members_;  ///< the components of each group
  std::vector<int> group_;                 ///< of each pixel
  std::vector<int> seen_in_;               ///< a group that sees a pixel
  std::vector<Pixel> pixels_;
  std::string& out_;
};

}  // namespace

void append_svg_shading(const PlanarMap& map, const Components& components, const ComponentPath& append_path,
                        std::string& out) {
  if (map.shading.any) ShadingWriter(map, components, append_path, out).write();
}

}  // namespace depixel
