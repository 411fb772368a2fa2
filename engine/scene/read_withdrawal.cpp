#include "engine/scene/read_withdrawal.h"

#include <cstddef>

#include "engine/scene/places.h"

namespace dda {

std::optional<TimeFunction> read_fading(const Field& field) {
  const auto over = field.find("over");
  const auto table = field.find("table");
  if (over) refuse(field, {"table"}, "beside over");
  if (over) return PiecewiseLinear{{0, over->positive(Dimension::time)}, {1, 0}};
  if (!table) return std::nullopt;
  PiecewiseLinear rows = read_table(*table);
  if (evaluate(rows, 0) != 1) table->fail("1 at time 0, when nothing has been let go");
  for (std::size_t i = 0; i < rows.values.size(); ++i)
    if (!(rows.values[i] >= 0 && rows.values[i] <= 1))
      table->items()[i].fail("[time, factor] with a factor from 0 to 1, of what was exerted");
  return rows;
}

Withdrawal read_withdrawal(const Field& owner, int first, const Model& model) {
  Withdrawal withdrawal;
  const auto until = owner.find("until_stage");
  if (!until) return withdrawal;
  const Field name = until->is_object() ? until->at("stage") : *until;
  withdrawal.last_stage = read_stage_reference(name, model);
  if (withdrawal.last_stage < first) name.fail("the stage of from_stage or a later one");
  if (!until->is_object()) return withdrawal;
  withdrawal.relaxation = read_fading(*until);
  const auto next = static_cast<std::size_t>(withdrawal.last_stage) + 1;
  if (withdrawal.relaxation && next < model.stages.size() && model.stages[next].paces_itself() &&
      model.stages[next].duration == 0)
    until->fail("without over and table where the next stage is static, without dt and duration: it takes no time");
  return withdrawal;
}

}  // namespace dda
