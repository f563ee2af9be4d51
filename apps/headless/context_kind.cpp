#include "apps/headless/context_kind.hpp"

#include <fmt/core.h>

#include <array>
#include <string>

namespace depixel {
namespace {

constexpr std::array<std::string_view, 2> kNames{"egl", "osmesa"};
constexpr std::array<decltype(&create_egl_context), 2> kCreators{create_egl_context, create_osmesa_context};

}  // namespace

std::span<const std::string_view> context_kind_names() {
  return kNames;
}

tl::expected<std::unique_ptr<HeadlessContext>, Error> create_headless_context(
    std::optional<ContextKind> kind, HeadlessContext::Wanted wanted) {
  std::string reasons;
  for (std::size_t i = 0; i < kCreators.size(); ++i) {
    if (kind && static_cast<std::size_t>(*kind) != i) continue;
    auto context = kCreators[i](wanted);
    if (context) return context;
    reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", kNames[i], context.error().message);
  }
  return tl::unexpected(
      Error{fmt::format("There is no OpenGL context to be had without a display ({}).", reasons)});
}

}  // namespace depixel
