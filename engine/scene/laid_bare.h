// The faces that an opening lays bare: those of other blocks that lie on blocks which are away.
#pragma once

#include <string>
#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

// `name`: of blocks or of a group (`groups`: of each block). They must be away in all of `stages`; faces are those of
// blocks that are there in the first of them.
std::vector<Stretch> faces_laid_bare(const Field& name, const std::vector<std::string>& groups, const StageSpan& stages,
                                     const Model& model);

}  // namespace dda
