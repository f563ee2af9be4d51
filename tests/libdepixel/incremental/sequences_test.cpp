// Frames of real games, in any order, as the incremental vectorizer and updater see them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "libdepixel/incremental/picture_updater.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

/// The folders of sequences: those that are shipped, and those in the folder that the environment names.
std::vector<std::filesystem::path> sequence_folders() {
  std::vector<std::filesystem::path> parents{data_folder() / "sequences"};
  if (const char* corpus = std::getenv("DEPIXEL_CORPUS")) parents.emplace_back(corpus);
  std::vector<std::filesystem::path> folders;
  for (const std::filesystem::path& parent : parents) {
    if (!std::filesystem::is_directory(parent)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(parent)) {
      if (entry.is_directory()) folders.push_back(entry.path());
    }
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

std::vector<Picture> frames_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Picture> frames(files.size());
  std::transform(files.begin(), files.end(), frames.begin(), load_picture);
  return frames;
}

/// Plays frames, some of them in other places of the order, and compares all that is made of them.
void expect_as_from_scratch(const std::vector<const Picture*>& frames) {
  constexpr int kScale = 4;
  IncrementalVectorizer vectorizer;
  Vectorizer scratch;
  PictureUpdater updater;
  CpuRaster raster;
  Picture kept, expected;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Picture& frame = *frames[i];
    if (kept.width != kScale * frame.width || kept.height != kScale * frame.height) {
      kept = expected = Picture(kScale * frame.width, kScale * frame.height);
    }
    const View view{kScale, kScale, 0, 0};
    vectorizer.vectorize(frame.view(), {});
    updater.draw(vectorizer, vectorizer.changes(), view, false, 1, kept.target(), true);
    raster.draw(scratch.vectorize(frame.view(), {}), view, false, 1, expected.target());
    ASSERT_TRUE(vectorizer.map() == scratch.map()) << "frame " << i;
    ASSERT_TRUE(kept == expected) << "frame " << i;
  }
}

class Sequences : public testing::TestWithParam<std::filesystem::path> {
 protected:
  void SetUp() override {
    frames_ = frames_of(GetParam());
    ASSERT_GT(frames_.size(), 2U);
    for (const Picture& frame : frames_) {
      ASSERT_GT(frame.width, 0);
      order_.push_back(&frame);
    }
  }

  std::vector<Picture> frames_;
  std::vector<const Picture*> order_;
};

TEST_P(Sequences, ForwardsAreAsFromScratch) {
  expect_as_from_scratch(order_);
}

TEST_P(Sequences, BackwardsAreAsFromScratch) {
  std::reverse(order_.begin(), order_.end());
  expect_as_from_scratch(order_);
}

TEST_P(Sequences, ShuffledAreAsFromScratch) {
  std::mt19937 random(11);
  for (std::size_t i = order_.size() - 1; i > 0; --i) std::swap(order_[i], order_[random() % (i + 1)]);
  expect_as_from_scratch(order_);
}

TEST_P(Sequences, InterleavedWithAnotherAreAsFromScratch) {
  // Frames of the next sequence that has any, cut or filled up to the size of this one.
  const std::vector<std::filesystem::path> folders = sequence_folders();
  const auto own = std::find(folders.begin(), folders.end(), GetParam()) - folders.begin();
  const std::vector<Picture> others = frames_of(folders[(own + 1) % folders.size()]);
  std::vector<Picture> resized;
  for (const Picture& other : others) {
    Picture same_size(frames_[0].width, frames_[0].height);
    paste(same_size, other, 0, 0);
    resized.push_back(same_size);
  }
  std::vector<const Picture*> interleaved;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    interleaved.push_back(order_[i]);
    interleaved.push_back(&resized[i % resized.size()]);
    // Now and then in its own size.
    if (i % 4 == 3) interleaved.push_back(&others[i % others.size()]);
  }
  expect_as_from_scratch(interleaved);
}

std::string name_of(const testing::TestParamInfo<std::filesystem::path>& info) {
  return info.param.filename().string();
}

INSTANTIATE_TEST_SUITE_P(All, Sequences, testing::ValuesIn(sequence_folders()), name_of);

}  // namespace
}  // namespace depixel::test
