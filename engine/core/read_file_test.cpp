#include "engine/core/read_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "engine/core/temporary_folder.h"

namespace dda {
namespace {

std::string why(const std::filesystem::path& path, std::uint64_t most_bytes = most_result_bytes) {
  try {
    read_file(path, most_bytes);
  } catch (const UnreadableFile& error) {
    EXPECT_EQ(error.what(), "cannot read " + path.string() + ": it is " + error.why());
    return error.why();
  }
  return "read";
}

TEST(ReadFile, GivesEveryByteAlsoThroughALink) {
  const TemporaryFolder folder;
  const std::string text("a\0b\r\n\xff", 6);
  std::ofstream(folder / "x", std::ios::binary) << text;
  EXPECT_EQ(read_file(folder / "x"), text);
  std::filesystem::create_symlink(folder / "x", folder / "link");
  EXPECT_EQ(read_file(folder / "link"), text);
  EXPECT_EQ(why_unreadable(folder / "link"), "");
}

TEST(ReadFile, RefusesWhatHasNoEndAndDoesNotWaitForIt) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder / "link");
  EXPECT_EQ(why(folder / "pipe"), "a named pipe");
  EXPECT_EQ(why(folder / "link"), "a device");
  EXPECT_EQ(why("/dev/random"), "a device");
  EXPECT_EQ(why(folder.path()), "a directory");
  EXPECT_EQ(why(folder / "none"), "missing");
  for (const char* name : {"pipe", "link", "none"}) EXPECT_EQ(why_unreadable(folder / name), why(folder / name));
}

TEST(ReadFile, StopsAtItsBound) {
  const TemporaryFolder folder;
  std::ofstream(folder / "x").close();
  std::filesystem::resize_file(folder / "x", (5U << 20) + 1);  // a hole, as a damaged file may have
  EXPECT_EQ(why(folder / "x", 5U << 20), "larger than 5 MiB");
  EXPECT_EQ(why_unreadable(folder / "x", 5U << 20), "larger than 5 MiB");
  EXPECT_EQ(read_file(folder / "x", (5U << 20) + 1).size(), (5U << 20) + 1);
}

TEST(ReadFile, SaysWhatThisUserMayNotRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const TemporaryFolder folder;
  std::ofstream(folder / "x").close();
  std::filesystem::permissions(folder / "x", std::filesystem::perms::none);
  EXPECT_EQ(why(folder / "x"), "not readable (Permission denied)");
}

}  // namespace
}  // namespace dda
