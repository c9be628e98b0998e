// A calibration may be stopped at any moment: then there is the best solution so far, or the finger
// is as it was.
#include "tests/support/flat_calibration.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::FlatFinger;

constexpr const char* kPage = "calibration_report.html";

Result<std::vector<ReportFile>> one_page(const FingerCalibration&, const Job& job) {
  for (int page = 0; page < 3; ++page) {
    job.report(0.95 + 0.01 * page, Message::typed("writing a page"));
    if (job.stop_requested())
      return Error{Message::typed("stopped before the report was written"), "", ""};
  }
  return std::vector<ReportFile>{{kPage, "<html></html>"}};
}

/// Stopped when the job reports for the `count`th time; 0: never.
struct Stopped {
  Result<FingerCalibration> result;
  int reports = 0;
};
Stopped calibrate_until(const FlatFinger& flat, int count) {
  FingerCalibrationInput input = flat_calibration(flat);
  input.make_report = one_page;
  int reports = 0;
  Job* self = nullptr;
  Job job([&](double, const Message&) {
    if (++reports == count) self->request_stop();
  });
  self = &job;
  auto result = calibrate_finger(input, job);
  if (result) result->solution.reset();  // the next calibration shall solve, too
  return {std::move(result), reports};
}

TEST(CalibrationProgress, NeverGoesBack) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  FingerCalibrationInput input = flat_calibration(flat);
  input.make_report = one_page;
  input.compare_methods = true;
  std::vector<double> fractions;
  const Job job([&](double fraction, const Message&) { fractions.push_back(fraction); });
  ASSERT_TRUE(calibrate_finger(input, job).ok());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GE(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
}

TEST(StoppedCalibration, LeavesTheBestSoFarOrTheFingerAsItWas) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  const fs::path kept = flat.file("as_it_was");
  fs::copy(flat.finger(), kept, fs::copy_options::recursive);
  const auto before = test::contents_of(flat.finger());
  const Stopped whole = calibrate_until(flat, 0);
  ASSERT_TRUE(whole.result.ok()) << whole.result.error().sentence();
  EXPECT_TRUE(fs::exists(fs::path(flat.finger()) / kPage));
  ASSERT_GT(whole.reports, 10);

  int solved = 0, refused = 0;
  for (int count = 1; count < whole.reports; count += 2) {
    fs::remove_all(flat.finger());
    fs::copy(kept, flat.finger(), fs::copy_options::recursive);
    const Stopped stopped = calibrate_until(flat, count);
    EXPECT_LT(stopped.reports, count + 12) << "went on after the stop";
    if (!stopped.result) {
      ++refused;
      EXPECT_THAT(stopped.result.error().sentence(), testing::HasSubstr("stopped"));
      EXPECT_EQ(test::contents_of(flat.finger()), before) << count;
      continue;
    }
    ++solved;
    const auto finger = Finger::load(flat.finger());
    ASSERT_TRUE(finger.ok()) << finger.error().sentence();
    ASSERT_TRUE(finger->mapping);
    const double full = whole.result->calibration.residual_mm;
    EXPECT_LT(stopped.result->calibration.residual_mm, 2 * full + 0.005) << count;
    EXPECT_FALSE(fs::exists(fs::path(flat.finger()) / kPage)) << "a page about nothing: " << count;
    // What is missing is completed from what is kept.
    if (solved != 1) continue;
    const auto again =
        calibrate_finger_again(flat.finger(), CalibrationInputs::load(flat.finger()).value(),
                               "0.1.0", one_page, false, Job());
    ASSERT_TRUE(again.ok()) << again.error().sentence();
    EXPECT_EQ(again->calibration.residual_mm, full);
    EXPECT_TRUE(fs::exists(fs::path(flat.finger()) / kPage));
  }
  EXPECT_GT(solved, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace alltact
