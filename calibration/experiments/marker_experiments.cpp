#include "calibration/experiments/experiments.h"
#include "calibration/study/evaluate.h"
#include "core/numerics/median.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace alltact {

// Results from the dots: direction of a push, and choice of the reference for a pose.

namespace {

constexpr int kRegions = 8;

/// Number of the eighth of the circle that contains a direction, the first one around +u.
int region_of(const Eigen::Vector2d& direction) {
  const double eighths = std::atan2(direction.y(), direction.x()) * kRegions / 2 / std::numbers::pi;
  return (static_cast<int>(std::lround(eighths)) + kRegions) % kRegions;
}

/// Sum of the dots' displacements from rest, px.
Eigen::Vector2d true_offset_px(const Truth& now, const Truth& rest) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < now.markers.size(); ++i)
    sum +=
        Eigen::Vector2d(now.markers[i].u - rest.markers[i].u, now.markers[i].v - rest.markers[i].v);
  return sum;
}

/// Fraction of the frames within a distance.
ExperimentSeries frames_within(const Message& name, std::vector<double> distances_px) {
  std::sort(distances_px.begin(), distances_px.end());
  ExperimentSeries series{name, ExperimentSeries::Style::kLine, {}, {}};
  for (std::size_t i = 0; i < distances_px.size(); ++i) {
    series.x.push_back(distances_px[i]);
    series.y.push_back(100.0 * static_cast<double>(i + 1) /
                       static_cast<double>(distances_px.size()));
  }
  return series;
}

constexpr const char* kReferencesScene = "experiment_references";

/// Distance of each frame's reference, and the result where it is far.
struct NearReferences {
  static constexpr double kNear_px = 10;
  int frames = 0, mean = 0, sum = 0, combined_sum = 0;  ///< within that distance
  int combined_or_estimated = 0;
  std::vector<double> combined_px;  ///< summed over the dots

  void add(const ReferenceLibrary& library, const FrameResult& result) {
    ++frames;
    if (!result.reference || !result.markers) return;
    const int dots = seen_count(*result.markers);
    const double mean_px = result.reference->distance_px;
    const double together_px = dots * library.combined_distance_px(*result.markers);
    combined_px.push_back(together_px);
    mean += mean_px < kNear_px || !result.reference->known_pose;
    sum += dots * mean_px < kNear_px;
    combined_sum += together_px < kNear_px;
    combined_or_estimated +=
        together_px < kNear_px || !result.reference->known_pose || result.reference->is_sparse();
  }
};

double angle_between_deg(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b))) * 180 / std::numbers::pi;
}

}  // namespace

Result<ExperimentOutcome> run_direction(const ExperimentBench& bench) {
  const double least_px = bench.finger().finger.contact.value_or(ContactSettings{}).threshold_px;
  ExperimentOutcome outcome;
  ErrorSamples angles;
  int pushed = 0, right = 0;
  ExperimentSeries by_direction{en::say("ours, simulated"), ExperimentSeries::Style::kDots, {}, {}};
  for (const char* scene : {"experiment_direction", "experiment_references"}) {
    const auto frames =
        bench.measure(scene, {}, [&](std::size_t, const Truth& truth, const FrameResult& result) {
          const Eigen::Vector2d truly = true_offset_px(truth, bench.truth_at_rest());
          if (truly.norm() <= least_px) return;  // pushed less than the detection limit
          ++pushed;
          if (!result.push || !result.push->direction) return;
          const Eigen::Vector2d estimated = result.push->direction->head<2>();
          right += region_of(estimated) == region_of(truly);
          angles.add(angle_between_deg(estimated, truly));
          by_direction.x.push_back(std::atan2(truly.y(), truly.x()) * 180 / std::numbers::pi);
          by_direction.y.push_back(angle_between_deg(estimated, truly));
        });
    if (!frames) return frames.error();
    outcome.frames += *frames;
  }
  if (angles.count == 0) return no_result("experiment_direction");
  outcome.figures = {
      {en::say("pushes with the correct side of 8"), "%", percent_of(right, pushed), 98.1, 99.5,
       true},
      {en::say("direction of a push in the image, mean error"), "degrees", angles.mean(), {}, {}},
      {en::say("direction of a push in the image, maximum error"),
       "degrees",
       angles.greatest,
       {},
       {}},
  };
  outcome.plots.push_back(compared_bars(en::say("pushes with the correct side of 8"),
                                        en::say("correct (%)"), {en::say("one of 8 sides")},
                                        {percent_of(right, pushed)}, {98.1}));
  outcome.plots.push_back(
      {en::say("error of a push's direction in the image; sides begin at 22.5 degrees and every 45 "
               "from there; the paper gives no figure for it"),
       en::say("true direction (degrees)"),
       en::say("error of the direction (degrees)"),
       {by_direction},
       {}});
  outcome.remarks = {
      en::say("{} pushes, by the true motion of the dots in the image; those near a border of two "
              "sides count like all others",
              pushed)};
  return outcome;
}

