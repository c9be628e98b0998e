#include "core/sensing/pipeline.h"

#include "core/base/message.h"
#include "core/camera/camera.h"
#include "core/finger/finger_store.h"
#include "core/sensing/contact/finger_contact.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/depth/smoothing.h"
#include "core/sensing/force/force_meter.h"
#include "core/sensing/frame_result.h"
#include "core/sensing/markers/marker_tracker.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/paper_method.h"
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

}  // namespace

/// State of a pipeline between frames, and its steps in their order.
struct Pipeline::State {
  std::optional<PaperMethod> paper;  // replaces all that follows except finger and camera
  PipelineSettings settings;
  FaceEdgeFinder edge_finder;
  std::optional<Finger> finger;
  std::optional<Camera> camera;            // with the finger
  std::optional<FingerSnapshot> snapshot;  // the same, for converting frames
  RunningMean mean{1};
  // Before there is a reference.
  std::optional<EvenRows> rows;
  ReferenceFreeContactDetector contact;
  // With the reference.
  std::optional<ReferenceLibrary> library;
  std::optional<Mapping> mapping;
  std::optional<FaceShape> plane;         // known beforehand, of flat sensors
  std::unique_ptr<MarkerFinder> markers;  // fingers with markers,
  std::optional<Error> marker_problem;    // or why they cannot be found
  std::optional<ForceMeter> force;        // fingers with a force model,
  std::optional<Error> force_problem;     // or why it cannot be used
  FramePtr last;                          // of a continuous source
  // Covariance of the markers' displacements, in a frame with a push
  Eigen::MatrixXd displacement_cov_px2;
  FingerContactTracker contact_tracker;

  [[nodiscard]] Result<cv::Mat> oriented(const Frame& frame) const;
  void check_frame(FrameResult& result);
  void find_shape(FrameResult& result, StopWatch& watch) const;
  void find_without_reference(FrameResult& result, StopWatch& watch);
  bool find_markers(FrameResult& result);
  void find_markers_by_shape(FrameResult& result) const;
  void find_reference(FrameResult& result, StopWatch& watch);
  void find_depth(FrameResult& result, StopWatch& watch) const;
  void find_contact(FrameResult& result, StopWatch& watch) const;
  [[nodiscard]] Eigen::MatrixXd markers_covariance(const FrameResult& result) const;
  void track_contact(FrameResult& result, std::optional<FrameContacts>* contacts, StopWatch& watch);
  void find_force(FrameResult& result, StopWatch& watch);
};

namespace {

// Stride of the rows that the measured fraction of the face is estimated from
constexpr int kFaultRowStride = 8;
/// Of a flat sensor, grey levels. Its threshold of dark pixels and the weights of the light do not
/// depend on the noise of an image.
constexpr double kPlaneNoiseSd = 1.0;

/// Depth by the slope at the same pixel equals that of a mapping along z, projected onto the
/// normal.
std::optional<Mapping> mapping_as_measured(const std::optional<Mapping>& mapping, LayerRays rays) {
  if (!mapping || rays == LayerRays::kExact || mapping->parameters().along != MappingAlong::kNormal)
    return mapping;
  MappingParameters parameters = mapping->parameters();
  parameters.along = MappingAlong::kProjected;
  auto parallel = Mapping::create(parameters);
  return parallel ? std::optional(std::move(parallel).value()) : mapping;
}

bool any_seen(const Markers& markers) {
  return std::any_of(markers.begin(), markers.end(), [](const Marker& m) { return m.seen; });
}

}  // namespace

Result<FrameResult> Pipeline::operator()(const FramePtr& frame) {
  return measure(frame, nullptr);
}

Result<FrameResult> Pipeline::measure_untracked(const FramePtr& frame,
                                                std::optional<FrameContacts>& contacts) {
  contacts.reset();
  return measure(frame, &contacts);
}

void Pipeline::warm_up(const FramePtr& frame) {
  State& state = *state_;
  if (state.paper) return;
  auto grey = state.oriented(*frame);
  if (!grey || !state.library) return;
  FrameResult result;
  result.frame = state.last = frame;
  result.grey = std::move(*grey);
  StopWatch watch;
  state.find_shape(result, watch);
  if (result.shape) static_cast<void>(state.find_markers(result));
}

bool Pipeline::has_long_memory() const {
  return state_->settings.average_frames > 1 ||
         (state_->paper.has_value() || (state_->force && state_->force->has_creep()));
}

