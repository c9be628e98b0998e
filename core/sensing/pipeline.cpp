#include "core/sensing/pipeline.h"

#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/depth/smoothing.h"
#include "core/sensing/force/force_meter.h"
#include "core/sensing/markers/marker_tracker.h"
#include "core/sensing/reference/recorded_poses.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

Message pose_not_recorded(double distance_px) {
  return en::say(
      "this pose was never recorded: the nearest reference frame is {:.1f} px away; record the "
      "finger bending further in this direction",
      distance_px);
}

Message camera_frozen() {
  return en::say(
      "the image equals the previous one to the last grey level: the camera is frozen; plug it in "
      "again");
}

Message sparse_pose(double error_factor) {
  return en::say(
      "few recorded frames are near this pose: its reference is {:.0f} times less certain than "
      "typical; record the finger bending slowly through it",
      error_factor);
}

Message pose_from_shape() {
  return en::say(
      "the markers were not found: this pose is estimated from the face's shape alone, so depth is "
      "less certain, and neither twist nor contact is estimated; uncover and light the dots on the "
      "side faces");
}

Message force_out_of_range() {
  return en::say(
      "the force model was not trained with frames like this one: its force is unreliable; add "
      "rows with such forces to the table and train it again");
}

/// `by`: full-size pixels a side of one reduced pixel.
[[nodiscard]] inline Markers full_size_markers(Markers markers, int by) {
  for (Marker& marker : markers)
    marker = {full_px(marker.u, by), full_px(marker.v, by), marker.seen, marker.sd_px * by};
  return markers;
}

// Stride of the rows that the measured fraction of the face is estimated from
constexpr int kFaultRowStride = 8;
/// Of a flat sensor, grey levels. Its threshold of dark pixels and the weights of the light do not
/// depend on the noise of an image.
constexpr double kPlaneNoiseSd = 1.0;

/// Depth by the slope at the same pixel equals that of a mapping along z, projected onto the
/// normal.
std::optional<Mapping> mapping_as_measured(const std::optional<Mapping>& mapping, bool exact_rays) {
  if (!mapping || exact_rays || mapping->parameters().along != MappingAlong::kNormal)
    return mapping;
  MappingParameters parameters = mapping->parameters();
  parameters.along = MappingAlong::kProjected;
  auto parallel = Mapping::create(parameters);
  return parallel ? std::optional(std::move(parallel).value()) : mapping;
}

/// The program's own method, as far as it is known what finger it measures.
class MeasuringSteps : public MeasuringMethod {
 public:
  explicit MeasuringSteps(const PipelineSettings& settings)
      : settings_(settings),
        edge_finder_({settings.edge_method, settings.edge_columns}),
        mean_(settings.average_frames) {}
  void add_finger(const FingerSnapshot& full_size);
  void add_library(ReferenceLibrary library, const FingerSnapshot& full_size);
  [[nodiscard]] const std::optional<Error>& marker_problem() const { return marker_problem_; }

  Result<FrameResult> measure(const FramePtr& frame) override;
  void warm_up(const FramePtr& frame) override;
  bool has_long_memory() const override {
    return settings_.average_frames > 1 || (force_ && force_->has_creep());
  }
  void forget() override;
  bool has_reference() const override { return library_.has_value(); }
  const Finger& finger() const override { return *finger_; }
  const Camera& camera() const override { return *camera_; }

 private:
  // The steps in their order.
  [[nodiscard]] Result<cv::Mat> oriented(const Frame& frame) const;
  void check_frame(FrameResult& result);
  void find_shape(FrameResult& result, StopWatch& watch) const;
  void find_without_reference(FrameResult& result, StopWatch& watch);
  bool find_markers(FrameResult& result);
  void find_markers_by_shape(FrameResult& result) const;
  void find_reference(FrameResult& result, StopWatch& watch);
  void find_depth(FrameResult& result, StopWatch& watch) const;
  void find_regions(FrameResult& result, StopWatch& watch) const;
  [[nodiscard]] Eigen::MatrixXd markers_covariance(const FrameResult& result) const;
  void find_evidence(FrameResult& result, StopWatch& watch) const;
  void find_force(FrameResult& result, StopWatch& watch);

  PipelineSettings settings_;
  FaceEdgeFinder edge_finder_;
  std::optional<Finger> finger_;
  std::optional<Camera> camera_;            // with the finger
  std::optional<FingerSnapshot> snapshot_;  // the same, for converting frames
  RunningMean mean_;
  // Before there is a reference.
  std::optional<EvenRows> rows_;
  ReferenceFreeContactDetector contact_;
  // With the reference.
  std::optional<ReferenceLibrary> library_;
  std::optional<Mapping> mapping_;
  std::optional<FaceShape> plane_;         // known beforehand, of flat sensors
  std::unique_ptr<MarkerFinder> markers_;  // fingers with markers,
  std::optional<Error> marker_problem_;    // or why they cannot be found
  std::optional<ForceMeter> force_;        // fingers with a force model,
  std::optional<Error> force_problem_;     // or why it cannot be used
  FramePtr last_;                          // of a continuous source
  // Covariance of the markers' displacements, in a frame with a push
  Eigen::MatrixXd displacement_cov_px2_;
};

