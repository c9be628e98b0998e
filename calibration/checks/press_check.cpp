#include "calibration/checks/press_check.h"

#include "calibration/finger/calibrate_presses.h"
#include "calibration/finger/calibration_inputs.h"
#include "calibration/finger/measuring_presets.h"
#include "calibration/joint/body_press.h"
#include "calibration/joint/joint_fit.h"
#include "calibration/joint/light_spread_fit.h"
#include "calibration/joint/step_press.h"
#include "calibration/presses/press.h"
#include "calibration/presses/press_bodies.h"
#include "calibration/report/press_errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <set>
#include <tuple>

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr double kFactorSeen = 0.02;  // a factor closer to 1 counts as 1
constexpr double kChance = 3.0;       // standard deviations

Error stopped() { return {en::say("stopped before the check was done"), "", ""}; }

/// The depth by the mapping; below zero it continues as a straight line.
double reading_mm(const Mapping& mapping, double x) {
  return x < 0 ? mapping.slope_mm(0) * x : mapping.depth_mm(x);
}

struct Mean {
  double mean = 0, sd = 0;
};

/// Of sorted values, so that their order does not matter.
Mean mean_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  Mean result;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) result.mean += value / n;
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  if (n > 1) result.sd = std::sqrt(squares / (n - 1));
  return result;
}

/// Of a member, or of what a member function returns.
template <class Member>
Mean mean_of(const std::vector<CheckedPress>& presses, Member member) {
  std::vector<double> values;
  for (const CheckedPress& press : presses) values.push_back(std::invoke(member, press));
  return mean_of(std::move(values));
}

/// Fits the ball of one press to the shape of its contact: centre and factor are free.
Result<CheckedPress> measure(const Press& press, double light_change, const Face& face,
                             const Mapping& mapping, const Job& job) {
  const auto ball = ball_by_shape(press, face, mapping, job);
  if (!ball) return ball.error();
  CheckedPress result;
  result.name = press.name;
  result.light_change = light_change;
  result.factor = ball->factor;
  result.depth_mm = ball->depth_mm;
  const double radius2 = ball->depth_mm * (2 * press.ball_radius_mm - ball->depth_mm);
  result.spot = {ball->on_face_mm.x(), ball->on_face_mm.y(), std::sqrt(std::max(0.0, radius2)),
                 face_length_mm(press.shape)};
  for (const double error_mm : ball->errors_mm) result.error_mm += std::abs(error_mm);
  result.error_mm /= static_cast<double>(ball->errors_mm.size());
  return result;
}

/// Turns the brightness of samples into depths, which a straight line of slope 1 reads as such.
MappingCurve read_depths(const Mapping& mapping, PressSamples& samples) {
  double deepest_mm = 1e-3;
  for (Sample& sample : samples.samples) {
    sample.x =
        mapping.parameters().variation.at(sample.position_mm) * reading_mm(mapping, sample.x);
    deepest_mm = std::max(deepest_mm, sample.x);
  }
  // Noise in mm near zero depth.
  samples.x_sd *= mapping.slope_mm(0);
  MappingCurve line({MappingKind::kPolynomial, 1}, deepest_mm);
  line.set_line(1.0);
  return line;
}

/// Measures a punch or another body of known shape with the mapping.
Result<CheckedPress> measure_shape(const Press& measured, double light_change, const Face& face,
                                   const Mapping& mapping, const Job& job) {
  const Press press = without_light_spread(measured, mapping.parameters());
  const MappingAlong along = mapping.parameters().along;
  CheckedPress result;
  result.name = press.name;
  result.light_change = light_change;
  PressSamples samples;
  double scale = 1;
  if (press.step_mm) {
    auto step = find_step(press, face);
    if (!step) return step.error();
    const MappingCurve line = read_depths(mapping, step->samples);
    scale = read_step(*step, line, line.values().data(), along).height_mm / step->step_mm;
    result.depth_mm = step->step_mm;
    samples = std::move(step->samples);
  } else {
    samples = sample_for_body(press, face);
    const MappingCurve line = read_depths(mapping, samples);
    auto body = find_body(press.name, std::move(samples), *press.body->shape, line, along, job);
    if (!body) return body.error();
    scale = 1 / read_body(*body, line, line.values().data(), along).factor;
    samples = std::move(body->samples);
    for (const Sample& sample : samples.samples)
      result.depth_mm = std::max(result.depth_mm, sample.x / scale);
  }
  result.factor = 1 / scale;
  result.error_mm = std::abs(scale - 1) * result.depth_mm;
  result.spot.face_length_mm = face_length_mm(press.shape);
  const auto count = static_cast<double>(samples.samples.size());
  for (const Sample& sample : samples.samples) {
    result.spot.along_mm += sample.position_mm.x() / count;
    result.spot.across_mm += sample.position_mm.y() / count;
  }
  return result;
}

