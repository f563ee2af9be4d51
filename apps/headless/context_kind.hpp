#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <tl/expected.hpp>

#include "filter/headless/headless_context.hpp"

namespace depixel {

/// Where a context without a display comes from.
enum class ContextKind {
  egl,    ///< EGL without surfaces
  osmesa  ///< Mesa's software rasteriser in memory
};

/// Names as on the command line; names[i] stands for enumerator i.
std::span<const std::string_view> context_kind_names();

/// Makes a context and makes it current on this thread.
/// \param kind  none: each is tried, EGL first. \return an error that says why each failed.
tl::expected<std::unique_ptr<HeadlessContext>, Error> create_headless_context(
    std::optional<ContextKind> kind = {}, HeadlessContext::Wanted wanted = {});

/// The second kind, as create_egl_context() is the first.
tl::expected<std::unique_ptr<HeadlessContext>, Error> create_osmesa_context(HeadlessContext::Wanted wanted);

}  // namespace depixel
