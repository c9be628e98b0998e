// The one answer against all rows of random studies, and what a finger keeps of its study.
#include "calibration/finger/measuring_presets.h"
#include "calibration/study/recommended_settings.h"
#include "calibration/study/study_file.h"
#include "core/base/atomic_file.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/temporary_folder.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

AccuracyStudy study_to_answer(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  AccuracyStudy study;
  for (int i = 0; i < 12; ++i) {
    StudyRow row;
    row.settings.edge_columns = 1 + i;
    row.frames = 9;
    row.time_ms = 10;
    row.time_ratio = i == 0 ? 1 : 0.3 + 2 * uniform(random);
    const double median_mm = 0.005 + 0.02 * uniform(random);
    row.depth = ErrorSpread{median_mm, median_mm * (1.5 + 3 * uniform(random))};
    row.position_mm = 0.1;
    study.rows.push_back(row);
  }
  return study;
}

TEST(StudyAnswer, IsTheBestOfAllRowsThatDoWhatIsAsked) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::set<StudyAnswerKind> kinds;
  for (int i = 0; i < 400; ++i) {
    const AccuracyStudy study = study_to_answer(random);
    StudyQuestion question;
    question.frames_per_s = 1000 / (2 + 24 * uniform(random));
    if (i % 2 == 0) question.error_mm = 0.005 + 0.06 * uniform(random);
    const auto answer = answer_to(question, study);
    ASSERT_TRUE(answer);
    kinds.insert(answer->kind);
    const StudyRow& told = study.rows[answer->row];
    const double told_ms = frame_ms(study, told);
    const auto within_error = [&](const StudyRow& row) {
      return !question.error_mm || row.depth->p95_mm <= *question.error_mm;
    };
    const auto fits = [&](const StudyRow& row) {
      return frame_ms(study, row) <= question.budget_ms();
    };
    int fitting = 0, keeping = 0, both = 0;
    for (const StudyRow& row : study.rows) {
      fitting += fits(row);
      keeping += within_error(row);
      both += fits(row) && within_error(row);
      if (answer->kind == StudyAnswerKind::kTooSlow) {
        EXPECT_GE(frame_ms(study, row), told_ms);
      } else if (answer->kind == StudyAnswerKind::kErrorMet) {
        EXPECT_FALSE(within_error(row) && frame_ms(study, row) < told_ms);
      } else {
        EXPECT_FALSE(fits(row) && row.depth->median_mm < told.depth->median_mm);
      }
    }
    switch (answer->kind) {
      case StudyAnswerKind::kMostAccurate:
        EXPECT_FALSE(question.error_mm);
        EXPECT_TRUE(fits(told));
        break;
      case StudyAnswerKind::kErrorMet:
        EXPECT_TRUE(fits(told) && within_error(told));
        break;
      case StudyAnswerKind::kErrorTooSmall:
        EXPECT_EQ(keeping, 0);
        EXPECT_TRUE(fits(told));
        break;
      case StudyAnswerKind::kErrorTooSlow:
        EXPECT_EQ(both, 0);
        EXPECT_TRUE(fits(told));
        ASSERT_TRUE(answer->within_error);
        EXPECT_TRUE(within_error(study.rows[*answer->within_error]));
        break;
      case StudyAnswerKind::kTooSlow:
        EXPECT_EQ(fitting, 0);
        break;
    }
  }
  EXPECT_EQ(kinds.size(), 5U) << "every kind of answer was asked for";
}

TEST(StudyAnswer, IsNoneWhereNothingMeasures) {
  AccuracyStudy study;
  study.rows.resize(2);
  EXPECT_FALSE(answer_to({}, study));
}

