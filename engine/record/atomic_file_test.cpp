#include "engine/record/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "engine/core/read_file.h"
#include "engine/record/record_test_support.h"

namespace dda {
namespace {

using Names = std::set<std::string>;

TEST(AtomicFile, WritesWhatItIsGiven) {
  const TemporaryFolder folder;
  const std::string text("a\0b\r\n\xff", 6);
  write_file(folder / "x", text);
  EXPECT_EQ(read_file(folder / "x"), text);
  write_file(folder / "x", "cd", Survives::power_cut);
  EXPECT_EQ(read_file(folder / "x"), "cd");
  write_file(folder / "x", "");
  EXPECT_EQ(read_file(folder / "x"), "");
  EXPECT_EQ(names_in(folder.path()), Names{"x"});
}

TEST(AtomicFile, OldFileStaysUntilCommit) {
  const TemporaryFolder folder;
  write_file(folder / "x", "old");
  AtomicFile file(folder / "x");
  file.write("new");
  EXPECT_EQ(read_file(folder / "x"), "old");
  EXPECT_EQ(names_in(folder.path()), (Names{"x", "x.tmp"}));
  file.commit();
  EXPECT_EQ(read_file(folder / "x"), "new");
  EXPECT_EQ(names_in(folder.path()), Names{"x"});
}

TEST(AtomicFile, WithoutCommitNothingIsLeft) {
  const TemporaryFolder folder;
  write_file(folder / "x", "old");
  AtomicFile(folder / "x").write("new");
  EXPECT_EQ(read_file(folder / "x"), "old");
  EXPECT_EQ(names_in(folder.path()), Names{"x"});
}

TEST(AtomicFile, TemporaryFileDoesNotFollowLinks) {
  const TemporaryFolder folder;
  write_file(folder / "precious", "mine");
  std::filesystem::create_symlink(folder / "precious", folder / "x.tmp");
  std::filesystem::create_hard_link(folder / "precious", folder / "y.tmp");
  for (const char* name : {"x", "y"}) {
    write_file(folder / name, "new");
    EXPECT_EQ(read_file(folder / name), "new");
  }
  EXPECT_EQ(read_file(folder / "precious"), "mine");
  EXPECT_EQ(names_in(folder.path()), (Names{"precious", "x", "y"}));
}

TEST(AtomicFile, RefusesToReplaceWhatIsNoRegularFile) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/null", folder / "link");
  std::filesystem::create_directory(folder / "folder");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const std::vector<std::pair<std::filesystem::path, std::string>> refused = {{folder / "link", "a symbolic link"},
                                                                              {folder / "folder", "a directory"},
                                                                              {folder / "pipe", "a named pipe"},
                                                                              {"/dev/null", "a device"}};
  for (const auto& [path, kind] : refused) {
    EXPECT_EQ(message_of<std::runtime_error>([&] { write_file(path, "new"); }),
              "cannot write " + path.string() + ": it is " + kind);
    EXPECT_EQ(why_unwritable(path), kind);
  }
  EXPECT_EQ(names_in(folder.path()), (Names{"folder", "link", "pipe"}));
  EXPECT_EQ(why_unwritable(folder / "none"), "");
}

TEST(AtomicFile, TwoWritersOfOneFileDoNotMix) {
  const TemporaryFolder folder;
  AtomicFile first(folder / "x");
  first.write("of the first");
  {
    AtomicFile second(folder / "x");
    second.write("of the second");
    EXPECT_EQ(message_of<std::runtime_error>([&] { first.commit(); }),
              "cannot write " + (folder / "x").string() + ": another program is writing it too");
    second.commit();
  }
  EXPECT_EQ(read_file(folder / "x"), "of the second");
}

TEST(AtomicFile, LeftOverTemporaryFileIsOverwritten) {
  const TemporaryFolder folder;
  write_file(folder / "x.tmp", "of a run that was killed");
  write_file(folder / "x", "new");
  EXPECT_EQ(read_file(folder / "x"), "new");
  EXPECT_EQ(names_in(folder.path()), Names{"x"});
}

TEST(AtomicFile, MissingFolderIsNamed) {
  const TemporaryFolder folder;
  const auto path = folder / "no such folder" / "x";
  EXPECT_EQ(message_of<std::runtime_error>([&] { write_file(path, "text"); }),
            "cannot write " + path.string() + ": No such file or directory");
}

TEST(AtomicFile, NameOfAFolderIsRefusedAndNothingLeft) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "x");
  EXPECT_EQ(message_of<std::runtime_error>([&] { write_file(folder / "x", "text"); }),
            "cannot write " + (folder / "x").string() + ": it is a directory");
  EXPECT_EQ(names_in(folder.path()), Names{"x"});
}

TEST(AtomicFile, FullDiskKeepsTheOldFile) {
  const TemporaryFolder folder;
  write_file(folder / "x", "old");
  const FullDisk full(100);
  EXPECT_EQ(message_of<std::runtime_error>([&] { write_file(folder / "x", std::string(200, 'n')); }),
            "cannot write " + (folder / "x").string() + ": File too large");
  EXPECT_EQ(read_file(folder / "x"), "old");
  EXPECT_EQ(names_in(folder.path()), Names{"x"});
}

TEST(AtomicFile, FailedWriteLeavesNoPartOfItself) {
  const TemporaryFolder folder;
  const FullDisk full(100);
  AtomicFile file(folder / "x");
  file.write(std::string(60, 'a'));
  EXPECT_THROW(file.write(std::string(60, 'b')), std::runtime_error);
  file.write(std::string(40, 'c'));
  file.commit();
  EXPECT_EQ(read_file(folder / "x"), std::string(60, 'a') + std::string(40, 'c'));
}

TEST(ReadFile, LongFile) {
  const TemporaryFolder folder;
  std::string text(200'000, 'x');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>('a' + i % 23);
  write_file(folder / "x", text);
  EXPECT_EQ(read_file(folder / "x"), text);
}

}  // namespace
}  // namespace dda