void MeasuringSteps::warm_up(const FramePtr& frame) {
  auto grey = oriented(*frame);
  if (!grey || !library_) return;
  FrameResult result;
  result.frame = last_ = frame;
  result.grey = std::move(*grey);
  StopWatch watch;
  find_shape(result, watch);
  if (result.shape) static_cast<void>(find_markers(result));
}

Result<FrameResult> MeasuringSteps::measure(const FramePtr& frame) {
  StopWatch watch;
  FrameResult result;
  result.frame = frame;
  auto grey = oriented(*frame);
  if (!grey) return grey.error();
  result.grey = mean_(*grey);
  result.mesh_step_px = settings_.mesh_step_px;
  result.reduced_by = snapshot_ ? snapshot_->reduced_by : binning_factor(settings_.resolution);
  if (library_) check_frame(result);
  watch.lap(result.times_ms.prepare);
  find_shape(result, watch);
  if (result.shape && !library_) find_without_reference(result, watch);
  if (result.shape && library_) find_reference(result, watch);
  if (result.reference) find_depth(result, watch);
  if (result.depth) find_regions(result, watch);
  if (result.reference) find_evidence(result, watch);
  if (result.markers && library_) find_force(result, watch);
  watch.total(result.times_ms.total);
  return result;
}

Result<cv::Mat> MeasuringSteps::oriented(const Frame& frame) const {
  if (!snapshot_) return reduced_image(frame.grey, binning_factor(settings_.resolution));
  return image_for(*snapshot_, frame.grey, en::say("the image"), frame.origin,
                   library_ ? en::say("an image of the size that the finger was calibrated with")
                            : en::say("the finger that belongs to this camera, or this finger's "
                                      "camera"));
}

void MeasuringSteps::check_frame(FrameResult& result) {
  if (auto fault = image_fault(result.grey)) result.problems.push_back(std::move(*fault));
  if (last_ && !is_same_frame(*last_, *result.frame) &&
      is_same_image(last_->grey, result.frame->grey))
    result.problems.push_back(camera_frozen());
  last_ = result.frame;
}

void MeasuringSteps::find_shape(FrameResult& result, StopWatch& watch) const {
  if (plane_) {
    result.shape = plane_;
    return;
  }
  auto edges = edge_finder_(result.grey);
  watch.lap(result.times_ms.edges);
  if (!edges) {
    result.problems.push_back(en::say("{}.", edges.error().message()));
    return;
  }
  result.edges = std::move(edges).value();
  if (!finger_ || finger_->face.kind == FaceKind::kFlat) return;  // edges only
  auto shape = FaceShape::fit(*result.edges, *camera_, finger_->face, settings_.profile_degree);
  watch.lap(result.times_ms.global);
  if (!shape) {
    result.problems.push_back(en::say("{}.", shape.error().message()));
    return;
  }
  result.shape = std::move(shape).value();
}

void MeasuringSteps::find_without_reference(FrameResult& result, StopWatch& watch) {
  result.markers = (*rows_)(result.grey, *result.shape, result.dots);
  watch.lap(result.times_ms.markers);
  const bool is_pressed = contact_(result.grey, *result.shape).has_value();
  result.evidence.emplace();
  if (contact_.is_ready()) result.evidence->is_face_pressed = is_pressed;
  watch.lap(result.times_ms.contact);
}

// Returns false where markers are needed and none were found.
bool MeasuringSteps::find_markers(FrameResult& result) {
  Message problem;
  if (marker_problem_) {
    problem = en::say("{}.", marker_problem_->message());
  } else if (markers_) {
    result.markers = (*markers_)(result.grey, *result.shape, &problem);
    if (result.markers) result.marker_method = settings_.marker_method;
  } else if (const MarkerModel* model = library_->marker_model()) {
    result.markers =
        model->complete(markers_at(*finger_->reference->positions, edge_curves(*result.shape)));
    problem = en::say("too little face is visible to estimate the pose from its shape");
  } else {
    return true;
  }
  if (!result.markers) result.problems.push_back(problem);
  if (!result.markers && (markers_ || marker_problem_)) find_markers_by_shape(result);
  return result.markers.has_value();
}

