#include "calibration/reference/reference_recording.h"

#include "core/sensing/pipeline.h"
#include "core/sensing/reference/reference_library.h"
#include "tests/support/marked_recording.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::Bend;
using test::described;
using test::MarkedFinger;
using test::MemorySource;
using test::pose;
using test::scratch_folder;
using test::small_finger;

// The furthest marker, among those that were seen or among the estimates.
double truth_error(const MarkerTable& table, const MarkedFinger& f, std::size_t row,
                   const Bend& bend, bool seen) {
  const Eigen::VectorXd difference =
      table.layouts.row(static_cast<Eigen::Index>(row)).transpose() - f.layout(bend);
  double worst = 0;
  for (std::size_t m = 0; m < table.typical.size(); ++m)
    if ((table.seen[row][m] != 0) == seen)
      worst = std::max(worst, difference.segment<2>(static_cast<Eigen::Index>(2 * m)).norm());
  return worst;
}

TEST(InstallReference, NumbersARecordingRejectsWhatIsNoneAndGivesALibraryOfItsFrames) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(11);
  MemorySource source;
  constexpr int kFrames = 60;
  std::vector<int> kept;
  for (int i = 0; i < kFrames; ++i) {
    // Now and then two markers are covered; one frame is black.
    const std::vector<int> hidden =
        i % 7 == 3 ? std::vector<int>{i % 12, (i + 5) % 12} : std::vector<int>{};
    source.images.push_back(i == 20 ? cv::Mat(f.height, f.width, CV_8UC1, cv::Scalar(3))
                                    : f.with_noise(f.clean(pose(i, kFrames), hidden), random));
    if (i != 20) kept.push_back(i);
  }
  Finger finger = described(f);
  const fs::path folder = scratch_folder("install");
  const auto t0 = std::chrono::steady_clock::now();
  const auto report = install_reference(source, folder, finger, Job{});
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
  ASSERT_TRUE(report.ok()) << report.error().sentence();
  EXPECT_EQ(report->frames_read, kFrames);
  for (const auto& line : report->rejected)
    std::printf("[ figures  ] rejected %s\n", line.english().c_str());
  EXPECT_GE(report->frames_retained, kFrames - 3);
  EXPECT_EQ(report->frames_retained + static_cast<int>(report->rejected.size()), kFrames);
  EXPECT_TRUE(std::any_of(report->rejected.begin(), report->rejected.end(),
                          [](const auto& line) { return line.english().find("frame 20: ") == 0; }));
  EXPECT_EQ(finger.markers.polarity, Polarity::kBright);

  const auto table = MarkerTable::load(folder / finger.reference->markers, 12);
  ASSERT_TRUE(table.ok()) << table.error().sentence();
  std::erase_if(kept, [&](int i) {
    const std::string start = "frame " + std::to_string(i) + ": ";
    return std::any_of(report->rejected.begin(), report->rejected.end(),
                       [&](const auto& line) { return line.english().find(start) == 0; });
  });
  ASSERT_EQ(kept.size(), table->frames.size());
  double worst = 0, worst_estimate = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    worst = std::max(worst, truth_error(*table, f, i, pose(kept[i], kFrames), true));
    worst_estimate =
        std::max(worst_estimate, truth_error(*table, f, i, pose(kept[i], kFrames), false));
  }
  std::printf("[ figures  ] recording: worst marker seen %.3f px, estimated %.3f px\n", worst,
              worst_estimate);
  std::printf("[ figures  ] recording: threshold %.2f px, %.1f ms a frame, step %.2f px\n",
              finger.contact->threshold_px, 1e3 * seconds / kFrames, report->median_step_px);
  EXPECT_LT(worst, 1.0);
  // Some poses carry the last markers out of the picture; few frames tell where they went.
  EXPECT_LT(worst_estimate, 0.2 * f.width / f.per_row);
  EXPECT_EQ(finger.contact->rest_markers.size(), 12U);
  EXPECT_GT(finger.contact->threshold_px, 0.0);
  EXPECT_LT(finger.contact->threshold_px, 20.0);

  // The pictures come back exactly.
  cv::VideoCapture video((folder / finger.reference->video).string());
  cv::Mat first;
  ASSERT_TRUE(video.read(first));
  if (first.channels() == 3) cv::extractChannel(first, first, 0);
  EXPECT_EQ(cv::norm(first, source.images[0], cv::NORM_INF), 0.0);

  const Camera camera = Camera::create(finger.camera).value();
  const auto library = ReferenceLibrary::load(FingerSnapshot::of(folder, finger).value(), Job{});
  ASSERT_TRUE(library.ok()) << library.error().sentence();
  EXPECT_EQ(static_cast<int>(library->frame_count()), report->frames_retained);

  // A pose between the recorded ones: the mixture is nearer to the noiseless truth than the
  // nearest.
  double nearest_error = 0, local_error = 0, gain = 0;
  for (const double at : {5.5, 17.5, 33.5, 47.5}) {
    const double t = 2 * M_PI * at / kFrames;
    const Bend bend{0.35 * std::sin(t), 0.2 * std::sin(2 * t + 1), 6 * std::cos(3 * t),
                    0.03 * std::sin(5 * t)};
    Markers markers;
    for (const auto& d : f.discs(bend)) markers.push_back({d.u, d.v, true, 0.02});
    const cv::Mat truth = f.clean(bend);
    const auto error = [&](const Reference& r) {
      // 3 px inside the edge, whose own blur no mixture can follow.
      cv::Mat inner, difference;
      const cv::Mat grey = r.image.grey();
      cv::erode(grey == grey, inner, cv::Mat(), cv::Point(-1, -1), 3);
      cv::absdiff(grey, truth, difference);
      return cv::mean(difference, inner)[0];
    };
    const Reference nearest =
        library->reference_for(markers, f.shape(bend), ReferenceMethod::kNearest);
    const Reference local = library->reference_for(markers, f.shape(bend), ReferenceMethod::kLocal);
    EXPECT_TRUE(local.known_pose);
    EXPECT_GT(local.noise_gain, 0.2);
    nearest_error += error(nearest);
    local_error += error(local);
    gain = std::max(gain, local.noise_gain);
  }
  std::printf(
      "[ figures  ] reference: nearest %.3f, local %.3f grey levels, noise gain up to %.2f\n",
      nearest_error / 4, local_error / 4, gain);
  EXPECT_LT(local_error, nearest_error);
  Markers far;
  const Bend beyond{1.2, 0, 30, 0};
  for (const auto& d : f.discs(beyond)) far.push_back({d.u, d.v, true, 0.02});
  EXPECT_FALSE(library->reference_for(far, f.shape(beyond), ReferenceMethod::kLocal).known_pose);

  // Half the memory: a covering subset, within the limit.
  const std::size_t limit = library->memory_bytes() / 2;
  const auto thinned =
      ReferenceLibrary::load(FingerSnapshot::of(folder, finger).value(), Job{}, limit);
  ASSERT_TRUE(thinned.ok());
  EXPECT_LE(thinned->memory_bytes(), limit);
  EXPECT_GE(thinned->frame_count(), library->frame_count() / 3);
}

