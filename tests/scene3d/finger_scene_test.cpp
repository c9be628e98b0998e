// The whole finger in the scene: its body, its ruler, the light that falls on it, and that nothing
// of it hides the face.
#include "tests/support/made_surface.h"
#include "widgets/scene3d/face_surface.h"
#include "widgets/scene3d/finger_actors.h"
#include "widgets/scene3d/vtk_view.h"

#include <cstdlib>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact::test {
namespace {

const cv::Size kFingerView{800, 500};

/// A finger with its base at the left, 24 mm wide and 96 mm long, that goes away from the camera.
struct MadeFinger {
  static constexpr double kSlope = 0.6, kBase_mm = 60;
  MadeSurface made;
  MadeFinger() {
    made.slope = kSlope;
    made.z_mm = kBase_mm + kSlope * 48;
    made.radius_mm = 3;
  }
  [[nodiscard]] FaceSurface make(int columns = 193, int rows = 49) const {
    FaceSurface surface = made.make(columns, rows);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        // Narrower than the picture is tall.
        auto& p = surface.untouched_mm.at<cv::Vec3f>(j, i);
        p[1] *= 24.0F / 53.9F;
        surface.depth_mm.at<float>(j, i) = static_cast<float>(made.depth_at(p[0], p[1]));
      }
    surface.has_body = true;
    for (int i = 0; i < columns; ++i)
      surface.along_mm.push_back((surface.untouched_mm.at<cv::Vec3f>(0, i)[0] + 47.95) *
                                 std::hypot(1.0, kSlope));
    return surface;
  }
};

TEST(FingerBody, StandsBehindTheFaceAndHoldsTheCamera) {
  const FaceSurface surface = MadeFinger().make();
  const FingerBody body = body_of(surface);
  ASSERT_GT(body.sections.size(), 20U);
  const auto& base = body.sections.front();
  const auto& tip = body.sections.back();
  const auto& corner = surface.untouched_mm.at<cv::Vec3f>(0, 0);
  EXPECT_LT((base[0] - Eigen::Vector3d(corner[0], corner[1], corner[2])).norm(), 1e-6);
  // The plane z = z0 + s x is z0 / sqrt(1 + s^2) from the origin, where the camera is.
  const double camera_mm = MadeFinger().made.z_mm / std::hypot(1.0, MadeFinger::kSlope);
  EXPECT_NEAR((base[3] - base[0]).norm(), camera_mm, 1e-3);
  const Eigen::Vector3d inward = Eigen::Vector3d(MadeFinger::kSlope, 0, -1).normalized();
  for (const auto& section : body.sections) {
    EXPECT_NEAR((section[3] - section[0]).normalized().dot(inward), 1, 1e-6);
    EXPECT_NEAR((section[2] - section[1]).normalized().dot(inward), 1, 1e-6);
    EXPECT_NEAR((section[1] - section[0]).norm(), 24, 1e-3);
  }
  EXPECT_LT((tip[3] - tip[0]).norm(), 0.2 * camera_mm) << "thinner towards the tip";
  EXPECT_LT(base[0].x(), tip[0].x());
}

TEST(FingerBody, IsNowhereLessDeepThanItsDots) {
  FaceSurface surface = MadeFinger().make();
  surface.markers.push_back({{0, 0, 0}, 0.95 * 192, 6.0, true});
  const FingerBody body = body_of(surface);
  const auto& near_tip = body.sections[static_cast<std::size_t>(std::lround(0.95 * 40))];
  EXPECT_GE((near_tip[3] - near_tip[0]).norm(), 6.0 + 1.0);
}

TEST(FingerBody, AFlatSensorHasNone) {
  FaceSurface surface = MadeFinger().make();
  surface.has_body = false;
  EXPECT_TRUE(body_of(surface).sections.empty());
  EXPECT_TRUE(body_of(surface).corners().empty());
}

TEST(Ruler, TheStickIsARoundHeightThatFits) {
  EXPECT_DOUBLE_EQ(stick_height_mm(1, 7.2), 5);
  EXPECT_DOUBLE_EQ(stick_height_mm(5, 7.2), 1);
  EXPECT_DOUBLE_EQ(stick_height_mm(20, 7.2), 0.2);
  EXPECT_DOUBLE_EQ(stick_height_mm(50, 7.2), 0.1);
}

