#include "engine/view/run_facts.h"

#include <system_error>

#include "engine/core/error.h"
#include "engine/core/read_file.h"

namespace dda {

RunFacts read_facts(const std::filesystem::path& folder) {
  std::error_code ignored;
  RunFacts facts;
  const std::filesystem::path summary = folder / "summary.json";
  if (std::filesystem::exists(summary, ignored)) {
    facts.summary = nlohmann::ordered_json::parse(read_file(summary), nullptr, false);
    if (!facts.summary.is_object())
      throw InputError(summary.string(), "the file", "damaged", "the summary that dda run writes; run the scene again");
    facts.title = facts.summary.value("title", "");
  }
  if (facts.title.empty()) facts.title = std::filesystem::weakly_canonical(folder).filename().string();
  const std::filesystem::path histories = folder / "histories.csv";
  if (std::filesystem::exists(histories, ignored)) facts.histories = read_histories(histories);
  return facts;
}

}  // namespace dda
