#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "libdepixel/core/error.hpp"

namespace depixel {

/// The files that a command line's inputs stand for.
struct Inputs {
  std::vector<std::filesystem::path> files;  ///< "-" is standard input
  bool sequence = false;  ///< more than one, or asked for as a folder or a numbered pattern
};

/// Finds the files: a folder stands for the pictures in it (by ending, not in its subfolders), a pattern such
/// as frame_%04d.png for the files so numbered, each sorted naturally; anything else stands for itself, in
/// the order given. A file whose name looks like a pattern but exists is itself.
tl::expected<Inputs, Error> find_inputs(const std::vector<std::string>& arguments);

}  // namespace depixel
