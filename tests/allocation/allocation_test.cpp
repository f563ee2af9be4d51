#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

#include "libdepixel/incremental/line_tiles_updater.hpp"
#include "libdepixel/incremental/picture_updater.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/ascii_picture.hpp"

namespace {

std::atomic<long> allocations{0};
/// From this one on, allocations fail.
std::atomic<long> first_refused{std::numeric_limits<long>::max()};

void count_allocation() {
  if (++allocations >= first_refused) throw std::bad_alloc();
}

void* allocate(std::size_t size) {
  count_allocation();
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}

void* allocate_aligned(std::size_t size, std::align_val_t alignment) {
  count_allocation();
  const auto unit = static_cast<std::size_t>(alignment);
  if (void* p = std::aligned_alloc(unit, (size + unit - 1) / unit * unit)) return p;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate_aligned(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocate_aligned(size, alignment);
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete[](void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}

namespace depixel::test {
namespace {

/// Two frames of one size that are turned into pictures in turn: noise, rings and a dither on the one, the
/// same upside down on the other, so that both need buffers as large.
std::array<Picture, 2> frames() {
  Picture picture(96, 64, palette_colour('.'));
  std::uint32_t state = 7;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      state = state * 1664525 + 1013904223;
      const int dx = x - 40, dy = y - 30, ring = (dx * dx + dy * dy) / 120 % 4;
      const char in_ring = x > 80 ? ".r"[(x + y) % 2] : "_#b5"[ring];  // or in a dither
      picture.at(x, y) = palette_colour(x < 24 ? ".#rg"[state >> 30] : in_ring);
    }
  }
  return {picture, Symmetry{false, 2}(picture)};
}

class Allocation : public testing::TestWithParam<Options> {};

TEST_P(Allocation, NoneAFrameWhenWarm) {
  const Options& options = GetParam();
  const std::array<Picture, 2> pictures = frames();
  Picture out(3 * pictures[0].width, 3 * pictures[0].height);
  Vectorizer vectorizer;
  CpuRaster raster;
  for (int frame = 0; frame < 6; ++frame) {
    const long before = allocations;
    const PlanarMap& map = vectorizer.vectorize(pictures[frame % 2].view(), options);
    const long vectorized = allocations;
    raster.draw(map, View::fit(map.lattice, out.width, out.height), options.linear_light, 1, out.target());
    const long drawn = allocations;
    if (frame == 0) {
      EXPECT_GT(vectorized, before) << "nothing is counted";
    }
    if (frame < 2) continue;
    EXPECT_EQ(vectorized - before, 0) << "vectorizing frame " << frame;
    EXPECT_EQ(drawn - vectorized, 0) << "drawing frame " << frame;
  }
}

/// Four frames that come again and again: a scene in which something moved, then something changed.
std::array<Picture, 4> recurring_frames() {
  const Picture scene = frames()[0];
  Picture moved(scene.width, scene.height, palette_colour('.'));
  paste(moved, scene, 3, 1);
  Picture changed = moved;
  paste(changed, Picture(5, 4, palette_colour('y')), 50, 20);
  return {scene, moved, changed, scene};
}

TEST_P(Allocation, NoneAnIncrementalFrameWhenWarm) {
  const Options& options = GetParam();
  const std::array<Picture, 4> pictures = recurring_frames();
  for (const double scale : {3.0, 2.5}) {
    Picture out(static_cast<int>(scale * pictures[0].width), static_cast<int>(scale * pictures[0].height));
    const View view{scale, scale, 0, 0};
    IncrementalVectorizer vectorizer;
    PictureUpdater updater;
    MapChanges changes;
    constexpr int kWarmUp = 3;
    std::int64_t moved_pixels = 0;
    for (int frame = 0; frame < 4 * (kWarmUp + 2); ++frame) {
      const long before = allocations;
      vectorizer.vectorize(pictures[frame % 4].view(), options);
      changes.add(vectorizer.changes());
      const long vectorized = allocations;
      updater.draw(vectorizer, changes, view, options.linear_light, 1, out.target(), true);
      changes.set_nothing();
      const long drawn = allocations;
      moved_pixels += updater.moved_pixels();
      if (frame < 4 * kWarmUp) continue;
      EXPECT_EQ(vectorized - before, 0) << "vectorizing frame " << frame;
      EXPECT_EQ(drawn - vectorized, 0) << "drawing frame " << frame;
    }
    EXPECT_EQ(moved_pixels > 0, scale == 3.0);
  }
}

TEST(Allocation, NoneAnUpdateOfTilesWhenWarm) {
  constexpr int kWarm = 60, kFrames = 120;
  Picture picture = frames()[0];
  IncrementalVectorizer vectorizer;
  LineTilesUpdater updater;
  int partial = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    paste(picture, Picture(9, 9, palette_colour("#b"[frame % 2])), frame % 6 * 10, frame % 5 * 9);
    vectorizer.vectorize(picture.view(), {});
    vectorizer.map();
    const long before = allocations;
    updater.update(vectorizer, vectorizer.changes(), {4, 4}, TileEncoding::levels);
    const long updated = allocations;
    if (frame < kWarm) continue;
    EXPECT_EQ(updated - before, 0) << "updating for frame " << frame;
    partial += updater.is_all_new() ? 0 : 1;
  }
  EXPECT_GT(partial, (kFrames - kWarm) / 2);
}

/// Calls work(), in which all allocations but the first few fail. \return whether it ended well.
template <typename Work>
bool ends_well_with(long few, Work&& work) {
  first_refused = allocations + few + 1;
  bool is_done = false;
  try {
    work();
    is_done = true;
  } catch (const std::bad_alloc&) {
    // As was to be tried.
  }
  first_refused = std::numeric_limits<long>::max();
  return is_done;
}

TEST_P(Allocation, AFailedOneLeavesNoTrace) {
  const Options& options = GetParam();
  const Picture first = frames()[0];
  Picture larger(first.width + 30, first.height + 20, palette_colour('b'));
  paste(larger, frames()[1], 20, 10);
  Picture changed = larger;
  paste(changed, Picture(7, 5, palette_colour('y')), 60, 30);
  for (const double scale : {3.0, 4.0}) {
    const View view{scale, scale, 0, 0};
    const auto picture_of_size = [&] {
      return Picture(int(scale) * larger.width, int(scale) * larger.height);
    };
    Picture expected = picture_of_size(), out = expected;
    const auto expect_as_from_scratch = [&](const Picture& frame) {
      Vectorizer scratch;
      CpuRaster().draw(scratch.vectorize(frame.view(), options), view, options.linear_light, 1,
                       expected.target());
      EXPECT_TRUE(out == expected);
    };
    bool is_done = false;
    for (long few = 0; !is_done; few += 1 + few / 4) {
      IncrementalVectorizer vectorizer;
      PictureUpdater updater;
      MapChanges changes;
      const auto show = [&](const Picture& frame) {
        vectorizer.vectorize(frame.view(), options);
        changes.add(vectorizer.changes());
        updater.draw(vectorizer, changes, view, options.linear_light, 1, out.target(), true);
        changes.set_nothing();
      };
      show(first);
      is_done = ends_well_with(few, [&] {
        show(larger);
        show(changed);
        show(larger);
      });
      show(changed);
      expect_as_from_scratch(changed);
      show(larger);
      expect_as_from_scratch(larger);
      ASSERT_FALSE(HasFailure()) << "after " << few << " allocations";
    }
  }
}

std::vector<Options> exact_options() {
  std::vector<Options> list;
  for (const SplineKind spline : {SplineKind::adaptive, SplineKind::approximate, SplineKind::interpolate}) {
    for (const Smoothing smoothing : {Smoothing::energy, Smoothing::average, Smoothing::none}) {
      Options options;
      options.spline = spline;
      options.smoothing = smoothing;
      options.linear_light = smoothing == Smoothing::average;
      list.push_back(options);
    }
  }
  list.push_back({.dither = DitherKind::blend});
  return list;
}

INSTANTIATE_TEST_SUITE_P(ExactSimilarity, Allocation, testing::ValuesIn(exact_options()));

}  // namespace
}  // namespace depixel::test
