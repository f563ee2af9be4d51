#pragma once

#include <cstddef>

/// The interface of RetroArch's video filters ("softfilters"), version 2, as version 1.14 uses it. A library
/// exports softfilter_get_implementation().
namespace depixel::softfilter {

constexpr unsigned kApiVersion = 2;
constexpr const char* kEntryPoint = "softfilter_get_implementation";
/// Formats are bits, pixels are native words.
constexpr unsigned kRgb565 = 1, kXrgb8888 = 2;

/// Reads a filter's settings. Each returns 0 where a key is absent and the default is handed out. Arrays and
/// strings are copies, to be released by free().
struct Config {
  int (*get_float)(void* userdata, const char* key, float* value, float fallback);
  int (*get_int)(void* userdata, const char* key, int* value, int fallback);
  int (*get_hex)(void* userdata, const char* key, unsigned* value, unsigned fallback);
  int (*get_float_array)(void* userdata, const char* key, float** values, unsigned* count,
                         const float* fallback, unsigned fallback_count);
  int (*get_int_array)(void* userdata, const char* key, int** values, unsigned* count, const int* fallback,
                       unsigned fallback_count);
  int (*get_string)(void* userdata, const char* key, char** value, const char* fallback);
  void (*free)(void* value);
};

/// A part of the work on a frame, for one thread.
struct Packet {
  void (*work)(void* data, void* thread_data);
  void* thread_data;
};

/// What a library can do. data is what create() returned; pitches are in bytes.
struct Implementation {
  unsigned (*query_input_formats)();
  unsigned (*query_output_formats)(unsigned input_format);
  void* (*create)(const Config* config, unsigned input_format, unsigned output_format, unsigned max_width,
                  unsigned max_height, unsigned threads, unsigned simd, void* userdata);
  void (*destroy)(void* data);
  unsigned (*query_num_threads)(void* data);
  void (*query_output_size)(void* data, unsigned* out_width, unsigned* out_height, unsigned width,
                            unsigned height);
  void (*get_work_packets)(void* data, Packet* packets, void* output, std::size_t output_pitch,
                           const void* input, unsigned width, unsigned height, std::size_t input_pitch);
  unsigned api_version;
  const char* ident;
  const char* short_ident;
};

/// \param simd  RetroArch's bits of what the processor can do; 0 is always safe.
using GetImplementation = const Implementation* (*)(unsigned simd);

}  // namespace depixel::softfilter