class KeptStudy : public testing::Test {
 protected:
  KeptStudy() {
    write_flat_sensor(folder_.path());
    Finger finger = flat_sensor_finger(true);
    finger.reference.emplace();
    finger.reference->image = "ref.png";
    EXPECT_TRUE(finger.save(folder_.path()).ok());
  }
  [[nodiscard]] FingerPtr finger() const { return open_finger(folder_.path()).value(); }
  [[nodiscard]] Result<FingerStudy> measure(const Job& job = Job()) const {
    return study_finger(finger(), StudyExtent::kQuick, "1", job);
  }
  TemporaryFolder folder_;
};

TEST_F(KeptStudy, IsThereOnAnotherDay) {
  EXPECT_FALSE(stored_study(finger()).value());
  const auto made = measure();
  ASSERT_TRUE(made) << made.error().sentence();
  const auto kept = stored_study(finger());
  ASSERT_TRUE(kept && *kept);
  EXPECT_TRUE((*kept)->is_of_finger_now);
  EXPECT_TRUE((*kept)->is_of_this_computer);
  EXPECT_TRUE((*kept)->has_all_single);
  EXPECT_FALSE((*kept)->has_all_pairs);
  ASSERT_EQ((*kept)->study.rows.size(), made->study.rows.size());
  EXPECT_EQ((*kept)->study.mapping_p95_mm, made->study.mapping_p95_mm);
  for (std::size_t i = 0; i < made->study.rows.size(); ++i) {
    const StudyRow &a = (*kept)->study.rows[i], &b = made->study.rows[i];
    EXPECT_EQ(key_of(a.settings), key_of(b.settings));
    EXPECT_EQ(a.depth->median_mm, b.depth->median_mm);
    EXPECT_EQ(frame_ms((*kept)->study, a), frame_ms(made->study, b));
  }
  const auto file = read_file(folder_ / kFingerStudy).value();
  ASSERT_TRUE(measure()) << "nothing is left to measure";
  EXPECT_EQ(read_file(folder_ / kFingerStudy).value(), file);
}

TEST_F(KeptStudy, HoldsWhateverSettingsAreUsedAndNotForAnotherMapping) {
  const auto made = measure();
  ASSERT_TRUE(made);
  const auto store = FingerStore::of(folder_.path());
  ASSERT_TRUE(use_settings(*store, made->study.rows.back().settings, "other"));
  EXPECT_TRUE((*stored_study(finger()).value()).is_of_finger_now);
  const auto changed = store->update([](Finger& now) {
    now.mapping->a_mm *= 1.01;
    return Status();
  });
  ASSERT_TRUE(changed);
  EXPECT_FALSE((*stored_study(finger()).value()).is_of_finger_now);
}

TEST_F(KeptStudy, GoesOnWhereItWasStopped) {
  Job* asked = nullptr;
  int batches = 0;
  double last = 0;
  Job job([&](double fraction, const Message&) {
    if (fraction > 0.25 && last <= 0.25) ++batches;
    last = fraction;
    if (std::filesystem::exists(folder_ / kFingerStudy)) asked->request_stop();
  });
  asked = &job;
  EXPECT_FALSE(measure(job));
  const auto part = stored_study(finger()).value();
  ASSERT_TRUE(part);
  EXPECT_FALSE(part->has_all_single);
  const auto whole = measure();
  ASSERT_TRUE(whole);
  EXPECT_TRUE(whole->has_all_single);
  ASSERT_GT(whole->study.rows.size(), part->study.rows.size());
  for (std::size_t i = 0; i < part->study.rows.size(); ++i)
    EXPECT_EQ(whole->study.rows[i].time_ratio, part->study.rows[i].time_ratio) << "kept as it was";
}

TEST_F(KeptStudy, SaysWhatIsNoStudy) {
  ASSERT_TRUE(write_file_atomically(folder_ / kFingerStudy, "something else\n"));
  EXPECT_FALSE(stored_study(finger()));
  EXPECT_TRUE(measure()) << "and is measured anew";
  EXPECT_TRUE(stored_study(finger()));
}

}  // namespace
}  // namespace alltact::test
