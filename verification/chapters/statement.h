// A statement of the thesis that can be checked, and what this engine says to it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "verification/study/document.h"

namespace verify {

using Finding = std::variant<std::string, double>;  // words, or a number in the statement's unit

struct Statement {
  int chapter = 0;
  std::string id;
  std::string statement;
  Finding thesis;
  Finding ours;
  std::string unit;               // "" for words
  std::optional<bool> confirmed;  // none: it cannot be judged, and `reason` says why
  std::string reason;             // what was compared, and the tolerance with its source
};

// One way to read what the text leaves open, and whether a statement holds in it.
struct Reading {
  std::string name;
  std::optional<bool> holds;  // none: this reading cannot tell
  std::string measured;
};

// A statement about which the readings may differ: "confirmed for 17 of 20 readings". It counts as confirmed when it
// holds in more than half of the readings that can tell, as not confirmed when in less than half; otherwise it cannot
// be judged. The reason is extended by the readings that are in the minority and those that cannot tell.
[[nodiscard]] Statement judged_over(Statement statement, const std::vector<Reading>& readings);

// A figure of the page: an SVG file beside it.
struct PageFigure {
  std::string file;
  std::string svg;
};

struct Chapter {
  int number = 0;
  std::string title;
  std::vector<Statement> statements;
  std::vector<std::string> assumptions;
  std::vector<Section> sections;      // what the page shows besides
  std::vector<PageFigure> figures;    // whose files the sections name
  std::vector<std::string> failures;  // runs that ended otherwise than well, a sentence each
};

}  // namespace verify
