// Damaged frames, histories and summaries of a run are shown as far as they go, or refused in one sentence, and then no
// page is left behind.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "engine/core/fuzz_support.h"
#include "engine/core/read_file.h"
#include "engine/view/page.h"
#include "engine/view/run_facts.h"
#include "engine/view/run_results.h"
#include "engine/view/svg_picture.h"
#include "engine/view/view_test_support.h"

namespace dda {
namespace {

constexpr std::string_view data_mark = "<AppendedData encoding=\"raw\">\n_";

// A run of three blocks with contacts and bolts, and its files one by one damaged and mended again.
class DamagedRun {
 public:
  DamagedRun() {
    const Model model = model_to_view();
    write_run(folder_.path(), model, {0, 0.5, 1});
    write_bolts(folder_.path(), model, {0, 0.5, 1});
    write_file(folder_ / "histories.csv", "time [s],\"a, b [MPa]\",c\n0,1,2\n0.5,-1e-3,4\n1,nan,3\n");
    write_file(folder_ / "summary.json",
               R"({"status": "ok", "title": "a <run>", "stages": [{"name": "s", "begin_s": 0}]})");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path()))
      if (entry.is_regular_file()) files_[entry.path()] = read_file(entry.path());
    for (const auto& [path, text] : files_) names_.push_back(path);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

  void damage(Mutator& mutator) {
    const std::filesystem::path& file = mutator.one_of(names_);
    const std::string& whole = files_.at(file);
    const std::size_t data = whole.find(data_mark);
    const bool in_data = data != std::string::npos && mutator.one_in(2);
    write_file(file, in_data ? mutator.memory(whole, data + data_mark.size()) : mutator.text(whole));
    damaged_ = file;
  }

  void mend() const { write_file(damaged_, files_.at(damaged_)); }

 private:
  TemporaryFolder folder_;
  std::map<std::filesystem::path, std::string> files_;
  std::vector<std::filesystem::path> names_;
  std::filesystem::path damaged_;
};

bool is_finite(const Vec2& vector) { return vector.allFinite(); }

// All numbers of a block that is not in the frame are missing; all others are finite.
void expect_numbers(const Frame& frame) {
  EXPECT_TRUE(std::isfinite(frame.time));
  for (std::size_t i = 0; i < frame.stress.size(); ++i) {
    const bool is_there = frame.stress[i].allFinite() && is_finite(frame.velocity[i]) && is_finite(frame.moved[i]);
    const bool is_absent = frame.stress[i].array().isNaN().all() && frame.velocity[i].array().isNaN().all();
    EXPECT_TRUE(is_there || is_absent) << frame.stress[i].transpose();
  }
  for (const DrawnContact& contact : frame.contacts) EXPECT_TRUE(is_finite(contact.force));
  for (const DrawnBolt& bolt : frame.bolts) {
    EXPECT_TRUE(std::isfinite(bolt.force));
    EXPECT_TRUE(std::ranges::all_of(bolt.reference, is_finite));
    EXPECT_TRUE(std::ranges::all_of(bolt.displacement, is_finite));
  }
}

void read_everything(const std::filesystem::path& folder) {
  const RunResults results(folder);
  EXPECT_TRUE(std::ranges::all_of(results.drawing().reference, is_finite));
  for (std::size_t i = 0; i < results.times().size(); ++i) {
    EXPECT_TRUE(std::isfinite(results.times()[i]));
    const Frame frame = results.frame(i);
    expect_numbers(frame);
    EXPECT_NE(svg_picture(results.drawing(), frame, {}).find("</svg>"), std::string::npos);
  }
}

// A page reads all frames twice and packs them, so it is made of one in four; the others are read as it reads them.
TEST(FramesFuzz, DamagedRuns) {
  DamagedRun run;
  const PageOptions options{run.path(), run.path() / "view.html"};
  const auto tally = fuzz({.inputs = 4000}, [&](Mutator& mutator) {
    run.damage(mutator);
    std::ostringstream said;
    try {
      if (mutator.one_in(4)) {
        write_page(options, said);
        EXPECT_TRUE(std::filesystem::remove(options.file));
      } else {
        read_everything(run.path());
        EXPECT_FALSE(read_facts(run.path()).title.empty());
      }
    } catch (const InputError&) {
      EXPECT_FALSE(std::filesystem::exists(options.file));
      run.mend();
      throw;
    }
    run.mend();
  });
  expect_both(tally);
}

}  // namespace
}  // namespace dda
