#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <filesystem>
#include <string>

#include "filter/frame_filter.hpp"
#include "tests/filter/gl_fixture.hpp"
#include "tests/support/random_sequences.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

constexpr double kMeanTolerance = 0.5;
constexpr int kTolerance = 4;
/// Near black, a level of linear light is many of sRGB.
constexpr int kLightTolerance = 12;

std::unique_ptr<FrameFilter> gl_filter(const GlContext& context) {
  auto filter = FrameFilter::gl(context.context->loader());
  if (!filter) throw std::runtime_error(filter.error().message);
  return std::move(*filter);
}

Picture drawn(FrameFilter& filter, const View& view, int width, int height) {
  Picture picture(width, height);
  const auto result = filter.draw(picture.target(), {0, 0, width, height}, view);
  EXPECT_TRUE(result) << result.error().message;
  return picture;
}

/// Empty if both filters draw the same picture, else how they differ; the pictures are then left on disk.
std::string mismatch(FrameFilter& gl, FrameFilter& cpu, const View& view, int width, int height,
                     int tolerance) {
  const Picture expected = drawn(cpu, view, width, height), actual = drawn(gl, view, width, height);
  const PictureDifference difference = compare(premultiplied(expected), premultiplied(actual));
  if (difference.mean <= kMeanTolerance && difference.largest <= tolerance) return "";
  save_picture(output_folder() / "gl" / "expected.png", expected);
  save_picture(output_folder() / "gl" / "actual.png", actual);
  return "scale " + std::to_string(view.scale_x) + ": mean difference " + std::to_string(difference.mean) +
         ", largest " + std::to_string(difference.largest) + "; see " + output_folder().string() + "/gl";
}

class GlFilterOn : public testing::TestWithParam<ContextKind> {};

TEST_P(GlFilterOn, DrawsShippedPicturesAsTheProcessorDoes) {
  const GlContext context(GetParam());
  const auto gl = gl_filter(context), cpu = FrameFilter::cpu();
  for (const char* folder : {"frames", "sprites"}) {
    for (const auto& file : std::filesystem::directory_iterator(data_folder() / folder)) {
      const Picture picture = load_picture(file.path());
      for (const auto& filter : {gl.get(), cpu.get()}) ASSERT_TRUE(filter->submit(picture.view(), {}));
      for (const double scale : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 7.3}) {
        const int width = std::min(int(picture.width * scale), 900);
        EXPECT_EQ(mismatch(*gl, *cpu, {scale, scale, 0, 0}, width, 300, kTolerance), "") << file.path();
      }
      EXPECT_EQ(mismatch(*gl, *cpu, {3.7, 2.9, -3.3, 5.21}, 500, 300, kTolerance), "") << file.path();
      EXPECT_EQ(mismatch(*gl, *cpu, {40, 33, 2.3, 1.7}, 300, 300, kTolerance), "") << file.path();
      EXPECT_EQ(mismatch(*gl, *cpu, {0.5, 0.4, -2.5, -1.1}, 200, 150, kTolerance), "") << file.path();
    }
  }
}

TEST_P(GlFilterOn, DrawsRandomViewsOfRandomPicturesAsTheProcessorDoes) {
  const GlContext context(GetParam());
  const auto gl = gl_filter(context), cpu = FrameFilter::cpu();
  EXPECT_TRUE(rc::check([&](const Picture& picture) {
    Options options = *random_options();
    options.border = *random_border();
    for (const auto& filter : {gl.get(), cpu.get()})
      RC_ASSERT(filter->submit(picture.view(), options).has_value());
    const auto scale = [] { return *rc::gen::inRange(1, 160) / 8.0; };
    const auto origin = [] { return *rc::gen::inRange(-40, 160) / 8.0; };
    const View view{scale(), scale(), origin(), origin()};
    const std::string found =
        mismatch(*gl, *cpu, view, 61, 47, options.linear_light ? kLightTolerance : kTolerance);
    if (!found.empty()) RC_FAIL(found);
  }));
}

