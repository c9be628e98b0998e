#include "calibration/finger/solve_presses.h"

#include "calibration/finger/calibration_basis.h"
#include "calibration/finger/find_contradictions.h"
#include "calibration/report/contact_error.h"
#include "calibration/report/halo.h"

#include <algorithm>

namespace alltact {
namespace {

/// Adds observations that a table of residuals does not show.
void add_remarks(Calibration& calibration) {
  if (calibration.weakest) calibration.remarks.push_back(calibration.weakest->sentence);
  if (calibration.radius_sensitivity)
    calibration.remarks.push_back(calibration.radius_sensitivity->sentence);
  if (calibration.next_press) calibration.remarks.push_back(calibration.next_press->sentence);
  for (const BallFit& ball : calibration.balls) {
    if (calibration.balls.size() > 2 && ball.residual_mm > 3 * calibration.residual_mm) {
      calibration.remarks.push_back(
          en::at(Message::typed(ball.press),
                 en::say("{:.3f} mm, more than three times the others; look at the picture, or "
                         "leave it out",
                         ball.residual_mm)));
    }
  }
}

/// Limits the number of the usable presses, spread evenly over them; 0: all.
void leave_out_beyond(int max_count, std::vector<TakenPress>& presses) {
  std::vector<TakenPress*> usable;
  for (TakenPress& press : presses)
    if (press.left_out.empty()) usable.push_back(&press);
  const auto limit = static_cast<std::size_t>(max_count);
  if (limit == 0 || usable.size() <= limit) return;
  const auto before = [&](std::size_t i) {  // number of retained ones among the first i
    return (i * limit + limit / 2) / usable.size();
  };
  for (std::size_t i = 0; i < usable.size(); ++i)
    if (before(i + 1) == before(i))
      usable[i]->left_out = en::say("beyond the {} that are to be used", max_count);
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

Status solve_presses(FingerCalibration& done,
                     const std::vector<std::optional<Reference>>& references,
                     const MeasureAsPaper& as_paper,
                     const Job& job,
                     const RoundListener& on_round) {
  leave_out_beyond(done.inputs.calibration.presses, done.presses);
  std::vector<Press> used;
  std::vector<Message> left_out;
  for (const TakenPress& one : done.presses) {
    if (one.left_out.empty()) {
      used.push_back(*one.press);
    } else {
      left_out.push_back(en::at(Message::typed(one.name), one.left_out));
    }
  }
  const CalibrationInputs& inputs = done.inputs;
  const auto& notes = inputs.press_set.notes;
  if (inputs.calibration.method != CalibrationMethod::kJoint &&
      std::any_of(notes.begin(), notes.end(), [](const auto& entry) {
        return entry.second.depth || entry.second.step_mm;
      }))
    return Error{en::say("only the joint method uses measured depths and punches with a step"),
                 "",
                 en::say("leaving them out, or --method joint")};
  if (used.empty())
    return Error{en::clauses({en::say("no press can be used"), en::clauses(left_out)}),
                 "",
                 en::say("pictures of this finger with a ball pressed into its face")};
  job.report(0.5, en::say("solving"));
  const auto camera = Camera::create(done.finger.camera);
  if (!camera) return camera.error();
  auto calibration =
      calibrate(used, *camera, done.finger.face, done.inputs.calibration, job, on_round);
  if (!calibration) return calibration.error();
  done.calibration = std::move(calibration).value();
  done.is_complete = !job.stop_requested();
  done.failed_presses =
      static_cast<int>(done.calibration.left_out.size() +
                       static_cast<std::size_t>(std::count_if(
                           done.presses.begin(), done.presses.end(), [](const TakenPress& press) {
                             return !press.press;
                           })));
  if (!done.is_complete)
    done.calibration.remarks.push_back(
        en::say("stopped before the end: this is the best solution until then, without a report; "
                "calibrating again from what is kept finishes it"));
  auto& all_left_out = done.calibration.left_out;
  all_left_out.insert(all_left_out.begin(), left_out.begin(), left_out.end());
  add_remarks(done.calibration);

  std::vector<const Press*> presses;
  for (const Press& press : used)
    if (!press.step_mm) presses.push_back(&press);
  done.residuals = press_residuals(presses, done.finger.face, done.calibration);
  done.zones = zone_errors(done.residuals, done.calibration, done.finger.face.kind);
  std::vector<PressSign> signs;
  for (const TakenPress& press : done.presses)
    if (press.left_out.empty()) signs.push_back(press.sign);
  done.fault_signs = fault_signs(signs);
  std::vector<ComparedPress> compared;
  for (std::size_t i = 0; i < done.presses.size(); ++i)
    if (done.presses[i].left_out.empty() && !done.presses[i].press->step_mm)
      compared.push_back({&*done.presses[i].press, &*references[i]});
  const ContactError pixel = contact_error(compared, done.residuals, done.calibration.mapping);
  done.pixel_mm = pixel.mean_mm;
  done.pixel_sd_mm = pixel.sd_without_mapping_mm;
  done.halo = measure_halo(presses, done.finger.face, done.calibration);
  if (done.halo.is_seen)
    done.calibration.remarks.push_back(
        en::say("beside contacts {:.3f} mm of depth is read: light scatters sideways there, or the "
                "skin is pressed in",
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
  if (as_paper && done.inputs.calibration.method == CalibrationMethod::kJoint &&
      !job.stop_requested()) {
    job.report(0.9, en::say("comparing with other methods"));
    done.methods =
        compare_methods(used, as_paper(), *camera, done.finger.face, done.calibration, job);
  }
  return {};
}

}  // namespace alltact
