#include "libdepixel/svg/chain_pose.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/random_chains.hpp"

namespace depixel::test {
namespace {

RC_GTEST_PROP(ChainPose, IsUndone, ()) {
  const Chain chain = random_chain();
  Chain posed;
  std::vector<Cubic> back;
  const ChainPose pose = random_pose();
  apply_pose(pose, chain, posed);
  undo_pose(pose, posed.curves, back);
  RC_ASSERT(back == chain.curves);
}

RC_GTEST_PROP(ChainPose, IsTheSameHoweverAChainLies, ()) {
  Chain chain = random_chain(), other, posed, other_posed;
  apply_pose(random_pose(), chain, other);
  const std::array<int, 1> start{0};
  apply_pose(find_pose(chain, start), chain, posed);
  apply_pose(find_pose(other, start), other, other_posed);
  RC_ASSERT(posed.curves == other_posed.curves);
  RC_ASSERT(posed.is_free == other_posed.is_free);
}

RC_GTEST_PROP(ChainPose, StartsInThePixelAtTheOrigin, ()) {
  const Chain chain = random_chain();
  const std::array<int, 1> start{0};
  Chain posed;
  apply_pose(find_pose(chain, start), chain, posed);
  const glm::ivec2 first = posed.curves.front().p0;
  RC_ASSERT(first.x >= 0 && first.y >= 0 && first.x < kSubpixels && first.y < kSubpixels);
}

}  // namespace
}  // namespace depixel::test
