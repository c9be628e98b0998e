// A study's truth against closed formulas, and what it says against what it must.
#include "calibration/study/accuracy_study.h"

#include "calibration/joint/calibration_settings.h"
#include "calibration/study/calibrating_study.h"
#include "calibration/study/recommended_settings.h"
#include "calibration/study/study_file.h"
#include "calibration/study/study_plot.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <cmath>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

using testing::HasSubstr;

FingerPtr calibrated_flat_finger(const TemporaryFolder& folder) {
  write_flat_sensor(folder.path());
  Finger finger = flat_sensor_finger(true);
  finger.reference.emplace();
  finger.reference->image = "ref.png";
  auto snapshot = FingerSnapshot::of(folder.path(), finger);
  EXPECT_TRUE(snapshot.ok());
  snapshot->presses.ball_radius_mm = FlatSensor::kBallRadiusMm;
  return std::make_shared<FingerSnapshot>(std::move(snapshot).value());
}

StudyWorld painted_flat_world(const TemporaryFolder& folder, int frames, std::uint64_t seed = 1) {
  StudyWorldOptions options;
  options.frames = frames;
  options.seed = seed;
  auto world = painted_world(calibrated_flat_finger(folder), options, Job());
  EXPECT_TRUE(world.ok());
  return std::move(world).value();
}

TEST(PaintedWorld, BallsAreBallsAndAsDarkAsTheMappingSays) {
  const TemporaryFolder folder;
  const StudyWorld world = painted_flat_world(folder, 9);
  ASSERT_EQ(world.frames.size(), 9U);
  const cv::Mat untouched = cv::imread((folder / "ref.png").string(), cv::IMREAD_GRAYSCALE);
  std::set<FaceZone> zones;
  for (const StudyFrame& frame : world.frames) {
    zones.insert(frame.zone);
    double deepest = 0;
    cv::Point at;
    cv::minMaxLoc(frame.depth_mm, nullptr, &deepest, nullptr, &at);
    ASSERT_GT(deepest, 0.1);
    // Of a ball of 4 mm around the deepest pixel, which is at most half a pixel off its middle.
    double grey_error = 0, pressed = 0;
    for (int v = 0; v < frame.depth_mm.rows; ++v)
      for (int u = 0; u < frame.depth_mm.cols; ++u) {
        const double r = FlatSensor::kMmPerPx * std::hypot(u - at.x, v - at.y);
        const double radius = FlatSensor::kBallRadiusMm;
        const double depth =
            r < radius ? deepest - (radius - std::sqrt(radius * radius - r * r)) : 0;
        const float painted = frame.depth_mm.at<float>(v, u);
        EXPECT_NEAR(painted, std::max(0.0, depth), 0.04) << u << ' ' << v;
        if (painted <= 0.05F) continue;
        const double x = painted / (FlatSensor::kA - FlatSensor::kB * painted);
        grey_error +=
            frame.image->grey.at<std::uint8_t>(v, u) - (1 - x) * untouched.at<std::uint8_t>(v, u);
        ++pressed;
      }
    EXPECT_LT(std::abs(grey_error / pressed), 0.3) << "grey levels in the mean";
  }
  EXPECT_EQ(zones.size(), kFaceZones);
}

