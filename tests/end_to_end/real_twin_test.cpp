// The twin of a real sensor: its pictures against real ones, bright halo included.
#include "tests/support/program.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path kRealSensor =
    fs::path(ALLTACT_SOURCE_DIR) / ".." / "shared" / "data" / "dtact_sensor_1";
constexpr int kProfile_px = 120;  // the halo is brightest at 87 px and gone at 150 px

/// Mean grey level of rings 1 px wide, written out here so that it shares nothing with the program.
std::vector<double> rings(const cv::Mat& grey, double u, double v) {
  std::vector<double> sum(kProfile_px), count(kProfile_px);
  for (int row = 0; row < grey.rows; ++row)
    for (int column = 0; column < grey.cols; ++column) {
      const double radius = std::hypot(column - u, row - v);
      if (radius >= kProfile_px) continue;
      sum[static_cast<std::size_t>(radius)] += grey.at<std::uint8_t>(row, column);
      count[static_cast<std::size_t>(radius)] += 1;
    }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= std::max(1.0, count[i]);
  return sum;
}

class RealTwin : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(press()))
      GTEST_SKIP() << "the real pictures are not beside the project (../shared/data)";
    write_text(folder_ / "camera.yaml",
               "model: orthographic\nsize: [460, 345]\nmm_per_px: 0.051015\ncx: 229.5\ncy: 172.0\n"
               "distortion: []\norientation: none\n");
    const ProgramRun made = run_alltact({"new", finger(), "--kind", "flat", "--layer-mm", "3",
                                         "--camera", (folder_ / "camera.yaml").string()});
    ASSERT_EQ(made.status, 0) << made.errors;
  }
  [[nodiscard]] static std::string press() {
    return (kRealSensor / "press_rectified_sample.png").string();
  }
  [[nodiscard]] static std::string untouched() {
    return (kRealSensor / "press_rectified_ref.png").string();
  }
  [[nodiscard]] std::string finger() const { return (folder_ / "finger").string(); }
  [[nodiscard]] ProgramRun fit(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"simulate", "--fit", finger(), "-o",
                                   (folder_ / "twin.yaml").string()};
    words.insert(words.end(), more.begin(), more.end());
    return run_alltact(words);
  }

  const TemporaryFolder folder_;
};

TEST_F(RealTwin, ShowsTheHeldPressAsItIs) {
  const ProgramRun run =
      fit({press(), "--reference", untouched(), "--ball-radius-mm", "4", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const auto answer = nlohmann::json::parse(run.output);
  const double told = answer.at("presses")[0].at("profile_rms").get<double>();

  // What the scene renders as a camera would give it, noise and all.
  const std::string out = (folder_ / "frames").string();
  const ProgramRun rendered =
      run_alltact({"simulate", (folder_ / "twin.yaml").string(), "-o", out});
  ASSERT_EQ(rendered.status, 0) << rendered.errors;
  const cv::Mat twin = cv::imread(out + "/frame_00001.png", cv::IMREAD_GRAYSCALE);
  const cv::Mat real = cv::imread(press(), cv::IMREAD_GRAYSCALE);
  ASSERT_EQ(twin.size(), real.size());
  const std::vector<double> of_twin = rings(twin, 243, 188), of_real = rings(real, 243, 188);
  double sum = 0, worst = 0;
  for (std::size_t i = 0; i < of_real.size(); ++i) {
    sum += (of_twin[i] - of_real[i]) * (of_twin[i] - of_real[i]);
    worst = std::max(worst, std::abs(of_twin[i] - of_real[i]));
  }
  const double rms = std::sqrt(sum / kProfile_px);
  std::printf(
      "radial profile, 0 to %d px: RMS %.3f, worst %.3f grey levels; the program says %.3f\n",
      kProfile_px, rms, worst, told);
  EXPECT_LT(rms, 2.0);
  EXPECT_LT(worst, 3.0);
  EXPECT_NEAR(rms, told, 0.5);
  // The halo is there, and as bright as the real one.
  EXPECT_NEAR(of_twin[87] - of_twin[65], of_real[87] - of_real[65], 2.0);
  EXPECT_GT(of_twin[87], of_twin[65] + 15);
  // The untouched frame.
  const cv::Mat bare = cv::imread(out + "/frame_00000.png", cv::IMREAD_GRAYSCALE);
  const cv::Mat reference = cv::imread(untouched(), cv::IMREAD_GRAYSCALE);
  EXPECT_LT(cv::norm(bare, reference, cv::NORM_L2) / std::sqrt(static_cast<double>(bare.total())),
            2.0);
}

TEST_F(RealTwin, RefusalsSayWhatIsMissing) {
  const auto refused = [&](const std::vector<std::string>& more, const char* why) {
    const ProgramRun run = fit(more);
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_THAT(run.errors, HasSubstr(why));
    EXPECT_FALSE(fs::exists(folder_ / "twin.yaml"));
  };
  refused({press(), "--reference", untouched()},
          "the radius of the ball that was pressed is not known");
  refused({press(), "--ball-radius-mm", "4"}, "no untouched image");
  refused({"--ball-radius-mm", "4", "--reference", untouched()}, "the finger has none");
  refused({untouched(), "--ball-radius-mm", "4", "--reference", untouched()},
          "no press can be used");
  refused({(kRealSensor / "press_sample.png").string(), "--ball-radius-mm", "4", "--reference",
           untouched()},
          "at the size of its camera");
  refused(
      {press(), "--ball-radius-mm", "4", "--reference", (kRealSensor / "press_ref.png").string()},
      "at the size of its camera");
  // Colours.
  cv::Mat coloured(345, 460, CV_8UC3, cv::Scalar(20, 60, 220));
  const std::string red = (folder_ / "red.png").string();
  cv::imwrite(red, coloured);
  refused({red, "--ball-radius-mm", "4", "--reference", untouched()}, "colour");
  EXPECT_EQ(run_alltact({"simulate", "--fit", finger()}).status, 2);
  EXPECT_EQ(run_alltact({"simulate", "scene.yaml", "-o", "x", "--ball-radius-mm", "4"}).status, 2);
  EXPECT_EQ(run_alltact({"simulate", "a.yaml", "b.yaml", "-o", "x"}).status, 2);
}

}  // namespace
}  // namespace alltact::test
