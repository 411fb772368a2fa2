// What `dda reaction` found, for people, for programs and for spreadsheets.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/reaction/ground_reaction.h"

namespace dda {

// The point at which the rock did not come to rest, where there is one.
[[nodiscard]] std::optional<ReactionPoint> failure_of(const ReactionCurve& curve);

// What a reader must know of the curve beside its points; whole sentences.
[[nodiscard]] std::vector<std::string> remarks_on(const ReactionCurve& curve, const Model& model);

[[nodiscard]] std::string reaction_text(const ReactionCurve& curve, const std::string& opening, const Model& model);
[[nodiscard]] std::string reaction_json(const ReactionCurve& curve, const std::string& opening, const Model& model);
// A row for every point that settled.
[[nodiscard]] std::string reaction_csv(const ReactionCurve& curve);

}  // namespace dda
