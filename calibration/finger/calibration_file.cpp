#include "calibration/finger/calibration_file.h"

#include "calibration/finger/calibration_report.h"
#include "core/base/atomic_file.h"
#include "core/base/fields.h"
#include "core/base/message_json.h"
#include "core/finger/finger_store.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFormat = "alltact-finger-calibration/1";
constexpr std::size_t kMaxSamples = 50'000;  // 65 bytes each: YamlFile reads up to 4 MB
constexpr std::size_t kSampleNumbers = 9;

/// 0 where it is unknown.
void describe_figure(Fields& fields, const char* key, double& value) {
  if (!std::isfinite(value)) value = 0;
  fields.number(key, value, kAnyNumber);
}

void describe_vector(Fields& fields, const char* key, Eigen::Vector3d& v) {
  for (double& value : v)
    if (!std::isfinite(value)) value = 0;
  fields.numbers(key, {&v.x(), &v.y(), &v.z()}, kAnyNumber);
}

std::string text_of(const Message& message) {
  // A file name in it may be anything but UTF-8.
  return message_json(message).dump(-1, ' ', false,
                                    nlohmann::ordered_json::error_handler_t::replace);
}

Message message_in(const std::string& text) {
  return message_of(nlohmann::ordered_json::parse(text, nullptr, false));
}

void describe_sentence(Fields& fields, const char* key, Message& sentence) {
  std::string text = text_of(sentence);
  fields.text(key, text);
  if (fields.is_reading()) sentence = message_in(text);
}

void describe_sentences(Fields& fields, const char* key, std::vector<Message>& sentences) {
  std::vector<std::string> texts;
  for (const Message& sentence : sentences) texts.push_back(text_of(sentence));
  fields.texts(key, texts);
  if (!fields.is_reading()) return;
  for (const std::string& text : texts) sentences.push_back(message_in(text));
}

void describe_samples(Fields& fields, std::vector<ResidualSample>& samples) {
  std::string text;
  for (const ResidualSample& s : samples)
    for (const double value : {s.pixel.x(), s.pixel.y(), s.x, s.ball_depth_mm, s.residual_mm,
                               s.along_mm, s.across_mm, s.rim, s.factor})
      text += fmt::format("{}{:.5g}", text.empty() ? "" : " ", std::isfinite(value) ? value : 0.0);
  fields.text("samples", text);
  if (!fields.is_reading()) return;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    std::array<double, kSampleNumbers> n{};
    for (double& value : n) {
      if (at != end && *at == ' ') ++at;
      const auto [next, failed] = std::from_chars(at, end, value);
      fields.demand(failed == std::errc{} && std::isfinite(value), "samples",
                    en::say("is not a number"), en::say("calibrating again"));
      at = next;
    }
    samples.push_back({{n[0], n[1]}, n[2], n[3], n[4], n[5], n[6], n[7], n[8]});
  }
}

void describe_ball(Fields& fields, BallFit& ball) {
  fields.text("press", ball.press);
  describe_figure(fields, "ball_radius_mm", ball.radius_mm);
  describe_vector(fields, "centre_mm", ball.centre_mm);
  describe_vector(fields, "centre_sd_mm", ball.centre_sd_mm);
  describe_figure(fields, "depth_mm", ball.depth_mm);
  describe_figure(fields, "residual_mm", ball.residual_mm);
  describe_figure(fields, "held_out_mm", ball.held_out_mm);
  describe_figure(fields, "tangent_arc_deg", ball.tangent_arc_deg);
  fields.flag("cut_by_edge", ball.cut_by_edge);
  describe_figure(fields, "pressed_in_mm", ball.indentation_mm);
  if (fields.has(may("measured_depth_mm"), ball.given_depth))
    fields.numbers("measured_depth_mm", {&ball.given_depth->mm, &ball.given_depth->sd_mm},
                   kAnyNumber);
}

