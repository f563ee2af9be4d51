#include <GL/osmesa.h>

#include <array>
#include <optional>

#include "apps/headless/context_kind.hpp"
#include "filter/headless/shared_library.hpp"

namespace depixel {
namespace {

/// OSMesa's functions, from the library that the machine has.
struct OsmesaLibrary {
  decltype(&OSMesaCreateContextAttribs) create_context;
  decltype(&OSMesaDestroyContext) destroy_context;
  decltype(&OSMesaMakeCurrent) make_current;
  decltype(&OSMesaGetCurrentContext) get_current_context;
  decltype(&OSMesaGetProcAddress) get_proc_address;

  /// nullptr where there is none.
  static const OsmesaLibrary* get() {
    static const std::optional<OsmesaLibrary> kLibrary = load();
    return kLibrary ? &*kLibrary : nullptr;
  }

 private:
  static std::optional<OsmesaLibrary> load() {
    SharedLibrary file("libOSMesa.so.8");
    OsmesaLibrary library{};
    file.find(library.create_context, "OSMesaCreateContextAttribs");
    file.find(library.destroy_context, "OSMesaDestroyContext");
    file.find(library.make_current, "OSMesaMakeCurrent");
    file.find(library.get_current_context, "OSMesaGetCurrentContext");
    file.find(library.get_proc_address, "OSMesaGetProcAddress");
    return file.has_all() ? std::optional(library) : std::nullopt;
  }
};

class OsmesaContext final : public HeadlessContext {
 public:
  OsmesaContext(const OsmesaLibrary& osmesa, OSMesaContext context) : osmesa_(osmesa), context_(context) {}
  ~OsmesaContext() override {
    if (osmesa_.get_current_context() == context_) osmesa_.make_current(nullptr, nullptr, 0, 0, 0);
    osmesa_.destroy_context(context_);
  }

  bool make_current() override {
    return osmesa_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_TRUE;
  }
  GlLoader loader() const override { return osmesa_.get_proc_address; }

 private:
  static constexpr int kSide = 16;  ///< of the default framebuffer, which nobody draws to

  const OsmesaLibrary& osmesa_;
  OSMesaContext context_;
  std::array<unsigned char, 4 * kSide * kSide> buffer_{};
};

}  // namespace

tl::expected<std::unique_ptr<HeadlessContext>, Error> create_osmesa_context(HeadlessContext::Wanted wanted) {
  if (wanted.es || wanted.debug) return tl::unexpected(Error{"neither OpenGL ES nor debugging"});
  const OsmesaLibrary* osmesa = OsmesaLibrary::get();
  if (osmesa == nullptr) return tl::unexpected(Error{"there is no libOSMesa"});
  constexpr std::array<int, 9> kAttributes{OSMESA_FORMAT,
                                           OSMESA_RGBA,
                                           OSMESA_PROFILE,
                                           OSMESA_CORE_PROFILE,
                                           OSMESA_CONTEXT_MAJOR_VERSION,
                                           3,
                                           OSMESA_CONTEXT_MINOR_VERSION,
                                           3,
                                           0};
  const OSMesaContext context = osmesa->create_context(kAttributes.data(), nullptr);
  if (context == nullptr) return tl::unexpected(Error{"no core profile of OpenGL 3.3"});
  auto result = std::make_unique<OsmesaContext>(*osmesa, context);
  if (!result->make_current()) return tl::unexpected(Error{"it cannot be made current"});
  return result;
}

}  // namespace depixel
