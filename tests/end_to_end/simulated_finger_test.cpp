// A newcomer's whole day with the simulated finger, through the program alone.
#include "calibration/study/evaluate.h"
#include "tests/support/program.h"
#include "tests/support/python_loader.h"
#include "tests/support/slow_run.h"

#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

std::string scene(const std::string& name) {
  return fmt::format("{}/resources/scenes/{}.yaml", ALLTACT_SOURCE_DIR, name);
}

/// A finger with reference and mapping and what it was made from, made once; each day goes on with
/// its own copy.
class Morning {
 public:
  static const Morning& get() {
    static const Morning morning;
    return morning;
  }
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  /// What the steps of the demonstration wrote to standard error.
  [[nodiscard]] const std::string& errors() const { return errors_; }

 private:
  Morning() {
    simulate_recording();
    step({"simulate", scene("demo_presses"), "-o", file("presses"), "--threads", "2"});
    step({"simulate", scene("demo_objects"), "-o", file("objects"), "--threads", "2"});
    step({"new", file("finger"), "--camera", file("recording/camera.yaml"), "--width-mm", "24",
          "--layer-mm", "1.5", "--per-row", "6"});
    step({"reference", file("finger"), file("recording/frames.mkv")});
    step({"calibrate", file("finger"), file("presses"), "--ball-radius-mm", "4"});
  }
  /// The wandering of the demonstration, in fewer and longer steps; all of them in
  /// the long run.
  void simulate_recording() {
    std::string text = text_of(scene("demo_reference"));
    const std::string all = "frames: 240";
    const auto place = text.find(all);
    if (place == std::string::npos)
      trouble_ += "the demonstration has other frames\n";
    else if (!is_slow_run())
      text.replace(place, all.size(), "frames: 180");
    write_text(file("recording.yaml"), text);
    step(
        {"simulate", file("recording.yaml"), "-o", file("recording"), "--video", "--threads", "2"});
  }
  void step(const std::vector<std::string>& arguments) {
    if (!trouble_.empty()) return;
    const ProgramRun run = run_alltact(arguments);
    errors_ += run.errors;
    if (run.status != 0)
      trouble_ = testing::PrintToString(arguments) + "\n" + run.errors + run.output;
  }

  TemporaryFolder folder_;
  std::string trouble_, errors_;
};

/// All steps of a day below one folder, which begins with what the morning made.
class Day {
 public:
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }

  void step(const std::vector<std::string>& arguments) {
    const ProgramRun run = run_alltact(arguments);
    ASSERT_EQ(run.status, 0) << testing::PrintToString(arguments) << "\n"
                             << run.errors << run.output;
  }

  void begin() {
    const Morning& morning = Morning::get();
    ASSERT_EQ(morning.trouble(), "");
    for (const char* name : {"presses", "objects", "finger"})
      fs::copy(morning.file(name), file(name), fs::copy_options::recursive);
  }

 private:
  TemporaryFolder folder_;
};

void expect_measured_well(const Evaluation& evaluation) {
  EXPECT_EQ(evaluation.frames_missing, 0);
  EXPECT_LE(evaluation.contact_depth_mm.value(), 0.03);
  EXPECT_GE(evaluation.contact_coverage.value(), 0.95);
  EXPECT_LE(evaluation.false_depth_mm.value(), 0.015);
  EXPECT_LE(evaluation.position_mm.value(), 0.05);
  EXPECT_LE(evaluation.marker_seen_px.value(), 0.1);
  EXPECT_LE(evaluation.marker_hidden_px.value(), 1.0);
}

void print(const Evaluation& evaluation) {
  testing::Test::RecordProperty("contact_depth_mm",
                                std::to_string(evaluation.contact_depth_mm.value_or(-1)));
  std::printf(
      "contact %.4f mm (%.3f covered), away %.4f mm, position %.4f mm, markers %.3f / %.3f px, "
      "%.2f ms\n",
      evaluation.contact_depth_mm.value_or(-1), evaluation.contact_coverage.value_or(-1),
      evaluation.false_depth_mm.value_or(-1), evaluation.position_mm.value_or(-1),
      evaluation.marker_seen_px.value_or(-1), evaluation.marker_hidden_px.value_or(-1),
      evaluation.time_ms.value_or(-1));
}

