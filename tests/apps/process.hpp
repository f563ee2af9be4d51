#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace depixel::test {

/// How a process ended and what it said.
struct Ended {
  int exit_code = -1;  ///< negative: killed by that signal
  std::string out, err;

  /// Whether standard error is what every error must be: one sentence on one line, with the program's name
  /// before it.
  bool is_one_sentence(std::string_view program = "depixel") const {
    return err.starts_with(std::string(program) + ": ") && err.ends_with(".\n") &&
           err.find('\n') == err.size() - 1;
  }
};

/// Runs a program, found along PATH, and waits for its end. One that hangs is killed after a minute.
/// \param standard_input  what the process reads there.
Ended run_program(const std::string& program, const std::vector<std::string>& arguments,
                  std::string_view standard_input = {});

/// Runs depixel.
inline Ended run_depixel(const std::vector<std::string>& arguments, std::string_view standard_input = {}) {
  return run_program(DEPIXEL_PROGRAM, arguments, standard_input);
}

/// A folder of its own for a test, removed with what is in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }
  /// The path of something in the folder.
  std::string operator/(std::string_view name) const { return (path_ / name).string(); }
  /// The names of all that is in the folder (not in its subfolders), hidden files too, sorted.
  std::vector<std::string> names(std::string_view subfolder = ".") const;

 private:
  std::filesystem::path path_;
};

std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace depixel::test
