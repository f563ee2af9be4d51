#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <tl/expected.hpp>
#include <vector>

#include "apps/common/picture.hpp"
#include "libdepixel/core/error.hpp"

struct GifFileType;

namespace depixel {

/// Reads the frames of a GIF one after the other, each as the whole picture that a viewer shows at that time.
/// Source: the GIF89a specification, sections 18 to 23; decoding is giflib's.
class GifReader {
 public:
  /// Reads the file's structure through to the end, without decoding pixels, so that a file that is cut short
  /// is refused before anything is drawn. The error's sentence goes on from the file's name.
  static tl::expected<GifReader, Error> open(std::vector<std::uint8_t> file);

  int frame_count() const { return frame_count_; }

  /// How long the frame that was read last is shown.
  double frame_seconds() const;

  /// The next frame, to be asked for frame_count() times.
  tl::expected<Picture, Error> next();

 private:
  struct Cursor {
    std::vector<std::uint8_t> file;
    std::size_t position = 0;
  };
  struct Close {
    void operator()(GifFileType* gif) const;
  };
  using Handle = std::unique_ptr<GifFileType, Close>;

  /// How a frame is shown, and what becomes of it before the next.
  struct Control {
    int transparent_index = -1;
    int disposal = 0;
    int delay = 0;  ///< hundredths of a second
  };

  GifReader() = default;
  static int feed(GifFileType* gif, std::uint8_t* to, int size);
  bool rewind();
  bool skip_to_image(Control& control);
  bool draw_image(const Control& control);
  bool draw_row(int row, int transparent_index);
  void dispose();

  std::unique_ptr<Cursor> cursor_;  ///< at an address that stays: giflib points to it
  Handle gif_;
  int frame_count_ = 0;
  Control control_;  ///< of the frame drawn last
  Picture canvas_, before_;
  std::vector<std::uint8_t> indices_;
};

}  // namespace depixel
