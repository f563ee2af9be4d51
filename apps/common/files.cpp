#include "apps/common/files.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "apps/common/limits.hpp"

namespace depixel {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
  return std::generic_category().message(error);
}

/// An open file descriptor, closed at the end of its life.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  explicit operator bool() const { return fd_ >= 0; }
  int get() const { return fd_; }
  /// \return false if the system reports here that an earlier write failed.
  bool close() { return fd_ < 0 || ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

/// How a file is named in sentences.
std::string name_of(const fs::path& path) {
  return path == "-" ? "standard input" : path.string();
}

tl::unexpected<Error> unreadable(const fs::path& path, int error) {
  return tl::unexpected(Error{fmt::format("{} cannot be read: {}.", name_of(path), reason(error))});
}

/// \return 0, or an errno value.
int write_all(int fd, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Creates a file of a name that nothing has yet, hidden, beside the one it is to become.
std::pair<int, fs::path> create_beside(const fs::path& path) {
  constexpr int kTries = 100;
  const fs::path folder = path.parent_path();
  for (int i = 0; i < kTries; ++i) {
    fs::path temporary = folder / fmt::format(".depixel-{}-{}.tmp", ::getpid(), i);
    const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return {fd, std::move(temporary)};
  }
  return {-1, {}};
}

/// Follows symbolic links, so that the file is replaced and not the link to it.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  fs::path target = fs::canonical(path, error);
  return error ? path : target;
}

}  // namespace

tl::expected<Stream, Error> open_stream(const fs::path& path) {
  Stream stream(path == "-" ? stdin : std::fopen(path.c_str(), "rbe"));
  if (!stream) return unreadable(path, errno);
  return stream;
}

tl::expected<std::vector<std::uint8_t>, Error> read_rest(std::FILE* stream, const fs::path& path) {
  constexpr std::size_t kChunk = std::size_t{1} << 20;
  std::vector<std::uint8_t> bytes;
  while (bytes.size() <= kMaxFileBytes) {
    const std::size_t size = bytes.size();
    bytes.resize(size + kChunk);
    errno = 0;
    const std::size_t got = std::fread(bytes.data() + size, 1, kChunk, stream);
    bytes.resize(size + got);
    if (got == kChunk) continue;
    if (std::ferror(stream) != 0) return unreadable(path, errno);
    return bytes;
  }
  return tl::unexpected(Error{fmt::format("{} is larger than {} MiB, the most that is read of a picture.",
                                          name_of(path), kMaxFileBytes >> 20)});
}

tl::expected<std::vector<std::uint8_t>, Error> read_file(const fs::path& path) {
  const auto stream = open_stream(path);
  if (!stream) return tl::unexpected(stream.error());
  return read_rest(stream->get(), path);
}

tl::expected<void, Error> write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  const auto failure = [&](int error) {
    return tl::unexpected(Error{fmt::format("{} cannot be written: {}.", path.string(), reason(error))});
  };
  const fs::path target = resolved(path);
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    return tl::unexpected(
        Error{fmt::format("{} cannot be written: it is not a regular file.", path.string())});
  }

  const auto [fd, temporary] = create_beside(target);
  Descriptor file(fd);
  if (!file) return failure(errno);
  int error = write_all(file.get(), bytes);
  if (error == 0 && !file.close()) error = errno;
  if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return {};
  ::unlink(temporary.c_str());
  return failure(error);
}

tl::expected<void, Error> write_standard_output(std::span<const std::uint8_t> bytes) {
  const int error = write_all(STDOUT_FILENO, bytes);
  if (error == 0) return {};
  return tl::unexpected(Error{fmt::format("Standard output cannot be written: {}.", reason(error))});
}

std::string lower_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

tl::unexpected<Error> about_file(const fs::path& path, const Error& error) {
  const std::string name = path == "-" ? "Standard input" : path.string();
  return tl::unexpected(Error{fmt::format("{} {}", name, error.message)});
}

}  // namespace depixel