/// The presses of the demonstration, drawn anew and with another finger or light.
std::string changed_presses(const Day& day, const std::string& name,
                            const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string text = text_of(scene("demo_presses"));
  for (const auto& [from, to] : changes) {
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    if (place != std::string::npos) text.replace(place, from.size(), to);
  }
  write_text(day.file(name + ".yaml"), text);
  EXPECT_EQ(run_alltact({"simulate", day.file(name + ".yaml"), "-o", day.file(name), "--seed", "4",
                         "--threads", "2"})
                .status,
            0);
  return day.file(name);
}

/// The same finger passes; other light drifts; another layer needs a calibration.
void expect_checked_well(const Day& day) {
  const auto check = [&](const std::string& presses) {
    return run_alltact({"check", day.file("finger"), "--presses", presses + "/frame_00000.png",
                        presses + "/frame_00002.png", presses + "/frame_00004.png"});
  };
  const ProgramRun same = check(changed_presses(day, "same", {}));
  EXPECT_EQ(same.status, 0) << same.errors;
  EXPECT_THAT(same.output, testing::HasSubstr("Verdict: pass")) << same.output;
  const std::vector<std::pair<std::string, std::string>> brighter = {
      {"power: 270000.0", "power: 278100.0"},
      {"power: 270000.0", "power: 278100.0"},
      {"power: 3300000.0", "power: 3399000.0"}};
  const ProgramRun warm = check(changed_presses(day, "warm", brighter));
  EXPECT_EQ(warm.status, 0) << warm.errors;
  EXPECT_THAT(warm.output, testing::HasSubstr("Verdict: drifting")) << warm.output;
  const ProgramRun layer =
      check(changed_presses(day, "layer", {{"scatter_per_mm: 0.6", "scatter_per_mm: 0.8"}}));
  EXPECT_EQ(layer.status, 1);
  EXPECT_THAT(layer.output, testing::HasSubstr("Verdict: recalibrate")) << layer.output;

  // A wrong radius agrees with itself; a ball of another size gives it away.
  const std::string small =
      changed_presses(day, "small",
                      {{"    radius_mm: 4.0", "    radius_mm: 3.0"},
                       {"[0.8, 0.4, 1.2, 0.6, 1.0, 0.9]", "[0.8, 0.6, 1.0, 0.7, 0.9, 0.8]"}});
  const auto check_small = [&] {
    return nlohmann::json::parse(
        run_alltact({"check", day.file("finger"), "--presses", small + "/frame_00000.png",
                     small + "/frame_00002.png", small + "/frame_00004.png", "--ball-radius-mm",
                     "3", "--json"})
            .output);
  };
  // Sharper than any lens: the fits reckon with half a square pixel of blur.
  EXPECT_NEAR(check_small().at("factor").get<double>(), 1, 0.03);
  const ProgramRun wrong =
      run_alltact({"calibrate", day.file("finger"), "--again", "--ball-radius-mm", "4.4"});
  EXPECT_THAT(wrong.output, testing::HasSubstr("Verdict: good"));
  EXPECT_NEAR(check_small().at("factor").get<double>(), 1.1, 0.04);
}

/// Another program, with what was exported for it. The bounds stand in packaging/python/README.md.
/// Of a pose that was never recorded neither claims to know the reference.
void expect_python_agrees(const Day& day) {
  std::vector<fs::path> images;
  std::ifstream results(day.file("results") + "/results.jsonl");
  for (std::string line; std::getline(results, line);) {
    const auto frame = nlohmann::json::parse(line);
    if (frame.at("reference").at("known_pose").get<bool>())
      images.push_back(
          day.file(fmt::format("objects/{}.png", frame.at("frame").get<std::string>())));
  }
  ASSERT_GE(images.size(), 9U);
  const DepthDifference difference =
      python_against_program(day.file("finger"), images, day.file("results"));
  std::printf("Python: %s\n", difference.words().c_str());
  ASSERT_GT(difference.in_contact.size(), 8000U);
  EXPECT_LT(difference.part(difference.all, 0.5), 0.004);  // noise has two signs
  EXPECT_LT(difference.part(difference.all, 0.95), 0.05);
  EXPECT_LT(difference.part(difference.in_contact, 0.5), 0.01);
  EXPECT_LT(difference.part(difference.in_contact, 0.95), 0.1);
  EXPECT_LT(difference.missing_part(), 0.01);
}

TEST(SimulatedFinger, IsMadeWithoutAnAlarm) {
  const Morning& morning = Morning::get();
  EXPECT_EQ(morning.trouble(), "");
  EXPECT_THAT(morning.errors(), testing::Not(testing::HasSubstr("responds slowly")));
}

