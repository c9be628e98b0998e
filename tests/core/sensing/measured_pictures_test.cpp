// Pictures that are reduced, averaged or measured in part: a flat sensor with balls of closed
// formulas.
#include "core/camera/camera.h"
#include "core/finger/finger_store.h"
#include "core/numerics/median.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/result_json.h"
#include "tests/support/flat_sensor.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr double kU = 150, kV = 117, kDepthMm = 0.6;

FramePtr picture_frame(const cv::Mat& grey) {
  auto frame = std::make_shared<Frame>();
  frame->grey = grey;
  frame->name = "press";
  return frame;
}

const Setting<PipelineSettings>& setting_named(const std::string& name) {
  const auto& all = pipeline_settings();
  return *std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == name; });
}

PipelineSettings with(const std::string& name, const std::string& value) {
  PipelineSettings settings;
  EXPECT_TRUE(setting_named(name).set(settings, value).ok());
  return settings;
}

Pipeline pipeline_with(const PipelineSettings& settings) {
  const FingerSnapshot finger = FingerSnapshot::of({}, flat_sensor_finger(true)).value();
  const cv::Mat untouched =
      reduced_image(untouched_picture(1), binning_factor(settings.resolution));
  return Pipeline::with_library(ReferenceLibrary::single(untouched).value(), finger, settings);
}

FrameResult pressed_once(const PipelineSettings& settings, std::uint64_t seed = 2) {
  Pipeline pipeline = pipeline_with(settings);
  auto result = pipeline(picture_frame(pressed_picture(ball_depth_mm(kU, kV, kDepthMm), seed)));
  EXPECT_TRUE(result.ok());
  return std::move(result).value();
}

/// Median error of depth where truly deeper than 0.1 mm, mm.
double median_error_mm(const FrameResult& result) {
  const cv::Mat_<float> truth = ball_depth_mm(kU, kV, kDepthMm);
  const int by = result.reduced_by;
  std::vector<double> errors;
  for (int v = 0; v < result.depth->depth_mm.rows; ++v)
    for (int u = 0; u < result.depth->depth_mm.cols; ++u) {
      double mean = 0;
      for (int y = 0; y < by; ++y)
        for (int x = 0; x < by; ++x) mean += truth(v * by + y, u * by + x);
      mean /= by * by;
      if (mean > 0.1) errors.push_back(std::abs(result.depth->depth_mm.at<float>(v, u) - mean));
    }
  return upper_median(errors);
}

TEST(Resolution, TellsTheSameMillimetresOfFewerPixels) {
  const FrameResult whole = pressed_once({});
  EXPECT_EQ(whole.reduced_by, 1);
  ASSERT_EQ(whole.regions.size(), 1U);
  const double depth_mm = whole.regions[0].deepest_mm;
  for (const auto& [word, by] : {std::pair<const char*, int>{"half", 2}, {"quarter", 4}}) {
    const FrameResult result = pressed_once(with("resolution", word));
    EXPECT_EQ(result.reduced_by, by);
    EXPECT_EQ(result.depth->depth_mm.size(),
              cv::Size(FlatSensor::kWidth / by, FlatSensor::kHeight / by));
    EXPECT_LT(median_error_mm(result), 0.012) << word;
    ASSERT_EQ(result.regions.size(), 1U) << word;
    EXPECT_NEAR(result.regions[0].deepest_mm, depth_mm, 0.03) << word;
    // Regions are of cells of 4 px, whatever the pixels.
    EXPECT_NEAR(result.regions[0].area_mm2 / whole.regions[0].area_mm2, 1.0, 0.02 * by) << word;
    EXPECT_NEAR(result.regions[0].volume_mm3, whole.regions[0].volume_mm3,
                0.05 * whole.regions[0].volume_mm3);
    // A third of the whole picture's pixel: centres are where they were.
    EXPECT_LT((result.regions[0].position_mm - whole.regions[0].position_mm).norm(), 0.02) << word;
    const std::string line = result_line(result, 0, ReferenceMethod::kLocal);
    EXPECT_THAT(line, testing::HasSubstr(fmt::format("\"reduced_by\":{}", by)));
    EXPECT_THAT(line, testing::HasSubstr(fmt::format("\"size_px\":[{},{}]", 320 / by, 240 / by)));
  }
  EXPECT_THAT(result_line(whole, 0, ReferenceMethod::kLocal),
              testing::Not(testing::HasSubstr("reduced_by")));
}

TEST(Resolution, RefusesPicturesOfAnotherSizeThanTheCameras) {
  Pipeline pipeline = pipeline_with(with("resolution", "half"));
  const cv::Mat half = reduced_image(untouched_picture(1), 2);
  const auto refused = pipeline(picture_frame(half));
  ASSERT_FALSE(refused.ok()) << "it is to come whole";
  EXPECT_THAT(refused.error().what.english(), testing::HasSubstr("320 x 240"));
}

