#include "bench/peers/xbrz_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

namespace depixel::bench {
namespace {

/// A new folder that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "depixel-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("Cannot make a folder for temporary files.");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs a program found on the search path, its output thrown away; true where it ended with status 0.
bool run_silently(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  }
  pid_t child = 0;
  const int failed = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  return !failed && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

bool has_xbrzscale() {
  static const bool kFound = [] {
    try {
      return run_xbrzscale(Picture(4, 4), 2).width() == 8;
    } catch (const std::runtime_error&) {
      return false;
    }
  }();
  return kFound;
}

Picture run_xbrzscale(const Picture& picture, int scale) {
  const TemporaryFolder folder;
  const auto input = folder.path() / "in.png", output = folder.path() / "out.png";
  write_png(picture, input);
  if (!run_silently({"xbrzscale", std::to_string(scale), input.string(), output.string()})) {
    throw std::runtime_error("The program xbrzscale is missing or failed.");
  }
  return read_picture(output);
}

}  // namespace depixel::bench
