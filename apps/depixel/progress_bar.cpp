#include "apps/depixel/progress_bar.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

namespace depixel {
namespace {

constexpr std::chrono::milliseconds kPatience{500}, kBetween{100};
constexpr int kWidth = 40;

}  // namespace

ProgressBar::ProgressBar(bool wanted)
    : wanted_(wanted && ::isatty(STDERR_FILENO) == 1), next_(Clock::now() + kPatience) {}

ProgressBar::~ProgressBar() {
  if (shown_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::show(double part) {
  if (!wanted_ || Clock::now() < next_) return;
  next_ = Clock::now() + kBetween;
  shown_ = true;
  const int filled = static_cast<int>(part * kWidth);
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {:3.0f} %", "", filled, "", kWidth - filled, part * 100);
  std::fflush(stderr);
}

}  // namespace depixel
