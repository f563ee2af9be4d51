#include "libdepixel/stages/smoothing.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

/// A simultaneous step along the gradient of the energy.
struct Sweep {
  int stride;      ///< neighbours are this many nodes away
  float rate;      ///< of the step; bending alone would diverge from 1/8 on
  float position;  ///< weight of the distance from rest, in the gradient
};

constexpr float kPosition = 0.5f;
/// Bending over twice the distance grows sixteenfold; a position term grown by a quarter of that stays
/// stable.
constexpr Sweep kCoarse{2, 0.1f, 4 * kPosition}, kFine{1, 0.11f, kPosition};
constexpr std::array kSweeps{kCoarse, kCoarse, kCoarse, kFine, kFine};

/// Second differences of positions over a stride, of eight nodes from i on; 0 where bending does not count.
template <int kStride>
inline Float8 bending(const float* position, const float* step, const float* counts, int i) {
  Float8 turn = load8(step + i) - load8(step + i - 1);
  if constexpr (kStride == 2) turn += load8(step + i + 1) - load8(step + i - 2);
  const Float8 ends = load8(position + i - kStride) + load8(position + i + kStride);
  return load8(counts + i) * (turn + (ends - 2 * load8(position + i)));
}

/// Half the gradient of the bending energy at eight nodes.
template <int kStride>
inline Float8 bending_slope(const float* bend, int i) {
  return (load8(bend + i - kStride) + load8(bend + i + kStride)) - 2 * load8(bend + i);
}

/// What a sweep reads and writes.
struct SweepArrays {
  float *x, *y, *bend_x, *bend_y;
  const float *rest_x, *rest_y, *step_x, *step_y, *mobility, *bends1, *bends2;
  int from, to;
};

template <int kStride>
inline void find_bending(const SweepArrays& a) {
  const float* counts = kStride == 1 ? a.bends1 : a.bends2;
  float *const bend_x = a.bend_x, *const bend_y = a.bend_y;
  const float *const x = a.x, *const y = a.y, *const step_x = a.step_x, *const step_y = a.step_y;
  for (int i = a.from, to = a.to; i < to; i += kFloatLanes) {
    store8(bend_x + i, bending<kStride>(x, step_x, counts, i));
    store8(bend_y + i, bending<kStride>(y, step_y, counts, i));
  }
}

template <int kStride>
inline void move_nodes(const SweepArrays& a, const Sweep sweep) {
  float *const at_x = a.x, *const at_y = a.y;
  const float *const bend_x = a.bend_x, *const bend_y = a.bend_y, *const rest_x = a.rest_x,
                     *const rest_y = a.rest_y;
  const float* const mobility = a.mobility;
  for (int i = a.from, to = a.to; i < to; i += kFloatLanes) {
    const Float8 x = load8(at_x + i), y = load8(at_y + i);
    const Float8 away_x = x - load8(rest_x + i), away_y = y - load8(rest_y + i);
    const Float8 pull = sweep.position * (away_x * away_x + away_y * away_y);
    const Float8 pace = sweep.rate * load8(mobility + i);
    const Float8 slope_x = bending_slope<kStride>(bend_x, i) + away_x * pull;
    const Float8 slope_y = bending_slope<kStride>(bend_y, i) + away_y * pull;
    store8(at_x + i, clamp8(x - pace * slope_x, -ArcBatch::kReach, ArcBatch::kReach));
    store8(at_y + i, clamp8(y - pace * slope_y, -ArcBatch::kReach, ArcBatch::kReach));
  }
}

DEPIXEL_VECTOR_CLONES void find_bending(const SweepArrays& arrays, int stride) {
  stride == 1 ? find_bending<1>(arrays) : find_bending<2>(arrays);
}

DEPIXEL_VECTOR_CLONES void move_nodes(const SweepArrays& arrays, const Sweep& sweep) {
  sweep.stride == 1 ? move_nodes<1>(arrays, sweep) : move_nodes<2>(arrays, sweep);
}

void make_room(const ArcBatch& batch, SmoothingScratch& scratch) {
  if (scratch.bend_x.size() < batch.x.size()) {
    scratch.bend_x.resize(batch.x.size());
    scratch.bend_y.resize(batch.x.size());
  }
}

/// The ghosts at both ends of the batch are not among the entries that sweeps compute; inner ones come out as
/// 0.
void clear_outer_ghosts(const ArcBatch& batch, SmoothingScratch& scratch) {
  for (auto* bend : {&scratch.bend_x, &scratch.bend_y}) {
    std::fill_n(bend->begin(), ArcBatch::kGhosts, 0.0f);
    std::fill_n(bend->begin() + batch.size - ArcBatch::kGhosts, ArcBatch::kGhosts, 0.0f);
  }
}

}  // namespace

void minimize_energy(ArcBatch& batch, SmoothingScratch& scratch) {
  if (batch.members.empty()) return;
  make_room(batch, scratch);
  const SweepArrays arrays{batch.x.data(),
                           batch.y.data(),
                           scratch.bend_x.data(),
                           scratch.bend_y.data(),
                           batch.rest_x.data(),
                           batch.rest_y.data(),
                           batch.step_x.data(),
                           batch.step_y.data(),
                           batch.mobility.data(),
                           batch.bends1.data(),
                           batch.bends2.data(),
                           ArcBatch::kGhosts,
                           batch.size - ArcBatch::kGhosts};
  for (const Sweep& sweep : kSweeps) {
    batch.close(batch.x, batch.y);
    find_bending(arrays, sweep.stride);
    clear_outer_ghosts(batch, scratch);
    batch.close(scratch.bend_x, scratch.bend_y);  // open contours need none: nothing bends beyond their ends
    move_nodes(arrays, sweep);
  }
}

void average_control_points(ArcBatch& batch, SmoothingScratch& scratch) {
  make_room(batch, scratch);
  for (const ArcBatch::Member& member : batch.members) {
    for (int round = 0; round < member.rounds; ++round) {
      for (auto [values, steps, result] : {std::tuple{&batch.x, &batch.step_x, &scratch.bend_x},
                                           std::tuple{&batch.y, &batch.step_y, &scratch.bend_y}}) {
        if (member.closed) ArcBatch::close_ghosts(member, *values);
        for (int i = member.first; i <= member.last(); ++i) {
          const float turn = (*steps)[i] - (*steps)[i - 1];
          const float bend = turn + (((*values)[i - 1] + (*values)[i + 1]) - 2 * (*values)[i]);
          (*result)[i] = (*values)[i] + batch.mobility[i] * 0.25f * bend;
        }
        std::copy_n(result->begin() + member.first, member.count, values->begin() + member.first);
      }
    }
  }
}

}  // namespace depixel
