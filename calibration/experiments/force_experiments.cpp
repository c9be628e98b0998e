// Detection limits: depth on the contact face, and force on every face.
#include "calibration/experiments/experiment_runs.h"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace alltact {
namespace {

constexpr double kPaperMin_N = 2.0;
constexpr double kBase_mm = 20;  // the paper's figure is for positions beyond

/// One trial: its strength, and whether it was detected.
struct ContactTrial {
  double strength;
  bool detected;
};

/// The least strength from which on all trials were detected; nullopt: not even the greatest.
std::optional<double> min_detected(const std::vector<ContactTrial>& trials) {
  double greatest_missed = -1;
  for (const ContactTrial& touch : trials)
    if (!touch.detected) greatest_missed = std::max(greatest_missed, touch.strength);
  std::optional<double> least;
  for (const ContactTrial& touch : trials)
    if (touch.strength > greatest_missed && (!least || touch.strength < *least))
      least = touch.strength;
  return least;
}

Message face_phrase(PushedFace face) {
  switch (face) {
    case PushedFace::kContact:
      return en::say("least force felt on the contact face, over all heights");
    case PushedFace::kBack:
      return en::say("least force felt on the back, over all heights");
    case PushedFace::kUpper:
      return en::say("least force felt on the upper side, over all heights");
    case PushedFace::kLower:
      break;
  }
  return en::say("least force felt on the lower side, over all heights");
}

/// Heights of the scene are 20 mm apart; a push slides along the face a little as the finger bends.
int height_of_mm(const ContactTruth& contact) {
  return 5 * static_cast<int>(std::lround(contact.along_mm / 5));
}

/// A frame of experiment_least_force.
struct PushedFrame {
  std::optional<ContactTruth> contact;
  std::optional<Markers> markers;
  bool base_at_low_u = true;
  bool has_region = false;
};

}  // namespace

Result<ExperimentOutcome> run_min_contact(const ExperimentBench& bench) {
  static constexpr const char* kScene = "experiment_least_touch";
  std::map<double, std::vector<ContactTrial>> by_height;
  const auto frames =
      bench.measure(kScene, {}, [&](std::size_t, const Truth& truth, const FrameResult& result) {
        const ContactTruth& contact = truth.contacts.front();
        by_height[contact.along_mm].push_back({contact.depth_mm, !result.regions.empty()});
      });
  if (!frames) return frames.error();
  ExperimentOutcome outcome;
  outcome.frames = *frames;
  for (const auto& [along_mm, trials] : by_height) {
    const auto least = min_detected(trials);
    if (!least) return no_result(kScene);
    outcome.figures.push_back(
        {en::say("least depth felt, {:.0f} mm from the base", along_mm), "mm", *least, {}, {}});
  }
  ExperimentPlot plot{en::say("least depth of a ball that is felt, ours alone"),
                      en::say("place along the finger (mm)"),
                      en::say("least depth felt (mm)"),
                      {{en::say("ours, simulated"), ExperimentSeries::Style::kLine, {}, {}}},
                      {}};
  for (const auto& [along_mm, trials] : by_height) {
    plot.series[0].x.push_back(along_mm);
    plot.series[0].y.push_back(min_detected(trials).value_or(0));
  }
  outcome.plots.push_back(std::move(plot));
  outcome.remarks = {
      en::say("Depths are doubled from 0.01 mm on, so that the least lies between a "
              "figure and its half")};
  return outcome;
}

Result<ExperimentOutcome> run_min_force(const ExperimentBench& bench) {
  static constexpr const char* kScene = "experiment_least_force";
  std::vector<PushedFrame> pushes;
  const auto frames =
      bench.measure(kScene, {}, [&](std::size_t, const Truth& truth, const FrameResult& result) {
        PushedFrame frame;
        if (!truth.contacts.empty()) frame.contact = truth.contacts.front();
        frame.markers = result.markers;
        frame.base_at_low_u = !result.shape || result.shape->base_at_low_u();
        frame.has_region = !result.regions.empty();
        pushes.push_back(std::move(frame));
      });
  if (!frames) return frames.error();
  // The dots' rest positions come from the frame in which nothing pushes. The recording's rest
  // frame is one of its poses, slightly bent.
  const auto free = std::find_if(
      pushes.begin(), pushes.end(), [](const PushedFrame& frame) { return !frame.contact; });
  if (free == pushes.end() || !free->markers) return no_result(kScene);
  ContactSettings rested = bench.finger().finger.contact.value_or(ContactSettings{});
  rested.rest_markers.clear();
  for (const Marker& marker : *free->markers) rested.rest_markers.emplace_back(marker.u, marker.v);

  std::map<PushedFace, std::map<int, std::vector<ContactTrial>>> trials;
  for (const PushedFrame& frame : pushes) {
    if (!frame.contact || frame.contact->along_mm < kBase_mm) continue;
    const bool pushed =
        frame.markers && push_of(*frame.markers, rested, frame.base_at_low_u).pushed;
    trials[frame.contact->face][height_of_mm(*frame.contact)].push_back(
        {frame.contact->force_N.value().norm(), pushed || frame.has_region});
  }
  ExperimentOutcome outcome;
  outcome.frames = *frames;
  ExperimentPlot plot{en::say("least force that is felt, on every face over height"),
                      en::say("place along the finger (mm)"),
                      en::say("least force felt (N)"),
                      {},
                      {},
                      true};
  for (const auto& [face, by_height] : trials) {
    double most_N = 0;
    ExperimentSeries felt_on{
        Message::typed(std::string(to_string(face))), ExperimentSeries::Style::kBars, {}, {}};
    if (plot.categories.empty())
      for (const auto& [along_mm, detected] : by_height)
        plot.categories.push_back(Message::typed(std::to_string(along_mm)));
    for (const auto& [along_mm, detected] : by_height) {
      const auto least = min_detected(detected);
      if (!least) return no_result(kScene);
      most_N = std::max(most_N, *least);
      felt_on.x.push_back(static_cast<double>(felt_on.x.size()));
      felt_on.y.push_back(*least);
    }
    plot.series.push_back(std::move(felt_on));
    outcome.figures.push_back({face_phrase(face), "N", most_N, kPaperMin_N, kPaperMin_N});
  }
  plot.series.push_back(level_line(en::say("paper, at most, measured"),
                                   ExperimentSeries::Style::kAim,
                                   kPaperMin_N,
                                   -0.6,
                                   static_cast<double>(plot.categories.size()) - 0.4));
  outcome.plots.push_back(std::move(plot));
  outcome.remarks = {
      en::say("All heights lie beyond {:.0f} mm, where the paper has less than 2 N; the body is "
              "rubber of Shore 40 A as the scene has it, and the paper's silicone is another",
              kBase_mm)};
  return outcome;
}

}  // namespace alltact
