// RetroArch's video filter: its calls, handed on to HostFilter.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>

#include "filter/host/host_filter.hpp"
#include "libretro_glue/softfilter_interface.hpp"

namespace depixel {
namespace {

using softfilter::Config;
using softfilter::Packet;

void tell(const std::string& sentence) {
  std::fprintf(stderr, "depixel: %s\n", sentence.c_str());
}

/// What create() makes: a filter, and the work that is given to it next.
struct Instance {
  HostFilter filter;
  HostFormat format;
  HostFrame frame;
  void* output = nullptr;
  std::size_t output_pitch = 0;
};

/// A side of a frame as a number that the filter takes; it cuts frames to the declared maximum anyway.
int side(unsigned pixels) {
  return static_cast<int>(std::min<unsigned>(pixels, HostFilter::kMaxOutputSide));
}

Instance& instance(void* data) {
  return *static_cast<Instance*>(data);
}

/// A setting, as RetroArch hands it out: absent where it is the empty default.
std::optional<std::string> text_of(const Config& config, void* userdata, const std::string& key) {
  char* value = nullptr;
  config.get_string(userdata, key.c_str(), &value, "");
  if (value == nullptr) return std::nullopt;
  const std::string text = value;
  config.free(value);
  return text.empty() ? std::nullopt : std::optional(text);
}

unsigned input_formats() {
  return softfilter::kRgb565 | softfilter::kXrgb8888;
}

/// The sixteen bits of the other format would lose colours.
unsigned output_formats(unsigned) {
  return softfilter::kXrgb8888;
}

/// The output format that is passed is the input's; the one that was offered is meant.
void* create(const Config* config, unsigned input_format, unsigned, unsigned max_width, unsigned max_height,
             unsigned threads, unsigned, void* userdata) try {
  constexpr unsigned kMaxSide = HostFilter::kMaxOutputSide;
  if (max_width < 1 || max_height < 1 || max_width > kMaxSide || max_height > kMaxSide) {
    tell("Frames of up to " + std::to_string(max_width) + " x " + std::to_string(max_height) +
         " pixels cannot be filtered: at least 1 and at most " + std::to_string(kMaxSide) + " a side can.");
    return nullptr;
  }
  if (input_format != softfilter::kRgb565 && input_format != softfilter::kXrgb8888) {
    tell("Frames of the format " + std::to_string(input_format) + " cannot be filtered.");
    return nullptr;
  }
  HostSettings settings =
      read_host_settings([&](const std::string& key) { return text_of(*config, userdata, key); }, tell);
  if (threads > 0) settings.options.threads = std::min(settings.options.threads, static_cast<int>(threads));
  return new Instance{HostFilter(settings, static_cast<int>(max_width), static_cast<int>(max_height), tell),
                      input_format == softfilter::kRgb565 ? HostFormat::rgb565 : HostFormat::xrgb8888,
                      {}};
} catch (const std::exception& error) {
  tell(std::string("The filter cannot be made: ") + error.what() + ".");
  return nullptr;
}

void destroy(void* data) {
  delete static_cast<Instance*>(data);
}

/// One packet, which RetroArch runs on the calling thread. Threads of the filter's own share its work: they
/// end in destroy(), where RetroArch's would outlive the library.
unsigned num_threads(void*) {
  return 1;
}

void output_size(void* data, unsigned* out_width, unsigned* out_height, unsigned width, unsigned height) {
  const HostFilter::Size size = instance(data).filter.output_size(side(width), side(height));
  *out_width = static_cast<unsigned>(size.width);
  *out_height = static_cast<unsigned>(size.height);
}

void work(void* data, void*) try {
  Instance& self = instance(data);
  self.filter.draw(self.frame, self.output, self.output_pitch);
} catch (const std::exception& error) {
  tell(std::string("A frame cannot be drawn: ") + error.what() + ".");
}

void get_work_packets(void* data, Packet* packets, void* output, std::size_t output_pitch, const void* input,
                      unsigned width, unsigned height, std::size_t input_pitch) {
  Instance& self = instance(data);
  self.frame = {input, side(width), side(height), input_pitch, self.format};
  self.output = output;
  self.output_pitch = output_pitch;
  packets[0] = {work, nullptr};
}

constexpr softfilter::Implementation kImplementation{
    input_formats,    output_formats,          create,    destroy,  num_threads, output_size,
    get_work_packets, softfilter::kApiVersion, "Depixel", "depixel"};

}  // namespace
}  // namespace depixel

extern "C" __attribute__((visibility("default"))) const depixel::softfilter::Implementation*
softfilter_get_implementation(unsigned /*simd*/) {
  return &depixel::kImplementation;
}