TEST(AccuracyStudy, ErrorsAreTheSameWithAnyNumberOfThreadsAndAreSmallWhereNothingIsWrong) {
  const TemporaryFolder folder;
  const StudyWorld world = painted_flat_world(folder, 6);
  StudyOptions options;
  options.extent = StudyExtent::kQuick;
  options.repeats = 1;
  std::vector<std::string> errors;
  for (const int threads : {1, 2, 1}) {
    cv::setNumThreads(threads);
    const auto study = study_accuracy(world, options, {}, {}, Job());
    ASSERT_TRUE(study.ok());
    nlohmann::json json = json_of(*study);
    std::string text = json.at("world");
    for (const auto& row : json.at("rows")) text += row.at("errors").dump();
    errors.push_back(text);
    const StudyRow& base = study->rows.front();
    EXPECT_EQ(base.frames, 6);
    EXPECT_EQ(base.frames_missing, 0);
    // sd of 1 grey level of about 180, smoothed over 12 pixels, at 2.2 mm for all of it
    EXPECT_LT(base.depth->median_mm, 0.01);
    EXPECT_LT(base.depth->p95_mm, 0.06);
    EXPECT_LT(*base.position_mm, 0.1);
    EXPECT_GE(*base.position_p95_mm, *base.position_mm);
    EXPECT_EQ(base.bars, 2);
    EXPECT_EQ(base.bars_missing, 0);
    EXPECT_LT(*base.angle_deg, 1.0);
    if (!test::kIsSanitized) {
      EXPECT_GT(base.memory_bytes, 2U * FlatSensor::kWidth * FlatSensor::kHeight);
    }
    EXPECT_EQ(base.time_ratio, 1);
    EXPECT_GT(base.time_ms, 0);
    const auto unsmoothed =
        std::find_if(study->rows.begin(), study->rows.end(),
                     [](const StudyRow& row) { return row.settings.smoothing_px == 0; });
    ASSERT_NE(unsmoothed, study->rows.end());
    EXPECT_GT(unsmoothed->depth->median_mm, 1.5 * base.depth->median_mm)
        << "noise that is not smoothed away";
  }
  EXPECT_EQ(errors[0], errors[1]);
  EXPECT_EQ(errors[0], errors[2]) << "run again";
}

TEST(PaintedWorld, ABarIsTurnedAsItsTruthSays) {
  const TemporaryFolder folder;
  const StudyWorld world = painted_flat_world(folder, 12);
  ASSERT_EQ(world.bars.size(), 3U);
  for (const StudyFrame& bar : world.bars) {
    // The principal axis of all that it presses deeper than 0.1 mm, in pixels of a plane seen
    // straight on.
    double weight = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
    for (int y = 0; y < bar.depth_mm.rows; ++y)
      for (int x = 0; x < bar.depth_mm.cols; ++x) {
        if (!(bar.depth_mm.at<float>(y, x) > 0.1F)) continue;
        ++weight, u += x, v += y, uu += x * x, uv += x * y, vv += y * y;
      }
    ASSERT_GT(weight, 100);
    u /= weight, v /= weight;
    const double turned_deg =
        90 / M_PI *
        std::atan2(2 * (uv / weight - u * v), (uu / weight - u * u) - (vv / weight - v * v));
    EXPECT_LT(std::abs(std::remainder(turned_deg - bar.angle_deg.value(), 180.0)), 3.0);
  }
}

TEST(AccuracyStudy, GoesOnWhereItWasStopped) {
  const TemporaryFolder folder;
  const StudyWorld world = painted_flat_world(folder, 3);
  StudyOptions options;
  options.extent = StudyExtent::kQuick;
  options.repeats = 1;
  std::vector<StudyRow> kept;
  const Error enough{Message::typed("enough"), "", ""};
  const auto stopped = study_accuracy(
      world, options, {},
      [&](const std::vector<StudyRow>& rows) -> Status {
        kept = rows;
        return enough;
      },
      Job());
  ASSERT_FALSE(stopped.ok());
  ASSERT_GE(kept.size(), 2U);
  std::size_t measured_again = 0;
  const auto study = study_accuracy(
      world, options, kept,
      [&](const std::vector<StudyRow>& rows) -> Status {
        measured_again += rows.size();
        return {};
      },
      Job());
  ASSERT_TRUE(study.ok());
  EXPECT_EQ(study->rows.size(),
            study_choices(options.base, options.extent, world.finger->finger).size());
  EXPECT_EQ(measured_again + kept.size(), study->rows.size());
  EXPECT_EQ(study->rows[1].time_ms, kept[1].time_ms);
}

/// On which every setting matters.
Finger finger_with_everything() {
  Finger finger;
  finger.camera.distortion = {-0.1};
  finger.markers.per_row = 6;
  finger.mapping.emplace();
  finger.mapping->along = MappingAlong::kNormal;
  return finger;
}

