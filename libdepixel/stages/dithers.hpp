#pragma once

#include <array>
#include <vector>

#include "libdepixel/core/bit_rows.hpp"
#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/core/lattice.hpp"

namespace depixel {

/// A frame, its dithered areas, and the frame in which these have the colour that they stand for.
///
/// A *checker* is a block with two colours, each along a diagonal. Checkers that share a side have the same
/// two colours, so a component of them is a checkerboard of two colours. It is a dither where it fills an
/// area: where it has squares of 4x4 pixels, and up to kGrowth pixels from these. What is smaller, as in
/// text, outlines and lone checkers, is left as it is.
struct Dithers {
  static constexpr int kGrowth = 4;

  Lattice lattice;
  std::vector<Rgba> pixels;   ///< padded; those of the frame, alpha 0 normalised, padding transparent
  BitRows checkers;           ///< by block inside the frame, from its north-western one on
  BitRows areas;              ///< the checkers that are parts of dithers
  std::vector<Rgba> blended;  ///< like pixels
  std::array<BitRows, 2> scratch;

  /// Makes room for another size of frame; nothing is a checker then.
  void resize(const Lattice& size);

  /// Whether a pixel is blended.
  bool is_dithered(int x, int y) const {
    return areas.has(x - 1, y - 1) || areas.has(x, y - 1) || areas.has(x - 1, y) || areas.has(x, y);
  }
  /// The blended frame; valid until the next one.
  FrameView view() const;

  std::size_t memory_bytes() const {
    return held_bytes(pixels, blended) + checkers.memory_bytes() + areas.memory_bytes() +
           scratch[0].memory_bytes() + scratch[1].memory_bytes();
  }
};

/// Recognises dithers by checkerboards and blends them (before stage 1, if asked for): each pixel of a
/// dithered area becomes the mean of its two colours, in linear light if edges are blended so, too: what
/// the rasteriser makes of both where one pixel of the output shows many of the frame. What a pixel becomes
/// depends on the pixels near it alone, wherever they lie, and not on which of the two colours it has:
/// dithers that scroll, or swap their colours from frame to frame, are even. Where a dither leaves the frame
/// it is taken to go on for a pixel, so that one that scrolls in is seen when it is three pixels wide. \param
/// frame    at least 1x1 pixels. \param dithers overwritten; its buffers are reused. Cost: linear in pixels,
/// small beside that of a similarity graph; no allocation when the size stays. Source: for the need,
/// Schapfel, sections 6.1 and 7.1.4.
void blend_dithers(const FrameView& frame, bool linear_light, Dithers& dithers);

/// Its parts. \pre  resize() to the frame's size.
/// Takes over row y of the frame's pixels, normalized.
void take_row(const FrameView& frame, int y, Dithers& dithers);
/// Finds the checkers of row y of blocks, between the rows y and y + 1 of pixels.
void find_checkers(int y, Dithers& dithers);
/// Finds areas from all checkers.
void find_dithered_areas(Dithers& dithers);
/// Blends row y of pixels: from that row and its areas alone.
void blend_row(int y, bool linear_light, Dithers& dithers);

}  // namespace depixel