/// An error adds a full stop of its own.
Message without_full_stop(const Message& sentence) {
  return sentence.words() == "{}." ? sentence.parts().front() : sentence;
}

/// Why an image shows no press; the reason may end in a full stop.
Message refused(const std::string& name, const Message& reason) {
  const Message phrase = without_full_stop(reason);
  const Message labelled = en::say("{}: {}", name, phrase);
  return phrase == reason ? labelled : en::say("{}.", labelled);
}

Message in_a_row(const std::vector<Message>& sentences) {
  Message all;
  for (const Message& sentence : sentences)
    all = all.empty() ? sentence : en::say("{} {}", all, sentence);
  return all;
}

/// Adds the presses, and those left out, to `all`; sentences with a full stop have the form "{}.".
/// Returns the names of all presses that were read.
Result<std::set<std::string>> measure_all(const PressInput& presses, PressMeter& meter,
                                          const Mapping& mapping, const PressSet& press_notes,
                                          const fs::path& finger_folder, const Job& job,
                                          PressCheck& all) {
  const auto bodies = load_bodies(press_notes, finger_folder);
  if (!bodies) return bodies.error();
  auto source = open_presses(presses);
  if (!source) return source.error();
  std::set<std::string> names;
  while (true) {
    if (job.stop_requested()) return stopped();
    const auto frame = (*source)->next();
    if (!frame) return frame.error();
    if (!*frame) break;
    names.insert((*frame)->name);
    const auto result = meter(*frame, job);
    if (!result) return result.error();
    const MeasuredPress& taken = **result;
    if (!taken.press) {
      all.left_out_names.push_back(taken.name);
      const Message no_face = en::say("no face was found");
      all.left_out.push_back(refused(
          taken.name, taken.left_out == no_face ? en::say("{}.", no_face) : taken.left_out));
      continue;
    }
    const double light = taken.sign.light_change;
    Press press = *taken.press;
    apply_note(press_notes, *bodies, press);
    const Face& face = meter.pipeline().finger().face;
    auto measured = press.is_ball() ? measure(press, light, face, mapping, job)
                                    : measure_shape(press, light, face, mapping, job);
    if (measured) {
      all.presses.push_back(std::move(measured).value());
    } else {
      all.left_out.push_back(en::say("{}.", measured.error().message()));
      all.left_out_names.push_back(press.name);
    }
  }
  std::sort(all.presses.begin(), all.presses.end(), [](const auto& a, const auto& b) {
    return std::tie(a.name, a.error_mm) < std::tie(b.name, b.error_mm);
  });
  std::sort(all.left_out_names.begin(), all.left_out_names.end());
  std::sort(all.left_out.begin(), all.left_out.end(),
            [](const Message& a, const Message& b) { return a.english() < b.english(); });
  return names;
}

double known_radius_mm(const Finger& finger) {
  const auto found = finger.provenance.find("ball_radius_mm");
  if (found == finger.provenance.end()) return 0;
  double radius = 0;
  const std::string& text = found->second;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), radius);
  const bool is_number = status == std::errc{} && end == text.data() + text.size();
  return is_number && radius > 0 && radius <= kLargestBallMm ? radius : 0;
}

/// The presses of the calibration, measured like the new ones; empty where they are not saved.
std::vector<CheckedPress> own_presses(const fs::path& folder, PressMeter& meter,
                                      const Mapping& mapping, const Job& job) {
  const auto inputs = CalibrationInputs::load(folder);
  if (!inputs) return {};
  PressInput presses;
  std::error_code failed;
  for (const StoredPress& press : inputs->presses) {
    const fs::path file = stored_press_file(folder, press.name);
    if (inputs->press_set.of(press.name).excluded || !fs::exists(file, failed)) continue;
    presses.files.push_back(file);
  }
  if (presses.files.empty()) return {};
  PressCheck own;
  if (!measure_all(presses, meter, mapping, inputs->press_set, folder, job, own)) return {};
  return std::move(own.presses);
}