void MeasuringSteps::find_markers_by_shape(FrameResult& result) const {
  const ShapePoses* poses = library_->shape_poses();
  auto matched = poses ? (*poses)(*result.shape) : std::nullopt;
  if (!matched) return;
  result.problems.push_back(pose_from_shape());
  if (!matched->known_pose) result.problems.push_back(pose_not_recorded(matched->distance_px));
  result.markers = std::move(matched->markers);
}

void MeasuringSteps::find_reference(FrameResult& result, StopWatch& watch) {
  const bool found = find_markers(result);
  watch.lap(result.times_ms.markers);
  if (!found) return;
  const bool seen = result.markers && seen_count(*result.markers) > 0;
  if (markers_ && seen) {
    if (const TwistModel* model = library_->twist_model())
      if (auto turned = model->twisted(*result.markers, *result.shape))
        result.shape = std::move(*turned);
  }
  if (seen && finger_->contact) {
    displacement_cov_px2_ = markers_covariance(result);
    result.push = push_of(*result.markers, *finger_->contact, result.shape->base_at_low_u(),
                          displacement_cov_px2_);
  }
  result.reference =
      library_->reference_for(result.markers ? *result.markers : Markers{}, *result.shape,
                              settings_.reference, {}, settings_.reference_neighbours);
  if (!result.reference->known_pose) {
    result.problems.push_back(pose_not_recorded(result.reference->distance_px));
  }
  if (result.reference->known_pose && result.reference->is_sparse())
    result.problems.push_back(sparse_pose(result.reference->error_factor));
  watch.lap(result.times_ms.reference);
}

void MeasuringSteps::find_depth(FrameResult& result, StopWatch& watch) const {
  DifferenceOptions options;
  options.smoothing =
      mapping_ ? smoothing_of(settings_.smoothing_px) : gaussian_smoothing(settings_.smoothing_px);
  options.columns = columns_of(settings_.region, *result.shape);
  options.correct_light = settings_.correct_light;
  options.noise_sd = result.edges ? result.edges->noise_sd : kPlaneNoiseSd;
  options.measure_noise = !result.edges;
  if (mapping_) {
    result.depth = depth_map(result.grey, *result.reference, *result.shape, options, *mapping_);
    flag_hidden(result.reference->hidden, &result.depth->flags);
    for (Message& fault :
         face_faults(flag_fractions(result.depth->flags, kFaultRowStride), result.depth->light))
      result.problems.push_back(std::move(fault));
  } else {
    result.difference = difference(result.grey, *result.reference, *result.shape, options);
    result.problems.push_back(
        en::say("the finger is not calibrated: calibrate it with ball presses"));
  }
  watch.lap(result.times_ms.local);
}

void MeasuringSteps::find_regions(FrameResult& result, StopWatch& watch) const {
  RegionOptions options;
  options.threshold_mm = settings_.contact_threshold_mm;
  options.correlated_px2 = std::pow(smoothing_of(settings_.smoothing_px).noise_factor(), -2);
  options.noise_mm = result.depth->noise_mm;
  options.is_light_doubtful = is_light_doubtful(*result.depth);
  // Of bars at random positions and angles in rendered images: their upright ends.
  constexpr double kAxisBeyondNoiseDeg = 0.021;
  options.axis_beyond_noise_deg = kAxisBeyondNoiseDeg;
  // Where on an oblique line of sight scattered light turned is known to a twentieth of the layer,
  // as in images made by walks of light.
  constexpr double kTurningSd = 0.05;
  if (!mapping_->parameters().spread.is_local())
    options.along_sd_mm = kTurningSd * finger_->face.layer_mm;
  DepthErrorModel error(*result.depth, *result.reference, *result.shape, *mapping_);
  options.untouched = [&](int u, int v) { return error.untouched(u, v); };
  options.pressed = [&](int u, int v, double mm) { return error.of_depth(u, v, mm); };
  result.regions = contact_regions(*result.depth, *result.shape, finger_->face, options);
  watch.lap(result.times_ms.contact);
}

// Covariance of the markers' displacements from rest, px^2.
Eigen::MatrixXd MeasuringSteps::markers_covariance(const FrameResult& result) const {
  const MarkerModel* model = library_->marker_model();
  const Markers& seen = *result.markers;
  return displacement_covariance_px2(
      seen, model && !are_all_seen(seen) ? model->covariance_px2(seen) : std::nullopt);
}

void MeasuringSteps::find_evidence(FrameResult& result, StopWatch& watch) const {
  ContactEvidence& evidence = result.evidence.emplace();
  evidence.time_s = time_s(*result.frame);
  if (result.depth)
    evidence.add_regions(result.regions, *result.shape,
                         result.markers ? &*result.markers : nullptr);
  if (result.difference) evidence.is_face_pressed = is_face_dark(*result.difference);
  if (result.push)
    evidence.add_push(*result.push, *finger_->contact, *result.markers, *result.shape,
                      displacement_cov_px2_);
  double milliseconds = 0;
  watch.lap(milliseconds);
  result.times_ms.contact += milliseconds;
}

