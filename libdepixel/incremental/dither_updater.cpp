#include "libdepixel/incremental/dither_updater.hpp"

#include <algorithm>
#include <cstring>

namespace depixel {

FrameView DitherUpdater::update(const FrameView& frame, bool linear_light, RuleSet rules) {
  if (!is_known_ || dithers_.lattice != Lattice(frame.width, frame.height)) {
    blend_dithers(frame, linear_light, dithers_);
    is_known_ = true;
    return dithers_.view();
  }
  if (!take_changed_rows(frame)) return dithers_.view();
  const auto has_changed = [&](int y) { return is_row_changed_[y] != 0; };
  for (int y = 0; y + 1 < frame.height; ++y) {
    if (has_changed(y) || has_changed(y + 1)) find_checkers(y, dithers_);
  }
  areas_before_ = dithers_.areas;
  find_dithered_areas(dithers_);
  const bool has_pixels = rules.has(Rule::dithers_by_pixels), has_areas = rules.has(Rule::dithers_by_areas);
  for (int y = 0; y < frame.height; ++y) {
    const bool is_stale =
        (has_pixels && has_changed(y)) || (has_areas && (are_areas_changed(y - 1) || are_areas_changed(y)));
    if (is_stale) blend_row(y, linear_light, dithers_);
  }
  return dithers_.view();
}

/// \return whether any did.
bool DitherUpdater::take_changed_rows(const FrameView& frame) {
  is_row_changed_.resize(frame.height);
  for (int y = 0; y < frame.height; ++y) {
    const Rgba* known = dithers_.pixels.data() + dithers_.lattice.pixel(0, y);
    const bool is_changed =
        std::memcmp(frame.pixels + y * frame.pitch, known, sizeof(Rgba) * frame.width) != 0;
    if (is_changed) take_row(frame, y, dithers_);
    is_row_changed_[y] = is_changed ? 1 : 0;
  }
  return std::find(is_row_changed_.begin(), is_row_changed_.end(), 1) != is_row_changed_.end();
}

/// Whether a row of blocks has other dithered areas than before.
bool DitherUpdater::are_areas_changed(int y) const {
  const BitRows& now = dithers_.areas;
  return !std::equal(now.row(y), now.row(y) + now.words(), areas_before_.row(y));
}

}  // namespace depixel