Result<FrameResult> Pipeline::measure(const FramePtr& frame,
                                      std::optional<FrameContacts>* contacts) {
  State& state = *state_;
  if (state.paper) return (*state.paper)(frame);
  StopWatch watch;
  FrameResult result;
  result.frame = frame;
  auto grey = state.oriented(*frame);
  if (!grey) return grey.error();
  result.grey = state.mean(*grey);
  result.mesh_step_px = state.settings.mesh_step_px;
  result.reduced_by =
      state.snapshot ? state.snapshot->reduced_by : binning_factor(state.settings.resolution);
  if (state.library) state.check_frame(result);
  watch.lap(result.times_ms.prepare);
  state.find_shape(result, watch);
  if (result.shape && !state.library) state.find_without_reference(result, watch);
  if (result.shape && state.library) state.find_reference(result, watch);
  if (result.reference) state.find_depth(result, watch);
  if (result.depth) state.find_contact(result, watch);
  if (result.reference) state.track_contact(result, contacts, watch);
  if (result.markers && state.library) state.find_force(result, watch);
  watch.total(result.times_ms.total);
  return result;
}

Result<cv::Mat> Pipeline::State::oriented(const Frame& frame) const {
  if (!snapshot) return reduced_image(frame.grey, binning_factor(settings.resolution));
  return image_for(*snapshot,
                   frame.grey,
                   en::say("the image"),
                   frame.origin,
                   library ? en::say("an image of the size that the finger was calibrated with")
                           : en::say("the finger that belongs to this camera, or this finger's "
                                     "camera"));
}

void Pipeline::State::check_frame(FrameResult& result) {
  if (auto fault = image_fault(result.grey)) result.problems.push_back(std::move(*fault));
  if (last && !is_same_frame(*last, *result.frame) && is_same_image(last->grey, result.frame->grey))
    result.problems.push_back(camera_frozen());
  last = result.frame;
}

void Pipeline::State::find_shape(FrameResult& result, StopWatch& watch) const {
  if (plane) {
    result.shape = plane;
    return;
  }
  auto edges = edge_finder(result.grey);
  watch.lap(result.times_ms.edges);
  if (!edges) {
    result.problems.push_back(en::say("{}.", edges.error().message()));
    return;
  }
  result.edges = std::move(edges).value();
  if (!finger || finger->face.kind == FaceKind::kFlat) return;  // edges only
  auto shape = FaceShape::fit(*result.edges, *camera, finger->face, settings.profile_degree);
  watch.lap(result.times_ms.global);
  if (!shape) {
    result.problems.push_back(en::say("{}.", shape.error().message()));
    return;
  }
  result.shape = std::move(shape).value();
}

void Pipeline::State::find_without_reference(FrameResult& result, StopWatch& watch) {
  auto seen = (*rows)(result.grey, *result.shape);
  result.markers = std::move(seen.markers);
  result.dots = std::move(seen.dots);
  watch.lap(result.times_ms.markers);
  const bool is_pressed = contact(result.grey, *result.shape).has_value();
  if (contact.is_ready()) result.touch = is_pressed ? FaceContact::kInContact : FaceContact::kFree;
  watch.lap(result.times_ms.contact);
}

// Returns false where markers are needed and none were found.
bool Pipeline::State::find_markers(FrameResult& result) {
  Message problem;
  if (marker_problem) {
    problem = en::say("{}.", marker_problem->message());
  } else if (markers) {
    result.markers = (*markers)(result.grey, *result.shape, &problem);
    if (result.markers) result.marker_method = settings.marker_method;
  } else if (const MarkerModel* model = library->marker_model()) {
    result.markers =
        model->complete(markers_at(*finger->reference->positions, edge_curves(*result.shape)));
    problem = en::say("too little face is visible to estimate the pose from its shape");
  } else {
    return true;
  }
  if (!result.markers) result.problems.push_back(problem);
  if (!result.markers && (markers || marker_problem)) find_markers_by_shape(result);
  return result.markers.has_value();
}

void Pipeline::State::find_markers_by_shape(FrameResult& result) const {
  const ShapePoses* poses = library->shape_poses();
  auto matched = poses ? (*poses)(*result.shape) : std::nullopt;
  if (!matched) return;
  result.problems.push_back(pose_from_shape());
  if (!matched->known_pose) result.problems.push_back(pose_not_recorded(matched->distance_px));
  result.markers = std::move(matched->markers);
}

