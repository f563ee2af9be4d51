#include "libdepixel/svg/svg_shading.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <map>
#include <span>
#include <string_view>

#include "libdepixel/svg/svg_document.hpp"

namespace depixel {
namespace {

/// A disc is opaque in its middle and fades out, three pixels wide, so that little of it reaches the next
/// centres.
struct Stop {
  std::string_view offset, opacity;
};
constexpr std::array<Stop, 4> kFading{{{"0", "1"}, {".33", ".6"}, {".67", ".12"}, {"1", "0"}}};
/// In pixels: as soft as the mixture between two centres is.
constexpr std::string_view kDeviation = ".45";

std::string colour_name(Rgba colour) {
  std::string name;
  append_svg_paint(name, "", colour);
  const std::size_t from = name.find('#') + 1;
  return name.substr(from, name.find('"', from) - from);
}

class ShadingWriter {
 public:
  ShadingWriter(const PlanarMap& map, const Components& components, const std::vector<std::string>& path_data,
                std::string& out)
      : map_(map), path_data_(path_data), label_(components.label), out_(out) {}

  void write() {
    find_own();
    find_beyond();
    if (pixels_.empty()) return;
    std::sort(pixels_.begin(), pixels_.end());
    pixels_.erase(std::unique(pixels_.begin(), pixels_.end()), pixels_.end());
    out_ += "<g id=\"shading\">\n<defs>\n";
    const bool is_gradient = map_.shading.kind == ShadingKind::gradient;
    is_gradient ? define_discs() : define_blur();
    out_ += "</defs>\n";
    for (auto from = pixels_.begin(); from != pixels_.end();) {
      const auto to =
          std::find_if(from, pixels_.end(), [&](const Pixel& p) { return p.component != from->component; });
      start_component(from->component);
      is_gradient ? put_discs({from, to}) : put_blurred({from, to});
      out_ += "</g>\n";
      from = to;
    }
    out_ += "</g>\n";
  }

 private:
  struct Pixel {
    int component;  ///< in which it is seen
    bool is_own;    ///< it lies there, not beyond a soft contour
    int index;

    friend auto operator<=>(const Pixel&, const Pixel&) = default;
  };

  void find_own() {
    const Lattice& lattice = map_.lattice;
    for (int y = 0; y < lattice.height(); ++y) {
      for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i) {
        if (map_.colours[i].a != 255 || !map_.shading.is_shaded(i, lattice.stride())) continue;
        pixels_.push_back({label_[i], true, i});
      }
    }
  }

  /// Pixels on the other sides of soft contours.
  void find_beyond() {
    const Lattice& lattice = map_.lattice;
    const std::array<int, 4> offset = block_pixels(lattice.stride());
    for (int y = 0; y <= lattice.height(); ++y) {
      for (int block = lattice.corner(0, y), end = block + lattice.width(); block <= end; ++block) {
        for (const PixelPair& pair : kPixelPairs) {
          if ((map_.shading.blocks[block] & pair.bit) == 0) continue;
          const int a = block + offset[pair.a], b = block + offset[pair.b];
          if (label_[a] == label_[b] || map_.colours[a].a != 255) continue;
          pixels_.push_back({label_[a], false, b});
          pixels_.push_back({label_[b], false, a});
        }
      }
    }
  }

  Rgba shade(const Pixel& pixel) const { return map_.shading.shades[pixel.index]; }

  void define_discs() {
    std::map<std::uint32_t, Rgba> colours;
    for (const Pixel& pixel : pixels_) colours.emplace(rgba_order(shade(pixel)), shade(pixel));
    for (const auto& [order, colour] : colours) {
      const std::string name = colour_name(colour);
      out_.append("<radialGradient id=\"g").append(name).append("\">");
      for (const Stop& stop : kFading) {
        out_.append("<stop offset=\"").append(stop.offset).append("\" stop-opacity=\"").append(stop.opacity);
        out_.append("\" stop-color=\"#").append(name).append("\"/>");
      }
      out_.append("</radialGradient>\n<circle id=\"d")
          .append(name)
          .append("\" cx=\".5\" cy=\".5\" r=\"1.5\" fill=\"url(#g");
      out_.append(name).append(")\"/>\n");
    }
  }

  void define_blur() {
    out_ +=
        "<filter id=\"blur\" x=\"-1\" y=\"-1\" width=\"3\" height=\"3\" "
        "color-interpolation-filters=\"sRGB\">";
    out_.append("<feGaussianBlur stdDeviation=\"").append(kDeviation).append("\"/></filter>\n");
  }

  void start_component(int component) {
    const std::string name = std::to_string(component);
    out_.append("<clipPath id=\"c").append(name).append("\"><path clip-rule=\"evenodd\" d=\"");
    out_.append(path_data_[component])
        .append("\"/></clipPath>\n<g clip-path=\"url(#c")
        .append(name)
        .append(")\">\n");
  }

  /// On squares of the same colours, for discs let something through.
  void put_discs(std::span<const Pixel> pixels) {
    put_squares(pixels, 0);
    for (const Pixel& pixel : pixels) {
      const glm::ivec2 at = map_.lattice.pixel_position(pixel.index);
      out_.append("<use xlink:href=\"#d").append(colour_name(shade(pixel)));
      out_.append("\" x=\"")
          .append(std::to_string(at.x))
          .append("\" y=\"")
          .append(std::to_string(at.y))
          .append("\"/>\n");
    }
  }

  /// What lies beyond a sharp contour takes part in the blur, and is what is nearest inside.
  void put_blurred(std::span<const Pixel> pixels) {
    out_ += "<g filter=\"url(#blur)\">\n";
    const auto own = std::find_if(pixels.begin(), pixels.end(), [](const Pixel& p) { return p.is_own; });
    put_squares({own, pixels.end()}, 1);
    put_squares(pixels, 0);
    out_ += "</g>\n";
  }

  void put_squares(std::span<const Pixel> pixels, int margin) {
    std::map<std::uint32_t, std::vector<Pixel>> by_colour;
    for (const Pixel& pixel : pixels) by_colour[rgba_order(shade(pixel))].push_back(pixel);
    for (const auto& [order, same] : by_colour) {
      out_ += "<path";
      append_svg_paint(out_, "fill", shade(same.front()));
      out_ += " d=\"";
      for (std::size_t i = 0; i < same.size();) {
        const std::size_t first = i++;
        while (i < same.size() && same[i].index == same[i - 1].index + 1) ++i;
        put_run(same[first].index, static_cast<int>(i - first), margin);
      }
      out_ += "\"/>\n";
    }
  }

  void put_run(int first, int count, int margin) {
    const glm::ivec2 from = map_.lattice.pixel_position(first) - margin;
    const glm::ivec2 size = glm::ivec2(count, 1) + 2 * margin;
    SvgPathData path(out_);
    path.move_to(from * kSubpixels);
    path.line_to((from + glm::ivec2(size.x, 0)) * kSubpixels);
    path.line_to((from + size) * kSubpixels);
    path.line_to((from + glm::ivec2(0, size.y)) * kSubpixels);
    path.close();
  }

  const PlanarMap& map_;
  const std::vector<std::string>& path_data_;
  const std::vector<int>& label_;
  std::vector<Pixel> pixels_;
  std::string& out_;
};

}  // namespace

void append_svg_shading(const PlanarMap& map, const Components& components,
                        const std::vector<std::string>& path_data, std::string& out) {
  if (map.shading.any) ShadingWriter(map, components, path_data, out).write();
}

}  // namespace depixel
