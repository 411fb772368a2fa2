#include "engine/record/atomic_file.h"

#include <gtest/gtest.h>

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
            "cannot write " + (folder / "x").string() + ": Is a directory");
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

TEST(ReadFile, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  EXPECT_EQ(message_of<std::runtime_error>([&] { read_file(folder / "x"); }),
            "cannot read " + (folder / "x").string() + ": No such file or directory");
  std::filesystem::create_directory(folder / "d");
  EXPECT_EQ(message_of<std::runtime_error>([&] { read_file(folder / "d"); }),
            "cannot read " + (folder / "d").string() + ": Is a directory");
}

}  // namespace
}  // namespace dda
