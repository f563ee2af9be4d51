#include "apps/common/clip.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "tests/apps/pictures.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {
namespace {

constexpr int kSide = 4;

std::string y4m_of(int frames) {
  std::string stream = "YUV4MPEG2 W4 H4 F50:1 A8:7 Cmono XCOLORRANGE=FULL\n";
  for (int i = 0; i < frames; ++i) stream += "FRAME\n" + std::string(kSide * kSide, static_cast<char>(i));
  return stream;
}

/// Pictures, a GIF and a stream in a row: a0, a1, b (2 frames), c (5 frames).
class MixedClip : public testing::Test {
 protected:
  void SetUp() override {
    for (int i = 0; i < 2; ++i)
      write_text(path("a" + std::to_string(i) + ".png"), png_of(sample_picture(kSide, kSide + i)));
    write_text(path("b.gif"), gif_of({sample_picture(6, 5), sample_picture(6, 5)}));
    write_text(path("c.y4m"), y4m_of(5));
  }

  std::string path(const std::string& name) const { return folder_ / name; }
  std::unique_ptr<Clip> open(std::size_t budget) const {
    auto clip = Clip::open({{path("a0.png"), path("a1.png"), path("b.gif"), path("c.y4m")}, true}, budget);
    if (!clip) throw std::runtime_error(clip.error().message);
    return std::move(*clip);
  }
  static std::string name_of(Clip& clip, int index) { return clip.frame(index).value()->name; }

  TemporaryFolder folder_;
};

TEST_F(MixedClip, CountsAndNamesItsFrames) {
  const auto clip = open(Clip::kBudgetBytes);
  EXPECT_EQ(clip->frame_count(), 9);
  EXPECT_EQ(name_of(*clip, 1), "a1");
  EXPECT_EQ(name_of(*clip, 3), "b_0001");
  EXPECT_EQ(name_of(*clip, 8), "c_0004");
  EXPECT_DOUBLE_EQ(clip->frame(8).value()->seconds, 1.0 / 50);
  EXPECT_DOUBLE_EQ(clip->pixel_aspect().value(), 8.0 / 7);
  EXPECT_TRUE(clip->has_frame(8));
  EXPECT_FALSE(clip->has_frame(9));
  EXPECT_FALSE(clip->has_frame(-1));
}

TEST_F(MixedClip, SeeksAsIfReadInOrder) {
  const auto in_order = open(Clip::kBudgetBytes);
  std::vector<std::shared_ptr<const ClipFrame>> expected(9);
  for (int i = 0; i < 9; ++i) expected[i] = in_order->frame(i).value();
  for (const std::size_t budget : {std::size_t{0}, std::size_t{200}, Clip::kBudgetBytes}) {
    const auto clip = open(budget);
    for (const int index : {8, 0, 5, 4, 7, 2, 3, 2, 8, 1, 6, 6, 0}) {
      const auto frame = clip->frame(index).value();
      EXPECT_EQ(frame->name, expected[index]->name);
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) EXPECT_EQ(frame->picture.at(x, y), expected[index]->picture.at(x, y));
      }
    }
  }
}

TEST_F(MixedClip, TellsOfDamage) {
  write_text(path("a1.png"), "damaged");
  const auto clip = open(Clip::kBudgetBytes);
  EXPECT_TRUE(clip->frame(0));
  const auto damaged = clip->frame(1);
  ASSERT_FALSE(damaged);
  EXPECT_NE(damaged.error().message.find("a1.png"), std::string::npos);
  EXPECT_TRUE(clip->frame(2));
  EXPECT_FALSE(Clip::open({{path("absent.png")}, false}));
  EXPECT_FALSE(Clip::open({{path("a0.png"), "-"}, true}));
}

/// Puts a pipe in the place of standard input for as long as it lives.
class PipedInput {
 public:
  PipedInput() : saved_(::dup(STDIN_FILENO)) {
    if (::pipe2(ends_, O_CLOEXEC) != 0) throw std::runtime_error("pipe");
    ::dup2(ends_[0], STDIN_FILENO);
    std::clearerr(stdin);
  }
  ~PipedInput() {
    close();
    ::close(ends_[0]);
    ::dup2(saved_, STDIN_FILENO);
    ::close(saved_);
  }
  void write(std::string_view bytes) const {
    ASSERT_EQ(::write(ends_[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  void close() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  int ends_[2] = {-1, -1};
  int saved_;
};

template <typename Condition>
bool comes_true(Condition condition) {
  for (int i = 0; i < 5000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

TEST(StreamClip, HasFramesAsTheyCome) {
  PipedInput input;
  const auto clip = Clip::open({{"-"}, false}).value();
  EXPECT_FALSE(clip->has_frame(0));
  EXPECT_FALSE(clip->frame_count());
  const std::string stream = y4m_of(3);
  const std::size_t two = stream.rfind("FRAME") + 3;
  input.write(stream.substr(0, two));
  ASSERT_TRUE(comes_true([&] { return clip->has_frame(1); }));
  EXPECT_FALSE(clip->has_frame(2));
  EXPECT_EQ(clip->frame(1).value()->picture.at(0, 0).r, 1);
  EXPECT_EQ(clip->frame(1).value()->name, "stdin_0001");
  input.write(stream.substr(two));
  input.close();
  ASSERT_TRUE(comes_true([&] { return clip->frame_count().has_value(); }));
  EXPECT_EQ(clip->frame_count(), 3);
  EXPECT_EQ(clip->frame(2).value()->picture.at(3, 3).r, 2);
}

TEST(StreamClip, KeepsTheNewestFramesOfItsBudget) {
  PipedInput input;
  constexpr std::size_t kFrameBytes = 4 * kSide * kSide;
  const auto clip = Clip::open({{"-"}, false}, 3 * kFrameBytes).value();
  input.write(y4m_of(60));
  input.close();
  for (int i = 0; i < 60; ++i) {
    ASSERT_TRUE(comes_true([&] { return clip->has_frame(i); })) << i;
    EXPECT_EQ(clip->frame(i).value()->picture.at(0, 0).r, i);
  }
  ASSERT_TRUE(comes_true([&] { return clip->frame_count() == 60; }));
}

TEST(StreamClip, TellsOfDamageAfterTheLastFrame) {
  PipedInput input;
  const auto clip = Clip::open({{"-"}, false}).value();
  const std::string stream = y4m_of(2);
  input.write(stream.substr(0, stream.size() - 1));
  input.close();
  ASSERT_TRUE(comes_true([&] { return clip->has_frame(1); }));
  EXPECT_TRUE(clip->frame(0));
  const auto cut = clip->frame(1);
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().message, "Standard input is cut short.");
}

}  // namespace
}  // namespace depixel::test
