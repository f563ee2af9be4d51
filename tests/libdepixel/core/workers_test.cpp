#include "libdepixel/core/workers.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>

namespace depixel::test {
namespace {

TEST(Workers, DoEveryPartOnce) {
  Workers workers;
  for (const int threads : {1, 2, 3, 8}) {
    workers.set_threads(threads);
    EXPECT_EQ(workers.threads(), threads);
    for (const int parts : {0, 1, 2, 7, 100}) {
      std::vector<std::atomic<int>> done(parts);
      workers.run(parts, [&](int part, int) { ++done[part]; });
      for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
    }
  }
}

TEST(Workers, ThreadsHaveNumbersOfTheirOwn) {
  constexpr int kThreads = 4, kParts = 200;
  Workers workers;
  workers.set_threads(kThreads);
  std::vector<std::thread::id> ids(kParts);
  std::vector<int> numbers(kParts);
  std::array<int, kThreads> counts{};  // each written by its thread alone
  workers.run(kParts, [&](int part, int thread) {
    ids[part] = std::this_thread::get_id();
    numbers[part] = thread;
    ++counts[thread];
  });
  int sum = 0;
  for (const int count : counts) sum += count;
  EXPECT_EQ(sum, kParts);
  for (int a = 0; a < kParts; ++a) {
    EXPECT_GE(numbers[a], 0);
    EXPECT_LT(numbers[a], kThreads);
    EXPECT_EQ(ids[a] == ids[0], numbers[a] == numbers[0]);
  }
}

TEST(Workers, WhatWasDoneIsSeenWhenAllIsDone) {
  Workers workers;
  workers.set_threads(3);
  std::vector<int> values(64);
  for (int round = 1; round <= 200; ++round) {
    workers.run(64, [&](int part, int) { values[part] += part; });
    for (int part = 0; part < 64; ++part) ASSERT_EQ(values[part], round * part);
  }
}

TEST(Workers, WorkAtOnce) {
  // Two parts that wait for each other are done only if two threads take them.
  Workers workers;
  workers.set_threads(2);
  std::atomic<int> arrived{0};
  std::atomic<bool> met{true};
  workers.run(2, [&](int, int) {
    ++arrived;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (arrived < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    if (arrived < 2) met = false;
  });
  EXPECT_TRUE(met);
}

TEST(Workers, WaitForAHelperThatTakesLong) {
  for (int round = 0; round < 20; ++round) {
    Workers workers;
    workers.set_threads(3);
    std::atomic<int> arrived{0}, done{0};
    workers.run(3, [&](int, int thread) {
      ++arrived;
      while (arrived < 3) std::this_thread::yield();  // so that each takes one part
      if (thread != 0) std::this_thread::sleep_for(std::chrono::milliseconds(3));
      ++done;
    });
    EXPECT_EQ(done, 3);
  }
}

TEST(Workers, ThrowWhatAPartThrew) {
  for (const int threads : {1, 2, 4}) {
    Workers workers;
    workers.set_threads(threads);
    for (int thrower = 0; thrower < threads; ++thrower) {
      std::atomic<int> arrived{0}, running{0};
      const auto work = [&](int, int thread) {
        ++running;
        ++arrived;
        while (arrived < threads) std::this_thread::yield();
        --running;
        if (thread == thrower) throw std::runtime_error("a part failed");
      };
      EXPECT_THROW(workers.run(threads, work), std::runtime_error);
      EXPECT_EQ(running, 0);
      std::atomic<int> sum{0};
      workers.run(10, [&](int part, int) { sum += part; });
      EXPECT_EQ(sum, 45);
    }
  }
}

TEST(Workers, NumbersOfThreadsCanChangeBetweenJobs) {
  Workers workers;
  std::atomic<int> sum{0};
  for (int round = 0; round < 30; ++round) {
    workers.set_threads(round % 5);
    workers.run(10, [&](int, int thread) {
      EXPECT_LT(thread, workers.threads());
      ++sum;
    });
  }
  EXPECT_EQ(sum, 300);
}

TEST(Workers, FewerThanOneThreadIsOne) {
  Workers workers;
  for (const int threads : {0, -3}) {
    workers.set_threads(threads);
    EXPECT_EQ(workers.threads(), 1);
    int sum = 0;
    workers.run(5, [&](int part, int) { sum += part; });
    EXPECT_EQ(sum, 10);
  }
}

TEST(Workers, CanBeDroppedWithoutWork) {
  Workers idle;
  idle.set_threads(4);
  Workers used;
  used.set_threads(4);
  used.run(0, [](int, int) {});
}

}  // namespace
}  // namespace depixel::test
