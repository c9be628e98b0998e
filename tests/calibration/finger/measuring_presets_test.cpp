// What a finger keeps of its study, and what it measures with then.
#include "calibration/finger/measuring_presets.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/study/recommended_settings.h"
#include "core/base/atomic_file.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

/// A finger's folder, calibrated with a smoothing of its own.
struct KeptFinger {
  TemporaryFolder folder;
  std::shared_ptr<FingerStore> store;

  KeptFinger() {
    EXPECT_TRUE(flat_sensor_finger(true).save(folder.path()).ok());
    calibrate_with_smoothing(3.0);
    store = FingerStore::of(folder.path());
  }
  void calibrate_with_smoothing(double smoothing_px) const {
    CalibrationInputs inputs;
    inputs.date = "2026-01-31T12:00:00Z";
    inputs.program_version = "0.1.0";
    inputs.press_set.ball_radius_mm = 4.0;
    inputs.pipeline.smoothing_px = smoothing_px;
    inputs.finger_checksum = inputs.reference_checksum = "0123456789abcdef";
    inputs.presses = {{"press_0", "0000000000000001"}};
    EXPECT_TRUE(
        write_file_atomically(folder / CalibrationInputs::kFileName, inputs.to_yaml()).ok());
  }
  [[nodiscard]] MeasuringPresets presets() const {
    auto read = presets_of_finger(folder.path());
    EXPECT_TRUE(read.ok()) << read.error().sentence();
    return std::move(read).value();
  }
};

MeasuringPresets found(const KeptFinger& finger) {
  MeasuringPresets presets;
  presets.date = "2026-02-01T08:00:00Z";
  presets.program_version = "0.1.0";
  presets.machine = "a processor: \"fast\", 1 thread";
  presets.about = "balls painted into pictures, 9 pictures";
  presets.calibrated = calibrated_settings(finger.folder.path());
  PipelineSettings fast = presets.calibrated;
  fast.resolution = Resolution::kHalf;
  fast.reference_neighbours = 4;
  presets.presets = {{"fast", fast, 0.8125, 0.015, 0.06},
                     {"balanced", presets.calibrated, 2.5, 0.0125, 0.05}};
  return presets;
}

TEST(MeasuringPresets, AFingerThatKeepsNoneMeasuresAsItWasCalibrated) {
  const KeptFinger finger;
  const MeasuringPresets presets = finger.presets();
  EXPECT_TRUE(presets.date.empty() && presets.presets.empty() && presets.used.empty());
  EXPECT_EQ(presets.now.smoothing_px, 3.0);
  EXPECT_EQ(measuring_settings(finger.folder.path()).smoothing_px, 3.0);
  EXPECT_TRUE(preset_settings(finger.folder.path(), "balanced").ok());
  const auto none = preset_settings(finger.folder.path(), "fast");
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.error().sentence(), HasSubstr("not studied yet"));
  EXPECT_THAT(none.error().sentence(), HasSubstr("--save"));
}

TEST(MeasuringPresets, ComeBackAsTheyWereKept) {
  const KeptFinger finger;
  const MeasuringPresets kept = found(finger);
  ASSERT_TRUE(save_presets(*finger.store, kept).ok());
  const MeasuringPresets read = finger.presets();
  EXPECT_EQ(read.date, kept.date);
  EXPECT_EQ(read.machine, kept.machine);
  EXPECT_EQ(read.about, kept.about);
  EXPECT_FALSE(read.is_stale);
  ASSERT_EQ(read.presets.size(), 2U);
  const MeasuringPreset* fast = read.find("fast");
  ASSERT_NE(fast, nullptr);
  EXPECT_EQ(fast->frame_ms, 0.8125);
  EXPECT_EQ(fast->median_mm, 0.015);
  EXPECT_EQ(fast->p95_mm, 0.06);
  for (const auto& setting : pipeline_settings())
    EXPECT_EQ(setting.get(fast->settings), setting.get(kept.presets[0].settings)) << setting.name;
  EXPECT_TRUE(read.used.empty()) << "keeping is not using";
  const auto finest = preset_settings(finger.folder.path(), "finest");
  ASSERT_FALSE(finest.ok());
  EXPECT_THAT(finest.error().sentence(), HasSubstr("no setting is more accurate on this finger"));
  EXPECT_THAT(preset_settings(finger.folder.path(), "slow").error().sentence(),
              HasSubstr("'slow' is not a preset"));
}