TEST(SimulatedFinger, IsMeasuredAsWellAsPromised) {
  Day day;
  ASSERT_NO_FATAL_FAILURE(day.begin());
  day.step({"check", day.file("finger")});
  day.step({"reconstruct", day.file("finger"), day.file("objects"), "-o", day.file("results"),
            "--format", "depth,points"});
  const auto evaluation = evaluate_folder(day.file("objects"), day.file("results"));
  ASSERT_TRUE(evaluation.ok()) << evaluation.error().sentence();
  print(*evaluation);
  EXPECT_EQ(evaluation->frames, 12);
  expect_measured_well(*evaluation);

  // Every object presses on the contact face, and the finger gives way to it.
  std::istringstream lines(text_of(day.file("results/results.jsonl")));
  int frames = 0;
  for (std::string line; std::getline(lines, line); ++frames) {
    const auto contact = nlohmann::json::parse(line).at("contact");
    EXPECT_TRUE(contact.at("touched").get<bool>()) << line;
    EXPECT_EQ(contact.at("face"), "contact") << line;
  }
  EXPECT_EQ(frames, 12);
  expect_python_agrees(day);
  expect_checked_well(day);
}

TEST(SimulatedFinger, TheSameInputsGiveTheSameBytes) {
  Day day;
  ASSERT_NO_FATAL_FAILURE(day.begin());
  // Rendered by one thread and by two.
  day.step({"simulate", scene("demo_objects"), "-o", day.file("one"), "--threads", "1", "--frames",
            "3"});
  day.step({"simulate", scene("demo_objects"), "-o", day.file("two"), "--threads", "2", "--frames",
            "3"});
  EXPECT_EQ(contents_of(day.file("one")), contents_of(day.file("two")));

  // Reconstructed twice, and from a finger that was calibrated once more: all but the times.
  day.step({"reconstruct", day.file("finger"), day.file("one"), "-o", day.file("first"),
            "--threads", "1"});
  const std::string finger_before = text_of(day.file("finger/calibration_report.json"));
  // Again from what the finger keeps.
  const auto kept_before = contents_of(day.file("finger"));
  day.step({"calibrate", day.file("finger"), "--again"});
  EXPECT_TRUE(contents_of(day.file("finger")) == kept_before);
  day.step({"calibrate", day.file("finger"), day.file("finger/presses"), "--ball-radius-mm", "4"});
  EXPECT_EQ(text_of(day.file("finger/calibration_report.json")), finger_before);
  day.step({"reconstruct", day.file("finger"), day.file("one"), "-o", day.file("second"),
            "--threads", "2"});
  for (const auto& [name, content] : contents_of(day.file("first"))) {
    if (name == "results.jsonl") continue;
    EXPECT_EQ(text_of(day.file(fmt::format("second/{}", name))), content) << name;
  }
  std::istringstream first(text_of(day.file("first/results.jsonl"))),
      second(text_of(day.file("second/results.jsonl")));
  int lines = 0;
  for (std::string a, b; std::getline(first, a) && std::getline(second, b); ++lines) {
    auto left = nlohmann::json::parse(a), right = nlohmann::json::parse(b);
    left.erase("times_ms");
    right.erase("times_ms");
    EXPECT_EQ(left, right);
  }
  EXPECT_EQ(lines, 3);
}

TEST(SimulatedFinger, ThePaperMethodRunsBesideOurs) {
  Day day;
  ASSERT_NO_FATAL_FAILURE(day.begin());
  day.step({"reconstruct", day.file("finger"), day.file("objects"), "-o", day.file("ours"),
            "--format", "depth,points"});
  day.step({"calibrate", day.file("finger"), day.file("presses"), "--ball-radius-mm", "4",
            "--method", "paper"});
  day.step({"reconstruct", day.file("finger"), day.file("objects"), "-o", day.file("paper"),
            "--format", "depth,points", "--method", "paper"});
  const auto ours = evaluate_folder(day.file("objects"), day.file("ours"));
  const auto paper = evaluate_folder(day.file("objects"), day.file("paper"));
  ASSERT_TRUE(ours.ok() && paper.ok());
  print(*ours);
  print(*paper);
  EXPECT_LT(*ours->contact_depth_mm, *paper->contact_depth_mm);
  EXPECT_LT(*ours->position_mm, *paper->position_mm);
}

}  // namespace
}  // namespace alltact::test
