// Forces from the markers, held out by whole groups.
#include "calibration/experiments/push_experiments.h"

#include "calibration/experiments/experiment_runs.h"
#include "calibration/force/collect_force.h"

#include <cmath>

namespace alltact {
namespace {

constexpr int kForceFingers = 3;
constexpr int kPlaces = 22;  // of the scene experiment_force, one after the other

/// Held-out rows of all fingers.
struct HeldOutForces {
  std::array<ErrorSamples, 2> error_N;
  std::array<double, 2> worst_N{};  ///< mean error of the worst finger
  double covered = 0, rows = 0;     ///< within their intervals of 95 %, both axes
  int frames = 0;
  std::array<int, kForceKinds.size()> kept{};

  void add(const ForceTable& table, const TrainedForce& trained) {
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const Eigen::VectorXd off =
          (trained.held_out_N.col(axis) - table.force_N.col(axis)).cwiseAbs();
      for (const double error : off) error_N[a].add(error);
      worst_N[a] = std::max(worst_N[a], off.mean());
      covered += trained.covered_95[axis] * static_cast<double>(off.size());
      rows += static_cast<double>(off.size());
    }
    ++kept[static_cast<std::size_t>(trained.model.kind) - 1];
  }
};

}  // namespace

ForceTraining training_of_experiments() {
  ForceTraining training;
  training.comparison_only = true;
  return training;
}

Result<ForceTable> table_of_pushes(const ExperimentBench& bench,
                                   const std::string& scene,
                                   int places) {
  std::vector<MarkerFrame> frames;
  ForceGauge gauge;
  gauge.has_block = true;
  int number = 0;
  const auto measured = bench.measure(
      scene, {PipelineSettings{}}, [&](std::size_t, const Truth& truth, const FrameResult& result) {
        const int place = number++ % places;
        if (!result.markers || truth.contacts.empty()) return;
        std::optional<Eigen::Vector2d> place_mm;
        if (!result.regions.empty()) place_mm = result.regions.front().place_on_face_mm;
        frames.push_back({result.frame->name, std::nullopt, *result.markers, place_mm});
        GaugeReading reading;
        reading.frame = result.frame->name;
        reading.force_N = truth.contacts.front().force_N.value();
        reading.block = fmt::format("place {}", place);
        gauge.readings.push_back(std::move(reading));
      });
  if (!measured) return measured.error();
  auto collected = collect_force(frames, gauge);
  if (!collected) return collected.error();
  return std::move(collected->table);
}

Result<ExperimentOutcome> run_force(const ExperimentBench& bench) {
  static constexpr const char* kScene = "experiment_force";
  HeldOutForces held_out;
  ExperimentOutcome outcome;
  for (int number = 1; number <= kForceFingers; ++number) {
    const auto drawn = bench.drawn(number);
    if (!drawn) return drawn.error();
    const auto table = table_of_pushes(*drawn, kScene, kPlaces);
    if (!table) return table.error();
    const auto trained =
        train_force(*table,
                    drawn->finger().finger.contact.value_or(ContactSettings{}).rest_markers,
                    training_of_experiments(),
                    bench.job());
    if (!trained) return trained.error();
    held_out.add(*table, *trained);
    outcome.frames += static_cast<int>(table->rows());
  }
  const auto& error_N = held_out.error_N;
  outcome.figures = {
      {en::say("Fx, mean error on places held out"), "N", error_N[0].mean(), 0.244, 0.1},
      {en::say("Fy, mean error on places held out"), "N", error_N[1].mean(), 0.162, 0.1},
      {en::say("Fx, the same of the worst finger"), "N", held_out.worst_N[0], {}, {}},
      {en::say("Fy, the same of the worst finger"), "N", held_out.worst_N[1], {}, {}},
      {en::say("forces within their intervals of 95 %"),
       "%",
       100 * held_out.covered / held_out.rows,
       {},
       {}},
  };
  outcome.remarks = {
      en::say("{} fingers drawn at random, {} pushes each, at {} places, of which whole ones are "
              "held out; forces are those on the finger in the camera's axes and have no error of "
              "a gauge",
              kForceFingers,
              outcome.frames / kForceFingers,
              kPlaces)};
  return outcome;
}

}  // namespace alltact
