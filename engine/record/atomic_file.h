// Files that appear complete or not at all: written as NAME.tmp and renamed when done.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace dda {

// What a committed file outlasts. Waiting for the disk costs about 10 ms, too much for every frame.
enum class Survives {
  crash,      // of the program
  power_cut,  // and of the machine
};

// A file being written. Whatever stood under its name stays there, whole, until commit(). Neither name follows a link:
// NAME.tmp is always a new file, and a NAME that is a link, device or folder is refused, as renaming would replace it.
// All errors are std::runtime_error naming the path and the reason.
class AtomicFile {
 public:
  // Opens NAME.tmp in the same folder, which must exist; a left-over NAME.tmp is removed.
  explicit AtomicFile(std::filesystem::path path);

  // Goes on behind the first `kept` bytes of a left-over NAME.tmp; what comes after them is dropped.
  AtomicFile(std::filesystem::path path, std::int64_t kept);

  // Without commit(): NAME.tmp is removed.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  // Appends all of `text` or, when that fails (full disk), nothing of it: the file is cut back before the error is
  // thrown, and may still be committed.
  void write(std::string_view text);

  // Puts the complete file in its place. Fails when another program has made a NAME.tmp of its own meanwhile.
  void commit(Survives survives = Survives::crash);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void fail(int error) const;
  void open(int flags);
  [[nodiscard]] bool temporary_is_ours() const;
  void close();

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;  // bytes of whole writes
};

// What stands at `path` where a result could not replace it: "a symbolic link", "a directory", "a device", ...; empty
// for a regular file, and for nothing.
std::string why_unwritable(const std::filesystem::path& path);

// One write and commit.
void write_file(const std::filesystem::path& path, std::string_view text, Survives survives = Survives::crash);

}  // namespace dda
