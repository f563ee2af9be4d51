#include <fmt/core.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <variant>

#include "apps/common/exit_codes.hpp"
#include "apps/depixel/command_line.hpp"
#include "apps/depixel/convert.hpp"

int main(int argc, char** argv) {
  using namespace depixel;
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error like any other
  try {
    const auto parsed = parse_command_line(argc, argv);
    if (const int* exit_code = std::get_if<int>(&parsed)) return *exit_code;
    return convert(std::get<Arguments>(parsed));
  } catch (const std::bad_alloc&) {
    std::fputs("depixel: There is not enough memory.\n", stderr);
  } catch (const std::exception& error) {
    fmt::print(stderr, "depixel: Something unexpected happened: {}.\n", error.what());
  }
  return kExitFailed;
}
