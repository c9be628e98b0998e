#include "widgets/report/calibration_pages.h"

#include "calibration/checks/check_history.h"
#include "tests/support/good_evidence.h"
#include "tests/support/picture_match.h"
#include "tests/support/program.h"
#include "tests/support/simulated_fault.h"
#include "widgets/language.h"
#include "widgets/plots/calibration_plots.h"
#include "widgets/plots/press_plots.h"
#include "widgets/report/calibration_figures.h"
#include "widgets/report/document.h"
#include "widgets/theme.h"

#include <QDir>
#include <algorithm>
#include <memory>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;
using testing::Not;

/// As calibrate_finger leaves it, of a simulated flat sensor.
FingerCalibration some_calibration() {
  const auto made = simulate_calibration(Fault::kNone, 1, true, Job());
  FingerCalibration done;
  done.finger.name = "left <07> & \"co\"";
  CameraParameters& camera = done.finger.camera;
  camera.model = CameraModel::kOrthographic;
  camera.width_px = 240, camera.height_px = 180;
  camera.mm_per_px = 0.1, camera.cx_px = 119.5, camera.cy_px = 89.5;
  done.finger.face.kind = FaceKind::kFlat;
  done.finger.face.layer_mm = 1.5;
  done.finger.face.plane_z_mm = 30;
  done.finger.provenance["press_settings"] = "Camera=usb-1; Gain=3";
  done.inputs.date = "2026-01-31T12:34:56Z";
  done.inputs.program_version = "0.1.0";
  done.inputs.press_set.operator_name = "Ada <Lovelace>";
  done.inputs.press_set.ball_radius_mm = 4;
  done.calibration = made->calibration;
  done.calibration.remarks = {en::say("something to <know>")};
  done.residuals = made->residuals;
  done.zones = zone_errors(done.residuals, done.calibration, FaceKind::kFlat);
  CalibrationEvidence evidence = test::good_evidence();
  evidence.residual_mm = done.calibration.residual_mm;
  evidence.held_out_mm = done.calibration.held_out_mm;
  done.verdict = verdict(evidence);
  for (const BallFit& ball : done.calibration.balls)
    done.presses.push_back({ball.press, cv::Mat(180, 240, CV_8UC1, cv::Scalar(120)), {}, "", {}});
  done.presses.push_back(
      {"press_9", cv::Mat(180, 240, CV_8UC1, cv::Scalar(90)), {}, en::say("excluded, glove"), {}});
  done.calibration.left_out = {en::say("press_9: excluded, glove")};
  return done;
}

struct Made {
  std::string html, pdf;
};

Made pages_of(const FingerCalibration& done,
              const std::filesystem::path& folder = "/data/left 07") {
  const auto files = make_calibration_pages(done, folder, Job());
  EXPECT_TRUE(files.ok());
  EXPECT_EQ(files->at(0).name, "calibration_report.html");
  EXPECT_EQ(files->at(1).name, "calibration_report.pdf");
  return {files->at(0).content, files->at(1).content};
}

TEST(CalibrationPages, SayWhatALabBookNeeds) {
  const FingerCalibration done = some_calibration();
  const std::string html = pages_of(done).html;
  for (const char* words :
       {"Calibration of finger left &lt;07&gt; &amp; &quot;co&quot;", "Good",
        "2026-01-31 12:34:56 UTC", "Ada &lt;Lovelace&gt;", "radius 4 mm", "4 used of 5 given",
        "Camera=usb-1; Gain=3", "Something to &lt;know&gt;.", "Excluded, glove.",
        "alltact calibrate 'left 07' --again", "Wrong radius of the ball"})
    EXPECT_THAT(html, HasSubstr(words));
  // The verdict before everything else.
  EXPECT_LT(html.find("Good, ±0."), html.find("What it was made with"));
}

