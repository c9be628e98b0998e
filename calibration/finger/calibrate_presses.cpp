#include "calibration/finger/calibrate_presses.h"

#include "calibration/finger/calibrate_finger.h"
#include "calibration/finger/paper_pipeline.h"
#include "calibration/joint/light_spread_fit.h"
#include "calibration/presses/press_bodies.h"
#include "calibration/reference/contact_search.h"
#include "calibration/report/press_errors.h"
#include "calibration/report/press_resolution.h"
#include "calibration/verdict/verdict.h"
#include "core/base/cache.h"
#include "core/base/typed_number.h"
#include "core/image/image_file.h"
#include "core/mesh/mesh_distance.h"
#include "core/numerics/checksum.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>

#include <fmt/format.h>

namespace alltact {
namespace {

/// Standard deviation of depth from the mapping's covariance, mm along z, where it reads this
/// depth. 0 without a covariance.
double scale_sd_mm(const MappingParameters& parameters, double depth_mm) {
  const auto mapping = Mapping::create(parameters);
  if (!mapping || parameters.covariance.size() == 0) return 0;
  const double sd_mm = mapping->depth_sd_mm(mapping->difference_at(depth_mm));
  return std::isfinite(sd_mm) ? sd_mm : 0.0;
}

/// Needs a solved calibration with residuals, pixel and halo figures. `camera` and `face` are those
/// of done.finger.
CalibrationBasis basis_of(const FingerCalibration& done) {
  CalibrationBasis basis;
  const Calibration& calibration = done.calibration;
  const Face& face = done.finger.face;
  basis.layer_mm = face.layer_mm;
  basis.width_mm = face.width_mm;
  basis.plane_z_mm = face.plane_z_mm;
  basis.camera = camera_fingerprint(done.finger.camera);
  basis.reference = done.inputs.reference_checksum;
  for (const BallFit& ball : calibration.balls) {
    basis.ball_radii_mm.push_back(ball.radius_mm);
    basis.shallowest_mm =
        basis.shallowest_mm > 0 ? std::min(basis.shallowest_mm, ball.depth_mm) : ball.depth_mm;
    basis.deepest_mm = std::max(basis.deepest_mm, ball.depth_mm);
  }
  // 0 stands for an external measure of the scale: a punch with a step, another body of known
  // shape, or a measured depth.
  const bool has_measured_depth =
      std::any_of(calibration.balls.begin(), calibration.balls.end(),
                  [](const BallFit& ball) { return ball.given_depth.has_value(); });
  if (!calibration.steps.empty() || !calibration.bodies.empty() || has_measured_depth)
    basis.ball_radii_mm.push_back(0);
  std::sort(basis.ball_radii_mm.begin(), basis.ball_radii_mm.end());
  basis.ball_radii_mm.erase(std::unique(basis.ball_radii_mm.begin(), basis.ball_radii_mm.end()),
                            basis.ball_radii_mm.end());
  std::vector<ContactSpot> spots;
  for (const PressResiduals& press : done.residuals)
    spots.push_back(
        {press.along_mm, press.across_mm, press.contact_radius_mm, press.face_length_mm});
  const PressCoverage coverage = coverage_of(std::move(spots));
  basis.positions = coverage.positions;
  basis.thirds = coverage.thirds;
  basis.position_leverage = coverage.leverage;
  basis.scale_sd_mm =
      scale_sd_mm(calibration.mapping, mean_depth_mm(basis.shallowest_mm, basis.deepest_mm));
  basis.pixel_sd_mm = done.pixel_sd_mm;
  basis.halo_mm = done.halo.is_seen ? done.halo.excess_mm : 0.0;
  basis.undetected_spread = calibration.undetected_spread;
  if (calibration.radius_sensitivity)
    basis.depth_per_radius = 100 * calibration.radius_sensitivity->depth_part;
  basis.left_out = done.failed_presses;
  basis.is_complete = done.is_complete;
  for (const Contradiction& one : done.contradictions)
    basis.contradictions.push_back(recorded(one));
  return basis;
}

Error stopped() { return {en::say("stopped before the calibration was done"), "", ""}; }

/// Of the untouched image that is to be installed.
Result<ReferenceLibrary> flat_library(const CalibrationWork& work, const Finger& finger) {
  const auto grey = oriented_for(
      finger.camera, work.untouched->grey, en::say("the reference image"), work.untouched->origin,
      en::say("the untouched image of this sensor, at the size of its presses"));
  if (!grey) return grey.error();
  return ReferenceLibrary::single(*grey);
}

Result<PaperMethod> paper_method_of(const CalibrationWork& work, const FingerSnapshot& blank,
                                    const Job& job) {
  if (!work.untouched) return PaperMethod::create(blank, job);
  auto library = flat_library(work, blank.finger);
  if (!library) return library.error();
  return PaperMethod::flat(std::move(library).value(), blank);
}

Result<Pipeline> make_pipeline(const CalibrationWork& work, const FingerCalibration& done,
                               const Job& job) {
  auto full = FingerSnapshot::of(work.store->folder(), done.finger);
  if (!full) return full.error();
  // the earlier mapping must have no influence
  const FingerSnapshot blank = full->without_mapping();
  if (done.inputs.calibration.method == CalibrationMethod::kPaper) {
    auto method = paper_method_of(work, blank, job);
    if (!method) return method.error();
    return Pipeline(std::make_unique<PaperMethod>(std::move(method).value()));
  }
  if (!work.untouched)
    return Pipeline::create(blank, settings_for_presses(done.inputs.pipeline), job);
  auto library = flat_library(work, done.finger);
  if (!library) return library.error();
  return Pipeline::with_library(std::move(library).value(), blank,
                                settings_for_presses(done.inputs.pipeline));
}

/// The stored image must be unchanged since the calibration.
Status check_stored(const CalibrationWork& work, const Frame& frame, std::size_t index) {
  if (!work.stored) return {};
  const StoredPress& stored = work.stored->presses[index];
  if (frame.name == stored.name && image_checksum(frame.grey) == stored.checksum) return {};
  return Error{en::say("this is not the image that the finger was calibrated with"),
               work.presses.files[index].string(),
               en::say("calibrating again with the existing images")};
}

/// The notes about a press and its exclusion.
void apply_notes(const PressSet& press_set, const PressBodies& bodies, MeasuredPress& press) {
  if (press.press) apply_note(press_set, bodies, *press.press);
  const PressNote& note = press_set.of(press.name);
  if (note.excluded)
    press.left_out = en::list({en::say("excluded"), Message::typed(*note.excluded)});
}

Status measure_presses(CalibrationWork& work, PressMeter& meter, FingerCalibration& done,
                       const Job& job) {
  PressInput input = work.presses;
  input.frames_per_press = static_cast<std::size_t>(done.inputs.calibration.frames_per_press);
  const auto bodies = load_bodies(done.inputs.press_set, work.store->folder());
  if (!bodies) return bodies.error();
  auto source = open_presses(input);
  if (!source) return source.error();
  if (!work.stored) done.inputs.is_continuous = is_one_video(**source);
  const double count = static_cast<double>((*source)->count().value_or(0));
  std::set<std::string> names;
  while (true) {
    if (job.stop_requested()) return stopped();
    auto next = (*source)->next();
    if (!next) return next.error();
    if (!*next) break;
    const FramePtr frame = *next;
    if (!names.insert(frame->name).second)
      return Error{
          en::say("two presses are called '{}'", frame->name), frame->origin,
          en::say("giving the images different names; they are stored by name with the finger")};
    if (const Status status = check_stored(work, *frame, work.frames.size()); !status)
      return status;
    if (count > 0)
      job.report(static_cast<double>(names.size() - 1) / count, en::say("reading {}", frame->name));
    const auto measured = done.inputs.is_continuous ? meter.next(frame) : meter(frame, job);
    if (!measured) return measured.error();
    done.presses.push_back(**measured);
    apply_notes(done.inputs.press_set, *bodies, done.presses.back());
    work.frames.push_back(frame);
  }
  done.source_remarks = (*source)->remarks();
  return {};
}

/// Notes must name existing presses.
Status check_names(const FingerCalibration& done) {
  std::set<std::string> names;
  for (const MeasuredPress& press : done.presses) names.insert(press.name);
  for (const auto& [name, note] : done.inputs.press_set.notes)
    if (!names.contains(name))
      return Error{en::say("no press is named '{}'", name), "",
                   en::say("one of {}", fmt::format("{}", fmt::join(names, ", ")))};
  return {};
}

}  // namespace

namespace {

std::atomic<std::int64_t> measurements{0};

/// Difference, face and reference are moved out of `result`.
MeasuredPress press_of(const std::string& name, FrameResult& result) {
  MeasuredPress press{name, result.grey, std::nullopt, "", {}};
  if (result.difference) press.sign.light_change = result.difference->light.change();
  if (result.reference) press.sign.known_pose = result.reference->known_pose;
  // A press with hidden markers is left out: its reference is less certain, and would degrade the
  // mapping.
  if (result.difference && result.shape && !result.reference->by_shape) {
    press.press = Press{name, std::move(*result.difference), std::move(*result.shape)};
  } else {
    press.left_out =
        result.problems.empty() ? en::say("no face was found") : result.problems.front();
    press.shape = std::move(result.shape);
  }
  press.reference = std::move(result.reference);
  return press;
}

/// All that a press depends on besides its frame. Empty: unknown.
std::string key_of(const Pipeline& pipeline, const std::string& reference_checksum) {
  if (reference_checksum.empty()) return {};
  Finger finger;
  finger.name = "-";
  finger.camera = pipeline.finger().camera;
  finger.face = pipeline.finger().face;
  finger.markers = pipeline.finger().markers;
  const auto yaml = finger.to_yaml();
  if (!yaml) return {};
  std::string key = reference_checksum + '\n' + *yaml;
  for (const Setting<PipelineSettings>& setting : pipeline_settings())
    key += fmt::format("{}: {}\n", setting.name, setting.get(pipeline.settings()));
  return key;
}

}  // namespace

std::int64_t press_measurements() { return measurements; }

PressMeter::PressMeter(Pipeline pipeline, const std::string& reference_checksum)
    : pipeline_(std::move(pipeline)), key_(key_of(pipeline_, reference_checksum)) {}

PressMeter::Measured PressMeter::measure(const FramePtr& frame, std::string key) {
  ++measurements;
  auto result = pipeline_(frame);
  if (!result) return result.error();
  MeasuredPress press = press_of(frame->name, *result);
  press.key = std::move(key);
  return std::make_shared<const MeasuredPress>(std::move(press));
}

PressMeter::Measured PressMeter::next(const FramePtr& frame) { return measure(frame, {}); }

PressMeter::Measured PressMeter::operator()(const FramePtr& frame, const Job& job) {
  const auto alone = [&](const std::string& key) {
    pipeline_.forget();
    return measure(frame, key);
  };
  if (key_.empty()) return alone({});
  static SharedValues<MeasuredPress> shared;
  const std::string key = fmt::format("{}\n{}\n{}", image_checksum(frame->grey), frame->name, key_);
  return shared.get(key, job, stopped(), [&] { return alone(key); });
}

Result<std::vector<Press>> take_presses_as_paper(const CalibrationWork& work,
                                                 const FingerCalibration& done, const Job& job) {
  const auto full = FingerSnapshot::of(work.store->folder(), done.finger);
  if (!full) return full.error();
  auto method = paper_method_of(work, full->without_mapping(), Job(job, 0, 0.9));
  if (!method) return method.error();
  return paper_presses(*method, work.frames, done.inputs.press_set, Job(job, 0.9, 1));
}

Status take_presses(CalibrationWork& work, FingerCalibration& done, const Job& job) {
  const auto checksum = work.untouched ? Result<std::string>(image_checksum(work.untouched->grey))
                                       : reference_checksum(work.store->folder(), done.finger);
  auto pipeline = make_pipeline(work, done, Job(job, 0, 0.6));
  if (!pipeline) return pipeline.error();
  if (!checksum) return checksum.error();
  done.inputs.reference_checksum = *checksum;
  // The source paper's method measures other presses from the same images.
  const bool is_paper = done.inputs.calibration.method == CalibrationMethod::kPaper;
  PressMeter meter(std::move(pipeline).value(), is_paper ? std::string() : *checksum);
  if (const Status status = measure_presses(work, meter, done, Job(job, 0.6, 1)); !status)
    return status;
  return check_names(done);
}

namespace {

/// Adds observations that a table of residuals does not show.
void add_remarks(Calibration& calibration) {
  if (calibration.weakest) calibration.remarks.push_back(calibration.weakest->sentence);
  if (calibration.radius_sensitivity)
    calibration.remarks.push_back(calibration.radius_sensitivity->sentence);
  if (calibration.next_press) calibration.remarks.push_back(calibration.next_press->sentence);
  for (const BallFit& ball : calibration.balls) {
    if (calibration.balls.size() > 2 && ball.residual_mm > 3 * calibration.residual_mm) {
      calibration.remarks.push_back(en::at(
          Message::typed(ball.press),
          en::say("{:.3f} mm, more than three times the others; check the image, or leave it out",
                  ball.residual_mm)));
    }
  }
}

/// Limits the number of the usable presses, spread evenly over them; 0: all.
void leave_out_beyond(int max_count, std::vector<MeasuredPress>& presses) {
  std::vector<MeasuredPress*> usable;
  for (MeasuredPress& press : presses)
    if (press.left_out.empty()) usable.push_back(&press);
  const auto limit = static_cast<std::size_t>(max_count);
  if (limit == 0 || usable.size() <= limit) return;
  const auto before = [&](std::size_t i) {  // number of retained ones among the first i
    return (i * limit + limit / 2) / usable.size();
  };
  for (std::size_t i = 0; i < usable.size(); ++i)
    if (before(i + 1) == before(i))
      usable[i]->left_out = en::say("beyond the {} to be used", max_count);
}

}  // namespace

MappingRecord record_of(const FingerCalibration& done) {
  const Calibration& calibration = done.calibration;
  MappingRecord record;
  record.method = method_name(done.inputs.calibration.method);
  for (const BallFit& ball : calibration.balls) record.presses.push_back(ball.press);
  record.residual_mm = calibration.residual_mm;
  record.held_out_mm = calibration.held_out_mm;
  record.spread_mm = calibration.spread_mm;
  record.pixel_mm = done.pixel_mm;
  record.degree_choice = calibration.degree_choice.english();
  record.basis = basis_of(done);
  return record;
}

namespace {

std::string checksum_of(const TriangleMesh& mesh) {
  Checksum checksum;
  for (const Eigen::Vector3d& point : mesh.points) checksum.add(point.data(), sizeof point);
  for (const auto& corners : mesh.triangles) checksum.add(corners.data(), sizeof corners);
  return checksum.text();
}

/// All that a solution depends on. Empty: unknown.
std::string solution_key(const FingerCalibration& done) {
  std::string key = done.inputs.press_set.to_yaml();
  for (const Setting<CalibrationSettings>& setting : calibration_settings())
    key += fmt::format("{}: {}\n", setting.name, setting.get(done.inputs.calibration));
  for (const MeasuredPress& press : done.presses) {
    if (!press.left_out.empty()) continue;
    if (press.key.empty()) return {};
    key += press.key + '\n';
    if (press.press->body) key += checksum_of(press.press->body->shape->mesh()) + '\n';
  }
  return key;
}

/// Sets solution, calibration and is_complete. `used`: the presses that are not left out.
Status solve(FingerCalibration& done, const std::vector<Press>& used, const Camera& camera,
             const Job& job, const RoundListener& on_round) {
  std::optional<Calibration> stopped_early;
  const auto make = [&]() -> Result<std::shared_ptr<const Calibration>> {
    auto made = calibrate(used, camera, done.finger.face, done.inputs.calibration, job, on_round);
    if (!made) return made.error();
    if (!job.stop_requested()) return std::make_shared<const Calibration>(std::move(*made));
    stopped_early = std::move(*made);  // which nobody shares
    return stopped();
  };
  static SharedValues<Calibration> shared;
  const std::string key = solution_key(done);
  const auto solution = key.empty() ? make() : shared.get(key, job, stopped(), make);
  done.is_complete = !stopped_early;
  if (!done.is_complete) {
    done.calibration = std::move(*stopped_early);
    return {};
  }
  if (!solution) return solution.error();
  done.solution = *solution;
  done.calibration = *done.solution;
  return {};
}

}  // namespace

Status solve_presses(FingerCalibration& done, const MeasureAsPaper& as_paper, const Job& job,
                     const RoundListener& on_round) {
  leave_out_beyond(done.inputs.calibration.presses, done.presses);
  std::vector<Press> used;
  std::vector<Message> left_out;
  for (const MeasuredPress& one : done.presses) {
    if (one.left_out.empty()) {
      used.push_back(*one.press);
    } else {
      left_out.push_back(en::at(Message::typed(one.name), one.left_out));
    }
  }
  const CalibrationInputs& inputs = done.inputs;
  const auto& notes = inputs.press_set.notes;
  if (inputs.calibration.method != CalibrationMethod::kJoint &&
      std::any_of(notes.begin(), notes.end(),
                  [](const auto& entry) { return entry.second.depth || !entry.second.is_ball(); }))
    return Error{en::say("only the joint method uses measured depths and bodies other than balls"),
                 "", en::say("leaving them out, or --method joint")};
  if (inputs.calibration.method != CalibrationMethod::kJoint && as_paper)
    return Error{en::say("only the joint method is compared with others"), "",
                 en::say("leaving --compare out, or --method joint")};
  if (used.empty())
    return Error{en::clauses({en::say("no press can be used"), en::clauses(left_out)}), "",
                 en::say("images of this finger with a ball pressed into its face")};
  const double by_solving = as_paper ? 0.5 : 1.0;  // part of the time
  job.report(0, en::say("solving"));
  const auto camera = Camera::create(done.finger.camera);
  if (!camera) return camera.error();
  if (const Status solved = solve(done, used, *camera, Job(job, 0, by_solving), on_round); !solved)
    return solved;
  done.failed_presses =
      static_cast<int>(done.calibration.left_out.size() +
                       static_cast<std::size_t>(
                           std::count_if(done.presses.begin(), done.presses.end(),
                                         [](const MeasuredPress& press) { return !press.press; })));
  if (!done.is_complete)
    done.calibration.remarks.push_back(
        en::say("stopped early: this is the best solution so far, without a report; calibrate "
                "again from the stored data to finish it"));
  auto& all_left_out = done.calibration.left_out;
  all_left_out.insert(all_left_out.begin(), left_out.begin(), left_out.end());
  add_remarks(done.calibration);

  // What follows compares depths with brightness as the mapping reads it.
  std::vector<Press> local;
  for (const Press& press : used)
    local.push_back(without_light_spread(press, done.calibration.mapping));
  std::vector<const Press*> presses;
  for (const Press& press : local)
    if (press.is_ball()) presses.push_back(&press);
  done.residuals = press_residuals(presses, done.finger.face, done.calibration);
  done.zones = zone_errors(done.residuals, done.calibration, done.finger.face.kind);
  std::vector<PressSign> signs;
  for (const MeasuredPress& press : done.presses)
    if (press.left_out.empty()) signs.push_back(press.sign);
  done.fault_signs = fault_signs(signs);
  std::vector<ComparedPress> compared;
  for (const Press* press : presses) {
    const auto taken =
        std::find_if(done.presses.begin(), done.presses.end(),
                     [&](const MeasuredPress& one) { return one.name == press->name; });
    compared.push_back({press, &*taken->reference});
  }
  const ContactError pixel = contact_error(compared, done.residuals, done.calibration.mapping);
  for (MeasuredPress& taken : done.presses) taken.reference.reset();
  done.pixel_mm = pixel.mean_mm;
  done.pixel_sd_mm = pixel.sd_without_mapping_mm;
  done.halo = measure_halo(presses, done.finger.face, done.calibration);
  set_resolutions(presses, done.calibration.mapping, smoothing_of(inputs.pipeline.smoothing_px),
                  &done.residuals);
  if (done.halo.is_seen)
    done.calibration.remarks.push_back(
        en::say("next to contacts, {:.3f} mm of depth is measured: light scatters sideways there, "
                "or the skin is pressed in",
                done.halo.excess_mm));
  done.contradictions = find_contradictions(done);
  // The verdict names the worst.
  for (std::size_t i = 1; i < done.contradictions.size(); ++i)
    done.calibration.remarks.push_back(sentence(done.contradictions[i]));
  Finger solved = done.finger;
  solved.mapping = done.calibration.mapping;
  solved.mapping_record = record_of(done);
  CalibrationEvidence evidence = evidence_of(solved);
  evidence.reference_is_newer = false;  // this calibration is made now
  done.verdict = verdict(evidence);
  if (as_paper && !job.stop_requested()) {
    job.report(by_solving, en::say("comparing with other methods"));
    done.methods = compare_methods(used, as_paper(Job(job, by_solving, 0.8)), *camera,
                                   done.finger.face, done.calibration, Job(job, 0.8, 1));
  }
  return {};
}

namespace {

// A layer is measured with a caliper to a few hundredths of a millimetre.
constexpr double kLayerTolerance = 1.03;
// The mapping ends at the darkest sample, which is below the deepest point by noise.
constexpr double kReachTolerance = 1.05;
// Working distances of lenses that fit into a finger: endoscopes focus from 5 mm on, and no finger
// is longer than half a metre.
constexpr double kNearestFaceMm = 5, kFarthestFaceMm = 500;

// Distance of bright spots that count as the same spot of skin.
constexpr double kSameSpotMm = 3;

/// Adds a press that shows the contradiction.
void add_press(Contradiction& to, const std::string& press, double mm) {
  to.measured_mm = to.presses.empty() ? mm : std::min(to.measured_mm, mm);
  to.measured_to_mm = std::max(to.measured_to_mm, mm);
  to.presses.push_back(press);
}

/// A ball's contact is at most as wide as its own circle, at any depth.
Contradiction wider_than_ball(const FingerCalibration& done) {
  Contradiction wider;
  wider.kind = ContradictionKind::kContactWiderThanBall;
  for (const MeasuredPress& taken : done.presses) {
    if (!taken.press || !taken.press->is_ball()) continue;
    if (const auto& note = done.inputs.press_set.of(taken.name); note.excluded) continue;
    Press press = *taken.press;
    const double radius_mm = press.ball_radius_mm;
    if (!(radius_mm > 0)) continue;
    press.ball_radius_mm = kBallRadius.possible.high;  // so that no disc is too wide to be measured
    press.ball_mm.reset();
    const auto disc = find_ball(press, done.finger.face);
    if (!disc) continue;
    ++wider.of;
    if (disc->disc_radius_mm <= radius_mm) continue;
    wider.given_mm = radius_mm;
    add_press(wider, taken.name, disc->disc_radius_mm);
  }
  return wider;
}

double indentation_mm(const BallFit& ball) {
  return ball.indentation_mm > 0 ? ball.indentation_mm : ball.depth_mm;
}

Contradiction deeper_than_layer(const FingerCalibration& done) {
  Contradiction deeper;
  deeper.kind = ContradictionKind::kContactDeeperThanLayer;
  deeper.given_mm = done.finger.face.layer_mm;
  deeper.of = static_cast<int>(done.calibration.balls.size());
  for (const BallFit& ball : done.calibration.balls)
    if (indentation_mm(ball) > kLayerTolerance * deeper.given_mm)
      add_press(deeper, ball.press, indentation_mm(ball));
  return deeper;
}

/// Measured depths beyond the range of the brightness curve.
Contradiction beyond_mapping(const FingerCalibration& done) {
  Contradiction beyond;
  beyond.kind = ContradictionKind::kDepthBeyondMapping;
  const auto mapping = Mapping::create(done.calibration.mapping);
  if (!mapping) return beyond;
  beyond.given_mm = mapping->depth_mm(mapping->x_max());
  for (const MeasuredPress& taken : done.presses) {
    const PressNote& note = done.inputs.press_set.of(taken.name);
    if (!note.depth || note.excluded || !taken.press) continue;
    ++beyond.of;
    if (note.depth->mm > kReachTolerance * beyond.given_mm + 3 * note.depth->sd_mm)
      add_press(beyond, taken.name, note.depth->mm);
  }
  return beyond;
}

/// The face's distance is in proportion to its width: z = f W / (width in the image).
Contradiction width_against_camera(const FingerCalibration& done) {
  Contradiction width;
  width.kind = ContradictionKind::kFaceWidthAgainstCamera;
  width.given_mm = done.finger.face.width_mm;
  if (done.finger.face.kind != FaceKind::kFinRay) return width;
  double least = 0, most = std::numeric_limits<double>::max();
  std::vector<std::string> presses;
  for (const MeasuredPress& taken : done.presses) {
    if (!taken.press) continue;
    double nearest = std::numeric_limits<double>::max(), farthest = 0;
    for (const FaceColumn& column : taken.press->shape.columns()) {
      if (!column.valid) continue;
      nearest = std::min(nearest, column.z_mm);
      farthest = std::max(farthest, column.z_mm);
    }
    if (!(farthest > 0)) continue;
    presses.push_back(taken.name);
    least = std::max(least, width.given_mm * kNearestFaceMm / nearest);
    most = std::min(most, width.given_mm * kFarthestFaceMm / farthest);
  }
  width.of = static_cast<int>(presses.size());
  if (presses.empty() || (width.given_mm >= least && width.given_mm <= most)) return width;
  width.presses = std::move(presses);
  width.measured_mm = least;
  width.measured_to_mm = std::max(least, most);
  return width;
}

/// Skin that is brighter than the reference at one position in two presses or more: in a single one
/// it may be a glint of the ball.
Contradiction reference_contact(const FingerCalibration& done) {
  Contradiction contact;
  contact.kind = ContradictionKind::kReferenceContact;
  std::vector<std::pair<std::string, ReferenceSuspect>> spots;
  for (const MeasuredPress& taken : done.presses) {
    if (!taken.press || !taken.sign.known_pose) continue;
    ++contact.of;
    if (const auto spot = find_reference_suspect(taken.press->difference, taken.press->shape))
      spots.emplace_back(taken.name, *spot);
  }
  for (const auto& [name, spot] : spots) {
    std::vector<std::string> alike;
    for (const auto& [other, there] : spots)
      if (std::hypot(there.along_mm - spot.along_mm, there.across_mm - spot.across_mm) <
          kSameSpotMm)
        alike.push_back(other);
    if (alike.size() >= 2 && alike.size() > contact.presses.size()) {
      contact.presses = alike;
      contact.measured_mm = spot.along_mm;
    }
  }
  return contact;
}

}  // namespace

std::vector<Contradiction> find_contradictions(const FingerCalibration& done) {
  std::vector<Contradiction> all;
  for (Contradiction& one :
       std::vector{width_against_camera(done), wider_than_ball(done), reference_contact(done),
                   deeper_than_layer(done), beyond_mapping(done)})
    if (!one.presses.empty()) all.push_back(std::move(one));
  return all;
}

namespace {

/// The samples of a press lie on a grid: the smallest step between two of them in a row.
int side_of(const std::vector<ResidualSample>& samples) {
  double side = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Eigen::Vector2d step = samples[i].pixel - samples[i - 1].pixel;
    if (step.y() == 0 && step.x() > 0 && (side == 0 || step.x() < side)) side = step.x();
  }
  return std::max(1, static_cast<int>(std::lround(side)));
}

}  // namespace