TEST(StudyChoices, HoldEveryValueOnceAndEveryTwoOfThem) {
  const Finger finger = finger_with_everything();
  const PipelineSettings base;
  std::size_t singles = 0, combined = 0, pairs = 0;
  for (const auto& setting : pipeline_settings()) {
    if (!setting.trade || setting.name == "mesh-step-px") continue;  // no frame's time or error
    const auto& tried = setting.trade->tried;
    EXPECT_NE(std::find(tried.begin(), tried.end(), setting.default_value()), tried.end())
        << setting.name << ": its default is among what is tried";
    EXPECT_FALSE(setting.trade->gains.empty());
    EXPECT_FALSE(setting.trade->costs.empty());
    const std::size_t both = tried.size() - 1 - setting.trade->alone.size();
    pairs += combined * both;
    combined += both;
    singles += tried.size() - 1;
  }
  const auto quick = study_choices(base, StudyExtent::kQuick, finger);
  EXPECT_EQ(key_of(quick.front()), key_of(base));
  EXPECT_EQ(quick.size(), 1 + singles);
  const auto all = study_choices(base, StudyExtent::kPairs, finger);
  EXPECT_EQ(all.size(), 1 + singles + pairs + 1);
  std::set<std::string> keys;
  for (const PipelineSettings& choice : all) keys.insert(key_of(choice));
  EXPECT_EQ(keys.size(), all.size());
  EXPECT_EQ(words_of(base, base).english(), "as it is");
  PipelineSettings other = base;
  other.smoothing_px = 2;
  EXPECT_EQ(words_of(other, base).english(), "smoothing-px 2");
  EXPECT_EQ(flags_of(other, base), "--smoothing-px 2");
}

TEST(CalibratingChoices, AreNamedByWhatDiffersFromTheUsualCalibration) {
  EXPECT_EQ(words_of(CalibratingChoice{}).english(), "6 presses");
  const CalibratingChoice other{1, 4, CalibrationMethod::kPaper, FamilyChoice::kMoebius, 2};
  EXPECT_EQ(words_of(other).english(),
            "1 press, 4 images each, method paper, family moebius, 2 iterations");
}

template <class S>
void expect_phrase_for_every_tried_value(const std::vector<Setting<S>>& table) {
  for (const auto& setting : table) {
    if (!setting.trade) continue;
    SCOPED_TRACE(setting.name);
    ASSERT_TRUE(setting.phrase);
    std::set<std::string> phrases;
    for (const std::string& value : setting.trade->tried) {
      S settings;
      ASSERT_TRUE(setting.set(settings, value));
      phrases.insert(setting.phrase(settings).english());
    }
    EXPECT_FALSE(phrases.contains(""));
    EXPECT_EQ(phrases.size(), setting.trade->tried.size()) << "two values have one phrase";
  }
}

TEST(SettingPhrases, DistinguishTheValuesThatAStudyTries) {
  expect_phrase_for_every_tried_value(pipeline_settings());
  expect_phrase_for_every_tried_value(calibration_settings());
}

TEST(SettingPhrases, ExistForAllThatTheWindowLists) {
  for (const auto& setting : pipeline_settings()) {
    ASSERT_TRUE(setting.phrase) << setting.name;
    EXPECT_FALSE(setting.phrase({}).empty()) << setting.name;
  }
}

TEST(StudyChoices, LeaveOutWhatMakesNoDifferenceOnAFinger) {
  const PipelineSettings base;
  const auto tried = [&](const Finger& finger) {
    std::set<std::string> names;
    for (const PipelineSettings& choice : study_choices(base, StudyExtent::kPairs, finger))
      for (const auto& setting : pipeline_settings())
        if (setting.get(choice) != setting.get(base)) names.insert(setting.name);
    return names;
  };
  Finger finger = finger_with_everything();
  const auto all = tried(finger);
  EXPECT_TRUE(all.contains("undistortion") && all.contains("rays") && all.contains("edge-method"));
  finger.camera.distortion = {0, 0};
  EXPECT_FALSE(tried(finger).contains("undistortion"));
  finger.mapping->along = MappingAlong::kZ;
  EXPECT_FALSE(tried(finger).contains("rays"));
  finger.markers.per_row = 0;
  EXPECT_FALSE(tried(finger).contains("marker-method"));
  finger.face.kind = FaceKind::kFlat;
  EXPECT_EQ(tried(finger), (std::set<std::string>{"resolution", "light-change", "smoothing-px"}));
}

