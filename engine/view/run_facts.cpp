#include "engine/view/run_facts.h"

#include <system_error>

#include "engine/core/error.h"
#include "engine/core/read_file.h"

namespace dda {

nlohmann::ordered_json read_summary(const std::filesystem::path& file) {
  constexpr int deepest = 32;  // as scenes are; walks over what is deeper would leave the stack
  bool is_deep = false;
  const auto shallow = [&](int depth, nlohmann::ordered_json::parse_event_t, nlohmann::ordered_json&) {
    is_deep = is_deep || depth > deepest;
    return !is_deep;
  };
  nlohmann::ordered_json summary = nlohmann::ordered_json::parse(read_file(file), shallow, false);
  if (is_deep || !summary.is_object())
    throw InputError(file.string(), "the file", "damaged", "the summary that dda run writes; run the scene again");
  return summary;
}

RunFacts read_facts(const std::filesystem::path& folder) {
  std::error_code ignored;
  RunFacts facts;
  const std::filesystem::path summary = folder / "summary.json";
  if (std::filesystem::exists(summary, ignored)) {
    facts.summary = read_summary(summary);
    if (const auto title = facts.summary.find("title"); title != facts.summary.end() && title->is_string())
      facts.title = title->get<std::string>();
  }
  if (facts.title.empty()) facts.title = std::filesystem::weakly_canonical(folder).filename().string();
  const std::filesystem::path histories = folder / "histories.csv";
  if (std::filesystem::exists(histories, ignored)) facts.histories = read_histories(histories);
  return facts;
}

}  // namespace dda