TEST(CalibrationPages, ShowMeasuredDepthsAndStepsBesideTheirPresses) {
  FingerCalibration done = some_calibration();
  BallFit& ball = done.calibration.balls[1];
  ball.given_depth = GivenDepth{1.0, 0.02};
  ball.indentation_mm = 1.012;
  done.presses.push_back({"punch_1", cv::Mat(180, 240, CV_8UC1, cv::Scalar(100)), {}, "", {}});
  done.calibration.steps.push_back({"punch_1", 0.5, 0.503, 0.004});
  done.presses.push_back({"rod_1", cv::Mat(180, 240, CV_8UC1, cv::Scalar(100)), {}, "", {}});
  done.calibration.bodies.push_back({"rod_1", "rod.stl", 1.012, 0.006});
  const std::string html = pages_of(done).html;
  EXPECT_THAT(html, HasSubstr("6 used of 7 given"));
  const std::size_t measured =
      html.find("measured 1.000 ± 0.020 mm deep, the solution has 1.012 mm");
  ASSERT_NE(measured, std::string::npos);
  EXPECT_LT(measured - html.rfind(ball.press + "<", measured), 40U);
  const std::size_t step =
      html.find("a punch with a step of 0.500 mm, which reads 0.503 ± 0.004 mm");
  ASSERT_NE(step, std::string::npos);
  EXPECT_LT(step - html.rfind("punch_1<", step), 40U);
  const std::size_t body =
      html.find("rod.stl, on which depths read 101.2 ± 0.6 % of the true ones");
  ASSERT_NE(body, std::string::npos);
  EXPECT_LT(body - html.rfind("rod_1<", body), 40U);
}

TEST(CalibrationPages, StandAlone) {
  const std::string html = pages_of(some_calibration()).html;
  for (const char* outside : {"http:", "https:", "file:", "picture:", "<script", "<link", "url("})
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  std::size_t images = 0;
  for (std::size_t at = html.find("<img src=\"data:image/png;base64,"); at != std::string::npos;
       at = html.find("<img src=\"data:image/png;base64,", at + 1))
    ++images;
  EXPECT_EQ(images, 5U + 4U + 3U + 6U);  // presses, plots, maps, faults
}

TEST(CalibrationPages, AreTheSameBytesForTheSameCalibration) {
  const FingerCalibration done = some_calibration();
  const Made one = pages_of(done), two = pages_of(done);
  EXPECT_TRUE(one.html == two.html);
  EXPECT_TRUE(one.pdf == two.pdf);
  EXPECT_THAT(one.pdf, testing::StartsWith("%PDF"));
  EXPECT_NE(one.pdf.find("/CreationDate (D:20260131123456"), std::string::npos);
  FingerCalibration other = done;
  other.inputs.date = "2026-01-31T12:34:57Z";
  EXPECT_TRUE(pages_of(other).html != one.html);
}

TEST(CalibrationPages, ListTheWorstPressFirst) {
  FingerCalibration done = some_calibration();
  done.calibration.balls[2].held_out_mm = 0.3;
  const std::string html = pages_of(done).html;
  const std::size_t table = html.find("worst first");
  const std::size_t worst = html.find(done.calibration.balls[2].press + "<", table);
  ASSERT_NE(worst, std::string::npos);
  for (const std::size_t i : {0, 1, 3})
    EXPECT_LT(worst, html.find(done.calibration.balls[i].press + "<", table)) << i;
}

TEST(CalibrationPages, ShowFaultsAndUnknownZones) {
  FingerCalibration done = some_calibration();
  done.fault_signs = {en::say("the light <flickers>")};
  done.zones[2].error_mm.reset();
  done.zones[2].presses = 0;
  const std::string html = pages_of(done).html;
  EXPECT_THAT(html, HasSubstr("The light &lt;flickers&gt;."));
  EXPECT_THAT(html, HasSubstr("nothing is known of it: right."));
}

TEST(CalibrationPages, ShowTheChecksBeforeAndNotThoseAfter) {
  const test::TemporaryFolder folder;
  CheckEntry check;
  check.drifting_above_mm = 0.02, check.recalibrate_above_mm = 0.06;
  check.time = "2026-02-01T00:00:00Z";
  ASSERT_TRUE(append_check(folder.path(), check).ok());
  const FingerCalibration done = some_calibration();
  EXPECT_THAT(pages_of(done, folder.path()).html, Not(HasSubstr("Checks before")));
  check.time = "2026-01-01T00:00:00Z";
  ASSERT_TRUE(append_check(folder.path(), check).ok());
  EXPECT_THAT(pages_of(done, folder.path()).html, HasSubstr("Checks before"));
}

