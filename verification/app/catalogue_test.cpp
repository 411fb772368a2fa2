// Every verification case as a test of its own: CatalogueNN.id_with_underscores, NN its first catalogue number, or
// CatalogueNN_slow.id, which CMakeLists.txt turns into the ctest label. Its rows are left in RESULTS_FOLDER/ID.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "engine/record/atomic_file.h"
#include "verification/cases/all_cases.h"
#include "verification/suite/catalogue.h"
#include "verification/suite/run_command.h"
#include "verification/suite/runner.h"

namespace verify {
namespace {

class CatalogueCase : public testing::Test {
 public:
  explicit CatalogueCase(const Case& given) : case_(given) {}
  void TestBody() override {
    const std::vector<Row> rows = run_case(case_);
    for (const Row& row : rows) EXPECT_TRUE(row.passed) << describe(row);
    const std::filesystem::path folder = std::filesystem::path(RESULTS_FOLDER) / case_.id;
    std::filesystem::create_directories(folder);
    dda::write_file(folder / verification_file, to_json(rows));
  }

 private:
  const Case& case_;
};

// GoogleTest reads a dash in a filter as "all but".
std::string test_name_of(const Case& given) {
  std::string name = given.id;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::string suite_name_of(const Case& given) {
  const int first = given.catalogue.empty() ? 0 : given.catalogue.front();
  return fmt::format("Catalogue{:02}{}", first, given.label == CaseLabel::slow ? "_slow" : "");
}

void register_cases() {
  for (const Case& each : all_cases())
    testing::RegisterTest(suite_name_of(each).c_str(), test_name_of(each).c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [&each]() -> CatalogueCase* { return new CatalogueCase(each); });
}

TEST(AllCases, HaveIdsOfTheirOwnAndNumbersOfTheCatalogue) {
  std::set<std::string> ids;
  for (const Case& each : all_cases()) {
    EXPECT_TRUE(ids.insert(each.id).second) << each.id << " twice";
    EXPECT_EQ(each.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos) << each.id;
    EXPECT_FALSE(each.id.empty() || each.title.empty() || each.catalogue.empty()) << each.id;
    for (const int number : each.catalogue)
      EXPECT_TRUE(number >= 1 && number <= static_cast<int>(catalogue().size())) << each.id << ": " << number;
  }
}

}  // namespace
}  // namespace verify

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  verify::register_cases();
  return RUN_ALL_TESTS();
}