void Pipeline::State::find_reference(FrameResult& result, StopWatch& watch) {
  const bool found = find_markers(result);
  watch.lap(result.times_ms.markers);
  if (!found) return;
  const bool seen = result.markers && any_seen(*result.markers);
  if (markers && seen) {
    if (const TwistModel* model = library->twist_model())
      if (auto turned = model->twisted(*result.markers, *result.shape))
        result.shape = std::move(*turned);
  }
  if (seen && finger->contact) {
    displacement_cov_px2 = markers_covariance(result);
    result.push = push_of(
        *result.markers, *finger->contact, result.shape->base_at_low_u(), displacement_cov_px2);
  }
  result.reference = library->reference_for(result.markers ? *result.markers : Markers{},
                                            *result.shape,
                                            settings.reference,
                                            {},
                                            settings.reference_neighbours);
  if (!result.reference->known_pose) {
    result.problems.push_back(pose_not_recorded(result.reference->distance_px));
  }
  if (result.reference->known_pose && result.reference->is_sparse())
    result.problems.push_back(sparse_pose(result.reference->error_factor));
  watch.lap(result.times_ms.reference);
}

void Pipeline::State::find_depth(FrameResult& result, StopWatch& watch) const {
  DifferenceOptions options;
  options.smoothing =
      mapping ? smoothing_of(settings.smoothing_px) : gaussian_smoothing(settings.smoothing_px);
  options.columns = columns_of(settings.region, *result.shape);
  options.correct_light = settings.light == LightChange::kCorrected;
  options.noise_sd = result.edges ? result.edges->noise_sd : kPlaneNoiseSd;
  options.measure_noise = !result.edges;
  if (mapping) {
    result.depth = depth_map(result.grey, *result.reference, *result.shape, options, *mapping);
    flag_hidden(result.reference->hidden, &result.depth->flags);
    for (Message& fault :
         face_faults(flag_fractions(result.depth->flags, kFaultRowStride), result.depth->light))
      result.problems.push_back(std::move(fault));
  } else {
    result.difference = difference(result.grey, *result.reference, *result.shape, options);
    result.touch = face_contact(*result.difference);
    result.problems.push_back(
        en::say("the finger is not calibrated: calibrate it with ball presses"));
  }
  watch.lap(result.times_ms.local);
}

void Pipeline::State::find_contact(FrameResult& result, StopWatch& watch) const {
  RegionOptions options;
  options.threshold_mm = settings.contact_threshold_mm;
  options.correlated_px2 = std::pow(smoothing_of(settings.smoothing_px).noise_factor(), -2);
  options.noise_mm = result.depth->noise_mm;
  options.is_light_doubtful = is_light_doubtful(*result.depth);
  // Of bars at random positions and angles in rendered images: their upright ends.
  constexpr double kAxisBeyondNoiseDeg = 0.021;
  options.axis_beyond_noise_deg = kAxisBeyondNoiseDeg;
  DepthErrorModel error(*result.depth, *result.reference, *result.shape, *mapping);
  options.untouched = [&](int u, int v) { return error.untouched(u, v); };
  options.pressed = [&](int u, int v, double mm) { return error.of_depth(u, v, mm); };
  result.regions = contact_regions(*result.depth, *result.shape, finger->face, options);
  result.touch = face_contact(result.regions);
  watch.lap(result.times_ms.contact);
}

// Covariance of the markers' displacements from rest, px^2.
Eigen::MatrixXd Pipeline::State::markers_covariance(const FrameResult& result) const {
  const MarkerModel* model = library->marker_model();
  const bool all_seen = std::all_of(
      result.markers->begin(), result.markers->end(), [](const Marker& m) { return m.seen; });
  return displacement_covariance_px2(
      *result.markers, model && !all_seen ? model->covariance_px2(*result.markers) : std::nullopt);
}

void Pipeline::State::track_contact(FrameResult& result,
                                    std::optional<FrameContacts>* contacts,
                                    StopWatch& watch) {
  FingerContactTracker::FrameInput signs;
  if (result.frame->time_ns != 0) signs.time_s = 1e-9 * static_cast<double>(result.frame->time_ns);
  signs.shape = &*result.shape;
  if (result.markers) signs.markers = &*result.markers;
  if (result.depth) signs.regions = &result.regions;
  if (result.push) {
    signs.push = &*result.push;
    signs.settings = &*finger->contact;
    signs.displacement_cov_px2 = &displacement_cov_px2;
  }
  if (contacts != nullptr)
    *contacts = FingerContactTracker::single_frame(signs);
  else
    result.contact = contact_tracker(signs);
  double milliseconds = 0;
  watch.lap(milliseconds);
  result.times_ms.contact += milliseconds;
}

