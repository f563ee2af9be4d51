#include <GL/osmesa.h>

#include <array>

#include "apps/headless/context_kind.hpp"

namespace depixel {
namespace {

class OsmesaContext final : public HeadlessContext {
 public:
  explicit OsmesaContext(OSMesaContext context) : context_(context) {}
  ~OsmesaContext() override {
    if (OSMesaGetCurrentContext() == context_) OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    OSMesaDestroyContext(context_);
  }

  bool make_current() override {
    return OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_TRUE;
  }
  GlLoader loader() const override { return OSMesaGetProcAddress; }

 private:
  static constexpr int kSide = 16;  ///< of the default framebuffer, which nobody draws to

  OSMesaContext context_;
  std::array<unsigned char, 4 * kSide * kSide> buffer_{};
};

}  // namespace

tl::expected<std::unique_ptr<HeadlessContext>, Error> create_osmesa_context(HeadlessContext::Wanted wanted) {
  if (wanted.es || wanted.debug) return tl::unexpected(Error{"neither OpenGL ES nor debugging"});
  constexpr std::array<int, 9> kAttributes{OSMESA_FORMAT,
                                           OSMESA_RGBA,
                                           OSMESA_PROFILE,
                                           OSMESA_CORE_PROFILE,
                                           OSMESA_CONTEXT_MAJOR_VERSION,
                                           3,
                                           OSMESA_CONTEXT_MINOR_VERSION,
                                           3,
                                           0};
  const OSMesaContext context = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
  if (context == nullptr) return tl::unexpected(Error{"no core profile of OpenGL 3.3"});
  auto result = std::make_unique<OsmesaContext>(context);
  if (!result->make_current()) return tl::unexpected(Error{"it cannot be made current"});
  return result;
}

}  // namespace depixel