void describe_resolution(Fields& fields, DepthResolution& resolution) {
  describe_figure(fields, "two_points_mm", resolution.two_points_mm);
  describe_figure(fields, "wall_mm", resolution.wall_mm);
  describe_figure(fields, "pin_mm", resolution.pin_mm);
  describe_figure(fields, "step_mm", resolution.step_mm);
  fields.numbers("contrasts", resolution.contrasts, {0.0, 10.0});
  fields.demand(resolution.contrasts.size() == std::size_t{DepthResolution::kWaves}, "contrasts",
                en::say("has another number of waves"), en::say("calibrating again"));
}

void describe_residuals(Fields& fields, PressResiduals& residuals) {
  describe_figure(fields, "along_mm", residuals.along_mm);
  describe_figure(fields, "across_mm", residuals.across_mm);
  describe_figure(fields, "contact_radius_mm", residuals.contact_radius_mm);
  describe_figure(fields, "face_length_mm", residuals.face_length_mm);
  describe_figure(fields, "face_width_mm", residuals.face_width_mm);
  if (fields.has(may("contrasts"), residuals.resolution))
    describe_resolution(fields, *residuals.resolution);
  describe_samples(fields, residuals.samples);
}

/// Up to kMaxSamples in all.
void thin_samples(std::vector<PressResiduals>& residuals) {
  std::size_t count = 0;
  for (const PressResiduals& press : residuals) count += press.samples.size();
  const std::size_t every = std::max<std::size_t>(1, (count + kMaxSamples - 1) / kMaxSamples);
  for (PressResiduals& press : residuals) {
    std::size_t number = 0;
    std::erase_if(press.samples, [&](const ResidualSample&) { return number++ % every != 0; });
  }
}

void describe_press(Fields& fields, BallFit& ball, std::vector<PressResiduals>& residuals) {
  describe_ball(fields, ball);
  if (fields.is_reading()) {
    if (fields.has(may("samples"))) {
      describe_residuals(fields, residuals.emplace_back());
      residuals.back().press = ball.press;
    }
  } else if (const auto found =
                 std::find_if(residuals.begin(), residuals.end(),
                              [&](const PressResiduals& one) { return one.press == ball.press; });
             found != residuals.end()) {
    describe_residuals(fields, *found);
  }
}

}  // namespace

static void describe(Fields& fields, PressAdvice& advice) {
  fields.flag("enough", advice.enough);
  describe_figure(fields, "along_mm", advice.along_mm);
  describe_figure(fields, "across_mm", advice.across_mm);
  describe_figure(fields, "depth_mm", advice.depth_mm);
  describe_figure(fields, "sd_now_mm", advice.sd_now_mm);
  describe_figure(fields, "sd_then_mm", advice.sd_then_mm);
  describe_sentence(fields, "sentence", advice.sentence);
}

static void describe(Fields& fields, StepFit& step) {
  fields.text("press", step.press);
  describe_figure(fields, "step_mm", step.step_mm);
  describe_figure(fields, "reads_mm", step.estimated_mm);
  describe_figure(fields, "sd_mm", step.sd_mm);
}

static void describe(Fields& fields, BodyFit& body) {
  fields.text("press", body.press);
  fields.text("body", body.body);
  describe_figure(fields, "scale", body.scale);
  describe_figure(fields, "sd", body.sd);
}

static void describe(Fields& fields, Halo& halo) {
  describe_figure(fields, "near_mm", halo.near_mm);
  describe_figure(fields, "far_mm", halo.far_mm);
  describe_figure(fields, "excess_mm", halo.excess_mm);
  describe_figure(fields, "excess_sd_mm", halo.excess_sd_mm);
  fields.integer("presses", halo.presses, 0, 1'000'000);
  fields.flag("is_seen", halo.is_seen);
}

