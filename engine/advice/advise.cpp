#include "engine/advice/advise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "engine/advice/chain_errors.h"
#include "engine/advice/explicit_offer.h"
#include "engine/advice/joints_in_waves.h"
#include "engine/advice/load_history.h"
#include "engine/advice/near_sides.h"
#include "engine/advice/no_figures.h"
#include "engine/advice/plane_wave_conditions.h"
#include "engine/advice/springs_in_waves.h"
#include "engine/advice/stages_on_the_way.h"
#include "engine/contact/make_contacts.h"
#include "engine/model/quantity_names.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/settling_pace.h"
#include "engine/simulation/system_matrix.h"

namespace dda {
namespace {

struct Direction {
  Vec2 unit;
  std::string name;
};

// Across the joints, each kind once, and half-way between the first two of them.
std::vector<Direction> directions_of(const Lattice& lattice) {
  const std::vector<Vec2> normals = lattice.face_normals();
  if (lattice.row) return {{normals.front(), "along the row"}};
  std::vector<Direction> directions;
  for (const Vec2& normal : normals) {
    const bool known = std::any_of(directions.begin(), directions.end(), [&](const Direction& direction) {
      return looks_the_same(lattice, direction.unit, normal);
    });
    if (!known) directions.push_back({normal, "across the joints"});
  }
  if (normals.size() >= 2) directions.push_back({(normals[0] + normals[1]).normalized(), "diagonal to the joints"});
  return directions;
}

const char* to_text(WaveKind kind) {
  switch (kind) {
    case WaveKind::bar: return "bar";
    case WaveKind::p: return "P";
    case WaveKind::s: return "S";
  }
  return "";
}

double size_along(const Lattice& lattice, const Vec2& direction) { return extent_along(lattice.ring, direction); }

// Four steps in a period, and no longer than is stable where steps are explicit.
double coarsest_dt(double period, double stable_dt) {
  return stable_dt > 0 ? std::min(period / 4, stable_dt) : period / 4;
}

constexpr const char* nothing_comes = "nothing arrives that resembles it within half a period of when it is due";

class Adviser {
 public:
  Adviser(const Simulation& simulation, const AdviceQuestion& question)
      : simulation_(simulation),
        model_(simulation.model()),
        contacts_(simulation.contacts()),
        drawn_(make_contacts(model_)),
        question_(question),
        no_figures_(model_, simulation.out_of_balance()) {
    if (!question.frequency) load_ = scene_load(model_);
    frequency_ = question.frequency ? question.frequency : default_frequency();
    for (std::size_t i = 0; frequency_ && i < model_.materials.size(); ++i)
      if (auto lattice = find_lattice(model_, drawn_, static_cast<int>(i))) lattices_.push_back(std::move(*lattice));
    if (frequency_ && load_) search_way();
  }

  [[nodiscard]] Advice run(const BlockMatrix& matrix) const {
    Advice advice;
    advice.frequency = frequency_;
    advice.load = load_ ? load_->description : "";
    advice.wanted_error = question_.error;
    advice.size = size_of(contacts_, matrix);
    advice.joints_may_open = contacts_.can_change;
    for (const LoadFinding& finding : no_figures_.unseen()) advice.unseen.push_back(finding.sentence);
    for (const LoadFinding& finding : no_figures_.sudden()) advice.sudden.push_back(finding.sentence);
    for (std::size_t i = 0; i < model_.stages.size(); ++i) {
      const Stage& stage = model_.stages[i];
      advice.damped = advice.damped || stage.velocity_factor != 1 || stage.damping_rate != 0;
      advice.stages.push_back(of_stage(i, matrix, advice.size));
    }
    advice.springs = springs_in_waves(model_, advice);
    return advice;
  }

 private:
  [[nodiscard]] std::optional<double> default_frequency() const {
    if (model_.expected.frequency) return model_.expected.frequency;
    if (const auto sine = highest_sine_frequency(model_)) return sine;
    if (load_) return 1 / load_->history.period;
    return std::nullopt;
  }

