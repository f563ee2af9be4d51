#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <variant>

#include "apps/common/gif_reader.hpp"
#include "apps/common/inputs.hpp"
#include "apps/common/picture.hpp"
#include "apps/common/y4m_reader.hpp"
#include "libdepixel/core/error.hpp"

namespace depixel {

/// A picture and the name that its output is to have, without ending.
struct NamedFrame {
  Picture picture;
  std::string name;
};

/// Reads the frames of all inputs in order, one at a time: a still picture is a frame, an animated GIF and a
/// YUV4MPEG2 stream are as many as they have, named NAME_0000, NAME_0001 and so on.
class FrameSource {
 public:
  explicit FrameSource(Inputs inputs) : inputs_(std::move(inputs)) {}

  /// The next frame, or none after the last.
  tl::expected<std::optional<NamedFrame>, Error> next();

  /// Whether there are several frames, or could be; of a single file this is known once its first frame was
  /// read.
  bool is_sequence() const { return inputs_.sequence || frames_in_file_ != 1; }
  /// The part of all frames that was read, 0..1, as far as it is known.
  double progress() const;

 private:
  static constexpr int kUnknown = -1;  ///< of frames: a stream tells at its end

  tl::expected<std::optional<NamedFrame>, Error> next_in_file();
  tl::expected<void, Error> open_next_file();

  Inputs inputs_;
  std::size_t files_opened_ = 0;
  std::variant<std::monostate, Picture, GifReader, Y4mReader> file_;  ///< what is left of the open one
  int frames_in_file_ = 0, frames_read_ = 0;
};

/// The name of a file's output, without ending: its own, or "stdin".
std::string output_name(const std::filesystem::path& input);

}  // namespace depixel
