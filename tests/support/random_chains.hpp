#pragma once

#include "libdepixel/svg/chain_pose.hpp"

namespace depixel::test {

/// A smooth closed wave, or a part of one, of curves about a pixel long; drawn from RapidCheck.
Chain random_chain();
/// Any way to look at an open chain.
ChainPose random_pose();

}  // namespace depixel::test
