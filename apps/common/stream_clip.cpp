
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "apps/common/clip.hpp"
#include "apps/common/frame_source.hpp"
#include "apps/common/y4m_reader.hpp"

namespace depixel {
namespace {

constexpr double kStillSeconds = 1.0 / 60;
constexpr int kMostAhead = 120;  ///< frames that are read before they are asked for: two seconds

/// What the reading thread and the player share. It outlives the clip where the thread hangs in a read.
struct Shared {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::shared_ptr<const ClipFrame>> frames;
  int first = 0;  ///< index of the first one kept
  int asked_for = 0;
  std::size_t bytes = 0, budget_bytes = 0;
  bool ended = false, abandoned = false;
  std::optional<Error> error;
  std::optional<double> pixel_aspect;

  int end() const { return first + static_cast<int>(frames.size()); }
};

/// Adds a frame, once there is room for it. \return false if nobody waits for frames any more.
bool add(Shared& shared, ClipFrame frame) {
  std::unique_lock lock(shared.mutex);
  shared.changed.wait(lock, [&] { return shared.abandoned || shared.end() < shared.asked_for + kMostAhead; });
  if (shared.abandoned) return false;
  shared.bytes += sizeof(Rgba) * frame.picture.pixel_count();
  shared.frames.push_back(std::make_shared<const ClipFrame>(std::move(frame)));
  while (shared.bytes > shared.budget_bytes && shared.frames.size() > 1 && shared.first < shared.asked_for) {
    shared.bytes -= sizeof(Rgba) * shared.frames.front()->picture.pixel_count();
    shared.frames.pop_front();
    ++shared.first;
  }
  return true;
}

/// Reads all that standard input brings. \return an error's sentence, whole.
std::optional<Error> read_frames(Shared& shared) {
  const auto about = [](const Error& error) { return Error{"Standard input " + error.message}; };
  if (!looks_like_y4m(stdin)) {
    FrameSource source({{"-"}, false});
    for (;;) {
      auto frame = source.next();
      if (!frame) return frame.error();
      if (!*frame || !add(shared, {std::move((*frame)->picture), (*frame)->name, kStillSeconds}))
        return std::nullopt;
    }
  }
  auto y4m = Y4mReader::open(Stream(stdin));
  if (!y4m) return about(y4m.error());
  {
    const std::lock_guard lock(shared.mutex);
    shared.pixel_aspect = y4m->pixel_aspect();
  }
  for (int index = 0;; ++index) {
    auto picture = y4m->next();
    if (!picture) return about(picture.error());
    if (!*picture) return index == 0 ? std::optional(about({"holds no frames."})) : std::nullopt;
    const std::string number = std::to_string(index);
    const std::string name = "stdin_" + std::string(number.size() < 4 ? 4 - number.size() : 0, '0') + number;
    if (!add(shared, {std::move(**picture), name, y4m->frame_seconds()})) return std::nullopt;
  }
}

class StreamClip final : public Clip {
 public:
  explicit StreamClip(std::size_t budget_bytes) : shared_(std::make_shared<Shared>()) {
    shared_->budget_bytes = budget_bytes;
    // The thread is not waited for at the end: a read from a pipe that brings nothing cannot be ended.
    std::thread([shared = shared_] {
      auto error = read_frames(*shared);
      const std::lock_guard lock(shared->mutex);
      shared->error = std::move(error);
      shared->ended = true;
    }).detach();
  }
  ~StreamClip() override {
    const std::lock_guard lock(shared_->mutex);
    shared_->abandoned = true;
    shared_->changed.notify_all();
  }

  std::optional<int> frame_count() override {
    const std::lock_guard lock(shared_->mutex);
    // What is wrong at the end of a stream is told as one frame more.
    if (shared_->ended) return shared_->end() + (shared_->error ? 1 : 0);
    return std::nullopt;
  }
  int first_frame() override {
    const std::lock_guard lock(shared_->mutex);
    return shared_->first;
  }
  bool has_frame(int index) override {
    const std::lock_guard lock(shared_->mutex);
    return (index >= shared_->first && index < shared_->end()) || (shared_->error && index == shared_->end());
  }
  std::optional<double> pixel_aspect() override {
    const std::lock_guard lock(shared_->mutex);
    return shared_->pixel_aspect;
  }

  tl::expected<std::shared_ptr<const ClipFrame>, Error> frame(int index) override {
    const std::lock_guard lock(shared_->mutex);
    if (index >= shared_->first && index < shared_->end()) {
      shared_->asked_for = index;
      shared_->changed.notify_all();
      return shared_->frames[std::size_t(index - shared_->first)];
    }
    return tl::unexpected(shared_->error.value_or(Error{"Standard input has no such frame."}));
  }

 private:
  std::shared_ptr<Shared> shared_;
};

}  // namespace

std::unique_ptr<Clip> open_stream_clip(std::size_t budget_bytes) {
  return std::make_unique<StreamClip>(budget_bytes);
}

}  // namespace depixel
