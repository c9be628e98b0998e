#include "calibration/finger/calibration_file.h"

#include "calibration/finger/calibration_report.h"
#include "core/base/atomic_file.h"
#include "core/base/message_json.h"
#include "core/base/yaml.h"
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
std::string number_text(double value) { return yaml_number(std::isfinite(value) ? value : 0.0); }

std::string vector_text(const Eigen::Vector3d& v) {
  return yaml_list({number_text(v.x()), number_text(v.y()), number_text(v.z())});
}

std::string sentence_text(const Message& message) {
  // A file name in it may be anything but UTF-8.
  return yaml_text(
      message_json(message).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

std::string sentences_text(const std::vector<Message>& messages) {
  std::vector<std::string> all;
  for (const Message& message : messages) all.push_back(sentence_text(message));
  return yaml_list(all);
}

std::string samples_text(const std::vector<ResidualSample>& samples, std::size_t every) {
  std::string text;
  for (std::size_t i = 0; i < samples.size(); i += every) {
    const ResidualSample& s = samples[i];
    for (const double value : {s.pixel.x(), s.pixel.y(), s.x, s.ball_depth_mm, s.residual_mm,
                               s.along_mm, s.across_mm, s.rim, s.factor})
      text += fmt::format("{}{:.5g}", text.empty() ? "" : " ", std::isfinite(value) ? value : 0.0);
  }
  return yaml_text(text);
}

std::string press_text(const BallFit& ball, const PressResiduals* residuals, std::size_t every) {
  YamlBlock block("");
  block.add("press", yaml_text(ball.press));
  block.add("ball_radius_mm", number_text(ball.radius_mm));
  block.add("centre_mm", vector_text(ball.centre_mm));
  block.add("centre_sd_mm", vector_text(ball.centre_sd_mm));
  block.add("depth_mm", number_text(ball.depth_mm));
  block.add("residual_mm", number_text(ball.residual_mm));
  block.add("held_out_mm", number_text(ball.held_out_mm));
  block.add("tangent_arc_deg", number_text(ball.tangent_arc_deg));
  block.add("cut_by_edge", ball.cut_by_edge ? "true" : "false");
  block.add("pressed_in_mm", number_text(ball.indentation_mm));
  if (ball.given_depth)
    block.add("measured_depth_mm",
              yaml_list({number_text(ball.given_depth->mm), number_text(ball.given_depth->sd_mm)}));
  if (residuals != nullptr) {
    block.add("along_mm", number_text(residuals->along_mm));
    block.add("across_mm", number_text(residuals->across_mm));
    block.add("contact_radius_mm", number_text(residuals->contact_radius_mm));
    block.add("face_length_mm", number_text(residuals->face_length_mm));
    block.add("face_width_mm", number_text(residuals->face_width_mm));
    block.add("samples", samples_text(residuals->samples, every));
  }
  return "  - " + block.in_braces() + "\n";
}

Message stored_sentence(const std::string& text) {
  return message_of(nlohmann::ordered_json::parse(text, nullptr, false));
}

std::vector<Message> stored_sentences(YamlSection& top, const char* key) {
  std::vector<Message> messages;
  for (const std::string& text : top.texts(key)) messages.push_back(stored_sentence(text));
  return messages;
}

double number_of(YamlSection& section, const char* key) { return section.number(key, kAnyNumber); }

Eigen::Vector3d vector_of(YamlSection& section, const char* key) {
  const std::vector<double> v = section.numbers(key, 3, 3, kAnyNumber);
  return {v[0], v[1], v[2]};
}

bool flag_of(YamlSection& section, const char* key) {
  return section.choice(key, {"false", "true"}) == 1;
}

std::vector<ResidualSample> samples_of(YamlSection& section) {
  const std::string text = section.text("samples");
  std::vector<ResidualSample> samples;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    std::array<double, kSampleNumbers> n{};
    for (double& value : n) {
      if (at != end && *at == ' ') ++at;
      const auto [next, failed] = std::from_chars(at, end, value);
      if (failed != std::errc{} || !std::isfinite(value))
        section.refuse("samples", en::say("is not a number"), en::say("calibrating again"));
      at = next;
    }
    samples.push_back({{n[0], n[1]}, n[2], n[3], n[4], n[5], n[6], n[7], n[8]});
  }
  return samples;
}

void read_press(YamlSection section, FingerCalibration& done) {
  BallFit ball;
  ball.press = section.text("press");
  ball.radius_mm = number_of(section, "ball_radius_mm");
  ball.centre_mm = vector_of(section, "centre_mm");
  ball.centre_sd_mm = vector_of(section, "centre_sd_mm");
  ball.depth_mm = number_of(section, "depth_mm");
  ball.residual_mm = number_of(section, "residual_mm");
  ball.held_out_mm = number_of(section, "held_out_mm");
  ball.tangent_arc_deg = number_of(section, "tangent_arc_deg");
  ball.cut_by_edge = flag_of(section, "cut_by_edge");
  ball.indentation_mm = number_of(section, "pressed_in_mm");
  if (section.has("measured_depth_mm")) {
    const auto depth = section.numbers("measured_depth_mm", 2, 2, kAnyNumber);
    ball.given_depth = GivenDepth{depth[0], depth[1]};
  }
  if (section.has("samples")) {
    PressResiduals residuals;
    residuals.press = ball.press;
    residuals.along_mm = number_of(section, "along_mm");
    residuals.across_mm = number_of(section, "across_mm");
    residuals.contact_radius_mm = number_of(section, "contact_radius_mm");
    residuals.face_length_mm = number_of(section, "face_length_mm");
    residuals.face_width_mm = number_of(section, "face_width_mm");
    residuals.samples = samples_of(section);
    done.residuals.push_back(std::move(residuals));
  }
  done.calibration.balls.push_back(std::move(ball));
}

PressAdvice read_advice(YamlSection section) {
  PressAdvice advice;
  advice.enough = flag_of(section, "enough");
  advice.along_mm = number_of(section, "along_mm");
  advice.across_mm = number_of(section, "across_mm");
  advice.depth_mm = number_of(section, "depth_mm");
  advice.sd_now_mm = number_of(section, "sd_now_mm");
  advice.sd_then_mm = number_of(section, "sd_then_mm");
  advice.sentence = stored_sentence(section.text("sentence"));
  return advice;
}

FingerCalibration read_calibration(YamlSection& top) {
  if (const std::string format = top.text("format"); format != kFormat)
    top.refuse("format", en::say("'{}' cannot be read by this version", printable(format)),
               en::say("calibrating again"));
  FingerCalibration done;
  Calibration& calibration = done.calibration;
  calibration.residual_mm = number_of(top, "residual_mm");
  calibration.condition = number_of(top, "condition");
  calibration.degree_choice = stored_sentence(top.text("degree_choice"));
  calibration.left_out = stored_sentences(top, "left_out");
  calibration.remarks = stored_sentences(top, "remarks");
  done.fault_signs = stored_sentences(top, "fault_signs");
  done.about_settings = stored_sentences(top, "about_settings");
  if (top.has("next_press")) calibration.next_press = read_advice(top.section("next_press"));
  if (top.has("steps"))
    for (YamlSection& step : top.sections("steps"))
      calibration.steps.push_back({step.text("press"), number_of(step, "step_mm"),
                                   number_of(step, "reads_mm"), number_of(step, "sd_mm")});
  if (top.has("presses"))
    for (YamlSection& press : top.sections("presses")) read_press(press, done);
  return done;
}

bool is_of(const Calibration& calibration, const MappingRecord& record) {
  return std::equal(
             calibration.balls.begin(), calibration.balls.end(), record.presses.begin(),
             record.presses.end(),
             [](const BallFit& ball, const std::string& press) { return ball.press == press; }) &&
         std::abs(calibration.residual_mm - record.residual_mm) <= 1e-9;
}

}  // namespace

