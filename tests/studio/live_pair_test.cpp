// Two fingers watched at once in the place Live.
#include "widgets/live/live_pair.h"

#include "core/base/atomic_file.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "tests/core/gripper/gripper_files.h"
#include "tests/studio/studio_rig.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <atomic>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::int64_t kPeriod_ns = 100'000'000, kLater_ns = 30'000'000;

/// A camera that takes a picture every kPeriod_ns, at times that two such share.
class SteadyCamera : public Source {
 public:
  SteadyCamera(std::string name, std::int64_t first_ns, const std::atomic<bool>* is_stuck)
      : name_(std::move(name)), first_ns_(first_ns), is_stuck_(is_stuck) {
    for (int i = 0; i < 6; ++i)
      pictures_.push_back(
          read_grey_image(MadeFingers::get().touched_pictures() / fmt::format("frame_{:05}.png", i))
              .value());
  }
  Result<FramePtr> next() override {
    auto frame = std::make_shared<Frame>();
    frame->sequence = count_++;
    frame->time_ns = first_ns_ + static_cast<std::int64_t>(frame->sequence) * kPeriod_ns;
    while (monotonic_ns() < *frame->time_ns || (is_stuck_ != nullptr && *is_stuck_))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    frame->grey = pictures_[frame->sequence % pictures_.size()];
    frame->origin = name_;
    frame->name = fmt::format("frame_{:05}", frame->sequence);
    return FramePtr(frame);
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return std::nullopt; }
  [[nodiscard]] bool is_continuous() const override { return true; }
  [[nodiscard]] bool is_live() const override { return true; }
  [[nodiscard]] double frames_per_s() const override { return 1e9 / kPeriod_ns; }

 private:
  std::string name_;
  std::int64_t first_ns_;
  const std::atomic<bool>* is_stuck_;
  std::uint64_t count_ = 0;
  std::vector<cv::Mat> pictures_;
};

/// Two fingers in a gripper that say of themselves where they sit when the motor stands at 5 turns.
class TwoCameras : public testing::Test {
 protected:
  static constexpr double kKnownAt_turns = 5.0;
  static RigidTransform place(bool is_second) {
    return {rotation_from_rpy_deg({0, 60, is_second ? 180.0 : 0.0}),
            Eigen::Vector3d(is_second ? 150 : -150, 0, 0)};
  }

  TwoCameras() {
    std::string gripper = kGripper;
    for (const bool is_second : {false, true}) {
      const fs::path folder = folder_ / (is_second ? "right" : "left");
      fs::copy(MadeFingers::get().calibrated(), folder, fs::copy_options::recursive);
      Finger finger = Finger::load(folder).value();
      finger.name = is_second ? "right" : "left";
      finger.gripper_from_camera = place(is_second);
      must(finger.save(folder));
      const auto at = gripper.find("link_from_camera");
      gripper.replace(at, gripper.find('\n', at) - at, "known_at_turns: 5.0");
    }
    must(write_file_atomically(gripper_file(), gripper));
    options_.finger = folder_ / "left";
    options_.source = {"left camera"};
    options_.opener = [this](const std::vector<fs::path>& inputs,
                             const SourceOptions&) -> Result<std::unique_ptr<Source>> {
      const bool is_second = inputs.front() == "right camera";
      if (!is_second && inputs.front() != "left camera")
        return Error{en::say("there is no such camera"), inputs.front().string(), ""};
      return std::unique_ptr<Source>(std::make_unique<SteadyCamera>(
          inputs.front().string(), start_ns_ + (is_second ? kLater_ns : 0),
          is_second ? &is_second_stuck_ : nullptr));
    };
  }
  [[nodiscard]] fs::path gripper_file() const { return folder_ / "gripper.yaml"; }
  [[nodiscard]] SecondCamera second(bool has_gripper) const {
    return {folder_ / "right",
            {"right camera"},
            has_gripper ? gripper_file() : fs::path(),
            has_gripper ? std::optional(kKnownAt_turns) : std::nullopt};
  }
  static LivePage& live(Studio& studio) { return *studio.window().findChild<LivePage*>(); }
  static bool wait_for_pair(Studio& studio) {
    return wait_until(
        [&] {
          const auto& pair = live(studio).pair().pair();
          return pair && pair->is_in_time && pair->views[0]->result.depth &&
                 pair->views[1]->result.depth;
        },
        40000);
  }
  static std::string reported(Studio& studio, const QString& label) {
    return studio.find<QLabel>(label)->text().toStdString();
  }

  TemporaryFolder folder_;
  StudioOptions options_;
  std::int64_t start_ns_ = monotonic_ns();
  std::atomic<bool> is_second_stuck_{false};
};

