// Damaged records are read to finite samples at increasing times, or refused in one sentence.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "engine/core/fuzz_support.h"
#include "engine/core/read_file.h"
#include "engine/core/temporary_folder.h"
#include "engine/scene/record_file.h"

namespace dda {
namespace {

const std::vector<std::string>& corpus() {
  static const std::vector<std::string> records{
      "t,a\n0,0\n0.5,-1.5\n2,2e1\n",
      "# made by hand\r\n\r\nt [ms];ax [g];ay (cm/s2)\r\n0;0;1\r\n5;0.1;2\r\n10;-0.3;3\r\n20;0.2;-1\r\n",
      "\xEF\xBB\xBF\"time\"\t\"a\"\n 0 \t +0 \n0.5\t -1.5\n+2\t+20\n3\t1e-3\n",
      read_file(DDA_DOCS_DIR "/examples/made_up_quake.csv").substr(0, 900)};
  return records;
}

RecordRequest some_request(Mutator& mutator) {
  RecordRequest request;
  request.dimension = mutator.one_in(2) ? Dimension::acceleration : Dimension::dimensionless;
  request.correct_baseline = mutator.one_in(2);
  if (mutator.one_in(3)) request.value = mutator.one_of(std::vector<std::string>{"ax", "ay", "a"});
  if (mutator.one_in(8)) request.time = mutator.one_of(std::vector<std::string>{"t", "time", "a"});
  if (mutator.one_in(8)) request.scale = mutator.one_of(std::vector<double>{1e300, -1e-300, 0});
  if (mutator.one_in(8)) request.most_samples = 3;
  return request;
}

void expect_finite(const Recording& record) {
  const auto is_finite = [](double number) { return std::isfinite(number); };
  EXPECT_GE(record.times().size(), 2U);
  EXPECT_TRUE(std::ranges::all_of(record.times(), is_finite));
  EXPECT_TRUE(std::ranges::all_of(record.values(), is_finite));
  EXPECT_TRUE(std::ranges::is_sorted(record.times(), std::less_equal<>()));
  for (std::size_t i = 0; i + 1 < record.times().size(); ++i) {
    const double between = record.times()[i] + (record.times()[i + 1] - record.times()[i]) / 2;
    for (const double number : {record.value(between), record.slope(record.times()[i]), record.integral(between),
                                record.second_integral(record.times()[i + 1])})
      EXPECT_TRUE(std::isfinite(number)) << number << " at " << between;
  }
}

TEST(RecordFuzz, DamagedRecords) {
  const TemporaryFolder folder;
  const auto tally = fuzz({.inputs = 5000}, [&](Mutator& mutator) {
    RecordRequest request = some_request(mutator);
    request.file = folder / "record.csv";
    std::ofstream(request.file, std::ios::binary) << mutator.text(mutator.one_of(corpus()));
    expect_finite(read_record(request, "place"));
  });
  expect_both(tally);
}

}  // namespace
}  // namespace dda
