#pragma once

#include <cstring>
#include <vector>

#include "libdepixel/raster/colour_model.hpp"
#include "libdepixel/raster/line_slices.hpp"
#include "libdepixel/raster/shade_field.hpp"
#include "libdepixel/raster/touched_groups.hpp"

namespace depixel {

/// How much of something regions cover; each is known by its colour on the map. What is transparent counts
/// for nothing.
class RegionMix {
 public:
  struct Part {
    Rgba region;
    int amount;
  };

  void clear() { parts_.clear(); }
  void add(Rgba region, int amount) {
    if (region.a == 0 || amount == 0) return;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (parts_[i].region != region) continue;
      parts_[i].amount += amount;
      if (parts_[i].amount == 0) {
        parts_[i] = parts_.back();
        parts_.pop_back();
      }
      return;
    }
    parts_.push_back({region, amount});
  }
  void add(const RegionMix& other, int factor) {
    for (const Part& part : other.parts_) add(part.region, part.amount * factor);
  }
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::vector<Part> parts_;  ///< no region twice, none with nothing
};

/// Like BandSums, for maps with shading: keeps for each pixel of a band of output rows which regions cover
/// how much of it, and gives each the colour that it has there. Where nothing is shaded, the pixels are those
/// of BandSums, bit for bit.
template <typename Model>
class RegionSums {
 public:
  static constexpr int kRows = kBandRows;

  struct Change {
    Rgba from, to;
  };
  static Change change(Rgba from, Rgba to) { return {from, to}; }

  /// What regions cover the left side of a row's pixel, of kRasterSubpixels.
  using Start = RegionMix;

  /// As those of BandSums.
  void resize(int width) {
    width_ = width;
    slicer_.resize(width);
    if (width <= capacity_) return;
    capacity_ = width;
    last_part_.assign(std::size_t{kRows} * stride(), kNone);
    touched_.resize(kRows, width);
  }
  void start(int first_row, int rows) {
    slicer_.start(first_row, rows);
    parts_.clear();
  }
  void shade_by(const ShadeField& field, int first_column) {
    field_ = &field;
    first_column_ = first_column;
  }

  void add_line(int x0, int y0, int x1, int y1, const Change& change) {
    slicer_.cut(x0, y0, x1, y1, [&](const LineSlicer::Slice& slice) {
      slice.for_each_pixel([&](int column, int height, int area) {
        int& last = last_part_[slice.row * stride() + column];
        parts_.push_back({change, height, area, last});
        last = static_cast<int>(parts_.size()) - 1;
        TouchedGroups::touch(touched_.row(slice.row), column);
      });
    });
  }

  static Start start_from(Rgba colour, int covered) {
    Start start;
    start.add(colour, covered);
    return start;
  }
  /// What is on a row's left where a colour is on its right.
  Start start_before(int row, Rgba colour, int covered) const {
    Start start = start_from(colour, covered);
    touched_.for_each(row, width_, [&](int first) {
      for (int x = first; x < first + kGroup; ++x) {
        for_each_part(row, x, [&](const Part& part) { pass(part, -1, start); });
      }
    });
    return start;
  }

  void resolve(int row, std::uint8_t* out) { resolve(row, out, Start{}, 0, width_); }

  void resolve(int row, std::uint8_t* out, const Start& before, int from, int to) {
    covering_ = before;
    int done = from;
    touched_.for_each(row, width_, [&](int first) {
      for (int x = first; x < first + kGroup; ++x) {
        int& last = last_part_[row * stride() + x];
        if (last == kNone) continue;
        fill(row, done, std::min(x, to), out);
        if (x >= from && x < to) {
          put(row, x, covered_pixel(row, x), out);
        }
        done = std::max(done, std::min(x + 1, to));
        for_each_part(row, x, [&](const Part& part) { pass(part, 1, covering_); });
        last = kNone;
      }
    });
    touched_.forget(row);
    fill(row, done, to, out);
  }

  std::size_t memory_bytes() const { return held_bytes(last_part_, parts_) + touched_.memory_bytes(); }

 private:
  static constexpr int kNone = -1;
  static constexpr int kGroup = TouchedGroups::kGroup;

  /// A line in a pixel.
  struct Part {
    Change change;
    int height, area;
    int before;  ///< another one in the same pixel, or kNone
  };

  std::size_t stride() const { return (static_cast<std::size_t>(capacity_) / kGroup + 1) * kGroup; }

  template <typename Visit>
  void for_each_part(int row, int column, Visit visit) const {
    for (int i = last_part_[row * stride() + column]; i != kNone; i = parts_[i].before) visit(parts_[i]);
  }

  /// Goes on to the right of a line.
  static void pass(const Part& part, int times, RegionMix& covering) {
    covering.add(part.change.to, times * part.height);
    covering.add(part.change.from, -times * part.height);
  }

  const RegionMix& covered_pixel(int row, int column) {
    pixel_.clear();
    pixel_.add(covering_, 2 * kRasterSubpixels);
    for_each_part(row, column, [&](const Part& part) {
      const int area = 2 * kRasterSubpixels * part.height - part.area;
      pixel_.add(part.change.to, area);
      pixel_.add(part.change.from, -area);
    });
    return pixel_;
  }

  /// \param mix  of kFullCoverage.
  void put(int row, int column, const RegionMix& mix, std::uint8_t* out) const {
    typename Model::Sums sums{};
    for (const RegionMix::Part& part : mix.parts()) {
      const Rgba colour = field_->at(first_column_ + column, slicer_.first_row() + row, part.region);
      sums += Model::times(Model::change(Rgba{}, colour), part.amount);
    }
    const Rgba colour = Model::decode(sums);
    std::memcpy(out + 4 * std::size_t(column), &colour, sizeof colour);
  }

  /// Pixels that no line touches.
  void fill(int row, int from, int to, std::uint8_t* out) {
    if (from >= to) return;
    if (covering_.parts().size() == 1 && covering_.parts()[0].amount == kRasterSubpixels) {
      field_->fill(slicer_.first_row() + row, first_column_ + from, first_column_ + to,
                   covering_.parts()[0].region, out - std::ptrdiff_t{4} * first_column_);
      return;
    }
    pixel_.clear();
    pixel_.add(covering_, 2 * kRasterSubpixels);
    for (int x = from; x < to; ++x) put(row, x, pixel_, out);
  }

  int width_ = 0, capacity_ = -1;
  LineSlicer slicer_;
  const ShadeField* field_ = nullptr;
  int first_column_ = 0;        ///< of the target, where rows begin
  std::vector<int> last_part_;  ///< by row and column
  std::vector<Part> parts_;
  TouchedGroups touched_;
  RegionMix covering_, pixel_;
};

}  // namespace depixel
