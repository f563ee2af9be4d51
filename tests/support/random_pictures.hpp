#pragma once

#include <rapidcheck.h>

#include "libdepixel/core/options.hpp"
#include "tests/support/ascii_picture.hpp"

namespace depixel {

/// Prints options as RapidCheck shows them: like a command line.
void showValue(const Options& options, std::ostream& out);

namespace test {

/// A number from..end - 1, all of them equally often in each run of a property.
rc::Gen<int> random_int(int from, int end);

/// What a random picture may be made of.
struct RandomPictureLimits {
  int max_size = 20;                         ///< pixels a side
  std::string_view colours = ".#rgb4567_R";  ///< palette characters
};

/// A picture of a few colours: a background on which spots, lines, rectangles, checkerboards, dithers, noise
/// and sprites are painted one after the other. Shrinks by painting less, smaller and with fewer colours.
rc::Gen<Picture> random_picture(const RandomPictureLimits& limits = {});

/// All combinations of spline and smoothing, with exact similarity and the default votes.
rc::Gen<Options> random_lossless_options();

/// Any options at all, threads included.
rc::Gen<Options> random_options();
rc::Gen<BorderKind> random_border();

}  // namespace test
}  // namespace depixel

namespace rc {

template <>
struct Arbitrary<depixel::test::Picture> {
  static Gen<depixel::test::Picture> arbitrary() { return depixel::test::random_picture(); }
};

}  // namespace rc
