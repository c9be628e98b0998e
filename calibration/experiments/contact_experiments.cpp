// Position of a contact, and orientation of the pressing body.
#include "calibration/experiments/experiment_runs.h"
#include "calibration/study/evaluate.h"

#include <array>
#include <cmath>
#include <utility>

namespace alltact {
namespace {

constexpr double kMiddleOfArray_mm = 60, kInnerReach_mm = 20, kTipRow_mm = 100;

/// Of one finger.
struct LocalisationErrors {
  ErrorSamples inner, tip, all;  ///< mm; within +-20 mm of the middle, at the tip
  ExperimentSeries found{en::say("ours, simulated"), ExperimentSeries::Style::kDots, {}, {}};
  int frames = 0;
};

Result<LocalisationErrors> localisation_errors(const ExperimentBench& bench) {
  LocalisationErrors errors;
  const auto frames =
      bench.measure("experiment_localisation",
                    {},
                    [&](std::size_t, const Truth& truth, const FrameResult& result) {
                      if (result.regions.empty()) return;
                      const ContactTruth& contact = truth.contacts.front();
                      const double error = position_error_mm(result.regions.front(), contact);
                      errors.all.add(error);
                      errors.found.x.push_back(contact.along_mm);
                      errors.found.y.push_back(error);
                      if (std::abs(contact.along_mm - kMiddleOfArray_mm) <= kInnerReach_mm)
                        errors.inner.add(error);
                      if (contact.along_mm >= kTipRow_mm) errors.tip.add(error);
                    });
  if (!frames) return frames.error();
  if (errors.inner.count == 0 || errors.tip.count == 0) return no_result("experiment_localisation");
  errors.frames = *frames;
  return errors;
}

}  // namespace

Result<ExperimentOutcome> run_localisation(const ExperimentBench& bench) {
  auto own = localisation_errors(bench);
  if (!own) return own.error();
  ErrorSamples inner, tip;  // means of the random fingers
  int frames = own->frames, found = own->all.count;
  for (int number = 1; number <= kFingerVariants; ++number) {
    const auto variant = bench.untrained_variant(number);
    if (!variant) return variant.error();
    const auto other = localisation_errors(**variant);
    if (!other) return other.error();
    inner.add(other->inner.mean());
    tip.add(other->tip.mean());
    frames += other->frames;
    found += other->all.count;
  }
  ExperimentOutcome outcome;
  outcome.frames = frames;
  outcome.figures = {
      {en::say("place, mean error within +-20 mm of the middle"),
       "mm",
       own->inner.mean(),
       0.814,
       0.2},
      {en::say("place, mean error at the tip"), "mm", own->tip.mean(), 2.93, 0.5},
      {en::say("place, greatest error"), "mm", own->all.greatest, {}, {}},
      {en::say("touches that are found"), "%", percent_of(found, frames), {}, {}, true},
      {en::say("the worst of {} fingers drawn at random, within +-20 mm", kFingerVariants),
       "mm",
       inner.greatest,
       0.814,
       0.2},
      {en::say("the worst of {} fingers drawn at random, at the tip", kFingerVariants),
       "mm",
       tip.greatest,
       2.93,
       0.5},
  };
  using Style = ExperimentSeries::Style;
  outcome.plots.push_back({en::say("error of the place along the finger, one point a touch"),
                           en::say("place along the finger (mm)"),
                           en::say("error of the place (mm)"),
                           {std::move(own->found),
                            level_line(en::say("paper, mean within 20 mm of the middle, measured"),
                                       Style::kPaper,
                                       0.814,
                                       kMiddleOfArray_mm - kInnerReach_mm,
                                       kMiddleOfArray_mm + kInnerReach_mm),
                            level_line(en::say("paper, mean at the tip, measured"),
                                       Style::kPaper,
                                       2.93,
                                       kTipRow_mm - 5,
                                       kTipRow_mm + 2)},
                           {},
                           true});
  return outcome;
}

Result<ExperimentOutcome> run_pose(const ExperimentBench& bench) {
  ErrorSamples errors;
  ExperimentSeries turned{en::say("ours, simulated"), ExperimentSeries::Style::kDots, {}, {}};
  const auto frames = bench.measure(
      "experiment_pose", {}, [&](std::size_t, const Truth& truth, const FrameResult& result) {
        if (result.regions.empty() || !result.regions.front().angle_deg) return;
        const double off =
            *result.regions.front().angle_deg - truth.contacts.front().angle_deg.value();
        errors.add(std::abs(std::remainder(off, 180.0)));  // a bar has no front
        turned.x.push_back(truth.contacts.front().angle_deg.value());
        turned.y.push_back(std::abs(std::remainder(off, 180.0)));
      });
  if (!frames) return frames.error();
  if (errors.count == 0) return no_result("experiment_pose");
  ExperimentOutcome outcome;
  outcome.frames = *frames;
  outcome.figures = {
      {en::say("angle, mean error"), "degrees", errors.mean(), 3.22, 1.0},
      {en::say("angle, greatest error"), "degrees", errors.greatest, 12.06, 1.0},
      {en::say("bars whose angle is told"), "%", percent_of(errors.count, *frames), {}, {}, true},
  };
  outcome.remarks = {
      en::say("The lesser of the paper's two figures stands beside the mean error, the greater one "
              "beside the greatest error")};
  using Style = ExperimentSeries::Style;
  outcome.plots.push_back(
      {en::say("error of the angle of a bar, by how it is turned"),
       en::say("true angle (degrees)"),
       en::say("error of the angle (degrees)"),
       {turned,
        level_line(en::say("paper, the lesser, measured"), Style::kPaper, 3.22, -75, 90),
        level_line(en::say("paper, the greater, measured"), Style::kPaper, 12.06, -75, 90)},
       {},
       true});
  return outcome;
}

}  // namespace alltact
