// The page about the blast of the thesis' chapter 4, as a Document.
#pragma once

#include "verification/study/document.h"
#include "verification/thesis/blast_study.h"

namespace verify {

[[nodiscard]] Document blast_report(const ThesisBlast& blast, const BlastStudy& study);

}  // namespace verify