  [[nodiscard]] StageAdvice of_stage(std::size_t index, const BlockMatrix& matrix, const SceneSize& size) const {
    const Stage stage = model_.with_acting_corrections(model_.stages[index]);
    const BlockTerms terms = make_block_terms(model_, stage);
    const double dt = first_step(model_, stage, contacts_.can_change);
    const StepPlan plan =
        make_plan(model_, index, contacts_, matrix.couplings(), stiffness_numbers(contacts_, terms, dt));
    StageAdvice advice;
    advice.name = stage.name;
    advice.integrator = stage.integrator.name;
    advice.why_integrator = stage.chosen.integrator.reason;
    advice.first_dt = stage.shortest_dt();
    advice.dt = stage.dt;
    advice.chi = plan.chi;
    advice.solver = plan.explicit_steps ? "explicit" : to_string(plan.solver);
    advice.cost = cost_of(size, plan, stage.steps());
    advice.stable_dt = simulation_.stability_limit(index);
    if (question_.limits) advice.explicit_instead = explicit_offer(model_, index, size, advice.cost);
    if (stage.integrator.is_static || !frequency_) return advice;
    if (stage.material_damping.acts()) advice.damping_ratio = stage.material_damping.ratio_at(*frequency_);
    const Course course{stage, index, advice.stable_dt,
                        advice.cost.seconds / static_cast<double>(std::max<std::int64_t>(1, advice.cost.steps))};
    if (way_) advice.waves.push_back(along_way(course));
    if (way_ && way_->kind == WaveKind::bar) return advice;
    for (const Lattice& lattice : lattices_)
      for (const WaveKind kind : lattice.row ? std::vector{WaveKind::bar} : std::vector{WaveKind::p, WaveKind::s})
        for (const Direction& direction : directions_for(lattice))
          advice.waves.push_back(of_wave(lattice, course, kind, direction));
    return advice;
  }

  // What is assumed of the mesh, or of a load on it, is no foretelling. A sentence where it cannot be.
  [[nodiscard]] std::string why_not_foretold(const Lattice& lattice) const {
    if (way_) return "the way from where it is driven is foretold for itself";
    const bool moved = static_cast<bool>(load_->history.displacement);
    if (lattice.assumed || (!why_no_way_.empty() && (lattice.row || moved || lattices_.size() > 1)))
      return fmt::format("cannot be foretold: {}", why_no_way_.empty() ? "blocks are not alike" : why_no_way_);
    return "";
  }

  // Into the rock from where it is driven, as far as that is known; else the direction asked about.
  [[nodiscard]] Vec2 way_into(const Vec2& direction) const {
    if (!load_->face.isZero(0)) return load_->face;
    return direction.dot(load_->looked_at - load_->place) < 0 ? Vec2(-direction) : direction;
  }

  [[nodiscard]] std::string what_disturbs(const Course& course, const DrivenWave& wave) const {
    std::string why = why_no_plane_wave(model_, course.index, *load_, wave, no_figures_.sudden());
    return why.empty() ? why_steps_change(model_, course.index, *load_, wave.timing.window) : why;
  }

  void check_joints(const Course& course, const WaveWay& wave, double window, WaveAdvice& advice) const {
    if (!advice.history) return;
    const WaveStress stress = stress_of(*load_, *advice.history, wave, advice.speed * window);
    if (const std::string why = why_joints_give_way(model_, course.index, drawn_, stress); !why.empty())
      cannot_foretell(why, advice);
  }

  void foretell_history(const WaveQuestion& question, const Course& course, WaveAdvice& advice) const {
    const Vec2 into = way_into(question.direction);
    const bool row = question.lattice.row;
    const WaveTiming timing = timing_of(question, load_->history);
    if (const std::string why = what_disturbs(course, {into, row, question.distance, timing}); !why.empty())
      return cannot_foretell(why, advice);
    advice.history = history_errors(question, load_->history);
    if (!advice.history) {
      advice.not_foretold = nothing_comes;
    } else if (is_from_face(question.lattice, question.direction)) {
      if (!advice.history->with_end) {
        cannot_foretell("the blocks on the face that is loaded are cut askew", advice);
      } else if (!is_row() && is_along(question.kind, load_->face)) {
        const MeshPlace place{load_->face, question.kind, advice.history->place,
                              load_->motion.dot(polarization(question.kind, load_->face))};
        count_sides(course, place, timing.window, advice, [&](const std::vector<double>& trace) {
          return read_other(question, load_->history, trace, course.stage.dt);
        });
      }
    }
    // The direction may stand for that of the load, which other joints than those of the mesh lie across.
    const Vec2 along = is_from_face(question.lattice, question.direction) ? load_->face : question.direction;
    const double unit = unit_of_load(model_, *load_, question.kind, into, row);
    check_joints(course, {question.kind, along, unit}, timing.window, advice);
  }

  static void cannot_foretell(const std::string& why, WaveAdvice& advice) {
    advice.history.reset();
    advice.not_foretold = "cannot be foretold: " + why;
  }

  // Whether what drives the scene moves particles as such a wave does.
  [[nodiscard]] bool is_along(WaveKind kind, const Vec2& direction) const {
    return std::abs(load_->motion.dot(polarization(kind, direction))) > (1 - 1e-6) * load_->motion.norm();
  }

  // Adds to a history foretold what sides of a mesh that are near make of it.
  void count_sides(const Course& course, const MeshPlace& place, double window, WaveAdvice& advice,
                   const ReadTrace& read) const {
    const BetweenSides found = NearSides(model_, drawn_, *load_, course).count(*advice.history, place, window, read);
    advice.history = found.history;
    if (!found.why_not.empty()) cannot_foretell(found.why_not, advice);
  }

