#include "engine/view/page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/view/page_parts.h"
#include "engine/view/view_test_support.h"

namespace dda {
namespace {

class PageTest : public testing::Test {
 protected:
  std::string page(std::size_t most_bytes = 50'000'000) {
    std::ostringstream out;
    write_page({folder_.path(), folder_ / "view.html", "mean_stress", most_bytes}, out);
    said_ = out.str();
    return read_file(folder_ / "view.html");
  }

  static nlohmann::json header_of(const std::string& page) {
    const std::string mark = "id=\"data-header\">";
    const std::size_t begin = page.find(mark) + mark.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  }

  void write_frames(int count) {
    std::vector<double> times;
    for (int i = 0; i < count; ++i) times.push_back(0.1 * i);
    write_run(folder_.path(), model_to_view(), times);
  }

  TemporaryFolder folder_;
  std::string said_;
};

TEST_F(PageTest, NeedsNothingElse) {
  write_frames(3);
  const std::string text = page();
  EXPECT_TRUE(text.starts_with("<!doctype html>"));
  for (const char* outside : {"http:", "https:", "src=", "@import", "url(", "import(", "{{", "fetch("})
    EXPECT_EQ(text.find(outside), std::string::npos) << outside;
  EXPECT_EQ(page_scripts().size(), 14U);
  for (const std::string_view script : page_scripts()) EXPECT_NE(text.find(script), std::string::npos);
  EXPECT_NE(text.find(page_style()), std::string::npos);
}

TEST_F(PageTest, HoldsWhatIsKnownOfTheRun) {
  write_frames(3);
  write_file(folder_ / "summary.json",
             R"({"status": "ok", "title": "A </script><b> title", "energy": {"residual_relative": 1e-9}})");
  write_file(folder_ / "histories.csv", "time [s],top [m]\n0,1\n0.2,nan\n");
  const std::string text = page();
  const auto header = header_of(text);
  EXPECT_EQ(header["title"], "A </script><b> title");
  EXPECT_NE(text.find("<title>A &lt;/script&gt;&lt;b&gt; title</title>"), std::string::npos);
  EXPECT_EQ(header["summary"]["energy"]["residual_relative"], 1e-9);
  EXPECT_EQ(header["histories"]["columns"][0]["name"], "top");
  EXPECT_TRUE(header["histories"]["columns"][0]["values"][1].is_null());
  EXPECT_EQ(header["maps"]["sequential"].size(), 256U);
  EXPECT_EQ(header["blocks"], 3);
  EXPECT_NE(said_.find("view.html: 3 blocks, 3 frames, 0."), std::string::npos) << said_;
}

TEST_F(PageTest, OfARunThatGoesOnHasNoSummary) {
  write_frames(2);
  const auto header = header_of(page());
  EXPECT_TRUE(header["summary"].is_null());
  EXPECT_TRUE(header["histories"].is_null());
  EXPECT_EQ(header["title"], folder_.path().filename().string());
}

TEST_F(PageTest, LongRunsAreThinned) {
  write_frames(40);
  const auto whole = header_of(page());
  EXPECT_EQ(whole["times"].size(), 40U);
  const auto thin = header_of(page(3000));
  EXPECT_LT(thin["times"].size(), 20U);
  EXPECT_GE(thin["times"].size(), 3U);
  EXPECT_EQ(thin["times"].front(), 0);
  EXPECT_EQ(thin["times"].back(), whole["times"].back());
  EXPECT_EQ(thin["frames_in_run"], 40);
  EXPECT_NE(said_.find(" frames of 40 (thinned to 0.003 MB, "), std::string::npos) << said_;
}

TEST_F(PageTest, RefusesWhatDoesNotFitAtAll) {
  write_frames(4);
  const std::string message = message_of<InputError>([&] { page(100); });
  EXPECT_NE(message.find("the size of two frames is 0.00"), std::string::npos) << message;
  EXPECT_NE(message.find(" MB, expected at most the 0.0001 MB of --max-size"), std::string::npos) << message;
}

TEST_F(PageTest, DamagedSummaryIsNamed) {
  write_frames(2);
  write_file(folder_ / "summary.json", "{\"status\": ");
  EXPECT_NE(message_of<InputError>([&] { page(); }).find("summary.json: the file is damaged"), std::string::npos);
}

}  // namespace
}  // namespace dda
