// Errors of the wave that sets out from what drives a scene, along its own blocks: for rows and layers that are not the
// same all along, and for ends that are moved. wave_errors.h is for blocks that repeat themselves.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engine/advice/chain.h"
#include "engine/advice/wave_errors.h"

namespace dda {

class ChainQuestion {
 public:
  // `distance`: m, along the way, to where the wave is looked at: the joint nearest to that.
  ChainQuestion(const Model& model, const ChainPath& path, const Stage& stage, double distance);

  // Asks about the same blocks under other time steps.
  [[nodiscard]] ChainQuestion with_dt(double dt) const;

  [[nodiscard]] double place() const { return path_.distance_of(joint_); }                          // m
  [[nodiscard]] double speed() const { return path_.distance_of(joint_) / path_.time_to(joint_); }  // m/s, of the rock

  // The phase of a steady wave there against that in the rock, and its amplitude.
  [[nodiscard]] std::optional<SteadyErrors> steady_errors(double frequency) const;
  // Returns nothing where what arrives does not resemble what should.
  [[nodiscard]] std::optional<HistoryErrors> history_errors(const LoadHistory& load) const;
  [[nodiscard]] std::optional<TotalErrors> total_steady_errors(double frequency) const;
  [[nodiscard]] std::optional<TotalErrors> total_history_errors(const LoadHistory& load) const;

  // When that stress comes, and the same readings of another trace of it, which has the stage's dt.
  struct OtherTrace {
    WaveTiming timing;
    std::function<std::optional<ArrivalErrors>(const std::vector<double>&)> read;
  };
  [[nodiscard]] OtherTrace other_trace(const LoadHistory& load) const;

 private:
  // Compares a steady wave with what it should be: the angle that it is late (rad), the ratio of amplitudes, and the
  // lags on the way up to its frequency, of phases and of groups.
  struct Phase {
    double angle = 0, amplitude = 0;
    Lags lags;
  };
  struct Traces;

  [[nodiscard]] const Chain& chain(Causes causes) const;
  [[nodiscard]] double fastest() const;
  [[nodiscard]] int layers_for(double window) const;
  [[nodiscard]] double window_for(const LoadHistory& load, const Lags& lags) const;
  [[nodiscard]] Complex force(Causes causes, Complex s, int layers) const;
  [[nodiscard]] Complex ratio(Causes causes, double omega, double growth, int layers) const;
  [[nodiscard]] Phase phase(Causes causes, double omega) const;
  [[nodiscard]] std::optional<TotalErrors> steady(Causes causes, double frequency) const;
  [[nodiscard]] std::function<double(double)> drive(Causes causes, const LoadHistory& load) const;
  [[nodiscard]] Complex integral(Causes causes, Complex s) const;
  [[nodiscard]] Lags lags(Causes causes, const LoadHistory& load) const;
  [[nodiscard]] double interval_for(double window) const;
  [[nodiscard]] double beyond(const LoadHistory& load, const Lags& lags) const;
  [[nodiscard]] std::function<double(double)> exact(const LoadHistory& load, const Lags& lags) const;
  [[nodiscard]] Traces traces(Causes causes, const LoadHistory& load, const Lags& lags) const;
  [[nodiscard]] std::optional<ArrivalErrors> read(Causes causes, const LoadHistory& load) const;

  const Model* model_;
  ChainPath path_;
  Stage stage_;
  int joint_;
  mutable std::array<std::shared_ptr<const Chain>, 3> chains_;  // by causes, made when they are asked for
};

}  // namespace dda