/// The light of the presses where that is the fault, else the mapping.
QImage picture_of(Fault fault) {
  const auto made = simulate_calibration(fault, 1, true, Job());
  EXPECT_TRUE(made.ok());
  std::unique_ptr<Plot> plot;
  if (fault == Fault::kBrighterLight || fault == Fault::kAutomaticExposure) {
    std::vector<PressLight> light;
    for (const PressSign& sign : made->signs) light.push_back({"", 100 * sign.light_change});
    auto shown = std::make_unique<PressLightPlot>();
    shown->set_data(std::move(light), 100 * kOtherLight);
    plot = std::move(shown);
  } else {
    MappingPlotData data = mapping_figure(made->calibration, made->residuals);
    data.is_small = true;
    auto shown = std::make_unique<MappingPlot>();
    shown->set_data(std::move(data));
    plot = std::move(shown);
  }
  QFont font("DejaVu Sans");
  font.setPixelSize(12);
  plot->setFont(font);
  plot->setPalette(theme_palette(Theme::kLight));
  return plot->image({260, 126}, 2.0);
}

/// ALLTACT_RENEW_HELP=1 keeps what is drawn now.
TEST(CalibrationPages, PicturesOfTypicalFaultsAreWhatIsSimulatedNow) {
  const EnglishScope english;
  const std::pair<const char*, Fault> faults[] = {{"none", Fault::kNone},
                                                  {"brighter_light", Fault::kBrighterLight},
                                                  {"automatic_exposure", Fault::kAutomaticExposure},
                                                  {"moved_camera", Fault::kMovedCamera},
                                                  {"loose_skin", Fault::kLooseSkin},
                                                  {"wrong_radius", Fault::kWrongRadius}};
  const QDir folder(QStringLiteral(ALLTACT_SOURCE_DIR "/resources/pictures/faults"));
  for (const auto& [name, fault] : faults) {
    const QString file = folder.filePath(QStringLiteral("%1.png").arg(QLatin1String(name)));
    const QImage now = picture_of(fault);
    if (qEnvironmentVariableIsSet("ALLTACT_RENEW_HELP")) {
      ASSERT_TRUE(folder.mkpath(QStringLiteral(".")) && now.save(file)) << name;
      continue;
    }
    const QImage kept(file);
    ASSERT_FALSE(kept.isNull()) << name << " is missing";
    EXPECT_EQ(test::what_differs(now, kept), "") << name;
  }
}

TEST(CalibrationPages, StopAtOnce) {
  Job job;
  job.request_stop();
  const auto files = make_calibration_pages(some_calibration(), "f", job);
  ASSERT_FALSE(files.ok());
  EXPECT_THAT(files.error().sentence(), HasSubstr("stopped"));
}

/// A ball straight ahead of an orthographic camera: a circle of its own radius around its centre.
TEST(PressPicture, DrawsTheOutlineWhereTheBallIs) {
  CameraParameters parameters;
  parameters.model = CameraModel::kOrthographic;
  parameters.width_px = 240, parameters.height_px = 180;
  parameters.mm_per_px = 0.1, parameters.cx_px = 119.5, parameters.cy_px = 89.5;
  const Camera camera = Camera::create(parameters).value();
  BallFit ball;
  ball.radius_mm = 4.0;
  ball.centre_mm = {1.0, -2.0, 30.0};
  const cv::Mat grey(180, 240, CV_8UC1, cv::Scalar(100));
  const QImage image = press_image(grey, camera, ball, {}, QSize(232, 174));
  // 80 px of outline in 1 / 1.45 of the height: 120 px across.
  const auto is_line = [&](int x, int y) {
    for (int dx = -1; dx <= 1; ++dx)
      if (image.pixelColor(x + dx, y).red() > 200 && image.pixelColor(x + dx, y).blue() < 60)
        return true;
    return false;
  };
  EXPECT_TRUE(is_line(116 - 60, 87));
  EXPECT_TRUE(is_line(116 + 60, 87));
  EXPECT_FALSE(is_line(116 - 50, 87));
  EXPECT_EQ(image.pixelColor(116 - 40, 87), QColor(100, 100, 100));
}

TEST(Document, CarriesAnyTextAsText) {
  Document document("a<b");
  document.paragraph("<img src=\"http://x\"> & \"picture:0\"");
  document.table({"<h>"}, {{{"<c>", {}, 0}}}, {});
  document.list({"<l>"});
  document.command("echo '<x>' && y");
  const std::string html = document.html();
  for (const char* raw : {"<b", "<img", "<h>", "<c>", "<l>", "<x>"})
    EXPECT_THAT(html, Not(HasSubstr(std::string(raw) == "<b" ? "a<b" : raw)));
  EXPECT_THAT(html, HasSubstr("&lt;x&gt;"));
}

}  // namespace
}  // namespace alltact
