#include "calibration/experiments/experiments.h"
#include "calibration/study/evaluate.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace alltact {

// Position of a contact, and orientation of the pressing body.

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
      bench.measure("experiment_localisation", {},
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
      {en::say("position, mean error within +-20 mm of the middle"), "mm", own->inner.mean(), 0.814,
       0.2},
      {en::say("position, mean error at the tip"), "mm", own->tip.mean(), 2.93, 0.5},
      {en::say("position, greatest error"), "mm", own->all.greatest, {}, {}},
      {en::say("contacts found"), "%", percent_of(found, frames), {}, {}, true},
      {en::say("the worst of {} fingers drawn at random, within +-20 mm", kFingerVariants), "mm",
       inner.greatest, 0.814, 0.2},
      {en::say("the worst of {} fingers drawn at random, at the tip", kFingerVariants), "mm",
       tip.greatest, 2.93, 0.5},
  };
  using Style = ExperimentSeries::Style;
  outcome.plots.push_back(
      {en::say("position error along the finger, one point per contact"),
       en::say("position along the finger (mm)"),
       en::say("position error (mm)"),
       {std::move(own->found),
        level_line(en::say("paper, mean within 20 mm of the middle, measured"), Style::kPaper,
                   0.814, kMiddleOfArray_mm - kInnerReach_mm, kMiddleOfArray_mm + kInnerReach_mm),
        level_line(en::say("paper, mean at the tip, measured"), Style::kPaper, 2.93, kTipRow_mm - 5,
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
      {en::say("bars whose angle is measured"),
       "%",
       percent_of(errors.count, *frames),
       {},
       {},
       true},
  };
  outcome.remarks = {
      en::say("The lesser of the paper's two figures is next to the mean error, the greater one "
              "next to the greatest error")};
  using Style = ExperimentSeries::Style;
  outcome.plots.push_back(
      {en::say("angle error of a bar, by its orientation"),
       en::say("true angle (degrees)"),
       en::say("angle error (degrees)"),
       {turned, level_line(en::say("paper, the lesser, measured"), Style::kPaper, 3.22, -75, 90),
        level_line(en::say("paper, the greater, measured"), Style::kPaper, 12.06, -75, 90)},
       {},
       true});
  return outcome;
}

// Reliefs of sharp-edged objects, with the local reference and with a single one.

namespace {

/// Straight as in the reference image, or bent.
bool is_bent(const Truth& truth) {
  return std::any_of(truth.pose.begin(), truth.pose.end(),
                     [](const auto& freedom) { return std::abs(freedom.second) > 1e-9; });
}

constexpr double kCell_mm = 0.05, kAlong_mm = 20, kAcross_mm = 17;  // of a map

/// Middle of the pressed area, mm along and across the face.
Eigen::Vector2d middle_of(const cv::Mat_<float>& depth_mm, const FaceShape& shape) {
  Eigen::Vector2d min = Eigen::Vector2d::Constant(1e9), max = -min;
  for (int v = 0; v < depth_mm.rows; v += 2)
    for (int u = 0; u < depth_mm.cols; u += 2)
      if (depth_mm(v, u) > 0.05F) {
        const Eigen::Vector2d position = shape.position_mm(u, v);
        min = min.cwiseMin(position), max = max.cwiseMax(position);
      }
  return 0.5 * (min + max);
}

/// Pixels of a map's cells in the image; outside of it where there is no face.
cv::Mat_<cv::Vec2f> pixels_of_map(const FaceShape& shape, const Eigen::Vector2d& middle_mm) {
  const cv::Size size(static_cast<int>(kAlong_mm / kCell_mm),
                      static_cast<int>(kAcross_mm / kCell_mm));
  cv::Mat_<cv::Vec2f> pixels(size, cv::Vec2f(-9, -9));
  const double to_tip = shape.base_at_low_u() ? 1 : -1;
  double u = shape.base_at_low_u() ? 0 : shape.width_px() - 1.0;
  for (int column = 0; column < size.width; ++column) {
    const double along_mm = middle_mm.x() - 0.5 * kAlong_mm + (column + 0.5) * kCell_mm;
    const auto is_within = [&](double at) { return at >= 0 && at <= shape.width_px() - 1.0; };
    while (is_within(u + to_tip) && shape.length_at(u + to_tip) < along_mm) u += to_tip;
    if (!is_within(u + to_tip)) break;
    const double here = shape.length_at(u), next = shape.length_at(u + to_tip);
    if (!(here <= along_mm && next > here)) continue;
    const auto on_face = shape.middle_at(u + to_tip * (along_mm - here) / (next - here));
    if (!on_face) continue;
    for (int row = 0; row < size.height; ++row) {
      const double across_mm = middle_mm.y() + 0.5 * kAcross_mm - (row + 0.5) * kCell_mm;
      const auto pixel =
          shape.camera().project(on_face->point_mm + Eigen::Vector3d(0, across_mm, 0));
      if (pixel) pixels(row, column) = cv::Vec2f(cv::Vec2d(pixel->x(), pixel->y()));
    }
  }
  return pixels;
}

cv::Mat_<float> map_of(const cv::Mat& depth_mm, const cv::Mat_<cv::Vec2f>& pixels) {
  cv::Mat_<float> map;
  cv::remap(depth_mm, map, pixels, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
            cv::Scalar(std::numeric_limits<double>::quiet_NaN()));
  return map;
}

/// 98 % bound of the differences, mm, rounded up to a plain number.
double top_of(const std::vector<ExperimentMap>& differences) {
  double top_mm = 0;
  for (const ExperimentMap& difference : differences) {
    std::vector<double> sizes;
    for (const float mm : difference.mm)
      if (std::isfinite(mm)) sizes.push_back(std::abs(static_cast<double>(mm)));
    if (sizes.empty()) continue;
    const auto nearly_all =
        sizes.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(sizes.size()));
    std::nth_element(sizes.begin(), nearly_all, sizes.end());
    top_mm = std::max(top_mm, *nearly_all);
  }
  return 0.04 * std::max(1.0, std::ceil(top_mm / 0.04));
}

/// Of a frame: the ground truth, then the result of each method.
class ReliefMaps {
 public:
  ReliefMaps(const Message& caption, const Truth& truth, const FaceShape& shape)
      : pixels_(pixels_of_map(shape, middle_of(truth.depth_mm, shape))) {
    maps_.caption = caption;
    maps_.mm_per_cell = kCell_mm;
    maps_.depths.push_back({en::say("truth"), map_of(truth.depth_mm, pixels_)});
    double deepest_mm = 0;
    cv::minMaxLoc(truth.depth_mm, nullptr, &deepest_mm);
    maps_.top_mm = 0.2 * std::ceil(deepest_mm / 0.2);
  }
  void add(const Message& method, const Message& difference, const cv::Mat& depth_mm) {
    const cv::Mat_<float> estimated = map_of(depth_mm, pixels_);
    maps_.differences.push_back({difference, cv::Mat(estimated - maps_.depths.front().mm)});
    maps_.depths.push_back({method, estimated});
    maps_.difference_top_mm = top_of(maps_.differences);
  }
  [[nodiscard]] const ExperimentMaps& maps() const { return maps_; }

 private:
  cv::Mat_<cv::Vec2f> pixels_;
  ExperimentMaps maps_;
};

/// The first straight frame and the first bent one, in this order.
using MapsOfRelief = std::array<std::optional<ReliefMaps>, 2>;

void show(const Truth& truth, const FrameResult& result, std::size_t method,
          std::array<int, 2>& frame, int number, MapsOfRelief& shown) {
  const std::size_t bent = is_bent(truth) ? 1 : 0;
  if (!shown[bent] && method == 0) {
    frame[bent] = number;
    shown[bent].emplace(
        bent == 0
            ? en::say(
                  "relief of the straight finger, along the pressed face from base (left) to tip")
            : en::say("relief of the bent finger, along the pressed face from base (left) to tip"),
        truth, *result.shape);
  }
  if (!shown[bent] || frame[bent] != number) return;
  if (method == 0)
    shown[bent]->add(en::say("recording of all poses"), en::say("recording of all poses, error"),
                     result.depth->depth_mm);
  else
    shown[bent]->add(en::say("single reference"), en::say("single reference, error"),
                     result.depth->depth_mm);
}

Result<ExperimentOutcome> relief_of(const ExperimentBench& bench, const std::string& scene) {
  PipelineSettings single;
  single.reference = ReferenceMethod::kSingle;
  // By method, straight and bent.
  std::vector<Evaluator> errors(4, Evaluator(bench.finger().camera));
  MapsOfRelief shown;
  std::array<int, 2> shown_frame{};
  int number = 0;
  const auto frames =
      bench.measure(scene, {{PipelineSettings{}, single}, TruthDetail::kAll, {}},
                    [&](std::size_t which, const Truth& truth, const FrameResult& result) {
                      const int frame = number++ / 2;
                      Evaluator& here = errors[2 * which + (is_bent(truth) ? 1 : 0)];
                      if (!result.depth) return here.add_missing();
                      here.add(truth, result.depth->depth_mm,
                               contact_face_points_mm(result, bench.finger().finger.face),
                               result.markers.value_or(Markers{}));
                      show(truth, result, which, shown_frame, frame, shown);
                    });
  if (!frames) return frames.error();
  const Message what[] = {
      en::say("relief, mean depth error, straight"), en::say("relief, mean depth error, bent"),
      en::say("the same straight, single reference"), en::say("the same bent, single reference")};
  ExperimentOutcome outcome;
  outcome.frames = *frames;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const auto mean = errors[i].evaluation().contact_depth_mm;
    if (!mean) return no_result(scene);
    outcome.figures.push_back({what[i], "mm", *mean, {}, {}});
  }
  using Style = ExperimentSeries::Style;
  const auto& figures = outcome.figures;
  outcome.plots.push_back({en::say("relief error, ours only: the paper shows only images"),
                           "",
                           en::say("mean depth error (mm)"),
                           {{en::say("recording of all poses"),
                             Style::kBars,
                             {0, 1},
                             {figures[0].simulated, figures[1].simulated}},
                            {en::say("single reference"),
                             Style::kBars,
                             {0, 1},
                             {figures[2].simulated, figures[3].simulated}}},
                           {en::say("straight"), en::say("bent")}});
  for (const auto& maps : shown)
    if (maps) outcome.maps.push_back(maps->maps());
  outcome.remarks = {
      en::say("The paper shows images of reliefs but no figure; both of ours use the same "
              "calibration, so only the reference differs")};
  return outcome;
}

}  // namespace

Result<ExperimentOutcome> run_thread(const ExperimentBench& bench) {
  return relief_of(bench, "experiment_thread_m8");
}

Result<ExperimentOutcome> run_usb_plug(const ExperimentBench& bench) {
  return relief_of(bench, "experiment_usb_plug");
}

}  // namespace alltact
