#include "apps/common/y4m_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include "apps/common/decode.hpp"

namespace depixel {
namespace {

constexpr std::size_t kMaxHeader = 512;

enum class Line { whole, end, cut, too_long };

/// Reads a line of text, without its end.
Line read_line(std::FILE* stream, std::string& line) {
  line.clear();
  for (int c = std::getc(stream); c != '\n'; c = std::getc(stream)) {
    if (c == EOF) return line.empty() ? Line::end : Line::cut;
    if (line.size() == kMaxHeader) return Line::too_long;
    line += static_cast<char>(c);
  }
  return Line::whole;
}

template <typename Use>
bool for_each_word(std::string_view text, Use use) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0 && !use(text.substr(0, end))) return false;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return true;
}

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "30000:1001" as a quotient; none if a part is not above zero.
std::optional<double> quotient(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto above = whole_number(text.substr(0, colon)), below = whole_number(text.substr(colon + 1));
  if (!above || !below || *above <= 0 || *below <= 0) return std::nullopt;
  return double(*above) / *below;
}

std::uint8_t to_level(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

Rgba to_rgb(int y, int u, int v, bool is_full_range) {
  const double luma = is_full_range ? y : (y - 16) * 255.0 / 219;
  const double chroma = is_full_range ? 1 : 255.0 / 224;
  const double blue = (u - 128) * chroma, red = (v - 128) * chroma;
  constexpr double kRed = 0.299, kGreen = 0.587, kBlue = 0.114;
  return {to_level(luma + 2 * (1 - kRed) * red),
          to_level(luma - (2 * (1 - kBlue) * kBlue * blue + 2 * (1 - kRed) * kRed * red) / kGreen),
          to_level(luma + 2 * (1 - kBlue) * blue), 255};
}

int shifted_up(int size, int shift) {
  return (size + (1 << shift) - 1) >> shift;
}

}  // namespace

bool looks_like_y4m(std::FILE* stream) {
  const int first = std::getc(stream);
  if (first != EOF) std::ungetc(first, stream);
  return first == 'Y';
}

bool Y4mReader::take_chroma(std::string_view name) {
  struct Kind {
    std::string_view name;
    int shift_x, shift_y;
    bool is_mono;
  };
  constexpr std::array<Kind, 7> kKinds{{{"420jpeg", 1, 1, false},
                                        {"420paldv", 1, 1, false},
                                        {"420mpeg2", 1, 1, false},
                                        {"420", 1, 1, false},
                                        {"422", 1, 0, false},
                                        {"444", 0, 0, false},
                                        {"mono", 0, 0, true}}};
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return k.name == name; });
  if (kind == kKinds.end()) return false;
  chroma_shift_x_ = kind->shift_x;
  chroma_shift_y_ = kind->shift_y;
  is_mono_ = kind->is_mono;
  return true;
}

bool Y4mReader::take_parameter(std::string_view parameter) {
  const std::string_view value = parameter.substr(1);
  switch (parameter.front()) {
    case 'W':
      width_ = whole_number(value).value_or(0);
      return true;
    case 'H':
      height_ = whole_number(value).value_or(0);
      return true;
    case 'F':
      if (const auto rate = quotient(value)) frame_seconds_ = 1 / *rate;
      return true;
    case 'A':
      pixel_aspect_ = quotient(value);
      return true;
    case 'C':
      return take_chroma(value);
    case 'X':
      if (value == "COLORRANGE=FULL") is_full_range_ = true;
      return true;
    default:
      return true;
  }
}

tl::expected<Y4mReader, Error> Y4mReader::open(Stream stream) {
  Y4mReader reader;
  reader.stream_ = std::move(stream);
  std::string header;
  const Line line = read_line(reader.stream_.get(), header);
  constexpr std::string_view kSignature = "YUV4MPEG2";
  if (line != Line::whole || !header.starts_with(kSignature)) {
    return tl::unexpected(Error{"is not a YUV4MPEG2 stream that can be read: its first line is damaged."});
  }
  std::string_view refused;
  const bool taken =
      for_each_word(std::string_view(header).substr(kSignature.size()), [&](std::string_view word) {
        refused = word;
        return reader.take_parameter(word);
      });
  if (!taken) {
    return tl::unexpected(Error{fmt::format(
        "has pixels of a kind that cannot be read ({}): 8 bits in 420, 422, 444 or mono can.", refused)});
  }
  if (auto fits = fits_limits(reader.width_, reader.height_); !fits) return tl::unexpected(fits.error());
  const auto luma = static_cast<std::size_t>(reader.width_) * static_cast<std::size_t>(reader.height_);
  const auto chroma = static_cast<std::size_t>(shifted_up(reader.width_, reader.chroma_shift_x_)) *
                      static_cast<std::size_t>(shifted_up(reader.height_, reader.chroma_shift_y_));
  reader.planes_.resize(luma + (reader.is_mono_ ? 0 : 2 * chroma));
  return reader;
}

/// Reads a frame's header and its bytes. \return false at the end.
tl::expected<bool, Error> Y4mReader::start_frame() {
  std::string header;
  const Line line = read_line(stream_.get(), header);
  if (line == Line::end) return false;
  if (line == Line::cut) return tl::unexpected(Error{"is cut short."});
  if (line != Line::whole || !header.starts_with("FRAME")) {
    return tl::unexpected(Error{"is damaged: a frame does not begin where it should."});
  }
  if (std::fread(planes_.data(), 1, planes_.size(), stream_.get()) == planes_.size()) return true;
  return tl::unexpected(Error{"is cut short."});
}

tl::expected<std::optional<Picture>, Error> Y4mReader::next() {
  const auto started = start_frame();
  if (!started) return tl::unexpected(started.error());
  if (!*started) return std::nullopt;
  Picture picture(width_, height_);
  convert(picture);
  return std::optional(std::move(picture));
}

bool Y4mReader::skip() {
  const auto started = start_frame();
  return started && *started;
}

void Y4mReader::convert(Picture& picture) const {
  const int chroma_width = shifted_up(width_, chroma_shift_x_);
  const auto at = [](int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  const std::size_t u_plane = at(0, height_, width_);
  const std::size_t v_plane = u_plane + (planes_.size() - u_plane) / 2;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const std::size_t chroma = at(x >> chroma_shift_x_, y >> chroma_shift_y_, chroma_width);
      const int u = is_mono_ ? 128 : planes_[u_plane + chroma],
                v = is_mono_ ? 128 : planes_[v_plane + chroma];
      picture.at(x, y) = to_rgb(planes_[at(x, y, width_)], u, v, is_full_range_);
    }
  }
}

}  // namespace depixel
