#include "engine/core/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace dda {
namespace {

std::string why_not_readable(int error) {
  if (error == ENOENT || error == ENOTDIR) return "missing";
  return "not readable (" + std::generic_category().message(error) + ")";
}

std::string kind_other_than_regular(mode_t mode) {
  if (S_ISREG(mode)) return "";
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a named pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

std::string too_large(std::uint64_t most_bytes) { return "larger than " + std::to_string(most_bytes >> 20) + " MiB"; }

class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path)
      : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
    if (descriptor_ < 0) refuse(why_not_readable(errno));
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  void expect_regular() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) refuse(why_not_readable(errno));
    if (const std::string kind = kind_other_than_regular(status.st_mode); !kind.empty()) refuse(kind);
  }

  // Counts what it reads: the size a file says it has may be 0 (in /proc), or change.
  [[nodiscard]] std::string text(std::uint64_t most_bytes) const {
    std::string text;
    std::array<char, 1 << 16> chunk{};
    while (true) {
      const ssize_t count = ::read(descriptor_, chunk.data(), chunk.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) refuse(why_not_readable(errno));
      if (count == 0) return text;
      text.append(chunk.data(), static_cast<std::size_t>(count));
      if (text.size() > most_bytes) refuse(too_large(most_bytes));
    }
  }

 private:
  [[noreturn]] void refuse(std::string why) const { throw UnreadableFile(path_, std::move(why)); }

  const std::filesystem::path& path_;
  int descriptor_;
};

}  // namespace

UnreadableFile::UnreadableFile(const std::filesystem::path& path, std::string why)
    : std::runtime_error("cannot read " + path.string() + ": it is " + why), why_(std::move(why)) {}

std::string read_file(const std::filesystem::path& path, std::uint64_t most_bytes) {
  const OpenFile file(path);
  file.expect_regular();
  return file.text(most_bytes);
}

std::string why_unreadable(const std::filesystem::path& path, std::uint64_t most_bytes) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return why_not_readable(errno);
  if (std::string kind = kind_other_than_regular(status.st_mode); !kind.empty()) return kind;
  return static_cast<std::uint64_t>(status.st_size) > most_bytes ? too_large(most_bytes) : "";
}

}  // namespace dda