Result<ExperimentOutcome> run_references(const ExperimentBench& bench) {
  static constexpr double kClose_px = 40;  // summed over the dots, as in the paper
  static constexpr std::array kMethods{ReferenceMethod::kSingle, ReferenceMethod::kNearest,
                                       ReferenceMethod::kLocal};
  ExperimentBench::Measuring measuring;
  measuring.truth = TruthDetail::kAll;
  measuring.settings.resize(kMethods.size());
  for (std::size_t i = 0; i < kMethods.size(); ++i) measuring.settings[i].reference = kMethods[i];
  std::array<int, kMethods.size()> close{};
  std::array<std::vector<double>, kMethods.size()> distances_px;
  std::vector<Evaluator> errors(kMethods.size(), Evaluator(bench.finger().camera));
  NearReferences near;
  const auto frames = bench.measure(
      kReferencesScene, measuring,
      [&](std::size_t which, const Truth& truth, const FrameResult& result) {
        if (kMethods[which] == ReferenceMethod::kLocal) near.add(bench.library(), result);
        if (result.reference && result.markers) {
          const double sum_px = result.reference->distance_px * seen_count(*result.markers);
          close[which] += sum_px < kClose_px;
          distances_px[which].push_back(sum_px);
        }
        if (!result.depth) return errors[which].add_missing();
        errors[which].add(truth, result.depth->depth_mm,
                          contact_face_points_mm(result, bench.finger().finger.face),
                          result.markers.value_or(Markers{}));
      });
  if (!frames) return frames.error();
  for (int number = 1; number <= kFingerVariants; ++number) {
    const auto variant = bench.untrained_variant(number);
    if (!variant) return variant.error();
    const auto more = (*variant)->measure(
        kReferencesScene, {}, [&](std::size_t, const Truth&, const FrameResult& result) {
          near.add((*variant)->library(), result);
        });
    if (!more) return more.error();
  }
  std::array<double, kMethods.size()> false_depth_mm{};
  for (std::size_t i = 0; i < kMethods.size(); ++i) {
    const auto mean = errors[i].evaluation().false_depth_mm;
    if (!mean) return no_result("experiment_references");
    false_depth_mm[i] = *mean;
  }
  ExperimentOutcome outcome;
  outcome.frames = near.frames;
  outcome.figures = {
      {en::say("frames under 40 px, nearest recorded image"),
       "%",
       percent_of(close[1], *frames),
       91.0,
       {},
       true},
      {en::say("frames under 40 px, one reference"),
       "%",
       percent_of(close[0], *frames),
       40.6,
       {},
       true},
      {en::say("frames under 10 px per dot, or reported as a pose never recorded"),
       "%",
       percent_of(near.mean, near.frames),
       {},
       99.5,
       true},
      {en::say("depth without contact, one reference"), "mm", false_depth_mm[0], {}, {}},
      {en::say("depth without contact, nearest recorded image"), "mm", false_depth_mm[1], {}, {}},
      {en::say("depth without contact, local regression"), "mm", false_depth_mm[2], {}, {}},
      {en::say("frames under 10 px summed over the dots, nearest of a recording"),
       "%",
       percent_of(near.sum, near.frames),
       {},
       {},
       true},
      {en::say("the same, for the recorded frames as the reference combines them"),
       "%",
       percent_of(near.combined_sum, near.frames),
       {},
       {},
       true},
      {en::say("the same, or the pose or its surroundings are reported as not recorded"),
       "%",
       percent_of(near.combined_or_estimated, near.frames),
       {},
       99.5,
       true},
  };
  outcome.plots.push_back(
      {en::say("share of frames with a reference closer than the given px, summed over the dots"),
       en::say("distance to the reference (px)"),
       en::say("frames (%)"),
       {frames_within(en::say("nearest of a recording, ours"), distances_px[1]),
        frames_within(en::say("one reference, ours"), distances_px[0]),
        frames_within(en::say("as the reference combines them, ours"), near.combined_px),
        {en::say("nearest, paper, measured"), ExperimentSeries::Style::kPaper, {kClose_px}, {91.0}},
        {en::say("one, paper, measured"), ExperimentSeries::Style::kPaper, {kClose_px}, {40.6}}},
       {}});
  outcome.remarks = {
      en::say("The number of frames near a single reference depends on how far the finger moves; "
              "here the scene sets this, in the paper its own recording"),
      en::say(
          "The paper sums the distance over its dots, and so does the figure under 40 px here; the "
          "figure under 10 px covers this finger and {} drawn at random, per dot and summed",
          kFingerVariants)};
  return outcome;
}

// Cost and accuracy of the marker methods, on the same images.

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

double rms_of(double squares, int count) { return std::sqrt(squares / std::max(1, count)); }

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
  figures.push_back({en::say("{}: visible markers that are found", name),
                     "%",
                     tally.found_percent(),
                     {},
                     {},
                     true});
  figures.push_back({en::say("{}: reported as seen, but elsewhere", name),
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

ExperimentPlot bars_of(const Message& caption, const Message& y_axis, const MethodTallies& tallies,
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
      bars_of(en::say("visible markers that are found, each frame by itself"), en::say("found (%)"),
              tallies,
              [](const MarkerTally& tally) { return std::optional(tally.found_percent()); }),
      bars_of(en::say("how far hidden markers are from their reported positions"),
              en::say("root mean square (px)"), tallies, [](const MarkerTally& tally) {
                const double rms = rms_of(tally.hidden_square_px2, tally.hidden);
                return tally.hidden > 0 ? std::optional(rms) : std::nullopt;
              })};
  outcome.plots.back().logarithmic_y = true;
  outcome.remarks = {en::say(
      "The demonstration's finger and {} drawn at random, on which the network was not trained. "
      "The recording numbers blobs and network dots; the paper's rows are numbered from left to "
      "right, hidden dots between their neighbours. Each frame is analysed anew, as if none had "
      "come before. The paper gives no figure for its markers",
      kFingerVariants)};
  return outcome;
}

}  // namespace alltact