TEST_P(GlFilterOn, ShowsNothingBeyondABorderThatContinues) {
  constexpr View kView{3.5, 4, -2, -1.6};  // output pixels 7 to 21 and 6.4 to 18.4
  const GlContext context(GetParam());
  const auto gl = gl_filter(context), cpu = FrameFilter::cpu();
  const Picture picture = ascii_picture({"#..#", ".rr.", ".#.#"});
  for (const auto& filter : {gl.get(), cpu.get()}) {
    ASSERT_TRUE(filter->submit(picture.view(), {.border = BorderKind::repeat}));
    Picture out(30, 24, {9, 9, 9, 9});
    ASSERT_TRUE(filter->draw(out.target(), {0, 0, out.width, out.height}, kView));
    for (int y = 0; y < out.height; ++y) {
      for (int x = 0; x < out.width; ++x) {
        const bool is_inside = x >= 7 && x < 21 && y >= 6 && y < 18;
        EXPECT_EQ(out.at(x, y).a, is_inside ? 255 : 0) << x << ' ' << y;
      }
    }
  }
  const TestFramebuffer framebuffer(context.gl, 40, 30);
  framebuffer.clear(0, 0, 1, 1);
  ASSERT_TRUE(gl->draw(GlFramebuffer{framebuffer.name()}, {5, 3, 30, 24}, kView));
  Picture expected(40, 30, {0, 0, 255, 255});
  ASSERT_TRUE(cpu->draw(expected.target(), {5, 3, 30, 24}, kView));
  EXPECT_LE(compare(premultiplied(expected), premultiplied(framebuffer.read())).largest, kTolerance);
}

TEST_P(GlFilterOn, DrawsToAPartOfAFramebuffer) {
  const GlContext context(GetParam());
  const auto filter = gl_filter(context), cpu = FrameFilter::cpu();
  const Picture picture = ascii_picture({"#..#", ".rr.", ".#_#"});
  for (const auto& each : {filter.get(), cpu.get()}) ASSERT_TRUE(each->submit(picture.view(), {}));
  const TestFramebuffer framebuffer(context.gl, 40, 30);
  framebuffer.clear(0, 0, 1, 1);
  ASSERT_TRUE(filter->draw(GlFramebuffer{framebuffer.name()}, {5, 7, 20, 15}, {5, 5, 0, 0}));
  Picture expected(40, 30);
  for (Rgba& c : expected.pixels) c = {0, 0, 255, 255};
  ASSERT_TRUE(cpu->draw(expected.target(), {5, 30 - 7 - 15, 20, 15}, {5, 5, 0, 0}));
  EXPECT_LE(compare(premultiplied(expected), premultiplied(framebuffer.read())).largest, kTolerance);
}

TEST_P(GlFilterOn, SurvivesResizeStorms) {
  const GlContext context(GetParam());
  const auto gl = gl_filter(context), cpu = FrameFilter::cpu();
  for (int i = 0; i < 60; ++i) {
    const Picture picture = i % 3 == 0 ? ascii_picture({"#"}) : ascii_picture({"#.#.#", ".#r#.", "##..b"});
    for (const auto& filter : {gl.get(), cpu.get()}) ASSERT_TRUE(filter->submit(picture.view(), {}));
    const int width = 1 + i * 37 % 211, height = 1 + i * 53 % 173;
    const View view = View::fit(cpu->vectorizer().map().lattice, width, height);
    EXPECT_EQ(mismatch(*gl, *cpu, view, width, height, kTolerance), "") << i;
  }
}

TEST_P(GlFilterOn, ComesBackAfterItsContextWasLost) {
  auto first = std::make_unique<GlContext>(GetParam());
  const auto gl = gl_filter(*first), cpu = FrameFilter::cpu();
  const Picture picture = ascii_picture({"#.#", ".#.", "r#."});
  for (const auto& filter : {gl.get(), cpu.get()}) ASSERT_TRUE(filter->submit(picture.view(), {}));
  EXPECT_EQ(mismatch(*gl, *cpu, {7, 7, 0, 0}, 21, 21, kTolerance), "");
  gl->context_lost();
  first.reset();
  const GlContext second(GetParam());
  EXPECT_EQ(mismatch(*gl, *cpu, {7, 7, 0, 0}, 21, 21, kTolerance), "");
}