TEST(InstallReference, WhatTheCameraWasSetToIsKeptAndComparedWithThePresses) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(11);
  std::vector<cv::Mat> images;
  for (int i = 0; i < 8; ++i) images.push_back(f.with_noise(f.clean(pose(i, 60)), random));
  Finger finger = described(f);
  finger.provenance["press_settings"] = "Camera=usb-1; Gain=3";
  const fs::path folder = scratch_folder("install_settings");
  const auto install = [&](const char* settings) {
    MemorySource source;
    source.images = images;
    if (settings != nullptr) source.settings = std::make_shared<const std::string>(settings);
    return install_reference(source, folder, finger, Job{});
  };
  const auto other = install("Camera=usb-1; Gain=5");
  ASSERT_TRUE(other.ok()) << other.error().sentence();
  EXPECT_EQ(finger.provenance.at("reference_settings"), "Camera=usb-1; Gain=5");
  ASSERT_EQ(other->warnings.size(), 1U);
  EXPECT_NE(other->warnings[0].english().find("different settings: Gain changed from 3 to 5."),
            std::string::npos);
  EXPECT_TRUE(install("Camera=usb-1; Gain=3")->warnings.empty());
  EXPECT_TRUE(install(nullptr)->warnings.empty());
  EXPECT_FALSE(finger.provenance.contains("reference_settings")) << "not told, so not invented";
}

