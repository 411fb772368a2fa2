#include "engine/record/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

namespace dda {
namespace {

[[noreturn]] void throw_file_error(const char* action, const std::filesystem::path& path, int error) {
  throw std::runtime_error("cannot " + std::string(action) + " " + path.string() + ": " +
                           std::generic_category().message(error));
}

// Zero, or the errno of the write that failed.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), temporary_(path_) {
  temporary_ += ".tmp";
  descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(errno);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  close();
  ::unlink(temporary_.c_str());
}

void AtomicFile::fail(int error) const { throw_file_error("write", path_, error); }

void AtomicFile::close() { ::close(std::exchange(descriptor_, -1)); }

void AtomicFile::write(std::string_view text) {
  if (const int error = write_all(descriptor_, text)) {
    if (::ftruncate(descriptor_, size_) == 0) ::lseek(descriptor_, size_, SEEK_SET);
    fail(error);
  }
  size_ += static_cast<std::int64_t>(text.size());
}

void AtomicFile::commit(Survives survives) {
  // Data first, then the name, so that the name never stands for an empty file.
  if (survives == Survives::power_cut && ::fsync(descriptor_) != 0) fail(errno);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
  close();
}

void write_file(const std::filesystem::path& path, std::string_view text, Survives survives) {
  AtomicFile file(path);
  file.write(text);
  file.commit(survives);
}

std::string read_file(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw_file_error("read", path, errno);
  std::string text;
  std::vector<char> chunk(1 << 16);
  ssize_t count = 0;
  do {
    count = ::read(descriptor, chunk.data(), chunk.size());
    if (count > 0) text.append(chunk.data(), static_cast<std::size_t>(count));
  } while (count > 0 || (count < 0 && errno == EINTR));
  const int error = errno;
  ::close(descriptor);
  if (count < 0) throw_file_error("read", path, error);
  return text;
}

}  // namespace dda
