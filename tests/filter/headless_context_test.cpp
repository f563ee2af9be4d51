#include <string>

#include "apps/headless/context_kind.hpp"
#include "tests/filter/gl_fixture.hpp"

namespace depixel::test {
namespace {

/// Clears a framebuffer on a context and reads it back.
void expect_that_it_draws(const GlContext& context) {
  ASSERT_TRUE(context.context->make_current());
  const TestFramebuffer framebuffer(context.gl, 3, 2);
  framebuffer.clear(1, 0.5, 0, 1);
  const Picture picture = framebuffer.read();
  for (const Rgba c : picture.pixels) {
    EXPECT_EQ(c.r, 255);
    EXPECT_NEAR(c.g, 127.5, 1);
    EXPECT_EQ(c.b, 0);
  }
}

class HeadlessContextOf : public testing::TestWithParam<ContextKind> {};

TEST_P(HeadlessContextOf, IsACoreProfileThatDraws) {
  const GlContext context(GetParam());
  EXPECT_NE(context.gl.VERSION_3_3, 0);
  GLint profile = 0;
  context.gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_NE(profile & GL_CONTEXT_CORE_PROFILE_BIT, 0);
  expect_that_it_draws(context);
  const bool is_egl = GetParam() == ContextKind::egl;
  const auto same_kind = is_egl ? create_egl_context({}) : create_osmesa_context({});
  ASSERT_TRUE(same_kind);
  EXPECT_EQ(context.context->loader(), (*same_kind)->loader());
}

TEST_P(HeadlessContextOf, LivesBesideAnotherAndAfterIt) {
  const GlContext first(GetParam());
  {
    const GlContext second(GetParam());
    expect_that_it_draws(second);
    expect_that_it_draws(first);
  }
  expect_that_it_draws(first);
  const GlContext third(GetParam());
  expect_that_it_draws(third);
}

INSTANTIATE_TEST_SUITE_P(Kinds, HeadlessContextOf, testing::Values(ContextKind::egl, ContextKind::osmesa),
                         [](const auto& test) { return std::string(context_kind_names()[int(test.param)]); });

TEST(HeadlessContext, OfBothKindsLiveInOneProcess) {
  const GlContext osmesa(ContextKind::osmesa), egl(ContextKind::egl);
  EXPECT_NE(osmesa.context->loader(), egl.context->loader());
  expect_that_it_draws(osmesa);
  expect_that_it_draws(egl);
}

TEST(HeadlessContext, IsOfOpenGlEsWhereWanted) {
  const GlContext context({}, {.es = true});
  EXPECT_NE(context.gl.ES_VERSION_3_0, 0);
  expect_that_it_draws(context);
}

TEST(HeadlessContext, SaysWhyThereIsNone) {
  const auto context = create_headless_context(ContextKind::osmesa, {.es = true});
  ASSERT_FALSE(context);
  EXPECT_EQ(
      context.error().message,
      "There is no OpenGL context to be had without a display (osmesa: neither OpenGL ES nor debugging).");
}

}  // namespace
}  // namespace depixel::test