TEST(InstallReference, RecordingsThatCannotBeOneAreToldApart) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(12);
  const fs::path folder = scratch_folder("refused");
  const auto install = [&](std::vector<cv::Mat> images) {
    MemorySource source;
    source.images = std::move(images);
    Finger finger = described(f);
    const auto report = install_reference(source, folder, finger, Job{});
    EXPECT_FALSE(report.ok());
    EXPECT_FALSE(finger.reference || finger.contact);
    for (const auto& file : fs::directory_iterator(folder))
      EXPECT_EQ(file.path().filename(), "reference.problem.png");
    return report.ok() ? std::string{} : report.error().sentence();
  };
  const cv::Mat good = f.with_noise(f.clean(Bend{}), random);
  EXPECT_NE(install({}).find("0 frames"), std::string::npos);
  EXPECT_NE(install({good}).find("1 frame;"), std::string::npos);
  EXPECT_NE(install({good, cv::Mat(100, 100, CV_8UC1, cv::Scalar(9))}).find("100 x 100"),
            std::string::npos);
  const cv::Mat black(f.height, f.width, CV_8UC1, cv::Scalar(2));
  const std::string dark = install({black, black});
  EXPECT_NE(dark.find("no frame shows the face"), std::string::npos);
  EXPECT_NE(dark.find("reference.problem.png shows what was found"), std::string::npos);
  EXPECT_FALSE(cv::imread((folder / "reference.problem.png").string()).empty());
}

// What the finger says after being written and read.
Finger read_again(const Finger& finger) {
  const auto yaml = finger.to_yaml();
  EXPECT_TRUE(yaml.ok());
  const auto again = Finger::parse(*yaml, "finger.yaml");
  EXPECT_TRUE(again.ok()) << again.error().sentence();
  return *again;
}

std::shared_ptr<Frame> as_frame(const cv::Mat& grey) {
  auto frame = std::make_shared<Frame>();
  frame->grey = grey;
  return frame;
}

// Half-way between two frames of a recording as pose() bends it.
Bend between_frames(double at, int frames) {
  const double t = 2 * M_PI * at / frames;
  return {0.35 * std::sin(t), 0.2 * std::sin(2 * t + 1), 6 * std::cos(3 * t),
          0.03 * std::sin(5 * t)};
}

TEST(InstallReference, AMarkerThatWasNeverEngravedIsSaidToBeMissingAndTheOthersWork) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(21);
  MemorySource source;
  constexpr int kFrames = 40;
  for (int i = 0; i < kFrames; ++i)
    source.images.push_back(f.with_noise(f.clean(pose(i, kFrames), {2, 9}), random));
  Finger finger = described(f);
  const fs::path folder = scratch_folder("missing");
  const auto report = install_reference(source, folder, finger, Job{});
  ASSERT_TRUE(report.ok()) << report.error().sentence();
  EXPECT_EQ(report->missing, (std::vector<int>{2, 9}));
  EXPECT_FALSE(report->by_shape);
  EXPECT_FALSE(cv::imread((folder / "reference.problem.png").string()).empty());
  const Finger again = read_again(finger);
  EXPECT_EQ(again.markers.missing, report->missing);
  EXPECT_EQ(again.contact->rest_markers.size(), 12U);
  auto pipeline =
      Pipeline::create(FingerSnapshot::of(folder, again).value(), PipelineSettings{}, Job{});
  ASSERT_TRUE(pipeline.ok()) << pipeline.error().sentence();
  for (int i = 0; i < kFrames; i += 5) {
    const Bend bend = pose(i, kFrames);
    const auto result = (*pipeline)(as_frame(f.with_noise(f.clean(bend, {2, 9}), random)));
    ASSERT_TRUE(result.ok() && result->markers && result->reference) << i;
    const Eigen::VectorXd truth = f.layout(bend);
    for (std::size_t m = 0; m < 12; ++m) {
      const Marker& marker = (*result->markers)[m];
      EXPECT_EQ(marker.seen && (m == 2 || m == 9), false);
      if (marker.seen) {
        EXPECT_NEAR(marker.u, truth[2 * static_cast<Eigen::Index>(m)], 0.6) << m;
      }
    }
  }
}

