// Every verification case as a test of its own: CatalogueNN.id_with_underscores, NN its first catalogue number, or
// CatalogueNN_slow.id, which CMakeLists.txt turns into the ctest label.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "verification/cases/all_cases.h"
#include "verification/suite/runner.h"

namespace verify {
namespace {

class CatalogueCase : public testing::Test {
 public:
  explicit CatalogueCase(const Case& given) : case_(given) {}
  void TestBody() override {
    for (const Row& row : run_case(case_)) EXPECT_TRUE(row.passed) << describe(row);
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

}  // namespace
}  // namespace verify

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  verify::register_cases();
  return RUN_ALL_TESTS();
}
