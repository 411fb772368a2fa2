#include "engine/record/run_folder.h"

#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/record/atomic_file.h"
#include "engine/record/record_test_support.h"

namespace dda {
namespace {

using Names = std::set<std::string>;

TEST(RunFolder, ClearingTakesWhatRunsLeaveAndNothingElse) {
  const TemporaryFolder folder;
  for (const char* name : {"frames", "contacts", "bolts"}) std::filesystem::create_directory(folder / name);
  for (const char* name :
       {"histories.csv", "histories.csv.tmp", "summary.json", "checkpoint.bin", "checkpoint.bin.tmp", "run.json",
        "frames.pvd", "contacts.pvd", "bolts.pvd", "view.html", "profile.json", "profile.json.tmp", "frames/000000.vtp",
        "frames/1000000.vtp", "frames/000001.vtp.tmp", "bolts/000000.vtp"})
    write_file(folder / name, "old");
  for (const char* name : {"notes.txt", "frames.txt", "contacts/mine.vtp", "contacts/000000.png"})
    write_file(folder / name, "mine");
  check_run_folder(folder.path());
  clear_run_folder(folder.path());
  EXPECT_EQ(names_in(folder.path()), (Names{"notes.txt", "frames.txt", "contacts"}));
  EXPECT_EQ(names_in(folder / "contacts"), (Names{"mine.vtp", "000000.png"}));
}

TEST(RunFolder, NamesWhatIsInTheWay) {
  const auto refusal = [](const TemporaryFolder& folder) {
    return message_of<InputError>([&] { check_run_folder(folder.path()); });
  };
  for (const char* name : {"histories.csv", "summary.json", "checkpoint.bin.tmp", "frames.pvd"}) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / name);
    EXPECT_EQ(refusal(folder), "--out is " + folder.path().string() + ", where " + name +
                                   " is a directory, expected a folder where that name is free, or a file");
  }
  const TemporaryFolder folder;
  EXPECT_EQ(refusal(folder), "");
  std::filesystem::create_directory_symlink("/tmp", folder / "frames");
  EXPECT_NE(refusal(folder).find("frames is not a folder"), std::string::npos);
}

}  // namespace
}  // namespace dda