TEST_F(TwoCameras, ShowsBothPicturesOfOneMoment) {
  Studio studio(options_);
  live(studio).open_second(second(false));
  ASSERT_TRUE(wait_for_pair(studio));
  int seen = 0;
  std::int64_t last_ns = 0;
  ASSERT_TRUE(wait_until(
      [&] {
        const auto& pair = live(studio).pair().pair();
        const FramePtr& first = pair->views[0]->result.frame;
        const FramePtr& second = pair->views[1]->result.frame;
        if (first->time_ns == last_ns || !pair->is_in_time) return false;
        last_ns = *first->time_ns;
        EXPECT_EQ(first->origin, "left camera");
        EXPECT_EQ(second->origin, "right camera");
        EXPECT_EQ(*second->time_ns - *first->time_ns, kLater_ns);
        return ++seen == 8;
      },
      20000))
      << seen;
  EXPECT_THAT(reported(studio, "Synchronization of both images"), HasSubstr("In sync"));
  // Side by side, each as large as the other, and neither squashed.
  const auto panels = live(studio).findChildren<ImagePanel*>();
  ASSERT_EQ(panels.size(), 2);
  EXPECT_NEAR(panels[0]->width(), panels[1]->width(), 2);
  EXPECT_GE(panels[1]->view().width(), 300);
  EXPECT_FALSE(panels[1]->view().image().empty());
  EXPECT_LT(panels[0]->mapToGlobal(QPoint()).x(), panels[1]->mapToGlobal(QPoint()).x());

  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(live(studio).pair().opened());
  EXPECT_FALSE(panels[1]->isVisible());
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(wait_for_pair(studio));
}

TEST_F(TwoCameras, SaysWhenOneOfThemStandsStillAndGoesOnWithTheOther) {
  Studio studio(options_);
  live(studio).open_second(second(false));
  ASSERT_TRUE(wait_for_pair(studio));
  is_second_stuck_ = true;
  ASSERT_TRUE(wait_until([&] { return !live(studio).pair().pair()->is_in_time; }, 20000));
  const auto before = live(studio).pair().pair()->views[0];
  EXPECT_TRUE(wait_until([&] { return live(studio).pair().pair()->views[0] != before; }));
  EXPECT_TRUE(wait_until([&] {
    return reported(studio, "Synchronization of both images").find("Not in sync") !=
           std::string::npos;
  }));
  is_second_stuck_ = false;
  EXPECT_TRUE(wait_for_pair(studio));
}

/// Points of a face in the gripper's frame, of every `step`th pixel within `within`.
struct PlacedPoint {
  Eigen::Vector3d at_mm;
  cv::Point pixel;
};
std::vector<PlacedPoint> placed_points(const cv::Mat& points_mm, const RigidTransform& place,
                                       cv::Rect within, int step) {
  within &= cv::Rect({}, points_mm.size());
  std::vector<PlacedPoint> placed;
  for (int v = within.y; v < within.br().y; v += step)
    for (int u = within.x; u < within.br().x; u += step) {
      const auto& at = points_mm.at<cv::Vec3f>(v, u);
      if (std::isfinite(at[2])) placed.push_back({place.point({at[0], at[1], at[2]}), {u, v}});
    }
  return placed;
}

/// By trying all: coarse ones first, then all pixels around the nearest.
double least_distance_mm(const std::array<cv::Mat, 2>& faces,
                         const std::array<RigidTransform, 2>& places) {
  std::array<cv::Rect, 2> within{cv::Rect({}, faces[0].size()), cv::Rect({}, faces[1].size())};
  double least_mm = 0;
  for (const int step : {8, 1}) {
    least_mm = std::numeric_limits<double>::infinity();
    std::array<cv::Point, 2> nearest;
    const auto theirs = placed_points(faces[1], places[1], within[1], step);
    for (const PlacedPoint& a : placed_points(faces[0], places[0], within[0], step))
      for (const PlacedPoint& b : theirs)
        if (const double apart = (a.at_mm - b.at_mm).norm(); apart < least_mm) {
          least_mm = apart;
          nearest = {a.pixel, b.pixel};
        }
    for (std::size_t i = 0; i < 2; ++i)
      within[i] = cv::Rect(nearest[i] - cv::Point(20, 20), cv::Size(41, 41));
  }
  return least_mm;
}

