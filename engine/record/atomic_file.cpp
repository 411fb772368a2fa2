#include "engine/record/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

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
  if (::unlink(temporary_.c_str()) != 0 && errno != ENOENT) fail(errno);
  open(O_CREAT | O_EXCL);
}

AtomicFile::AtomicFile(std::filesystem::path path, std::int64_t kept)
    : path_(std::move(path)), temporary_(path_), size_(kept) {
  temporary_ += ".tmp";
  open(0);
  if (::ftruncate(descriptor_, kept) == 0 && ::lseek(descriptor_, kept, SEEK_SET) == kept) return;
  const int error = errno;
  close();
  fail(error);
}

void AtomicFile::open(int flags) {
  if (const std::string kind = why_unwritable(path_); !kind.empty())
    throw std::runtime_error("cannot write " + path_.string() + ": it is " + kind);
  descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | flags, 0666);
  if (descriptor_ < 0) fail(errno);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  if (temporary_is_ours()) ::unlink(temporary_.c_str());
  close();
}

bool AtomicFile::temporary_is_ours() const {
  struct stat ours {};
  struct stat named {};
  return ::fstat(descriptor_, &ours) == 0 && ::lstat(temporary_.c_str(), &named) == 0 && ours.st_dev == named.st_dev &&
         ours.st_ino == named.st_ino;
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
  if (!temporary_is_ours())
    throw std::runtime_error("cannot write " + path_.string() + ": another program is writing it too");
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
  close();
}

std::string why_unwritable(const std::filesystem::path& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode)) return "";
  if (S_ISLNK(status.st_mode)) return "a symbolic link";
  if (S_ISDIR(status.st_mode)) return "a directory";
  if (S_ISFIFO(status.st_mode)) return "a named pipe";
  return S_ISSOCK(status.st_mode) ? "a socket" : "a device";
}

void write_file(const std::filesystem::path& path, std::string_view text, Survives survives) {
  AtomicFile file(path);
  file.write(text);
  file.commit(survives);
}

}  // namespace dda