TEST(MeasuringPresets, WhatIsUsedIsMeasuredWithUntilTheWayBack) {
  const KeptFinger finger;
  int told = 0;
  ASSERT_TRUE(finger.store->snapshot().ok());
  const auto listening = finger.store->listen([&](const FingerPtr& now, const FingerPtr& before) {
    EXPECT_EQ(now->revision, before->revision);
    EXPECT_NE(now->measuring, before->measuring);
    ++told;
  });
  const MeasuringPresets kept = found(finger);
  ASSERT_TRUE(use_settings(*finger.store, kept.presets[0].settings, "within 5 ms").ok());
  EXPECT_EQ(told, 1);
  EXPECT_EQ(finger.presets().used, "within 5 ms");
  PipelineSettings now = measuring_settings(finger.folder.path());
  EXPECT_EQ(now.resolution, Resolution::kHalf);
  EXPECT_EQ(now.smoothing_px, 3.0);
  EXPECT_EQ(calibrated_settings(finger.folder.path()).resolution, Resolution::kFull);
  ASSERT_TRUE(save_presets(*finger.store, kept).ok());
  EXPECT_EQ(finger.presets().used, "within 5 ms") << "a new study leaves it as it is";
  // Calibrated anew: the mapping's own smoothing counts, and what was chosen beside it stays.
  finger.calibrate_with_smoothing(1.5);
  now = measuring_settings(finger.folder.path());
  EXPECT_EQ(now.smoothing_px, 1.5);
  EXPECT_EQ(now.reference_neighbours, 4);
  EXPECT_TRUE(finger.presets().is_stale);
  ASSERT_TRUE(use_calibrated_settings(*finger.store).ok());
  EXPECT_EQ(measuring_settings(finger.folder.path()).resolution, Resolution::kFull);
  EXPECT_EQ(finger.presets().presets.size(), 2U) << "they are still kept";
  EXPECT_EQ(told, 3);
}

TEST(MeasuringPresets, SpoiltFilesAreNamedAndNothingIsWrittenOverThem) {
  const KeptFinger finger;
  ASSERT_TRUE(save_presets(*finger.store, found(finger)).ok());
  const auto file = finger.folder / kMeasuringFile;
  const std::string whole = read_file(file).value();
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    EXPECT_TRUE(write_file_atomically(file, text).ok());
    const auto read = presets_of_finger(finger.folder.path());
    return read ? std::string("taken") : read.error().sentence();
  };
  EXPECT_THAT(with("alltact-measuring/1", "alltact-measuring/9"), HasSubstr("measuring.yaml"));
  EXPECT_THAT(with("resolution: half", "resolution: eighth"), HasSubstr("resolution"));
  EXPECT_THAT(with("frame_ms: 0.8125", "frame_ms: soon"), HasSubstr("frame_ms"));
  EXPECT_FALSE(use_calibrated_settings(*finger.store).ok());
  EXPECT_THAT(read_file(file).value(), HasSubstr("soon"));
  EXPECT_EQ(measuring_settings(finger.folder.path()).smoothing_px, 3.0);
}

TEST(MeasuringPresets, AStudyKeepsOnlyWhatBringsSomething) {
  AccuracyStudy study;
  study.about = en::say("balls");
  const auto add = [&](double ratio, double median_mm, double smoothing_px) {
    StudyRow row;
    row.settings.smoothing_px = smoothing_px;
    row.frames = 9;
    row.depth = ErrorSpread{median_mm, 4 * median_mm};
    row.position_mm = 0.05;
    row.time_ms = 2.0 * ratio;
    row.time_ratio = ratio;
    study.rows.push_back(row);
  };
  add(1.0, 0.010, 1);
  add(0.5, 0.014, 0);
  MeasuringPresets kept = presets_to_save(study, "a machine");
  EXPECT_EQ(kept.machine, "a machine");
  ASSERT_NE(kept.find("fast"), nullptr);
  EXPECT_EQ(kept.find("fast")->settings.smoothing_px, 0);
  EXPECT_DOUBLE_EQ(kept.find("fast")->frame_ms, 1.0);
  EXPECT_NE(kept.find("balanced"), nullptr);
  EXPECT_EQ(kept.find("finest"), nullptr);
  add(3.0, 0.005, 2);
  kept = presets_to_save(study, "a machine");
  ASSERT_NE(kept.find("finest"), nullptr);
  EXPECT_EQ(kept.find("finest")->settings.smoothing_px, 2);
}

}  // namespace
}  // namespace alltact::test
