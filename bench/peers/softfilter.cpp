#include "bench/peers/softfilter.hpp"

#include <dlfcn.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace depixel::bench {
namespace {

constexpr unsigned kThreads = 1, kNoSimd = 0;
/// Some filters look at and write to pixels outside of the frame, as it lies in a larger one in the console.
constexpr std::size_t kMarginRows = 8;

/// A copy on C's heap, as filters release it.
template <typename T>
T* copy_array(const T* from, std::size_t count) {
  auto* copy = static_cast<T*>(std::calloc(std::max<std::size_t>(count, 1), sizeof(T)));
  if (copy != nullptr && count > 0) std::memcpy(copy, from, count * sizeof(T));
  return copy;
}

template <typename T>
int default_value(void*, const char*, T* value, T fallback) {
  *value = fallback;
  return 0;
}

template <typename T>
int default_array(void*, const char*, T** values, unsigned* count, const T* fallback,
                  unsigned fallback_count) {
  *values = copy_array(fallback, fallback_count);
  *count = fallback_count;
  return 0;
}

int default_string(void*, const char*, char** value, const char* fallback) {
  *value = copy_array(fallback, std::strlen(fallback) + 1);
  return 0;
}

void release(void* value) {
  std::free(value);
}

/// Has no key at all.
constexpr softfilter::Config kDefaults{default_value<float>,
                                       default_value<int>,
                                       default_value<unsigned>,
                                       default_array<float>,
                                       default_array<int>,
                                       default_string,
                                       release};

std::size_t bytes_a_pixel(unsigned format) {
  return format == softfilter::kXrgb8888 ? 4 : 2;
}

/// The most exact of some formats.
unsigned best_format(unsigned formats) {
  return formats & softfilter::kXrgb8888 ? softfilter::kXrgb8888 : softfilter::kRgb565;
}

/// Rows of a frame and the margins, all black.
std::vector<std::uint8_t> make_rows(std::size_t pitch, unsigned height) {
  return std::vector<std::uint8_t>(pitch * (height + 2 * kMarginRows));
}

template <typename Word, typename Pack>
void pack_row(const std::uint8_t* from, int width, std::uint8_t* to, Pack pack) {
  for (int x = 0; x < width; ++x, from += 4, to += sizeof(Word)) {
    const Word word = static_cast<Word>(pack(unsigned{from[0]}, unsigned{from[1]}, unsigned{from[2]}));
    std::memcpy(to, &word, sizeof word);
  }
}

unsigned pack_xrgb8888(unsigned red, unsigned green, unsigned blue) {
  return red << 16 | green << 8 | blue;
}

unsigned pack_rgb565(unsigned red, unsigned green, unsigned blue) {
  return red >> 3 << 11 | green >> 2 << 5 | blue >> 3;
}

}  // namespace

SoftFilterLibrary open_softfilter(const std::filesystem::path& library) {
  const auto refuse = [&](std::string_view reason) {
    return std::runtime_error(fmt::format("{} cannot be used: {}.", library.string(), reason));
  };
  std::shared_ptr<void> handle(dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL), [](void* opened) {
    if (opened != nullptr) dlclose(opened);
  });
  if (!handle) throw refuse(dlerror());
  const auto get_implementation =
      reinterpret_cast<softfilter::GetImplementation>(dlsym(handle.get(), softfilter::kEntryPoint));
  if (get_implementation == nullptr) throw refuse("it is no video filter");
  const softfilter::Implementation* implementation = get_implementation(kNoSimd);
  if (implementation == nullptr) throw refuse("it has no filter for this processor");
  if (implementation->api_version != softfilter::kApiVersion) {
    throw refuse("its interface is of another version");
  }
  return {implementation->short_ident, std::move(handle), implementation};
}

std::vector<std::filesystem::path> list_softfilters(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> libraries;
  if (!std::filesystem::is_directory(folder)) return libraries;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".so") libraries.push_back(entry.path());
  }
  std::sort(libraries.begin(), libraries.end());
  return libraries;
}

SoftFilter::SoftFilter(const SoftFilterLibrary& library, int width, int height)
    : library_(library),
      width_(static_cast<unsigned>(width)),
      height_(static_cast<unsigned>(height)),
      in_format_(best_format(library.implementation->query_input_formats())),
      out_format_(best_format(library.implementation->query_output_formats(in_format_))),
      data_(library.implementation->create(&kDefaults, in_format_, out_format_, width_, height_, kThreads,
                                           kNoSimd, nullptr),
            Destroy{library.implementation->destroy}) {
  if (!data_) {
    throw std::runtime_error(
        fmt::format("The filter {} refuses frames of {} x {} pixels.", library.name, width, height));
  }
  packets_.resize(library.implementation->query_num_threads(data_.get()));
  input_ = make_rows(width_ * bytes_a_pixel(in_format_), height_);
}

void SoftFilter::load(const FrameView& frame) {
  const std::size_t pitch = width_ * bytes_a_pixel(in_format_);
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* from = frame.pixels + y * frame.pitch;
    std::uint8_t* to = input_.data() + (static_cast<std::size_t>(y) + kMarginRows) * pitch;
    if (in_format_ == softfilter::kXrgb8888) {
      pack_row<std::uint32_t>(from, frame.width, to, pack_xrgb8888);
    } else {
      pack_row<std::uint16_t>(from, frame.width, to, pack_rgb565);
    }
  }
}

void SoftFilter::run() {
  const softfilter::Implementation& filter = *library_.implementation;
  filter.query_output_size(data_.get(), &out_width_, &out_height_, width_, height_);
  const std::size_t in_pitch = width_ * bytes_a_pixel(in_format_),
                    out_pitch = out_width_ * bytes_a_pixel(out_format_);
  if (output_.empty()) output_ = make_rows(out_pitch, out_height_);
  filter.get_work_packets(data_.get(), packets_.data(), output_.data() + kMarginRows * out_pitch, out_pitch,
                          input_.data() + kMarginRows * in_pitch, width_, height_, in_pitch);
  for (const softfilter::Packet& packet : packets_) packet.work(data_.get(), packet.thread_data);
}

}  // namespace depixel::bench