  [[nodiscard]] bool is_row() const {
    if (way_) return way_->layers.size() == model_.blocks.size();
    return std::ranges::any_of(lattices_, [](const Lattice& lattice) { return lattice.row; });
  }

  // Directions that look the same in the mesh stand for each other: one of them is asked about.
  [[nodiscard]] bool is_from_face(const Lattice& lattice, const Vec2& direction) const {
    const Vec2& face = load_->face;
    if (face.isZero(0)) return false;
    return std::abs(face.dot(direction)) > 1 - 1e-6 || looks_the_same(lattice, direction, face);
  }

  // The scene's own layers are asked where blocks that repeat themselves do not say it all.
  void search_way() {
    PathSearch search = find_chain_path(model_, drawn_, *load_);
    if (!search.path) {
      why_no_way_ = search.why_not;
    } else if (search.path->is_moved || lattices_.size() != 1 || !search.path->repeats_itself(model_, drawn_)) {
      way_ = std::move(search.path);
    }
  }

  [[nodiscard]] WaveAdvice along_way(const Course& course) const {
    const Stage& stage = course.stage;
    const ChainQuestion question(model_, *way_, stage, way_distance());
    WaveAdvice advice;
    for (const Material& material : model_.materials) {
      const bool met = std::any_of(way_->layers.begin(), way_->layers.end(), [&](const ChainLayer& layer) {
        return model_.material_of(layer.block).name == material.name;
      });
      if (met) advice.material += (advice.material.empty() ? "" : ", ") + material.name;
    }
    advice.kind = to_text(way_->kind);
    advice.mesh = fmt::format("the scene's own {} layers, one behind the other", way_->layers.size());
    advice.own_layers = true;
    advice.direction = way_->direction + Vec2::Zero();  // and no negative zeros
    advice.direction_name = "from where it is driven";
    advice.speed = question.speed();
    advice.wavelength = advice.speed / *frequency_;
    for (const ChainLayer& layer : way_->layers) advice.block_size = std::max(advice.block_size, layer.thickness);
    advice.distance = question.place();
    advice.steady = question.steady_errors(*frequency_);
    advice.asked_history = true;
    const double wavelength = advice.speed * load_->history.period;
    advice.not_foretold = no_figures_.why(*load_, course.index, wavelength, advice.block_size);
    if (!advice.not_foretold.empty()) return advice;
    const ChainQuestion::OtherTrace other = question.other_trace(load_->history);
    if (const std::string why = what_disturbs(course, {way_->direction, is_row(), question.place(), other.timing});
        !why.empty()) {
      cannot_foretell(why, advice);
      return advice;
    }
    advice.history = question.history_errors(load_->history);
    if (!advice.history) {
      advice.not_foretold = nothing_comes;
    } else {
      const MeshPlace place{way_->direction, way_->kind, advice.history->place, unit_of_way()};
      if (!is_row()) count_sides(course, place, other.timing.window, advice, other.read);
      check_joints(course, {way_->kind, way_->direction, unit_of_way()}, other.timing.window, advice);
    }
    if (question_.limits && has_limits(advice)) advice.limits = limits_of(question, course, advice);
    return advice;
  }

  // Pa, of a wave along the way as it sets out.
  [[nodiscard]] double unit_of_way() const {
    const double motion = load_->motion.dot(polarization(way_->kind, way_->direction));
    if (!way_->is_moved) return unit_of_load(model_, *load_, way_->kind, way_->direction, is_row());
    const ChainLayer& first = way_->layers[way_->driven_as_whole ? 1 : 0];
    return motion * first.impedance / first.width;
  }

  // A mesh and steps that nothing comes through have limits to keep; what cannot be foretold has none.
  static bool has_limits(const WaveAdvice& advice) {
    return advice.not_foretold.empty() || advice.not_foretold == nothing_comes;
  }

  // And the way from where it is driven, where that is another and has no layers of its own.
  [[nodiscard]] std::vector<Direction> directions_for(const Lattice& lattice) const {
    std::vector<Direction> directions = directions_of(lattice);
    if (lattice.row || !load_ || way_) return directions;
    const Vec2 way = way_of(*load_) + Vec2::Zero();
    const bool known = way.isZero(0) || std::any_of(directions.begin(), directions.end(), [&](const Direction& other) {
                         return looks_the_same(lattice, other.unit, way);
                       });
    if (!known) directions.push_back({way, "from where it is driven"});
    return directions;
  }