TEST(GridBoxes, FindsEveryPointThatARayIsSentTo) {
  const FaceSurface surface = MadeFinger().make(100, 60);
  const GridBoxes boxes(surface.untouched_mm);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> column(0.01, 98.99), row(0.01, 58.99);
  for (int k = 0; k < 300; ++k) {
    const cv::Point2d place(column(random), row(random));
    const cv::Vec3f p = point_between(surface.untouched_mm, place);
    const Eigen::Vector3d from(3, -40, -20), to(p[0], p[1], p[2]);
    const auto found = boxes.first_hit(from, to - from);
    ASSERT_TRUE(found) << place;
    EXPECT_NEAR(found->x, place.x, 1e-3);
    EXPECT_NEAR(found->y, place.y, 1e-3);
  }
  EXPECT_FALSE(boxes.first_hit({0, 0, -10}, {0, 0, -1}));
}

class FingerSceneTest : public testing::Test {
 protected:
  FingerSceneTest() : renderer_(OffscreenScene::create(kFingerView).value()) {
    scene().set_options(options_);
  }
  FaceScene& scene() { return renderer_.scene(); }
  void show(const FaceSurface& surface) { scene().show(surface, MadeSurface::camera()); }
  void look_at_it(const std::string& name) {
    if (const char* folder = std::getenv("ALLTACT_LOOK_AT"))
      cv::imwrite(std::string(folder) + "/" + name + ".png", renderer_.image());
  }
  cv::Vec3d at(cv::Point2d pixel) {
    const cv::Mat image = renderer_.image();
    const auto place = scene().window_pixel_of(pixel);
    return place ? cv::Vec3d(image.at<cv::Vec3b>(cv::Point(*place))) : cv::Vec3d();
  }
  /// What is drawn, without the scale of the colours at the right.
  cv::Rect drawn() {
    cv::Mat grey;
    cv::cvtColor(renderer_.image(), grey, cv::COLOR_BGR2GRAY);
    const cv::Mat free = grey(cv::Rect(0, 0, kFingerView.width - 78, kFingerView.height));
    return cv::boundingRect(free < 250);
  }
  SceneOptions options_;
  OffscreenScene renderer_;
};

TEST_F(FingerSceneTest, FillsTheView) {
  for (const Viewpoint viewpoint :
       {Viewpoint::kTilted, Viewpoint::kCamera, Viewpoint::kOutside, Viewpoint::kSide}) {
    scene().set_viewpoint(viewpoint);
    show(MadeFinger().make());
    look_at_it("finger_" + std::to_string(static_cast<int>(viewpoint)));
    const cv::Rect box = drawn();
    const double across = box.width / (kFingerView.width - 78.0),
                 up = box.height / (kFingerView.height + 0.0);
    EXPECT_GT(std::max(across, up), 0.88) << static_cast<int>(viewpoint);
    if (viewpoint == Viewpoint::kCamera) continue;  // side faces reach out of what it sees
    EXPECT_GT(box.x, 0) << "nothing is cut off";
    EXPECT_GT(box.y, 0);
    EXPECT_LT(box.br().y, kFingerView.height);
  }
}

/// Over a face brought so near that it fills the view.
TEST_F(FingerSceneTest, TheScaleHasAPlateAndMarksItsEnds) {
  scene().set_viewpoint(Viewpoint::kCamera);
  show(MadeFinger().make());
  scene().dolly(2);
  look_at_it("scale");
  const cv::Mat image = renderer_.image();
  const cv::Vec3b left = image.at<cv::Vec3b>(250, 600), plate = image.at<cv::Vec3b>(250, 790);
  EXPECT_LT(left[0], 100) << "the face";
  EXPECT_GT(plate[0], 190) << "letters are black";
  cv::Mat above, below;
  const cv::Scalar top(kAboveScale.blue, kAboveScale.green, kAboveScale.red),
      low(kBelowScale.blue, kBelowScale.green, kBelowScale.red);
  cv::inRange(image, top, top, above);
  cv::inRange(image, low, low, below);
  EXPECT_GT(cv::countNonZero(above), 60);
  EXPECT_GT(cv::countNonZero(below), 60);
  EXPECT_LT(cv::boundingRect(above).br().y, cv::boundingRect(below).y);
}

