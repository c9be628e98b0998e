// Results from the dots: direction of a push, and choice of the reference for a pose.
#include "calibration/experiments/experiment_runs.h"
#include "calibration/study/evaluate.h"

#include <array>
#include <cmath>
#include <numbers>

namespace alltact {
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

int dots_seen(const Markers& markers) {
  return static_cast<int>(
      std::count_if(markers.begin(), markers.end(), [](const Marker& m) { return m.seen; }));
}

/// Distance of each frame's reference, and the result where it is far.
struct NearReferences {
  static constexpr double kNear_px = 10;
  int frames = 0, mean = 0, sum = 0, combined_sum = 0;  ///< within that distance
  int combined_or_estimated = 0;
  std::vector<double> combined_px;  ///< summed over the dots

  void add(const ReferenceLibrary& library, const FrameResult& result) {
    ++frames;
    if (!result.reference || !result.markers) return;
    const int dots = dots_seen(*result.markers);
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
      {en::say("pushes whose side of 8 is told right"),
       "%",
       percent_of(right, pushed),
       98.1,
       99.5,
       true},
      {en::say("direction of a push in the picture, mean error"), "degrees", angles.mean(), {}, {}},
      {en::say("direction of a push in the picture, greatest error"),
       "degrees",
       angles.greatest,
       {},
       {}},
  };
  outcome.plots.push_back(compared_bars(en::say("pushes whose side of 8 is told right"),
                                        en::say("told right (%)"),
                                        {en::say("side of 8")},
                                        {percent_of(right, pushed)},
                                        {98.1}));
  outcome.plots.push_back(
      {en::say("error of a push's direction in the picture; sides begin at 22.5 degrees and every "
               "45 from there, and the paper tells no figure of it"),
       en::say("true direction (degrees)"),
       en::say("error of the direction (degrees)"),
       {by_direction},
       {}});
  outcome.remarks = {en::say(
      "{} pushes, by how the dots truly moved in the picture; those near a border of two sides are "
      "counted as all others",
      pushed)};
  return outcome;
}

Result<ExperimentOutcome> run_references(const ExperimentBench& bench) {
  static constexpr double kClose_px = 40;  // summed over the dots, as in the paper
  static constexpr std::array kMethods{
      ReferenceMethod::kSingle, ReferenceMethod::kNearest, ReferenceMethod::kLocal};
  ExperimentBench::Measuring measuring;
  measuring.truth = TruthDetail::kAll;
  measuring.settings.resize(kMethods.size());
  for (std::size_t i = 0; i < kMethods.size(); ++i) measuring.settings[i].reference = kMethods[i];
  std::array<int, kMethods.size()> close{};
  std::array<std::vector<double>, kMethods.size()> distances_px;
  std::vector<Evaluator> errors(kMethods.size(), Evaluator(bench.finger().camera));
  NearReferences near;
  const auto frames = bench.measure(
      kReferencesScene,
      measuring,
      [&](std::size_t which, const Truth& truth, const FrameResult& result) {
        if (kMethods[which] == ReferenceMethod::kLocal) near.add(bench.library(), result);
        if (result.reference && result.markers) {
          const double sum_px = result.reference->distance_px * dots_seen(*result.markers);
          close[which] += sum_px < kClose_px;
          distances_px[which].push_back(sum_px);
        }
        if (!result.depth) return errors[which].add_missing();
        errors[which].add(truth,
                          result.depth->depth_mm,
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
      {en::say("frames under 40 px, nearest of a recording"),
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
      {en::say("frames under 10 px a dot, or told to be in a pose never recorded"),
       "%",
       percent_of(near.mean, near.frames),
       {},
       99.5,
       true},
      {en::say("depth where nothing touches, one reference"), "mm", false_depth_mm[0], {}, {}},
      {en::say("depth where nothing touches, nearest of a recording"),
       "mm",
       false_depth_mm[1],
       {},
       {}},
      {en::say("depth where nothing touches, local regression"), "mm", false_depth_mm[2], {}, {}},
      {en::say("frames under 10 px summed over the dots, nearest of a recording"),
       "%",
       percent_of(near.sum, near.frames),
       {},
       {},
       true},
      {en::say("the same, of the recorded frames as the reference combines them"),
       "%",
       percent_of(near.combined_sum, near.frames),
       {},
       {},
       true},
      {en::say("the same, or told that the pose or its surroundings were not recorded"),
       "%",
       percent_of(near.combined_or_estimated, near.frames),
       {},
       99.5,
       true},
  };
  outcome.plots.push_back(
      {en::say("how many frames have a reference closer than so many px, summed over the dots"),
       en::say("distance to the reference (px)"),
       en::say("frames (%)"),
       {frames_within(en::say("nearest of a recording, ours"), distances_px[1]),
        frames_within(en::say("one reference, ours"), distances_px[0]),
        frames_within(en::say("as the reference combines them, ours"), near.combined_px),
        {en::say("nearest, paper, measured"), ExperimentSeries::Style::kPaper, {kClose_px}, {91.0}},
        {en::say("one, paper, measured"), ExperimentSeries::Style::kPaper, {kClose_px}, {40.6}}},
       {}});
  outcome.remarks = {
      en::say("How many frames a single reference is near to depends on how far the finger moves, "
              "which is the scene's choice here and was the paper's there"),
      en::say(
          "The paper sums the distance over its dots, and under 40 px is told so here; under 10 "
          "px is told over this finger and {} drawn at random, for a dot and summed",
          kFingerVariants)};
  return outcome;
}

}  // namespace alltact
