// The table of one case in docs/verification.md, and whether an earlier one still holds.
#pragma once

#include <string>
#include <vector>

#include "verification/suite/row.h"

namespace verify {

using Lines = std::vector<std::string>;

// A Markdown table of the rows of one case, with notes on references and tolerances below it. Values to six digits,
// errors to two; errors below 1e-8, which round-off may have made, as the power of ten they are well below.
[[nodiscard]] Lines page_table(const std::vector<Row>& rows);

// How much of its tolerance the printed error of a row takes up: 1 is all of it. Errors printed as bounds, which are
// round-off, and exact counts take up nothing.
struct Margin {
  std::string quantity;
  double share;
};

// One for each row of a printed table.
[[nodiscard]] std::vector<Margin> margins_of(const Lines& printed);

// What of `printed`, the table in the page, is not so in `measured`: a sentence each. Texts must be the same; numbers
// may differ by what is printed of them and by a fiftieth of the tolerance, whichever is more.
[[nodiscard]] std::vector<std::string> differences(const Lines& printed, const Lines& measured);

}  // namespace verify
