#pragma once

#include <string_view>
#include <tl/expected.hpp>

#include "filter/gl/gl_object.hpp"
#include "libdepixel/core/error.hpp"

namespace depixel {

/// Compiles and links a program. The sources are without their first lines, which depend on the context: core
/// profile 3.3 or ES 3.0. \return an error with the driver's text.
tl::expected<GlProgram, Error> link_program(const GladGLContext& gl, std::string_view vertex_source,
                                            std::string_view fragment_source);

}  // namespace depixel