static void describe(Fields& fields, FingerCalibration& done) {
  Calibration& calibration = done.calibration;
  fields.format(kFormat, en::say("calibrating again"));
  describe_figure(fields, "residual_mm", calibration.residual_mm);
  describe_figure(fields, "condition", calibration.condition);
  describe_sentence(fields, "degree_choice", calibration.degree_choice);
  describe_sentences(fields, "left_out", calibration.left_out);
  describe_sentences(fields, "remarks", calibration.remarks);
  describe_sentences(fields, "fault_signs", done.fault_signs);
  describe_sentences(fields, "about_settings", done.about_settings);
  fields.section(may("next_press"), calibration.next_press);
  fields.section(may("halo"), done.halo);
  fields.sections(may("steps", !calibration.steps.empty()), calibration.steps);
  fields.sections(may("bodies", !calibration.bodies.empty()), calibration.bodies);
  auto& balls = calibration.balls;
  fields.sections(
      may("presses", !balls.empty()), Fields::Layout::kBraces, balls.size(),
      [&](std::size_t count) { balls.resize(count); },
      [&](Fields& press, std::size_t i) { describe_press(press, balls[i], done.residuals); });
}

namespace {

bool is_of(const Calibration& calibration, const MappingRecord& record) {
  return std::equal(
             calibration.balls.begin(), calibration.balls.end(), record.presses.begin(),
             record.presses.end(),
             [](const BallFit& ball, const std::string& press) { return ball.press == press; }) &&
         std::abs(calibration.residual_mm - record.residual_mm) <= 1e-9;
}

}  // namespace

std::string calibration_yaml(const FingerCalibration& done) {
  FingerCalibration stored;
  stored.calibration = done.calibration;
  stored.residuals = done.residuals;
  stored.halo = done.halo;
  thin_samples(stored.residuals);
  stored.fault_signs = done.fault_signs;
  stored.about_settings = done.about_settings;
  return fields_text(std::move(stored));
}

Result<FingerCalibration> parse_calibration(const std::string& yaml, const fs::path& origin) {
  YamlFile file(origin);
  return read_fields<FingerCalibration>(file, yaml);
}

Result<FingerCalibration> stored_calibration(const fs::path& folder) {
  const auto finger = open_finger(folder);
  if (!finger) return finger.error();
  const auto& record = (*finger)->finger.mapping_record;
  if (!(*finger)->finger.mapping || !record)
    return Error{en::say("the finger is not calibrated"), (folder / Finger::kFileName).string(),
                 en::say("calibrating it with ball presses")};
  auto inputs = CalibrationInputs::load(folder);
  if (!inputs) return inputs.error();
  const fs::path file = folder / kCalibrationFile;
  const auto content = read_file(file, YamlFile::kMaxBytes);
  if (!content) return content.error();
  auto stored = parse_calibration(*content, file);
  if (!stored) return stored.error();
  FingerCalibration done = std::move(stored).value();
  if (!is_of(done.calibration, *record))
    return Error{en::say("this is not the file of the finger's calibration"), file.string(),
                 en::say("calibrating again")};
  done.finger = (*finger)->finger;
  done.inputs = std::move(*inputs);
  done.calibration.mapping = *done.finger.mapping;
  done.calibration.residual_mm = record->residual_mm;
  done.calibration.held_out_mm = record->held_out_mm;
  done.calibration.spread_mm = record->spread_mm;
  done.zones = zone_errors(done.residuals, done.calibration, done.finger.face.kind);
  done.pixel_mm = record->pixel_mm;
  if (record->basis) {
    done.pixel_sd_mm = record->basis->pixel_sd_mm;
    done.calibration.undetected_spread = record->basis->undetected_spread;
  }
  if (record->basis && record->basis->halo_mm > 0) {
    done.halo.is_seen = true;
    done.halo.excess_mm = record->basis->halo_mm;
  }
  const CalibrationEvidence evidence = evidence_in(**finger, "");
  done.contradictions = evidence.contradictions;
  done.verdict = verdict(evidence);
  return done;
}

}  // namespace alltact