TEST_P(GlFilterOn, SharesAContextWithAnother) {
  const GlContext context(GetParam());
  const auto one = gl_filter(context), two = gl_filter(context), cpu_one = FrameFilter::cpu(),
             cpu_two = FrameFilter::cpu();
  const Picture first = ascii_picture({"#.", ".#"}), second = ascii_picture({"rrr", "rgr", "rrr"});
  ASSERT_TRUE(one->submit(first.view(), {}));
  ASSERT_TRUE(cpu_one->submit(first.view(), {}));
  ASSERT_TRUE(two->submit(second.view(), {}));
  ASSERT_TRUE(cpu_two->submit(second.view(), {}));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(mismatch(*one, *cpu_one, {9, 9, 0, 0}, 18, 18, kTolerance), "");
    EXPECT_EQ(mismatch(*two, *cpu_two, {9, 9, 0, 0}, 27, 27, kTolerance), "");
  }
}

TEST_P(GlFilterOn, DrawsSequencesAsAFreshFilterDoes) {
  const GlContext context(GetParam());
  constexpr int kSequences = 12;
  const auto gl = gl_filter(context);
  for (unsigned seed = 0; seed < kSequences; ++seed) {
    const Sequence sequence = fixed_sequence(seed, {.max_width = 60, .max_height = 40, .steps = 12});
    for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
      const SequenceFrame& frame = sequence.frames[i];
      ASSERT_TRUE(gl->submit(frame.picture.view(), frame.options));
      if (i % 5 == 3) continue;  // two frames between two pictures
      gl->check_incremental(true);
      const View view{seed % 2 == 0 ? 4.0 : 2.3, 3, double(i) / 4, 0};
      const Picture actual = drawn(*gl, view, 150, 110);
      gl->check_incremental(false);
      const auto fresh = gl_filter(context);
      ASSERT_TRUE(fresh->submit(frame.picture.view(), frame.options));
      ASSERT_TRUE(actual == drawn(*fresh, view, 150, 110)) << "sequence " << seed << ", frame " << i;
    }
  }
}

TEST_P(GlFilterOn, SendsOnlyWhatChanged) {
  const GlContext context(GetParam());
  const auto gl = gl_filter(context);
  Picture picture = load_picture(data_folder() / "frames" / "alex4_0036.png");
  const auto sent = [&](double scale = 3) {
    EXPECT_TRUE(gl->submit(picture.view(), {}));
    const Picture actual = drawn(*gl, {scale, 3, 0, 0}, 400, 300);
    const std::size_t bytes = gl->stats().upload_bytes;
    const auto fresh = gl_filter(context);
    EXPECT_TRUE(fresh->submit(picture.view(), {}));
    EXPECT_TRUE(actual == drawn(*fresh, {scale, 3, 0, 0}, 400, 300));
    return bytes;
  };
  const std::size_t all = sent();
  EXPECT_GE(all, 16 * picture.pixels.size());
  EXPECT_EQ(sent(), 0u);
  EXPECT_EQ(gl->stats().prepare_ns, 0);
  paste(picture, Picture(3, 3, palette_colour('r')), 70, 50);
  const std::size_t little = sent();
  EXPECT_GT(little, 0u);
  EXPECT_LT(20 * little, all);
  EXPECT_GE(sent(4), 16 * picture.pixels.size());
}

/// New lines come after the others until most of them are nobody's; so textures grow on the way.
TEST_P(GlFilterOn, DrawsWhatWasSentWhileTexturesGrew) {
  constexpr int kSize = 244, kBlock = 61;
  const GlContext context(GetParam());
  const auto gl = gl_filter(context), fresh = gl_filter(context);
  std::uint32_t state = 1;
  const auto noise = [&](int size) {
    Picture picture(size, size);
    for (Rgba& c : picture.pixels) {
      state = state * 1664525 + 1013904223;
      c = palette_colour(".#rg"[state >> 30]);
    }
    return picture;
  };
  Picture picture = noise(kSize);
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (int frame = 0; frame < 24; ++frame) {
    paste(picture, noise(kBlock), frame % 4 * kBlock, frame / 4 % 4 * kBlock);
    for (const auto& filter : {gl.get(), fresh.get()}) ASSERT_TRUE(filter->submit(picture.view(), {}));
    drawn(*fresh, {5, 5, 0, 0}, 1, 1);  // at another scale: next, it sends all
    ASSERT_TRUE(drawn(*gl, {2, 2, 0, 0}, 400, 400) == drawn(*fresh, {2, 2, 0, 0}, 400, 400)) << frame;
    least = std::min(least, gl->stats().upload_bytes);
  }
  EXPECT_LT(4 * least, fresh->stats().upload_bytes);
}

