#include "engine/record/folder_lock.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <optional>

#include "engine/core/error.h"
#include "engine/record/atomic_file.h"
#include "engine/record/record_test_support.h"

namespace dda {
namespace {

using Names = std::set<std::string>;

TEST(FolderLock, LetsOneInAndSaysWho) {
  const TemporaryFolder folder;
  const auto results = folder / "a" / "b";
  std::optional<FolderLock> first(results);
  EXPECT_EQ(names_in(results), Names{"run.lock"});
  for (int i = 0; i < 2; ++i) {
    const std::string refusal = message_of<InputError>([&] { const FolderLock second(results); });
    EXPECT_EQ(
        refusal.find("--out is " + results.string() + ", to which a run of process " + std::to_string(::getpid())), 0U)
        << refusal;
  }
  first.reset();
  EXPECT_EQ(names_in(results), Names{});
  EXPECT_EQ(message_of<InputError>([&] { const FolderLock third(results); }), "");
}

TEST(FolderLock, WhatAKilledRunLeftIsNoLock) {
  const TemporaryFolder folder;
  write_file(folder / "run.lock", "process 1 on a machine that was switched off, with a long name");
  const FolderLock lock(folder.path());
  EXPECT_NE(message_of<InputError>([&] { const FolderLock second(folder.path()); }).find(std::to_string(::getpid())),
            std::string::npos);
}

TEST(FolderLock, DoesNotFollowLinks) {
  const TemporaryFolder folder;
  write_file(folder / "precious", "mine");
  std::filesystem::create_symlink(folder / "precious", folder / "run.lock");
  EXPECT_NE(message_of<std::runtime_error>([&] { const FolderLock lock(folder.path()); }), "");
  EXPECT_EQ(std::filesystem::file_size(folder / "precious"), 4U);
}

}  // namespace
}  // namespace dda