void judge(const std::vector<CheckedPress>& own, double held_out_mm, PressCheck& check) {
  const double n = static_cast<double>(check.presses.size());
  Mean error{2 * held_out_mm, held_out_mm}, light;
  if (own.size() > 2) {
    error = mean_of(own, &CheckedPress::error_mm);
    light = mean_of(own, &CheckedPress::light_change);
  }
  check.error_mm = mean_of(check.presses, &CheckedPress::error_mm).mean;
  check.factor = mean_of(check.presses, &CheckedPress::factor).mean;
  check.bias_mm = mean_of(check.presses, &CheckedPress::bias_mm).mean;
  check.light_change = mean_of(check.presses, &CheckedPress::light_change).mean - light.mean;
  check.drifting_above_mm = std::max(kMinErrorMm, error.mean + kChance * error.sd / std::sqrt(n));
  check.recalibrate_above_mm = std::max(2 * check.drifting_above_mm, kGoodErrorMm);
  check.light_limit = std::max(kLightLimit, kChance * light.sd / std::sqrt(n));
  std::vector<ContactSpot> spots;
  for (const CheckedPress& press : check.presses) spots.push_back(press.spot);
  const PressCoverage coverage = coverage_of(std::move(spots));
  check.positions = coverage.positions;
  check.thirds = coverage.thirds;
  check.verdict = check_verdict({static_cast<int>(check.presses.size()), check.positions,
                                 check.error_mm, check.drifting_above_mm,
                                 check.recalibrate_above_mm, std::abs(check.light_change),
                                 check.light_limit, std::max(kLightOff, 3 * check.light_limit)});
}

Message why_depth_is_off(const PressCheck& check) {
  if (!(check.error_mm > check.drifting_above_mm)) return {};
  if (std::abs(check.factor - 1) < kFactorSeen)
    return en::say("the contacts are not ball-shaped: is the ball or face dirty?");
  const Message side = check.factor > 1 ? en::say("shallow") : en::say("deep");
  return en::say("the mapping reads {:.0f} % too {}: layer, ball or camera have changed",
                 100 * std::abs(1 - 1 / check.factor), side);
}

Message why_light_is_off(const PressCheck& check) {
  if (!(std::abs(check.light_change) > check.light_limit)) return {};
  const Message how = check.light_change > 0 ? en::say("brighter") : en::say("darker");
  return en::say("the face is {:.1f} % {} than before: check lamps, exposure and layer",
                 100 * std::abs(check.light_change), how);
}

/// Number and position of the presses that a check lacks.
Message press_again(const PressCheck& check) {
  std::vector<Message> empty;
  const bool is_known =
      std::any_of(check.thirds.begin(), check.thirds.end(), [](int n) { return n > 0; });
  for (std::size_t i = 0; i < check.thirds.size(); ++i)
    if (is_known && check.thirds[i] == 0) empty.push_back(third_name(check.is_flat, i));
  const Message thirds = en::list(empty);
  return empty.empty()
             ? en::say(
                   "a check needs {} presses at different positions; these are at {}: press again",
                   kCheckPresses, check.positions)
             : en::say(
                   "a check needs {} presses at different positions; these are at {}: press also "
                   "in these thirds: {}",
                   kCheckPresses, check.positions, thirds);
}

Message sentence_of(const PressCheck& check) {
  const Message where =
      en::count("at {0} positions", "at {0} position", static_cast<long>(check.positions));
  const Message figures = en::count(
      "{1:.3f} mm depth error on {0} presses {4} (passes up to {2:.3f} mm), light {3:+.1f} %",
      "{1:.3f} mm depth error on {0} press {4} (passes up to {2:.3f} mm), light {3:+.1f} %",
      check.presses.size(), check.error_mm, check.drifting_above_mm, 100 * check.light_change,
      where);
  Message advice;
  if (check.verdict == CheckVerdict::kDrifting) advice = en::say("calibrate again soon");
  if (check.verdict == CheckVerdict::kRecalibrate)
    advice = en::say("calibrate again before measuring with it");
  if (check.verdict == CheckVerdict::kTooFew) advice = press_again(check);
  std::vector<Message> names;
  for (const std::string& name : check.left_out_names) names.push_back(Message::typed(name));
  const Message left_out = en::list(names);
  return en::clauses({en::at(word_of(check.verdict), figures), why_depth_is_off(check),
                      why_light_is_off(check),
                      names.empty() ? Message() : en::say("left out: {}", left_out), advice});
}

}  // namespace

