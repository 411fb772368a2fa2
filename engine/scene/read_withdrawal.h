// How something that held rock goes: at once, or with a force that fades.
#pragma once

#include <optional>

#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

// `over` or `table` of an object; nothing where neither is given.
std::optional<TimeFunction> read_fading(const Field& field);

// `until_stage` of what is put in with the stage `first`.
Withdrawal read_withdrawal(const Field& owner, int first, const Model& model);

}  // namespace dda