TEST_P(GlFilterOn, SendsAllAfterItsContextWasLost) {
  auto first = std::make_unique<GlContext>(GetParam());
  const auto gl = gl_filter(*first);
  Picture picture = load_picture(data_folder() / "frames" / "alex4_0036.png");
  ASSERT_TRUE(gl->submit(picture.view(), {}));
  drawn(*gl, {3, 3, 0, 0}, 400, 300);
  for (const bool is_changed : {false, true}) {
    gl->context_lost();
    auto second = std::make_unique<GlContext>(GetParam());
    first = std::move(second);
    ASSERT_TRUE(first->context->make_current());
    if (is_changed) {
      paste(picture, Picture(3, 3, palette_colour('r')), 70, 50);
      ASSERT_TRUE(gl->submit(picture.view(), {}));
    }
    const Picture actual = drawn(*gl, {3, 3, 0, 0}, 400, 300);
    EXPECT_GE(gl->stats().upload_bytes, 16 * picture.pixels.size());
    const auto fresh = gl_filter(*first);
    ASSERT_TRUE(fresh->submit(picture.view(), {}));
    EXPECT_TRUE(actual == drawn(*fresh, {3, 3, 0, 0}, 400, 300)) << is_changed;
  }
}

INSTANTIATE_TEST_SUITE_P(Contexts, GlFilterOn, testing::Values(ContextKind::egl, ContextKind::osmesa),
                         [](const auto& test) { return std::string(context_kind_names()[int(test.param)]); });

TEST(GlFilter, DrawsOnOpenGlEs) {
  const GlContext context({}, {.es = true});
  const auto gl = gl_filter(context), cpu = FrameFilter::cpu();
  const Picture picture = load_picture(data_folder() / "sprites" / "whichwayisup_brown_key_0.png");
  for (const bool linear_light : {false, true}) {
    for (const auto& filter : {gl.get(), cpu.get()}) {
      ASSERT_TRUE(filter->submit(picture.view(), {.linear_light = linear_light}));
    }
    EXPECT_EQ(mismatch(*gl, *cpu, {4.5, 4, 0, 0}, 200, 200, linear_light ? kLightTolerance : kTolerance), "");
  }
}

TEST(GlFilter, MakesTheDriverSayNothing) {
  const GlContext context(ContextKind::egl, {.debug = true});
  std::string said;
  context.gl.Enable(GL_DEBUG_OUTPUT);
  context.gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  context.gl.DebugMessageCallback(
      [](GLenum, GLenum kind, GLuint, GLenum severity, GLsizei, const GLchar* text, const void* to) {
        const bool is_notice = severity == GL_DEBUG_SEVERITY_NOTIFICATION || kind == GL_DEBUG_TYPE_OTHER;
        if (!is_notice) *static_cast<std::string*>(const_cast<void*>(to)) += text;
      },
      &said);
  const auto filter = gl_filter(context);
  for (const auto& rows : {std::vector<std::string_view>{"#.", ".#"}, {"rrr", "r_r", "###"}}) {
    ASSERT_TRUE(filter->submit(ascii_picture(rows).view(), {}));
    drawn(*filter, {8, 8, 0, 0}, 24, 24);
    drawn(*filter, {3, 3, 0, 0}, 9, 9);
  }
  EXPECT_EQ(said, "");
}

TEST(GlFilter, TellsWhatItCannotDo) {
  const GlContext context;
  const auto filter = gl_filter(context);
  Picture picture(8, 8);
  const Viewport whole{0, 0, 8, 8};
  const auto message = [&](const Viewport& viewport, const View& view) {
    const auto result = filter->draw(picture.target(), viewport, view);
    return result ? "" : result.error().message;
  };
  EXPECT_EQ(message(whole, {}), "There is no frame to draw yet.");
  EXPECT_FALSE(filter->submit({nullptr, 4, 4, 16}, {}));
  EXPECT_FALSE(
      filter->submit(FrameView{reinterpret_cast<const std::uint8_t*>(picture.pixels.data()), 0, 3, 0}, {}));
  ASSERT_TRUE(filter->submit(ascii_picture({"#.", ".#"}).view(), {}));
  EXPECT_EQ(message(whole, {1.0 / 32, 1, 0, 0}),
            "OpenGL draws at scales from 0.0625 on, and this is 0.03125 by 1.");
  EXPECT_NE(message(whole, {0, 1, 0, 0}), "");
  EXPECT_NE(message(whole, {1, 1, 1e9, 0}), "");
  EXPECT_NE(message(whole, {std::numeric_limits<double>::quiet_NaN(), 1, 0, 0}), "");
  EXPECT_NE(message({1, 0, 8, 8}, {}), "");
  EXPECT_NE(message({0, 0, -1, 8}, {}), "");
  EXPECT_EQ(message({0, 0, 0, 8}, {}), "");
  EXPECT_EQ(message({8, 8, 0, 0}, {}), "");
}