AccuracyStudy random_study(std::mt19937& random) {
  std::uniform_real_distribution<double> some(0.1, 1);
  AccuracyStudy study;
  for (int i = 0; i < 40; ++i) {
    StudyRow row;
    row.settings.smoothing_px = 0.1 * i;
    row.time_ms = 3;
    row.time_ratio = i == 0 ? 1 : 2 * some(random);
    if (i % 7 != 3) row.depth = ErrorSpread{some(random), 1 + some(random)};
    if (i % 5 != 4) row.position_mm = 0.1 * some(random);
    if (i % 11 == 5) row.frames_missing = 1;
    study.rows.push_back(row);
  }
  return study;
}

TEST(StudyFront, IsWhatNothingBeats) {
  std::mt19937 random(5);
  for (int world = 0; world < 50; ++world) {
    const AccuracyStudy study = random_study(random);
    const auto front = pareto_front(study);
    ASSERT_FALSE(front.empty());
    const auto all_three = [&](std::size_t row) {
      const StudyRow& of = study.rows[row];
      return std::array<double, 3>{frame_ms(study, of), of.depth->median_mm,
                                   of.position_mm.value_or(1e9)};
    };
    for (std::size_t i = 0; i < front.size(); ++i)
      for (std::size_t k = 0; k < front.size(); ++k) {
        if (i == k) continue;
        const auto a = all_three(front[i]), b = all_three(front[k]);
        EXPECT_TRUE(a[0] < b[0] || a[1] < b[1] || a[2] < b[2]) << "worse in nothing";
      }
    for (std::size_t row = 0; row < study.rows.size(); ++row) {
      const bool has_depth = study.rows[row].depth && study.rows[row].frames_missing == 0;
      const bool is_on_front = std::find(front.begin(), front.end(), row) != front.end();
      const auto better = dominated_by(study, front, row);
      EXPECT_EQ(better.has_value(), has_depth && !is_on_front) << row;
      if (!better) continue;
      EXPECT_LE(frame_ms(study, study.rows[*better]), frame_ms(study, study.rows[row]));
      EXPECT_LE(study.rows[*better].depth->median_mm, study.rows[row].depth->median_mm);
      EXPECT_LE(study.rows[*better].position_mm.value_or(1e9),
                study.rows[row].position_mm.value_or(1e9));
    }
  }
}

TEST(StudyFront, MoreTimeIsNeverWorseAndMoreErrorNeverSlower) {
  std::mt19937 random(6);
  for (int world = 0; world < 50; ++world) {
    const AccuracyStudy study = random_study(random);
    double last_error = 1e9, last_ms = 1e9;
    for (double budget_ms = 0.1; budget_ms < 8; budget_ms += 0.1) {
      const auto row = most_accurate_within(study, budget_ms);
      if (!row) continue;
      EXPECT_LE(frame_ms(study, study.rows[*row]), budget_ms);
      EXPECT_LE(study.rows[*row].depth->median_mm, last_error);
      EXPECT_LE(study.rows[*row].position_mm.value(), default_position_limit_mm(study).value());
      last_error = study.rows[*row].depth->median_mm;
    }
    for (double error_mm = 1.0; error_mm < 2.2; error_mm += 0.05) {
      const auto row = fastest_within(study, error_mm);
      if (!row) continue;
      EXPECT_LE(study.rows[*row].depth->p95_mm, error_mm);
      EXPECT_LE(study.rows[*row].position_mm.value(), default_position_limit_mm(study).value());
      EXPECT_LE(frame_ms(study, study.rows[*row]), last_ms);
      last_ms = frame_ms(study, study.rows[*row]);
    }
    EXPECT_FALSE(most_accurate_within(study, 1e-6));
    EXPECT_FALSE(fastest_within(study, 1e-6));
  }
}

