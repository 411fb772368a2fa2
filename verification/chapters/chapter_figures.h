// Figures of the thesis drawn again: peak values over what is varied.
#pragma once

#include <string>

#include "engine/view/line_plot.h"
#include "verification/chapters/statement.h"

namespace verify {

// Adds the plot to the chapter as the file `name`.svg, and to the section with its caption. Nothing of a plot without
// lines, or with fewer than two values across.
void add_figure(const std::string& name, const std::string& caption, const dda::LinePlot& plot, Section& section,
                Chapter& chapter);

}  // namespace verify
