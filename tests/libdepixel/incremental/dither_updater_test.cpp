#include "libdepixel/incremental/dither_updater.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/random_sequences.hpp"

namespace depixel::test {
namespace {

RC_GTEST_PROP(DitherUpdater, BlendsAsFromScratch, (const Sequence& sequence)) {
  const bool linear_light = *rc::gen::arbitrary<bool>();
  DitherUpdater updater;
  Dithers scratch;
  for (const SequenceFrame& frame : sequence.frames) {
    if (frame.is_reset) updater.reset();
    const FrameView actual = updater.update(frame.picture.view(), linear_light, {});
    blend_dithers(frame.picture.view(), linear_light, scratch);
    const FrameView expected = scratch.view();
    RC_ASSERT(actual.width == expected.width);
    RC_ASSERT(actual.height == expected.height);
    for (int y = 0; y < actual.height; ++y) {
      const std::uint8_t* row = actual.pixels + y * actual.pitch;
      RC_ASSERT(std::equal(row, row + 4 * actual.width, expected.pixels + y * expected.pitch));
    }
  }
}

}  // namespace
}  // namespace depixel::test
