#include "filter/host/gl_thread.hpp"

#include <gtest/gtest.h>

#include <new>
#include <thread>

#include "tests/filter/gl_fixture.hpp"
#include "tests/support/ascii_picture.hpp"

namespace depixel::test {
namespace {

TEST(GlThread, DrawsForAnyThreadAndLeavesItsContextAlone) {
  const GlContext hosts(ContextKind::osmesa);
  auto gl = GlThread::start();
  ASSERT_TRUE(gl) << gl.error().message;
  const Picture frame = ascii_picture({"#..r", ".rr.", ".#g#"});
  const auto draw = [&] {
    Picture picture(16, 12);
    bool is_drawn = false;
    (*gl)->run([&](FrameFilter& filter) {
      is_drawn =
          filter.submit(frame.view(), {}) && filter.draw(picture.target(), {0, 0, 16, 12}, {4, 4, 0, 0});
    });
    EXPECT_TRUE(is_drawn);
    return picture;
  };
  const Picture first = draw();
  Picture second;
  std::thread([&] { second = draw(); }).join();
  EXPECT_EQ(first, second);
  EXPECT_EQ(first.at(0, 0), (Rgba{0, 0, 0, 255}));
  EXPECT_NE(hosts.gl.GetString(GL_VERSION), nullptr);
}

TEST(GlThread, ThrowsWhatWorkThrew) {
  auto gl = GlThread::start();
  ASSERT_TRUE(gl) << gl.error().message;
  EXPECT_THROW((*gl)->run([](FrameFilter&) { throw std::bad_alloc(); }), std::bad_alloc);
  bool is_run = false;
  (*gl)->run([&](FrameFilter&) { is_run = true; });
  EXPECT_TRUE(is_run);
}

TEST(GlThread, StartsAndEndsManyTimes) {
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(GlThread::start());
}

}  // namespace
}  // namespace depixel::test