// Their motion is unknown: an estimate of it may put them anywhere.
TEST(InstallReference, MissingMarkersRestAtOnePositionWhicheverFrameIsTheRest) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(23);
  const std::vector<int> missing{8, 9, 10, 11};
  constexpr int kFrames = 60;
  MemorySource source;
  for (int i = 0; i < kFrames; ++i)
    source.images.push_back(f.with_noise(f.clean(pose(i, kFrames), missing), random));
  std::vector<std::vector<Eigen::Vector2d>> rests;
  for (const int rest : {5, 35}) {
    MemorySource again = source;
    Finger finger = described(f);
    ReferenceChoices choices;
    choices.rest_frame = rest;
    const auto report = install_reference(again, scratch_folder("an_end"), finger, Job{}, choices);
    ASSERT_TRUE(report.ok()) << report.error().sentence();
    ASSERT_EQ(report->missing, missing);
    rests.push_back(finger.contact->rest_markers);
  }
  EXPECT_GT((rests[0][2] - rests[1][2]).norm(), 1.0) << "those that are seen move";
  for (const int m : missing) {
    const Eigen::Vector2d& marker = rests[0][static_cast<std::size_t>(m)];
    EXPECT_EQ(marker, rests[1][static_cast<std::size_t>(m)]) << m;
    EXPECT_TRUE(marker.x() >= 0 && marker.x() < f.width) << marker.transpose();
    EXPECT_TRUE(marker.y() >= 0 && marker.y() < f.height) << marker.transpose();
  }
}

TEST(InstallReference, WithoutMarkersTheShapeOfTheFaceTellsThePose) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(22);
  const std::vector<int> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  constexpr int kFrames = 60;
  std::vector<cv::Mat> images;
  for (int i = 0; i < kFrames; ++i)
    images.push_back(f.with_noise(f.clean(pose(i, kFrames), all), random));
  for (const int per_row : {0, 6}) {
    MemorySource source;
    source.images = images;
    Finger finger = described(f);
    finger.markers.per_row = per_row;
    const fs::path folder = scratch_folder("by_shape");
    const auto report = install_reference(source, folder, finger, Job{});
    ASSERT_TRUE(report.ok()) << report.error().sentence();
    EXPECT_TRUE(report->by_shape);
    // Only who said that there are markers is told that there are none.
    EXPECT_EQ(report->warnings.size(), per_row == 0 ? 0U : 1U);
    const Finger again = read_again(finger);
    ASSERT_TRUE(again.reference && again.reference->positions);
    auto pipeline =
        Pipeline::create(FingerSnapshot::of(folder, again).value(), PipelineSettings{}, Job{});
    ASSERT_TRUE(pipeline.ok()) << pipeline.error().sentence();
    double steps = 0;
    int looked = 0;
    for (double at = 2.5; at < kFrames; at += 9, ++looked) {
      const Bend bend = between_frames(at, kFrames);
      const auto result = (*pipeline)(as_frame(f.with_noise(f.clean(bend, all), random)));
      ASSERT_TRUE(result.ok() && result->reference) << at;
      EXPECT_TRUE(result->reference->known_pose) << at;
      steps += std::min(std::abs(result->reference->frame - at), 60.0);
    }
    std::printf("[ figures  ] by shape: nearest frame %.1f frames away on average\n",
                steps / looked);
    EXPECT_LT(steps / looked, 4.0);
  }
}

