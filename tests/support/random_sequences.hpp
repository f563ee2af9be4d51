#pragma once

#include <rapidcheck.h>

#include <iosfwd>
#include <vector>

#include "libdepixel/core/options.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {

/// A frame of a sequence and how it is to be vectorized.
struct SequenceFrame {
  Picture picture;
  Options options;
  bool is_reset = false;  ///< what is known of the frames before is to be forgotten first
};

/// Successive frames. Prints itself as the call that makes it, so that a failing case can be pasted into a
/// test.
struct Sequence {
  std::vector<SequenceFrame> frames;
};
std::ostream& operator<<(std::ostream& out, const Sequence& sequence);

/// What a random sequence may be made of.
struct RandomSequenceLimits {
  int max_width = 40, max_height = 32;  ///< pixels
  int steps = 0;                        ///< frames after the first; 0: any number up to about twenty
};

/// The frames of a small game: a background that scrolls with wrap, a layer before it that scrolls at its own
/// speed, rows that stand still, sprites, and a palette. Each step changes the scene in one way, as games and
/// their users do: sprites move by any vector, pixels and rectangles are painted, the palette is cycled or
/// faded, layers scroll, the scene is cut, the frame changes its size, options are flipped, or nothing
/// happens. Shrinks by leaving out steps.
rc::Gen<Sequence> random_sequence(const RandomSequenceLimits& limits = {});

/// The same sequence whenever it is asked for. \param seed  tells sequences apart.
Sequence fixed_sequence(unsigned seed, const RandomSequenceLimits& limits);

}  // namespace depixel::test

namespace rc {

template <>
struct Arbitrary<depixel::test::Sequence> {
  static Gen<depixel::test::Sequence> arbitrary() { return depixel::test::random_sequence(); }
};

}  // namespace rc