TEST(StudyFront, FastChoicesThatLoseThePlaceAreNotCalledBest) {
  AccuracyStudy study;
  const auto add = [&](double ratio, double median_mm, double position_mm) {
    StudyRow row;
    row.settings.smoothing_px = 0.1 * static_cast<double>(study.rows.size());
    row.time_ms = 2;
    row.time_ratio = ratio;
    row.depth = ErrorSpread{median_mm, 4 * median_mm};
    row.position_mm = position_mm;
    study.rows.push_back(row);
  };
  add(1.0, 0.005, 0.010);
  add(0.6, 0.0051, 0.100);  // whole pixels: fast, depth nearly as good, the place lost
  add(0.8, 0.006, 0.012);
  EXPECT_EQ(pareto_front(study), (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_EQ(most_accurate_within(study, 1.3), std::nullopt);
  EXPECT_EQ(most_accurate_within(study, 1.3, 0.2), 1U);
  EXPECT_EQ(most_accurate_within(study, 1.7), 2U);
  EXPECT_EQ(fastest_within(study, 0.03), 2U);
  EXPECT_EQ(fastest_within(study, 0.03, 0.2), 1U);
  EXPECT_EQ(presets_of(study).fast, 2U);
  // What painted pictures cannot show of the mapping counts, too.
  study.mapping_p95_mm = 0.02;
  EXPECT_NEAR(error_p95_mm(study, study.rows[2]).value(), std::hypot(0.024, 0.02), 1e-12);
  EXPECT_EQ(fastest_within(study, 0.03), 0U);
  const StudyBalance balance = balance_of(study, study.rows[1]);
  ASSERT_EQ(balance.loses.size(), 1U);
  EXPECT_THAT(balance.loses[0].english(), HasSubstr("position error 0.100 instead of 0.010 mm"));
  ASSERT_EQ(balance.brings.size(), 1U);
  EXPECT_THAT(balance.brings[0].english(), HasSubstr("0.60 times as long"));
}

TEST(StudyFile, LinesComeBackToTheBit) {
  std::mt19937 random(7);
  const AccuracyStudy study = random_study(random);
  std::string lines;
  for (const StudyRow& row : study.rows) lines += line_of(row);
  const auto rows = rows_of_lines(lines, "file");
  ASSERT_TRUE(rows.ok());
  ASSERT_EQ(rows->size(), study.rows.size());
  std::string again;
  for (const StudyRow& row : *rows) again += line_of(row);
  EXPECT_EQ(lines, again);
  for (std::size_t cut = 0; cut < lines.size(); cut += 97) {
    const auto part = rows_of_lines(std::string_view(lines).substr(0, cut), "file");
    ASSERT_TRUE(part.ok()) << cut;
    EXPECT_LE(part->size(), study.rows.size());
  }
  StudyRow with_real = study.rows.front();
  with_real.real = RealErrors{5, 1, {0.004, 0.02}, {ErrorSpread{0.003, 0.01}}};
  const auto real = rows_of_lines(line_of(with_real), "file");
  ASSERT_TRUE(real.ok());
  EXPECT_EQ(line_of(real->front()), line_of(with_real));
  EXPECT_EQ(real->front().real->presses, 5);
  for (const char* broken : {"{}\n", "no\n", "[1]\n", "{\"settings\": {}}\n"}) {
    const auto refused = rows_of_lines(broken, "study_rows.jsonl");
    ASSERT_FALSE(refused.ok()) << broken;
    EXPECT_THAT(refused.error().message().english(), HasSubstr("study_rows.jsonl"));
  }
}

TEST(StudyFigure, NamesAtMostSevenAndTheBase) {
  std::mt19937 random(8);
  for (int world = 0; world < 20; ++world) {
    const AccuracyStudy study = random_study(random);
    const std::string svg = svg_of(study);
    EXPECT_THAT(svg, HasSubstr("as it is"));
    std::size_t named = 0;
    for (std::size_t at = svg.find("(95 % within"); at != std::string::npos;
         at = svg.find("(95 % within", at + 1))
      ++named;
    EXPECT_LE(named, 7U);
    EXPECT_GE(named, 1U);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
}

}  // namespace
}  // namespace alltact::test