  [[nodiscard]] double way_distance() const {
    if (question_.distance) return *question_.distance;
    double distance = way_->direction.dot(load_->looked_at - load_->place);
    if (way_->driven_as_whole) distance -= way_->layers.front().thickness / 2;  // from its middle to its face
    return distance > 0 ? distance : way_->layers.front().speed / *frequency_;
  }

  // Layers stay as they are: they belong to the scene.
  [[nodiscard]] WaveLimits limits_of(const ChainQuestion& question, const Course& course,
                                     const WaveAdvice& advice) const {
    const auto error_of = [&](double dt, double scale) -> std::optional<double> {
      if (scale != 1) return std::nullopt;
      return largest(question.with_dt(dt).total_history_errors(load_->history), advice);
    };
    return find_limits(error_of, course.stage.dt, {coarsest_dt(load_->history.period, course.stable_dt), 1},
                       question_.error);
  }

  // A plane wave from a loaded edge has gone square to it; from elsewhere, or in other directions, straight there.
  [[nodiscard]] double distance_for(const Lattice& lattice, const Vec2& direction, double wavelength) const {
    if (question_.distance) return *question_.distance;
    double farthest = 0;
    if (load_) {
      const bool from_face = is_from_face(lattice, direction);
      for (const Measurement& measurement : model_.measurements) {
        const Vec2 gone = measurement.point - load_->place;
        if (is_at_point(measurement)) farthest = std::max(farthest, from_face ? load_->face.dot(gone) : gone.norm());
      }
    }
    return farthest > 0 ? farthest : wavelength;
  }

  [[nodiscard]] WaveAdvice of_wave(const Lattice& lattice, const Course& course, WaveKind kind,
                                   const Direction& direction) const {
    const Stage& stage = course.stage;
    WaveAdvice advice;
    advice.material = lattice.material.name;
    advice.kind = to_text(kind);
    advice.mesh = lattice.origin;
    advice.direction = direction.unit;
    advice.direction_name = direction.name;
    advice.speed = continuum_speed(lattice.material, kind);
    advice.wavelength = advice.speed / *frequency_;
    advice.block_size = size_along(lattice, direction.unit);
    advice.distance = distance_for(lattice, direction.unit, advice.wavelength);
    const WaveQuestion question{lattice, stage, kind, direction.unit, advice.distance};
    advice.steady = steady_errors(question, *frequency_);
    advice.asked_history = load_.has_value();
    if (load_)
      advice.not_foretold =
          no_figures_.why(*load_, course.index, advice.speed * load_->history.period, advice.block_size);
    if (load_ && advice.not_foretold.empty()) advice.not_foretold = why_not_foretold(lattice);
    if (!advice.not_foretold.empty()) return advice;
    if (load_) foretell_history(question, course, advice);
    if (question_.limits && has_limits(advice)) advice.limits = limits_of(question, course, advice);
    return advice;
  }

  [[nodiscard]] WaveLimits limits_of(const WaveQuestion& question, const Course& course,
                                     const WaveAdvice& advice) const {
    const auto error_of = [&](double dt, double scale) -> std::optional<double> {
      WaveQuestion changed = question;
      changed.stage.dt = dt;
      if (scale != 1) changed.lattice = scaled(question.lattice, scale);
      return load_ ? largest(total_history_errors(changed, load_->history), advice)
                   : largest(total_steady_errors(changed, *frequency_), advice);
    };
    const double period = load_ ? load_->history.period : 1 / *frequency_;
    const CoarseBounds coarse{coarsest_dt(period, course.stable_dt), advice.speed * period / 4 / advice.block_size};
    return find_limits(error_of, question.stage.dt, coarse, question_.error);
  }

  // What sides add neither blocks nor steps take away.
  static std::optional<double> largest(const std::optional<TotalErrors>& errors, const WaveAdvice& advice) {
    if (!errors) return std::nullopt;
    const double speed = advice.history ? advice.history->speed.sides : 0;
    const double amplitude = advice.history ? advice.history->amplitude.sides : 0;
    return std::max(std::abs(errors->speed + speed), std::abs(errors->amplitude + amplitude));
  }

  const Simulation& simulation_;
  const Model& model_;
  const ContactSet& contacts_;  // as they are followed
  const ContactSet drawn_;      // joints as drawn, along which waves are predicted
  const AdviceQuestion& question_;
  NoFigures no_figures_;
  std::optional<SceneLoad> load_;
  std::optional<double> frequency_;
  std::vector<Lattice> lattices_;
  std::optional<ChainPath> way_;
  std::string why_no_way_;
};

}  // namespace

Advice advise(const Simulation& simulation, const AdviceQuestion& question) {
  const BlockMatrix matrix = make_system_matrix(static_cast<int>(simulation.model().blocks.size()),
                                                simulation.contacts(), simulation.bolts().pairs());
  return Adviser(simulation, question).run(matrix);
}

}  // namespace dda