TEST(Resolution, MovesWhatAFingerKnowsInPixels) {
  Finger finger = flat_sensor_finger(true);
  finger.contact = ContactSettings{12.0, {{0.5, 0.5}, {101.0, 20.0}}};
  finger.reference = ReferenceFiles{"r.mkv", "r.csv", "", EdgePositions{10.5, 2.0}};
  const FingerSnapshot whole = FingerSnapshot::of({}, finger).value();
  const FingerSnapshot half = reduced_finger(whole, 2);
  EXPECT_EQ(half.reduced_by, 2);
  EXPECT_DOUBLE_EQ(half.finger.contact->threshold_px, 6.0);
  EXPECT_EQ(half.finger.contact->rest_markers[0], Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(half.finger.contact->rest_markers[1], Eigen::Vector2d(50.25, 9.75));
  EXPECT_DOUBLE_EQ(half.finger.reference->positions->from_u_px, 5.0);
  EXPECT_DOUBLE_EQ(half.finger.reference->positions->step_mm, 2.0);
  EXPECT_EQ(reduced_finger(half, 2).camera.size(), half.camera.size()) << "once is enough";
}

TEST(Region, ToldDepthIsThatOfTheWholeFaceAndNothingBeside) {
  PipelineSettings all;
  all.correct_light = false;  // which looks at all of the skin that it is given
  const FrameResult whole = pressed_once(all);
  PipelineSettings part = all;
  part.region = {6.0, 12.5};
  const FrameResult result = pressed_once(part);
  int inside = 0, outside = 0;
  for (int v = 0; v < result.depth->depth_mm.rows; ++v)
    for (int u = 0; u < result.depth->depth_mm.cols; ++u) {
      const double along_mm = u * FlatSensor::kMmPerPx;
      const float mm = result.depth->depth_mm.at<float>(v, u);
      if (along_mm < 6.0 - 1e-9 || along_mm > 12.5 + 1e-9) {
        EXPECT_TRUE(std::isnan(mm));
        EXPECT_EQ(result.depth->flags.at<std::uint8_t>(v, u), kOffFace);
        ++outside;
      } else if (along_mm > 7.0 && along_mm < 11.5) {  // beyond the reach of the smoothing
        EXPECT_EQ(mm, whole.depth->depth_mm.at<float>(v, u)) << u << ' ' << v;
        ++inside;
      }
    }
  EXPECT_GT(inside, 10000);
  EXPECT_GT(outside, 10000);
  ASSERT_EQ(result.regions.size(), 1U);
  EXPECT_NEAR(result.regions[0].deepest_mm, whole.regions[0].deepest_mm, 1e-6);
}

TEST(Region, IsReadAsItIsWritten) {
  const auto& region = setting_named("region");
  for (const char* text : {"all", "0-20", "20-60", "12.5-13.75"})
    EXPECT_EQ(region.get(with("region", text)), text);
  EXPECT_EQ(region.get(with("region", "20-60mm")), "20-60");
  PipelineSettings settings;
  for (const char* text :
       {"", "middle", "20", "60-20", "20-20", "-5-20", "20-", "-", "20-60cm", "20-2000", "nan-5"})
    EXPECT_FALSE(region.set(settings, text).ok()) << text;
}

TEST(AverageFrames, QuietTheNoiseByTheirSquareRoot) {
  const auto untouched_sd = [](int frames) {
    PipelineSettings settings = with("average-frames", std::to_string(frames));
    settings.smoothing_px = 0;
    settings.correct_light = false;
    // The reference without noise of its own: the mean of many.
    cv::Mat sum = cv::Mat::zeros(FlatSensor::kHeight, FlatSensor::kWidth, CV_32F);
    for (std::uint64_t i = 0; i < 64; ++i)
      cv::add(sum, untouched_picture(1000 + i), sum, cv::noArray(), CV_32F);
    RunningMean mean(frames);
    cv::Mat averaged;
    for (int i = 0; i < 2 * frames; ++i)
      averaged = mean(untouched_picture(static_cast<std::uint64_t>(100 + i)));
    cv::Mat difference;
    cv::subtract(averaged, sum / 64.0, difference, cv::noArray(), CV_32F);
    cv::Scalar middle, sd;
    cv::meanStdDev(difference, middle, sd);
    return sd[0];
  };
  // 0.7 grey levels and rounding to whole ones; rounded again after averaging.
  const double one2 = std::pow(untouched_sd(1), 2), rounding2 = 1.0 / 12;
  for (const int frames : {4, 16}) {
    const double expected = std::sqrt(one2 / frames + rounding2);
    EXPECT_NEAR(untouched_sd(frames), expected, 0.1 * expected) << frames;
  }
}

TEST(AverageFrames, AreOfOneSourceUntilForgotten) {
  Pipeline pipeline = pipeline_with(with("average-frames", "4"));
  const cv::Mat bright(FlatSensor::kHeight, FlatSensor::kWidth, CV_8UC1, cv::Scalar(120));
  const cv::Mat dark(bright.size(), CV_8UC1, cv::Scalar(100));
  const auto level = [&](const cv::Mat& grey) {
    return pipeline(picture_frame(grey)).value().grey.at<std::uint8_t>(9, 9);
  };
  EXPECT_EQ(level(bright), 120);
  EXPECT_EQ(level(dark), 110);
  EXPECT_EQ(level(dark), 107);  // (120 + 100 + 100) / 3
  EXPECT_EQ(level(dark), 105);
  EXPECT_EQ(level(dark), 100) << "the bright one is the fifth last";
  EXPECT_EQ(level(bright), 105);
  pipeline.forget();
  EXPECT_EQ(level(bright), 120);
}

TEST(MeshStep, TakesEveryNthVertexAsItWas) {
  const FrameResult whole = pressed_once({});
  const FrameResult result = pressed_once(with("mesh-step-px", "7"));
  const Face face = flat_sensor_finger(true).face;
  const FaceVertices every = contact_face_vertices(whole, face),
                     some = contact_face_vertices(result, face);
  ASSERT_EQ(every.points_mm.size(), whole.depth->depth_mm.size());
  ASSERT_EQ(some.points_mm.size(), cv::Size((320 + 6) / 7, (240 + 6) / 7));
  ASSERT_EQ(some.depth_mm.size(), some.points_mm.size());
  for (int row = 0; row < some.points_mm.rows; ++row)
    for (int column = 0; column < some.points_mm.cols; ++column) {
      const auto was = every.points_mm.at<cv::Vec3f>(7 * row, 7 * column),
                 is = some.points_mm.at<cv::Vec3f>(row, column);
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_TRUE(is[axis] == was[axis] || (std::isnan(is[axis]) && std::isnan(was[axis])));
    }
  EXPECT_EQ(median_error_mm(result), median_error_mm(whole)) << "depth itself stays as it was";
}

TEST(Rays, ParallelOnesTellDepthAtTheSamePixelByTheSlopeAlone) {
  Finger finger = flat_sensor_finger(true);
  finger.mapping->along = MappingAlong::kNormal;
  const FingerSnapshot snapshot = FingerSnapshot::of({}, finger).value();
  const auto along = [&](bool exact_rays) {
    PipelineSettings settings;
    settings.exact_rays = exact_rays;
    return Pipeline::with_library(ReferenceLibrary::single(untouched_picture(1)).value(), snapshot,
                                  settings)
        .finger()
        .mapping->along;
  };
  EXPECT_EQ(along(true), MappingAlong::kNormal);
  EXPECT_EQ(along(false), MappingAlong::kProjected);
  // What presses are read with, and thus the mapping, does not depend on it.
  EXPECT_TRUE(settings_for_presses(with("rays", "parallel")).exact_rays);
}

TEST(Undistortion, NoneTakesTheLensAsOneThatBendsNothing) {
  Finger finger;
  finger.camera.model = CameraModel::kBrown;
  finger.camera.width_px = 960;
  finger.camera.height_px = 540;
  finger.camera.fx_px = finger.camera.fy_px = 500;
  finger.camera.cx_px = 479.5;
  finger.camera.cy_px = 269.5;
  finger.camera.distortion = {-0.2, 0.05};
  finger.face.width_mm = 24;
  finger.face.layer_mm = 1.5;
  const FingerSnapshot snapshot = FingerSnapshot::of({}, finger).value();
  EXPECT_FALSE(finger_as_measured(snapshot, {}).camera.is_linear());
  PipelineSettings settings = with("undistortion", "none");
  settings.resolution = Resolution::kHalf;
  const FingerSnapshot plain = finger_as_measured(snapshot, settings);
  EXPECT_TRUE(plain.camera.is_linear());
  EXPECT_EQ(plain.camera.size(), cv::Size(480, 270));
  EXPECT_EQ(plain.full_camera.distortion, finger.camera.distortion) << "pictures come as before";
  // By hand: x / z = (u - cx) / fx, at half the pixels a side.
  const auto ray = plain.camera.unproject({400, 30}).value();
  EXPECT_NEAR(ray.direction.x() / ray.direction.z(), (2 * 400 + 0.5 - 479.5) / 500, 1e-12);
  EXPECT_NEAR(ray.direction.y() / ray.direction.z(), (2 * 30 + 0.5 - 269.5) / 500, 1e-12);
}

}  // namespace
}  // namespace alltact::test