void MeasuringSteps::find_force(FrameResult& result, StopWatch& watch) {
  if (force_problem_) result.problems.push_back(en::say("{}.", force_problem_->message()));
  if (!force_) return;
  std::optional<Eigen::Vector2d> position_mm;
  if (!result.regions.empty()) position_mm = result.regions.front().position_on_face_mm;
  result.force = (*force_)(full_size_markers(*result.markers, result.reduced_by), position_mm,
                           time_s(*result.frame));
  if (!result.force)
    result.problems.push_back(en::say("no marker is visible to estimate the force"));
  else if (!result.force->in_range)
    result.problems.push_back(force_out_of_range());
  watch.lap(result.times_ms.force);
}

void MeasuringSteps::add_finger(const FingerSnapshot& snapshot) {
  const Finger& finger = snapshot.finger;
  finger_ = finger;
  camera_ = snapshot.camera;
  snapshot_ = snapshot;
  edge_finder_ = FaceEdgeFinder({settings_.edge_method, settings_.edge_columns,
                                 FaceView{snapshot.camera, finger.face.width_mm}});
  rows_.emplace(finger.markers);
}

void MeasuringSteps::add_library(ReferenceLibrary library, const FingerSnapshot& full_size) {
  const Finger& finger = snapshot_->finger;
  library_ = std::move(library);
  mapping_ = mapping_as_measured(snapshot_->mapping, settings_.exact_rays);
  if (mapping_) finger_->mapping = mapping_->parameters();
  if (finger.face.kind == FaceKind::kFlat)
    plane_ = FaceShape::plane(snapshot_->camera, finger.face);
  const bool by_shape = finger.reference && finger.reference->positions;
  if (const MarkerModel* model = library_->marker_model(); model && !by_shape) {
    auto made =
        make_marker_finder(settings_.marker_method, settings_.marker_network, finger, *model);
    if (made)
      markers_ = std::move(made).value();
    else
      marker_problem_ = made.error();
  }
  force_problem_ = snapshot_->force_problem;
  if (!snapshot_->force) return;
  if (const Status belongs = snapshot_->force->belongs_to(full_size.finger); belongs)
    force_.emplace(snapshot_->force);
  else
    force_problem_ = belongs.error();
}

void MeasuringSteps::forget() {
  if (markers_) markers_->forget();
  if (rows_) rows_->forget();
  if (force_) force_->forget();
  contact_.forget();
  last_.reset();
  mean_.forget();
}

std::unique_ptr<MeasuringSteps> steps_with_library(ReferenceLibrary library,
                                                   const FingerSnapshot& finger,
                                                   const PipelineSettings& settings) {
  auto steps = std::make_unique<MeasuringSteps>(settings);
  steps->add_finger(finger_as_measured(finger, settings));
  steps->add_library(std::move(library), finger);
  return steps;
}

}  // namespace

Result<Pipeline> Pipeline::create(const FingerSnapshot& finger, const PipelineSettings& settings,
                                  const Job& job) {
  auto library = ReferenceLibrary::load(finger_as_measured(finger, settings), job);
  if (!library) return library.error();
  auto steps = steps_with_library(std::move(library).value(), finger, settings);
  if (steps->marker_problem()) return *steps->marker_problem();
  return Pipeline(std::move(steps), settings);
}

Pipeline Pipeline::with_library(ReferenceLibrary library, const FingerSnapshot& finger,
                                const PipelineSettings& settings) {
  return Pipeline(steps_with_library(std::move(library), finger, settings), settings);
}

Pipeline Pipeline::without_reference(const FingerSnapshot& finger,
                                     const PipelineSettings& settings) {
  auto steps = std::make_unique<MeasuringSteps>(settings);
  steps->add_finger(finger_as_measured(finger, settings));
  return Pipeline(std::move(steps), settings);
}

Pipeline Pipeline::without_finger(const PipelineSettings& settings) {
  return Pipeline(std::make_unique<MeasuringSteps>(settings), settings);
}

cv::Mat RunningMean::operator()(const cv::Mat& grey) {
  if (max_frames_ == 1) return grey;
  if (!last_.empty() && last_.front().size() != grey.size()) forget();
  if (last_.empty()) sum_ = cv::Mat::zeros(grey.size(), CV_16UC1);
  if (last_.size() == max_frames_) {
    cv::subtract(sum_, last_.front(), sum_, cv::noArray(), CV_16U);
    last_.pop_front();
  }
  cv::add(sum_, grey, sum_, cv::noArray(), CV_16U);
  last_.push_back(grey);
  cv::Mat mean;
  sum_.convertTo(mean, CV_8U, 1.0 / static_cast<double>(last_.size()));
  return mean;
}

}  // namespace alltact