Result<PressCheck> check_with_presses(const FingerSnapshot& snapshot, const PressInput& presses,
                                      const PressSet& of_presses, const Job& job) {
  const Finger& finger = snapshot.finger;
  if (!snapshot.mapping || !finger.mapping_record)
    return Error{en::say("the finger is not calibrated, so there is nothing to check"),
                 snapshot.folder, en::say("alltact calibrate")};
  PressSet press_notes = of_presses;
  if (!(press_notes.ball_radius_mm > 0)) press_notes.ball_radius_mm = known_radius_mm(finger);
  if (!(press_notes.ball_radius_mm > 0))
    return Error{en::say("the finger's data does not name its calibration ball"), snapshot.folder,
                 en::say("--ball-radius-mm with the radius of the pressed ball")};
  PressCheck check;
  check.ball_radius_mm = press_notes.ball_radius_mm;
  check.is_flat = finger.face.kind == FaceKind::kFlat;
  const auto checksum = reference_checksum(snapshot.folder, finger);
  // Stops before the mapping: up to the brightness difference.
  auto pipeline = Pipeline::create(snapshot.without_mapping(),
                                   settings_for_presses(measuring_settings(snapshot.folder)), job);
  if (!pipeline) return pipeline.error();
  PressMeter meter(std::move(pipeline).value(), checksum ? *checksum : std::string());
  job.report(0.3, en::say("measuring the presses"));
  const auto names =
      measure_all(presses, meter, *snapshot.mapping, press_notes, snapshot.folder, job, check);
  if (!names) return names.error();
  for (const auto& [name, note] : press_notes.notes)
    if (!names->contains(name))
      return Error{en::say("no press is named '{}'", name), "",
                   en::say("one of {}", fmt::format("{}", fmt::join(*names, ", ")))};
  if (check.presses.empty()) {
    std::vector<Message> reasons = check.left_out;
    if (!reasons.empty()) reasons.back() = without_full_stop(reasons.back());
    return Error{
        en::say("no press can be used: {}", in_a_row(reasons)), "",
        en::say("images of this finger with the ball pressed 0.3 mm or more into its face")};
  }
  job.report(0.6, en::say("measuring the presses of the calibration"));
  const auto own = own_presses(snapshot.folder, meter, *snapshot.mapping, job);
  if (job.stop_requested()) return stopped();
  judge(own, finger.mapping_record->held_out_mm, check);
  check.sentence = sentence_of(check);
  return check;
}

Result<BallByShape> ball_by_shape(const Press& measured, const Face& face, const Mapping& mapping,
                                  const Job& job) {
  constexpr int kSamplesOfBall = 1500;
  constexpr std::size_t kMinSamplesOfBall = 60;
  const auto guess = find_ball(measured, face);
  if (!guess) return guess.error();
  const Press press = without_light_spread(measured, mapping.parameters());
  const Error too_small{en::say("{}: the contact covers too few pixels", press.name), "",
                        en::say("pressing deeper, or a larger image")};
  PressSamples samples =
      sample_around(press, face, guess->centre_mm, 1.06 * press.ball_radius_mm, kSamplesOfBall);
  if (samples.samples.size() < kMinSamplesOfBall) return too_small;
  JointOptions options;
  options.along = mapping.parameters().along;
  options.zone = kInnerRim;
  const MappingCurve line = read_depths(mapping, samples);
  JointOptions fixed = options;
  fixed.fix_mapping = true;
  JointFit fit = fit_jointly({&samples}, {line, {guess->centre_mm}, false}, fixed, job);
  if (fit.converged) fit = fit_jointly({&samples}, fit, options, job);
  if (job.stop_requested()) return stopped();
  if (!fit.converged)
    return Error{en::say("{}: no ball fits the contact", press.name), "", en::say("a clean ball")};

  BallByShape ball{fit.centres_mm[0], fit.curve.values()[0], 0, Eigen::Vector2d::Zero(), {}};
  if (const Sample* nearest = nearest_sample(samples, ball.centre_mm))
    ball.on_face_mm = nearest->position_mm;
  const ContactDisc disc(samples, options.along, ball.centre_mm);
  for (const Sample& sample : samples.samples) {
    const double depth = ball_depth_mm(sample, options.along, ball.centre_mm, press.ball_radius_mm);
    if (!std::isfinite(depth) || !(disc.position_of(sample).radius <= kInnerRim)) continue;
    ball.errors_mm.push_back(sample.x - depth -
                             blur_mm(sample, samples, line.at(), options.along, ball.centre_mm));
    ball.depth_mm = std::max(ball.depth_mm, depth);
  }
  if (ball.errors_mm.empty()) return too_small;
  return ball;
}

}  // namespace alltact