TEST_F(FingerSceneTest, NothingHidesTheFace) {
  const cv::Point2d middle(479.5, 269.5), beside(300, 269.5);
  for (const Viewpoint viewpoint : {Viewpoint::kTilted, Viewpoint::kCamera, Viewpoint::kOutside}) {
    scene().set_viewpoint(viewpoint);
    show(MadeFinger().make());
    const ViewPose look = scene().view_pose();
    const cv::Vec3d deep = at(middle), flat = at(beside);
    options_.body = options_.ruler = options_.camera = false;
    scene().set_options(options_);
    scene().set_view_pose(look);
    EXPECT_LT(cv::norm(at(middle) - deep), 3) << static_cast<int>(viewpoint);
    EXPECT_LT(cv::norm(at(beside) - flat), 3) << static_cast<int>(viewpoint);
    options_ = {};
    scene().set_options(options_);
  }
}

/// Five hundredths of a millimetre in a face that is one colour all over.
TEST_F(FingerSceneTest, LightShowsFiveHundredthsOfAMillimetre) {
  MadeSurface made;
  made.deepest_mm = 0.05;
  made.radius_mm = 1.5;
  FaceSurface surface = made.make(481, 271);
  surface.depth_mm += 5.0F;
  options_.top_mm = 10;
  options_.camera = false;
  scene().set_options(options_);
  scene().set_viewpoint(Viewpoint::kCamera);
  show(surface);
  look_at_it("five_hundredths");
  cv::Mat grey;
  cv::cvtColor(renderer_.image(), grey, cv::COLOR_BGR2GRAY);
  const auto middle = *scene().window_pixel_of({479.5, 269.5});
  const cv::Mat dent = grey(cv::Rect(cv::Point(middle) - cv::Point(14, 14), cv::Size(28, 28)));
  double low = 0, high = 0;
  cv::minMaxLoc(dent, &low, &high);
  const double around = grey.at<std::uint8_t>(cv::Point(middle) + cv::Point(60, 0));
  EXPECT_LT(low, 0.95 * around) << "a side in shade";
  EXPECT_GT(high, 1.05 * around) << "a side in the light";
}

/// A ball's two sides keep their brightness when the finger is turned.
TEST_F(FingerSceneTest, TheLightStaysWithTheFinger) {
  for (const Viewpoint viewpoint : {Viewpoint::kTilted, Viewpoint::kCamera, Viewpoint::kOutside}) {
    scene().set_viewpoint(viewpoint);
    show(MadeFinger().make());
    const double left = cv::norm(at({463, 269.5})), right = cv::norm(at({496, 269.5}));
    EXPECT_GT(left, 1.2 * right) << static_cast<int>(viewpoint);
  }
}

TEST_F(FingerSceneTest, TheCameraIsSeenThroughTheBody) {
  scene().set_viewpoint(Viewpoint::kOutside);
  show(MadeFinger().make());
  const cv::Mat with = renderer_.image();
  const ViewPose look = scene().view_pose();
  options_.camera = false;
  scene().set_options(options_);
  scene().set_view_pose(look);
  EXPECT_GT(cv::countNonZero(cv::Mat(with != renderer_.image()).reshape(1)), 100);
}

TEST_F(FingerSceneTest, TheStickHasTheLanguagesDecimalMark) {
  options_.exaggeration = 20;
  scene().set_options(options_);
  show(MadeFinger().make());
  const cv::Rect room(0, 0, kFingerView.width - 90, kFingerView.height);
  const cv::Mat point = renderer_.image()(room).clone();
  scene().set_colours({.decimal_mark = ','});
  const cv::Mat comma = renderer_.image()(room).clone();
  const int changed = cv::countNonZero(cv::Mat(point != comma).reshape(1));
  EXPECT_GT(changed, 2) << "0,2 mm";
  EXPECT_LT(changed, 300);
  show(MadeFinger().make());
  EXPECT_EQ(cv::countNonZero(cv::Mat(comma != renderer_.image()(room)).reshape(1)), 0)
      << "the next frame, too";
}

TEST_F(FingerSceneTest, TheBodyAndTheRulerCanBeTakenAway) {
  show(MadeFinger().make());
  const cv::Mat all = renderer_.image();
  const ViewPose look = scene().view_pose();
  for (const auto member : {&SceneOptions::body, &SceneOptions::ruler}) {
    SceneOptions less = options_;
    less.*member = false;
    scene().set_options(less);
    scene().set_view_pose(look);
    EXPECT_GT(cv::countNonZero(cv::Mat(all != renderer_.image()).reshape(1)), 300);
  }
}

}  // namespace
}  // namespace alltact::test
