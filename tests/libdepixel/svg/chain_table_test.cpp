#include "libdepixel/svg/chain_table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>

#include "tests/support/random_chains.hpp"

namespace depixel::test {
namespace {

constexpr SvgGrid kTableGrid = SvgGrid::within(kSvgTolerance);

std::vector<Cubic> simplified_by_table(const Chain& chain) {
  ChainTable table(kSvgTolerance, kTableGrid);
  std::vector<Cubic> curves;
  table.simplify(chain, curves);
  return curves;
}

/// How long each curve is from end to end, whatever their order.
std::vector<std::int64_t> chords(const std::vector<Cubic>& curves) {
  std::vector<std::int64_t> squares;
  for (const Cubic& c : curves) {
    const glm::i64vec2 chord(c.p3 - c.p0);
    squares.push_back(chord.x * chord.x + chord.y * chord.y);
  }
  std::sort(squares.begin(), squares.end());
  return squares;
}

/// Where a chain is symmetric itself, but not what it is simplified to, the curves may be the mirrored
/// ones.
RC_GTEST_PROP(ChainTable, ChainsAreSimplifiedAlikeHoweverTheyLie, ()) {
  const Chain chain = random_chain();
  Chain other;
  apply_pose(random_pose(), chain, other);
  RC_ASSERT(chords(simplified_by_table(other)) == chords(simplified_by_table(chain)));
}

RC_GTEST_PROP(ChainTable, RemembersWhatItWouldFind, ()) {
  ChainTable table(kSvgTolerance, kTableGrid);
  for (int i = 0; i < 5; ++i) {
    const Chain chain = random_chain();
    std::vector<Cubic> first, second;
    table.simplify(chain, first);
    table.simplify(chain, second);
    RC_ASSERT(first == simplified_by_table(chain));
    RC_ASSERT(second == first);
  }
}

}  // namespace
}  // namespace depixel::test
