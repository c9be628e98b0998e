// Cost and accuracy of the marker methods, on the same images.
#include "calibration/experiments/experiment_runs.h"
#include "core/numerics/median.h"

#include <cmath>
#include <optional>
#include <vector>

namespace alltact {
namespace {

// a marker farther from its true position counts as wrong, or missing
constexpr double kFound_px = 3;

struct NamedMethod {
  MarkerMethod method;
  Message name;
};

/// Images of one difficulty.
struct Difficulty {
  Message name;
  std::vector<const char*> scenes;
};

std::vector<NamedMethod> methods() {
  return {{MarkerMethod::kBlobs, en::say("blobs, the default")},
          {MarkerMethod::kPaper, en::say("the paper's rows")},
          {MarkerMethod::kNetwork, en::say("network")}};
}

std::vector<Difficulty> difficulties() {
  return {{en::say("clear"), {"demo_presses"}},
          {en::say("half hidden"), {"hard_hidden_dots"}},
          {en::say("worn"), {"hard_worn_dots"}},
          {en::say("blurred"), {"hard_defocus_at_the_base", "hard_defocus_at_the_tip"}},
          {en::say("partly lit"), {"hard_dead_lamp"}},
          {en::say("dirty"), {"hard_dirty_skin"}}};
}

/// Result of one method.
struct MarkerTally {
  /// markers visible to the camera, and those of them that are reported
  int in_sight = 0, found = 0;
  int reported = 0, wrong = 0;  ///< reported as seen, and those of them at a wrong position
  int hidden = 0;               ///< reported as estimated
  double square_px2 = 0, hidden_square_px2 = 0;  ///< of those found, of those estimated
  std::vector<double> ms;

  void add(const std::vector<Truth::Dot>& truth, const FrameResult& result) {
    ms.push_back(result.times_ms.markers);
    for (std::size_t m = 0; m < truth.size(); ++m) {
      in_sight += truth[m].visible;
      if (!result.markers || m >= result.markers->size()) continue;
      const Marker& marker = (*result.markers)[m];
      const double off_px = std::hypot(marker.u - truth[m].u, marker.v - truth[m].v);
      if (!marker.seen) {
        ++hidden, hidden_square_px2 += off_px * off_px;
        continue;
      }
      ++reported;
      wrong += off_px > kFound_px;
      if (!truth[m].visible || off_px > kFound_px) continue;
      ++found, square_px2 += off_px * off_px;
    }
  }
  [[nodiscard]] double found_percent() const { return percent_of(found, in_sight); }
};

double rms_of(double squares, int count) {
  return std::sqrt(squares / std::max(1, count));
}

/// One method over all difficulties.
struct MethodTally {
  MarkerTally all;
  std::vector<MarkerTally> by_difficulty{difficulties().size()};
};

using MethodTallies = std::vector<MethodTally>;

Result<int> measure_methods(const ExperimentBench& bench, MethodTallies& tallies) {
  ExperimentBench::Measuring measuring;
  measuring.settings.clear();
  for (const NamedMethod& named : methods())
    measuring.settings.emplace_back().marker_method = named.method;
  const auto all = difficulties();
  int frames = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const char* scene : all[i].scenes) {
      const auto measured = bench.measure(
          scene, measuring, [&](std::size_t which, const Truth& truth, const FrameResult& result) {
            tallies[which].all.add(truth.markers, result);
            tallies[which].by_difficulty[i].add(truth.markers, result);
          });
      if (!measured) return measured.error();
      frames += *measured;
    }
  return frames;
}

void add_figures(const Message& name, MarkerTally& tally, std::vector<ExperimentFigure>& figures) {
  figures.push_back({en::say("{}: markers in sight that are found", name),
                     "%",
                     tally.found_percent(),
                     {},
                     {},
                     true});
  figures.push_back({en::say("{}: told as seen, and elsewhere", name),
                     "%",
                     percent_of(tally.wrong, tally.reported),
                     {},
                     {}});
  figures.push_back({en::say("{}: those found, root mean square", name),
                     "px",
                     rms_of(tally.square_px2, tally.found),
                     {},
                     {}});
  figures.push_back({en::say("{}: hidden ones, root mean square", name),
                     "px",
                     rms_of(tally.hidden_square_px2, tally.hidden),
                     {},
                     {}});
  figures.push_back(
      {en::say("{}: time of a frame, median", name), "ms", upper_median(tally.ms), {}, {}});
}

ExperimentPlot bars_of(const Message& caption,
                       const Message& y_axis,
                       const MethodTallies& tallies,
                       std::optional<double> (*figure)(const MarkerTally& tally)) {
  ExperimentPlot plot{caption, en::say("what is difficult"), y_axis, {}, {}};
  for (const Difficulty& difficulty : difficulties()) plot.categories.push_back(difficulty.name);
  const auto all = methods();
  for (std::size_t index = 0; index < all.size(); ++index) {
    ExperimentSeries bars{all[index].name, ExperimentSeries::Style::kBars, {}, {}};
    const auto& by_difficulty = tallies[index].by_difficulty;
    for (std::size_t i = 0; i < by_difficulty.size(); ++i)
      if (const auto height = figure(by_difficulty[i])) {
        bars.x.push_back(static_cast<double>(i));
        bars.y.push_back(*height);
      }
    plot.series.push_back(std::move(bars));
  }
  return plot;
}

}  // namespace

Result<ExperimentOutcome> run_markers(const ExperimentBench& bench) {
  MethodTallies tallies(methods().size());
  ExperimentOutcome outcome;
  std::vector<const ExperimentBench*> fingers{&bench};
  for (int number = 1; number <= kFingerVariants; ++number) {
    const auto variant = bench.untrained_variant(number);
    if (!variant) return variant.error();
    fingers.push_back(*variant);
  }
  for (const ExperimentBench* finger : fingers) {
    const auto frames = measure_methods(*finger, tallies);
    if (!frames) return frames.error();
    outcome.frames += *frames;
  }
  const auto all = methods();
  for (std::size_t index = 0; index < all.size(); ++index)
    add_figures(all[index].name, tallies[index].all, outcome.figures);
  outcome.plots = {
      bars_of(en::say("markers in sight that are found, each frame by itself"),
              en::say("found (%)"),
              tallies,
              [](const MarkerTally& tally) { return std::optional(tally.found_percent()); }),
      bars_of(en::say("how far hidden markers are from where they are said to be"),
              en::say("root mean square (px)"),
              tallies,
              [](const MarkerTally& tally) {
                const double rms = rms_of(tally.hidden_square_px2, tally.hidden);
                return tally.hidden > 0 ? std::optional(rms) : std::nullopt;
              })};
  outcome.plots.back().logarithmic_y = true;
  outcome.remarks = {
      en::say("The demonstration's finger and {} drawn at random, which the network has not been "
              "trained on. Blobs and network are numbered by the recording, the paper's rows from "
              "left to right with hidden ones between their neighbours; each frame is looked at "
              "anew, as if none had come before. The paper tells no figure of its markers",
              kFingerVariants)};
  return outcome;
}

}  // namespace alltact