void Pipeline::State::find_force(FrameResult& result, StopWatch& watch) {
  if (force_problem) result.problems.push_back(en::say("{}.", force_problem->message()));
  if (!force) return;
  std::optional<Eigen::Vector2d> position_mm;
  if (!result.regions.empty()) position_mm = result.regions.front().position_on_face_mm;
  std::optional<double> time_s;
  if (result.frame->time_ns != 0) time_s = 1e-9 * static_cast<double>(result.frame->time_ns);
  result.force =
      (*force)(full_size_markers(*result.markers, result.reduced_by), position_mm, time_s);
  if (!result.force)
    result.problems.push_back(en::say("no marker is visible to estimate the force"));
  else if (!result.force->in_range)
    result.problems.push_back(force_out_of_range());
  watch.lap(result.times_ms.force);
}

Result<Pipeline> Pipeline::create(const FingerSnapshot& finger,
                                  const PipelineSettings& settings,
                                  const Job& job) {
  auto library = ReferenceLibrary::load(finger_as_measured(finger, settings), job);
  if (!library) return library.error();
  Pipeline pipeline = with_library(std::move(library).value(), finger, settings);
  if (pipeline.state_->marker_problem) return *pipeline.state_->marker_problem;
  return pipeline;
}

Pipeline Pipeline::with_library(ReferenceLibrary library,
                                const FingerSnapshot& full_size,
                                const PipelineSettings& settings) {
  const FingerSnapshot snapshot = finger_as_measured(full_size, settings);
  const Finger& finger = snapshot.finger;
  Pipeline pipeline = without_reference(snapshot, settings);
  State& state = *pipeline.state_;
  state.library = std::move(library);
  state.mapping = mapping_as_measured(snapshot.mapping, settings.rays);
  if (state.mapping) state.finger->mapping = state.mapping->parameters();
  if (finger.face.kind == FaceKind::kFlat)
    state.plane = FaceShape::plane(snapshot.camera, finger.face);
  const bool by_shape = finger.reference && finger.reference->positions;
  if (const MarkerModel* model = state.library->marker_model(); model && !by_shape) {
    auto made = make_marker_finder(settings.marker_method, settings.marker_network, finger, *model);
    if (made)
      state.markers = std::move(made).value();
    else
      state.marker_problem = made.error();
  }
  state.force_problem = snapshot.force_problem;
  if (!snapshot.force) return pipeline;
  if (const Status belongs = snapshot.force->belongs_to(full_size.finger); belongs)
    state.force.emplace(snapshot.force);
  else
    state.force_problem = belongs.error();
  return pipeline;
}

Pipeline Pipeline::with_paper_method(PaperMethod method) {
  Pipeline pipeline = without_finger();
  pipeline.state_->finger = method.finger();
  pipeline.state_->camera = method.camera();
  pipeline.state_->paper = std::move(method);
  return pipeline;
}

Pipeline Pipeline::without_reference(const FingerSnapshot& full_size,
                                     const PipelineSettings& settings) {
  const FingerSnapshot snapshot = finger_as_measured(full_size, settings);
  const Finger& finger = snapshot.finger;
  Pipeline pipeline = without_finger(settings);
  State& state = *pipeline.state_;
  state.finger = finger;
  state.camera = snapshot.camera;
  state.snapshot = snapshot;
  state.edge_finder = FaceEdgeFinder({settings.edge_method,
                                      settings.edge_columns,
                                      FaceView{snapshot.camera, finger.face.width_mm}});
  state.rows.emplace(finger.markers);
  return pipeline;
}

Pipeline Pipeline::without_finger(const PipelineSettings& settings) {
  auto state = std::make_unique<State>();
  state->settings = settings;
  state->mean = RunningMean(settings.average_frames);
  state->edge_finder = FaceEdgeFinder({settings.edge_method, settings.edge_columns});
  return Pipeline(std::move(state));
}

Pipeline::Pipeline(std::unique_ptr<State> state) : state_(std::move(state)) {}
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline& Pipeline::operator=(Pipeline&&) noexcept = default;
Pipeline::~Pipeline() = default;

void Pipeline::forget() {
  if (state_->paper) state_->paper->forget();
  if (state_->markers) state_->markers->forget();
  if (state_->rows) state_->rows->forget();
  if (state_->force) state_->force->forget();
  state_->contact.forget();
  state_->contact_tracker.forget();
  state_->last.reset();
  state_->mean.forget();
}
bool Pipeline::has_reference() const {
  return state_->library.has_value() || state_->paper.has_value();
}
const Finger& Pipeline::finger() const {
  return *state_->finger;
}
const Camera& Pipeline::camera() const {
  return *state_->camera;
}
const PipelineSettings& Pipeline::settings() const {
  return state_->settings;
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
