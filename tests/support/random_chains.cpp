#include "tests/support/random_chains.hpp"

#include <rapidcheck.h>

#include <cmath>

#include "libdepixel/svg/chain_simplifier.hpp"

namespace depixel::test {

Chain random_chain() {
  const int count = *rc::gen::inRange(3, 24);
  const double wave = *rc::gen::inRange(1, 6), depth = *rc::gen::inRange(0, 40) / 100.0;
  std::vector<glm::dvec2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = i * 6.28318 / count, radius = count / 6.28 * (1 + depth * std::sin(wave * angle));
    points.push_back(double(kSubpixels) *
                     glm::dvec2(9.3 + radius * std::cos(angle), 8.4 + radius * std::sin(angle)));
  }
  const auto at = [&](int i) { return points[(i + count) % count]; };
  const auto rounded = [](glm::dvec2 p) {
    return glm::ivec2(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)));
  };
  Chain chain;
  chain.is_closed = *rc::gen::arbitrary<bool>();
  if (!chain.is_closed) chain.is_free = {*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
  chain.weight = *rc::gen::inRange(1, CurveCost::kWeights + 1);
  const int curves = chain.is_closed ? count : *rc::gen::inRange(1, count);
  for (int i = 0; i < curves; ++i) {
    chain.curves.push_back({rounded(at(i)), rounded(at(i) + (at(i + 1) - at(i - 1)) / 6.0),
                            rounded(at(i + 1) - (at(i + 2) - at(i)) / 6.0), rounded(at(i + 1))});
  }
  return chain;
}

ChainPose random_pose() {
  const auto pick = [] { return *rc::gen::arbitrary<bool>(); };
  const auto whole_pixels = [] { return *rc::gen::inRange(-50, 50) * kSubpixels; };
  return {pick(), {pick() ? -1 : 1, pick() ? -1 : 1}, pick(), 0, {whole_pixels(), whole_pixels()}};
}

}  // namespace depixel::test
