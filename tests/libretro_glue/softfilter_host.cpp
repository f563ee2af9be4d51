#include "tests/libretro_glue/softfilter_host.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace depixel::test {
namespace {

constexpr unsigned kNoSimd = 0;

const std::string* find(void* userdata, const char* key) {
  const auto& preset = *static_cast<const Preset*>(userdata);
  const auto found = preset.find(key);
  return found == preset.end() ? nullptr : &found->second;
}

int get_float(void* userdata, const char* key, float* value, float fallback) {
  const std::string* text = find(userdata, key);
  *value = text == nullptr ? fallback : std::strtof(text->c_str(), nullptr);
  return text != nullptr;
}

template <typename Number>
int get_whole(void* userdata, const char* key, Number* value, Number fallback) {
  const std::string* text = find(userdata, key);
  *value = text == nullptr ? fallback : static_cast<Number>(std::strtol(text->c_str(), nullptr, 0));
  return text != nullptr;
}

template <typename Number>
int get_array(void*, const char*, Number** values, unsigned* count, const Number*, unsigned) {
  *values = nullptr;
  *count = 0;
  return 0;
}

int get_string(void* userdata, const char* key, char** value, const char* fallback) {
  const std::string* text = find(userdata, key);
  *value = strdup(text == nullptr ? fallback : text->c_str());
  return text != nullptr;
}

constexpr std::size_t word_bytes(unsigned format) {
  return format == softfilter::kXrgb8888 ? 4 : 2;
}

}  // namespace

CoreFrame pack(const Picture& picture, unsigned format, std::size_t padding) {
  CoreFrame frame{static_cast<unsigned>(picture.width), static_cast<unsigned>(picture.height), 0, {}};
  frame.pitch = frame.width * word_bytes(format) + padding;
  frame.bytes.assign(frame.pitch * frame.height, 0x5a);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Rgba c = picture.at(x, y);
      std::uint8_t* to = frame.bytes.data() + y * frame.pitch + x * word_bytes(format);
      const std::uint32_t word = format == softfilter::kXrgb8888 ? c.r * 65536U + c.g * 256U + c.b
                                                                 : c.r / 8 * 2048U + c.g / 4 * 32U + c.b / 8;
      std::memcpy(to, &word, word_bytes(format));
    }
  }
  return frame;
}

Picture unpack(const CoreFrame& frame, unsigned format) {
  Picture picture(static_cast<int>(frame.width), static_cast<int>(frame.height));
  const auto fill = [](std::uint32_t bits, std::uint32_t most) {
    return static_cast<std::uint8_t>(std::lround(255.0 * bits / most));
  };
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      std::uint32_t word = 0;
      std::memcpy(&word, frame.bytes.data() + y * frame.pitch + x * word_bytes(format), word_bytes(format));
      picture.at(x, y) =
          format == softfilter::kXrgb8888
              ? Rgba{std::uint8_t(word / 65536), std::uint8_t(word / 256), std::uint8_t(word), 255}
              : Rgba{fill(word / 2048, 31), fill(word / 32 % 64, 63), fill(word % 32, 31), 255};
    }
  }
  return picture;
}

SoftfilterLibrary::SoftfilterLibrary(const std::string& file)
    : handle_(dlopen(file.c_str(), RTLD_LAZY), [](void* opened) {
        if (opened != nullptr) dlclose(opened);
      }) {
  if (!handle_) throw std::runtime_error(dlerror());
  const auto get =
      reinterpret_cast<softfilter::GetImplementation>(dlsym(handle_.get(), softfilter::kEntryPoint));
  if (get == nullptr) throw std::runtime_error("no entry point");
  implementation_ = get(kNoSimd);
}

SoftfilterHost::SoftfilterHost(const SoftfilterLibrary& library, const Preset& preset, unsigned format,
                               unsigned max_width, unsigned max_height, unsigned threads)
    : library_(library), format_(format) {
  {
    // As RetroArch has them, both are gone when create() has returned.
    auto own_preset = std::make_unique<Preset>(preset);
    const softfilter::Config config{get_float,        get_whole<int>, get_whole<unsigned>,
                                    get_array<float>, get_array<int>, get_string,
                                    std::free};
    data_ =
        library_->create(&config, format, format, max_width, max_height, threads, kNoSimd, own_preset.get());
  }
  if (data_ == nullptr) throw std::runtime_error("the plug-in makes no filter");
  unsigned width = 0, height = 0;
  library_->query_output_size(data_, &width, &height, max_width, max_height);
  buffer_ =
      std::make_unique<std::vector<std::uint8_t>>(std::size_t{4} * width * height + kGuardBytes, kGuard);
}

SoftfilterHost::~SoftfilterHost() {
  library_->destroy(data_);
}

Picture SoftfilterHost::filter(const CoreFrame& frame) {
  return filter(frame, frame.pitch);
}

Picture SoftfilterHost::filter(const CoreFrame& frame, std::size_t claimed_pitch) {
  unsigned width = 0, height = 0;
  library_->query_output_size(data_, &width, &height, frame.width, frame.height);
  Picture picture(static_cast<int>(width), static_cast<int>(height));
  const std::size_t size = 4 * picture.pixels.size();
  if (size + kGuardBytes > buffer_->size()) throw std::runtime_error("a picture has no room in the buffer");

  std::vector<softfilter::Packet> packets(library_->query_num_threads(data_));
  library_->get_work_packets(data_, packets.data(), buffer_->data(), std::size_t{4} * width,
                             frame.bytes.data(), frame.width, frame.height, claimed_pitch);
  std::vector<std::thread> workers;
  workers.reserve(packets.size());
  for (const softfilter::Packet& packet : packets) {
    workers.emplace_back([&] { packet.work(data_, packet.thread_data); });
  }
  for (std::thread& worker : workers) worker.join();

  if (std::any_of(buffer_->end() - kGuardBytes, buffer_->end(), [](auto byte) { return byte != kGuard; })) {
    throw std::runtime_error("the plug-in writes beyond the buffer");
  }
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const std::uint8_t* bytes = buffer_->data() + 4 * i;
    picture.pixels[i] = {bytes[2], bytes[1], bytes[0], bytes[3]};
  }
  return picture;
}

void SoftfilterHost::scribble() {
  for (std::size_t i = 0; i + kGuardBytes < buffer_->size(); ++i)
    (*buffer_)[i] = static_cast<std::uint8_t>(i);
}

void SoftfilterHost::move_buffer() {
  buffer_ = std::make_unique<std::vector<std::uint8_t>>(*buffer_);
}

}  // namespace depixel::test