TEST(InstallReference, AFrameWhoseMarkersAreHiddenIsMeasuredByTheShapeOfItsFace) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(23);
  MemorySource source;
  constexpr int kFrames = 80;
  for (int i = 0; i < kFrames; ++i)
    source.images.push_back(f.with_noise(f.clean(pose(i, kFrames)), random));
  Finger finger = described(f);
  const fs::path folder = scratch_folder("hidden_markers");
  ASSERT_TRUE(install_reference(source, folder, finger, Job{}).ok());
  const Finger again = read_again(finger);
  auto pipeline =
      Pipeline::create(FingerSnapshot::of(folder, again).value(), PipelineSettings{}, Job{});
  ASSERT_TRUE(pipeline.ok()) << pipeline.error().sentence();
  const auto library = ReferenceLibrary::load(FingerSnapshot::of(folder, again).value(), Job{});
  ASSERT_TRUE(library.ok());
  const std::vector<int> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  for (double at = 2.5; at < kFrames; at += 9) {
    const Bend bend = between_frames(at, kFrames);
    pipeline->forget();
    const auto seen = (*pipeline)(as_frame(f.with_noise(f.clean(bend), random)));
    ASSERT_TRUE(seen.ok() && seen->reference && seen->difference) << at;
    EXPECT_FALSE(seen->reference->by_shape);
    EXPECT_TRUE(seen->push.has_value());
    pipeline->forget();
    const auto hidden = (*pipeline)(as_frame(f.with_noise(f.clean(bend, all), random)));
    ASSERT_TRUE(hidden.ok() && hidden->reference && hidden->difference) << at;
    EXPECT_TRUE(hidden->reference->by_shape);
    EXPECT_TRUE(hidden->reference->known_pose);
    // An estimate that may lie further off makes the reference less sure.
    Markers vague = *hidden->markers;
    for (Marker& marker : vague) marker.sd_px += 2.0;
    const Reference less_sure =
        library->reference_for(vague, *hidden->shape, ReferenceMethod::kLocal);
    EXPECT_GT(less_sure.error_factor, 1.1 * hidden->reference->error_factor);
    EXPECT_FALSE(hidden->push.has_value());
    // Why there are no markers, what that costs, and that the finger is not calibrated.
    ASSERT_EQ(hidden->problems.size(), 3U);
    EXPECT_NE(hidden->problems[1].english().find("the markers were not found"), std::string::npos);
    const Eigen::VectorXd truth = f.layout(bend);
    for (std::size_t m = 0; m < 12; ++m) {
      const Marker& marker = (*hidden->markers)[m];
      EXPECT_FALSE(marker.seen);
      EXPECT_NEAR(marker.u, truth[2 * static_cast<Eigen::Index>(m)], 3.0) << at << " " << m;
      EXPECT_NEAR(marker.v, truth[2 * static_cast<Eigen::Index>(m) + 1], 3.0) << at << " " << m;
    }
    // Nothing presses: the reference is the picture.
    cv::Mat measured = hidden->difference->flags == kMeasured;
    EXPECT_LT(cv::mean(cv::abs(hidden->difference->x), measured)[0], 0.01) << at;
  }
}

TEST(InstallReference, RestIsTheMiddleOfTheRecordingOrTheFrameAskedFor) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(23);
  std::vector<cv::Mat> images;
  // It starts at one end of its motion and stays there for a while.
  const auto curl = [](int i) { return i < 8 ? 0.3 : 0.3 * std::cos(2 * M_PI * (i - 8) / 32); };
  for (int i = 0; i < 40; ++i)
    images.push_back(f.with_noise(f.clean(Bend{curl(i), 0, 0, 0}), random));
  const auto install = [&](std::optional<int> rest, Finger& finger) {
    MemorySource source;
    source.images = images;
    ReferenceChoices choices;
    choices.rest_frame = rest;
    return install_reference(source, scratch_folder("rest"), finger, Job{}, choices);
  };
  Finger finger = described(f);
  const auto middle = install(std::nullopt, finger);
  ASSERT_TRUE(middle.ok()) << middle.error().sentence();
  EXPECT_LT(std::abs(curl(middle->rest_frame)), 0.12) << middle->rest_frame;
  const auto asked = install(3, finger);
  ASSERT_TRUE(asked.ok()) << asked.error().sentence();
  EXPECT_EQ(asked->rest_frame, 3);
  const Eigen::VectorXd truth = f.layout(Bend{curl(3), 0, 0, 0});
  for (std::size_t m = 0; m < 6; ++m)
    EXPECT_NEAR(finger.contact->rest_markers[m].x(), truth[2 * static_cast<Eigen::Index>(m)], 1.0);
  const auto beyond = install(40, finger);
  ASSERT_FALSE(beyond.ok());
  EXPECT_NE(beyond.error().what.english().find("frame 40 cannot be"), std::string::npos);
}

}  // namespace
}  // namespace alltact