std::string calibration_yaml(const FingerCalibration& done) {
  const Calibration& calibration = done.calibration;
  YamlBlock head("");
  head.add("format", kFormat);
  head.add("residual_mm", number_text(calibration.residual_mm));
  head.add("condition", number_text(calibration.condition));
  head.add("degree_choice", sentence_text(calibration.degree_choice));
  head.add("left_out", sentences_text(calibration.left_out));
  head.add("remarks", sentences_text(calibration.remarks));
  head.add("fault_signs", sentences_text(done.fault_signs));
  head.add("about_settings", sentences_text(done.about_settings));
  std::string text = head.on_many_lines();
  if (const auto& next = calibration.next_press) {
    YamlBlock advice("next_press");
    advice.add("enough", next->enough ? "true" : "false");
    advice.add("along_mm", number_text(next->along_mm));
    advice.add("across_mm", number_text(next->across_mm));
    advice.add("depth_mm", number_text(next->depth_mm));
    advice.add("sd_now_mm", number_text(next->sd_now_mm));
    advice.add("sd_then_mm", number_text(next->sd_then_mm));
    advice.add("sentence", sentence_text(next->sentence));
    text += advice.on_one_line();
  }
  if (!calibration.steps.empty()) text += "steps:\n";
  for (const StepFit& step : calibration.steps) {
    YamlBlock block("");
    block.add("press", yaml_text(step.press));
    block.add("step_mm", number_text(step.step_mm));
    block.add("reads_mm", number_text(step.estimated_mm));
    block.add("sd_mm", number_text(step.sd_mm));
    text += "  - " + block.in_braces() + "\n";
  }
  std::size_t count = 0;
  for (const PressResiduals& press : done.residuals) count += press.samples.size();
  const std::size_t every = std::max<std::size_t>(1, (count + kMaxSamples - 1) / kMaxSamples);
  if (!calibration.balls.empty()) text += "presses:\n";
  for (const BallFit& ball : calibration.balls) {
    const auto found =
        std::find_if(done.residuals.begin(), done.residuals.end(),
                     [&](const PressResiduals& one) { return one.press == ball.press; });
    text += press_text(ball, found != done.residuals.end() ? &*found : nullptr, every);
  }
  return text;
}

Result<FingerCalibration> parse_calibration(const std::string& yaml, const fs::path& origin) {
  YamlFile file(origin);
  FingerCalibration done;
  const Status read = file.read(yaml, [&](YamlSection& top) { done = read_calibration(top); });
  if (!read) return read.error();
  return done;
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
  done.pixel_sd_mm = record->basis ? record->basis->pixel_sd_mm : 0.0;
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
