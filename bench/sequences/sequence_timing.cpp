#include "bench/sequences/sequence_timing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <deque>
#include <stdexcept>

#include "bench/peers/libav_scaler.hpp"
#include "bench/sequences/scratch_player.hpp"
#include "filter/frame_filter.hpp"

namespace depixel::bench {
namespace {

const Options kOptions;  // the defaults, one thread

/// Frames of a turn.
constexpr std::size_t kTurn = 8;

void check(const tl::expected<void, Error>& done) {
  if (!done) throw std::runtime_error(done.error().message);
}

/// Submits and draws frames one after the other, to a picture that is kept.
class IncrementalPlayer {
 public:
  IncrementalPlayer(int width, int height) : out_(width * kTimingScale, height * kTimingScale) {}

  /// Forgets all frames.
  void restart() { filter_ = FrameFilter::cpu(); }

  void show(const FrameView& frame) {
    check(filter_->submit(frame, kOptions));
    const View view = View::fit(filter_->vectorizer().lattice(), out_.width(), out_.height());
    check(filter_->draw(KeptPicture{out_.target()}, {0, 0, out_.width(), out_.height()}, view));
  }

  std::size_t memory_bytes() const { return filter_->memory_bytes(); }

 private:
  std::unique_ptr<FrameFilter> filter_;
  Picture out_;
};

/// A scaler that is not ours, and its times.
template <typename Scaler>
struct Peer {
  template <typename... Arguments>
  explicit Peer(std::size_t frames, Arguments&&... arguments)
      : scaler(std::forward<Arguments>(arguments)...), samples(frames) {}

  void time(std::size_t frame) {
    samples.time(frame, [&] { scaler.run(); });
  }

  Scaler scaler;
  Samples samples;
};

/// All that is timed on one sequence, and the samples.
class SequenceTimer {
 public:
  SequenceTimer(const Sequence& sequence, std::span<const SoftFilterLibrary> softfilters)
      : sequence_(sequence),
        incremental_player_(sequence.width(), sequence.height()),
        scratch_player_(sequence.width(), sequence.height(), kOptions.threads),
        xbr_(count(), "xbr", kTimingScale, sequence.width(), sequence.height()),
        hqx_(count(), "hqx", kTimingScale, sequence.width(), sequence.height()),
        incremental_(count()),
        scratch_(count()),
        compare_(count()),
        is_repeat_(count()) {
    for (const SoftFilterLibrary& library : softfilters) add(library);
  }

  /// \param first_turn  frames of the first turn, 1 to kTurn.
  void play(std::size_t first_turn) {
    incremental_player_.restart();
    for (std::size_t from = 0, to = first_turn; from < count(); from = to, to += kTurn) {
      take_turns(from, std::min(to, count()));
    }
  }

  SequenceTiming result() const {
    SequenceTiming timing{sequence_.name,
                          incremental_,
                          scratch_,
                          xbr_.samples,
                          hqx_.samples,
                          compare_,
                          {is_repeat_.begin() + 1, is_repeat_.end()},
                          {},
                          double(most_memory_bytes_) / double(sequence_.frames.front().pixel_count())};
    for (const auto& peer : softfilters_) {
      const SoftFilter& filter = peer.scaler;
      timing.softfilters.push_back({filter.name(), filter.out_width(), filter.out_height(), peer.samples});
    }
    return timing;
  }

 private:
  std::size_t count() const { return sequence_.frames.size(); }
  FrameView view(std::size_t frame) const { return sequence_.frames[frame].view(); }

  void add(const SoftFilterLibrary& library) {
    try {
      softfilters_.emplace_back(count(), library, sequence_.width(), sequence_.height());
    } catch (const std::runtime_error& error) {
      fmt::print(stderr, "{}: left out: {}\n", sequence_.name, error.what());
    }
  }

  /// All contestants, one after the other, with frames from .. to - 1.
  void take_turns(std::size_t from, std::size_t to) {
    const auto each_frame = [&](auto&& work) {
      for (std::size_t frame = from; frame < to; ++frame) work(frame);
    };
    // Handing over a frame is not timed.
    const auto play = [&](auto& peer) {
      each_frame([&](std::size_t frame) {
        peer.scaler.load(view(frame));
        peer.time(frame);
      });
    };
    each_frame([&](std::size_t frame) {
      incremental_.time(frame, [&] { incremental_player_.show(view(frame)); });
      most_memory_bytes_ = std::max(most_memory_bytes_, incremental_player_.memory_bytes());
    });
    each_frame([&](std::size_t frame) {
      scratch_.time(frame, [&] {
        scratch_player_.vectorize(view(frame));
        scratch_player_.draw();
      });
    });
    play(xbr_);
    play(hqx_);
    for (auto& peer : softfilters_) play(peer);
    each_frame([&](std::size_t frame) { compare(frame); });
  }

  void compare(std::size_t frame) {
    const std::size_t before = frame == 0 ? 0 : frame - 1;
    const std::size_t bytes = sequence_.frames[frame].pixel_count() * sizeof(Rgba);
    bool is_same = false;
    compare_.time(frame, [&] { is_same = std::memcmp(view(before).pixels, view(frame).pixels, bytes) == 0; });
    is_repeat_[frame] = is_same;
  }

  const Sequence& sequence_;
  IncrementalPlayer incremental_player_;
  ScratchPlayer scratch_player_;
  Peer<LibavScaler> xbr_, hqx_;
  std::deque<Peer<SoftFilter>> softfilters_;
  Samples incremental_, scratch_, compare_;
  std::vector<bool> is_repeat_;
  std::size_t most_memory_bytes_ = 0;
};

}  // namespace

SequenceTiming time_sequence(const Sequence& sequence, std::span<const SoftFilterLibrary> softfilters,
                             int playbacks) {
  SequenceTimer timer(sequence, softfilters);
  for (int i = 0; i < playbacks; ++i) timer.play(kTurn - std::size_t(i) % kTurn);
  return timer.result();
}

}  // namespace depixel::bench