TEST(GlFilter, NeedsAContext) {
  const auto nothing = [](const char*) -> GlFunction { return nullptr; };
  const auto filter = FrameFilter::gl(nothing);
  ASSERT_FALSE(filter);
  EXPECT_EQ(filter.error().message, "There is no current OpenGL context.");
}

TEST(GlFilter, RefusesOldContexts) {
  static constexpr auto kOldVersion = [](GLenum) { return reinterpret_cast<const GLubyte*>("2.1 Old"); };
  const auto loader = [](const char* name) -> GlFunction {
    const GLubyte* (*get_string)(GLenum) = kOldVersion;
    return std::string_view(name) == "glGetString" ? reinterpret_cast<GlFunction>(get_string) : nullptr;
  };
  const auto filter = FrameFilter::gl(loader);
  ASSERT_FALSE(filter);
  EXPECT_EQ(filter.error().message, "OpenGL 3.3 or OpenGL ES 3.0 is needed, and this is 2.1 Old.");
}

TEST(GlFilter, IsIdleWhereNothingChanged) {
  const GlContext context;
  const auto filter = gl_filter(context);
  ASSERT_TRUE(filter->submit(ascii_picture({"#...", ".#..", "..##"}).view(), {}));
  drawn(*filter, {8, 8, 0, 0}, 16, 16);
  EXPECT_GT(filter->stats().upload_bytes, 0u);
  EXPECT_GT(filter->stats().lines, 0);
  drawn(*filter, {8, 8, 1, 0.5}, 16, 16);  // panned
  EXPECT_EQ(filter->stats().upload_bytes, 0u);
  drawn(*filter, {9, 8, 1, 0.5}, 16, 16);
  EXPECT_GT(filter->stats().upload_bytes, 0u);
}

/// What a filter draws to a picture that it is told is kept, against what one draws that knows nothing
/// before.
void expect_kept_is_as_fresh(const GlContext& context, FrameFilter& filter, const Picture& frame,
                             const Options& options, Picture& kept) {
  constexpr View kView{4, 4, 0, 0};
  const Viewport all{0, 0, kept.width, kept.height};
  ASSERT_TRUE(filter.draw(KeptPicture{kept.target()}, all, kView));
  const auto fresh = gl_filter(context);
  ASSERT_TRUE(fresh->submit(frame.view(), options));
  Picture expected(kept.width, kept.height);
  ASSERT_TRUE(fresh->draw(expected.target(), all, kView));
  EXPECT_TRUE(kept == expected);
}

TEST(GlFilter, ARefusedFrameLeavesNoTrace) {
  const GlContext context;
  const auto filter = gl_filter(context);
  Picture kept(4 * 96, 4 * 48);
  for (const int from : {0, 1}) {
    ASSERT_TRUE(filter->submit(hills({from, 0}).view(), {}));
    expect_kept_is_as_fresh(context, *filter, hills({from, 0}), {}, kept);
  }
  EXPECT_FALSE(filter->submit({}, {}));
  expect_kept_is_as_fresh(context, *filter, hills({1, 0}), {}, kept);
}

TEST(GlFilter, KeptPicturesTakeOnAnotherLight) {
  const GlContext context;
  Options options;
  options.similarity = Similarity::merge;
  for (const ShadingKind shading : {ShadingKind::none, ShadingKind::gradient}) {
    options.shading = shading;
    const auto filter = gl_filter(context);
    Picture kept(4 * 96, 4 * 48);
    for (const bool linear_light : {false, true, false}) {
      options.linear_light = linear_light;
      ASSERT_TRUE(filter->submit(hills({0, 0}).view(), options));
      expect_kept_is_as_fresh(context, *filter, hills({0, 0}), options, kept);
    }
  }
}

}  // namespace
}  // namespace depixel::test