TEST_F(TwoCameras, TellsTheGapAndTheWidthOfWhatIsHeld) {
  Studio studio(options_);
  live(studio).open_second(second(true));
  ASSERT_TRUE(wait_for_pair(studio));
  const LivePair& pair = live(studio).pair();
  ASSERT_TRUE(wait_until([&] { return pair.reading() && pair.reading()->gap; }, 20000))
      << (pair.problem() ? pair.problem()->sentence() : "");
  const PairReading reading = *pair.reading();
  const Face face = studio.session().status().finger.finger->face;
  const FrameResult &first = reading.of.views[0]->result, &second = reading.of.views[1]->result;

  const double least_mm =
      least_distance_mm({contact_face_points_mm(first, face), contact_face_points_mm(second, face)},
                        {place(false), place(true)});
  EXPECT_NEAR(reading.gap->mm, least_mm, 0.5);  // the nearest of all are so by noise
  ASSERT_TRUE(reading.gap->sd_mm);
  EXPECT_GT(*reading.gap->sd_mm, 0);

  ASSERT_TRUE(reading.width);
  const double width_mm = std::abs(place(true).point(second.regions.front().position_mm).x() -
                                   place(false).point(first.regions.front().position_mm).x());
  EXPECT_NEAR(reading.width->mm, width_mm, 1e-6);
  ASSERT_TRUE(wait_until(
      [&] { return reported(studio, "Gap and width").find("Object width") != std::string::npos; }));
  EXPECT_THAT(reported(studio, "Gap and width"), HasSubstr("±"));

  // Another motor position is another gap, and can be taken back.
  auto* motor = studio.find<QDoubleSpinBox>("Motor position in turns");
  ASSERT_NE(motor, nullptr);
  EXPECT_EQ(motor->value(), kKnownAt_turns);
  motor->setFocus();
  motor->stepBy(5);
  ASSERT_TRUE(wait_until(
      [&] { return pair.reading() && pair.reading()->motor_turns == kKnownAt_turns + 0.5; },
      20000));
  ASSERT_TRUE(pair.reading()->gap);
  EXPECT_GT(std::abs(pair.reading()->gap->mm - reading.gap->mm), 0.05);
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(pair.motor_turns(), kKnownAt_turns);
}

TEST_F(TwoCameras, SaysWhatIsWrongWithSecondFingerCameraAndGripper) {
  Studio studio(options_);
  ASSERT_TRUE(studio.wait_for_picture());
  const auto problem_of = [&](const SecondCamera& wanted) {
    live(studio).open_second(wanted);
    static_cast<void>(wait_until([&] { return live(studio).pair().problem().has_value(); }, 20000));
    const auto problem = live(studio).pair().problem();
    return problem ? problem->sentence() : std::string();
  };
  SecondCamera wrong = second(true);
  wrong.source = {"no camera"};
  EXPECT_THAT(problem_of(wrong), HasSubstr("there is no such camera"));
  EXPECT_TRUE(wait_until([&] {
    return reported(studio, "Synchronization of both images").find("no such camera") !=
           std::string::npos;
  }));
  wrong = second(true);
  wrong.finger = folder_ / "nobody";
  EXPECT_THAT(problem_of(wrong), HasSubstr("nobody"));
  wrong = second(true);
  wrong.gripper = folder_ / "none.yaml";
  EXPECT_THAT(problem_of(wrong), HasSubstr("none.yaml"));
  // The gripper's own fingers are others.
  wrong = second(true);
  wrong.finger = MadeFingers::get().calibrated();
  EXPECT_THAT(problem_of(wrong), HasSubstr("others are open"));
}

TEST_F(TwoCameras, AreOpenedByTheDialog) {
  Studio studio(options_);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.click("Second finger…");
  auto* dialog = studio.window().findChild<SecondCameraDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* show = studio.find<QPushButton>("Show it");
  EXPECT_FALSE(show->isEnabled());
  for (QLineEdit* line : dialog->findChildren<QLineEdit*>()) {
    if (line->accessibleName() == QLatin1String("Finger's folder"))
      line->setText(QString::fromStdString((folder_ / "right").string()));
    if (line->accessibleName() == QLatin1String("Gripper's file"))
      line->setText(QString::fromStdString(gripper_file().string()));
  }
  EXPECT_FALSE(show->isEnabled());
  dialog->findChild<QComboBox*>()->setEditText(QStringLiteral("right camera"));
  EXPECT_TRUE(show->isEnabled());
  QTest::mouseClick(show, Qt::LeftButton);
  ASSERT_TRUE(live(studio).pair().opened());
  EXPECT_EQ(live(studio).pair().opened()->finger, folder_ / "right");
  EXPECT_TRUE(wait_for_pair(studio));
  studio.click("Close");
  EXPECT_FALSE(live(studio).pair().opened());
  EXPECT_FALSE(live(studio).pair().pair());
}

}  // namespace
}  // namespace alltact::test
