#include "engine/record/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include "engine/core/error.h"

namespace dda {

void refuse_place(const std::filesystem::path& folder, const std::string& why) {
  throw InputError("", "--out", folder.string() + ", " + why, "a folder that can be written to");
}

namespace {

[[noreturn]] void refuse_lock(const std::filesystem::path& path, int error) {
  refuse_place(path.parent_path(), fmt::format("where nothing can be written (cannot lock {}: {})", path.string(),
                                               std::generic_category().message(error)));
}

void make(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) refuse_place(folder, "which cannot be made (" + error.message() + ")");
}

// False when the file has been removed, or another one has taken its name, since it was opened.
bool still_has_its_name(int descriptor, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : path_(folder / "run.lock") {
  make(folder);
  while (!lock(folder)) ::close(descriptor_);
  name_holder();
}

FolderLock::~FolderLock() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

// False when the holder before removed the file between opening and locking it.
bool FolderLock::lock(const std::filesystem::path& folder) {
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  if (descriptor_ < 0) refuse_lock(path_, errno);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) refuse(folder);
    const int error = errno;
    ::close(descriptor_);
    refuse_lock(path_, error);
  }
  return still_has_its_name(descriptor_, path_);
}

void FolderLock::refuse(const std::filesystem::path& folder) {
  std::array<char, 256> holder{};
  const ssize_t count = ::read(descriptor_, holder.data(), holder.size());
  ::close(descriptor_);
  const std::string name = count > 0 ? std::string(holder.data(), static_cast<std::size_t>(count)) : "another process";
  throw InputError("", "--out", fmt::format("{}, to which a run of {} writes", folder.string(), name),
                   "a folder of its own for every run");
}

// Only for people to read, so a full disk does not matter.
void FolderLock::name_holder() const {
  std::array<char, 128> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host = {};
  const std::string name = fmt::format("process {} on {}", ::getpid(), host.data());
  if (::ftruncate(descriptor_, 0) != 0) return;
  [[maybe_unused]] const ssize_t written = ::write(descriptor_, name.data(), name.size());
}

}  // namespace dda