Result<FingerCalibration> forecast_calibration(const Finger& finger,
                                               const std::filesystem::path& finger_folder,
                                               std::vector<MeasuredPress> presses,
                                               const CalibrationInputs& inputs, const Job& job) {
  FingerCalibration done;
  done.finger = finger;
  done.inputs = inputs;
  done.presses = std::move(presses);
  const auto bodies = load_bodies(inputs.press_set, finger_folder);
  if (!bodies) return bodies.error();
  for (MeasuredPress& press : done.presses) apply_notes(inputs.press_set, *bodies, press);
  if (const Status solved = solve_presses(done, {}, job, {}); !solved) return solved.error();
  return done;
}

std::optional<PressFit> fit_of_press(const Press& press, const Face& face,
                                     const MappingParameters& mapping,
                                     const Eigen::Vector3d& centre_mm) {
  if (!(press.ball_radius_mm > 0)) return std::nullopt;
  Calibration single;
  single.mapping = mapping;
  BallFit ball;
  ball.press = press.name;
  ball.radius_mm = press.ball_radius_mm;
  ball.centre_mm = centre_mm;
  single.balls.push_back(ball);
  const Press local = without_light_spread(press, mapping);
  auto residuals = press_residuals({&local}, face, single);
  if (residuals.empty()) return std::nullopt;
  PressFit fit{std::move(residuals.front())};
  int inner = 0;
  for (const ResidualSample& sample : fit.residuals.samples) {
    if (!(sample.rim <= kInnerRim) || !std::isfinite(sample.residual_mm)) continue;
    fit.error_mm += std::abs(sample.residual_mm);
    ++inner;
  }
  if (inner == 0) return std::nullopt;
  fit.error_mm /= inner;
  fit.side_px = side_of(fit.residuals.samples);
  return fit;
}

}  // namespace alltact
