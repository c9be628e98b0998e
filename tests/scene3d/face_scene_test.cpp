// The face in 3D against what a picture of it must show, without a display.
#include "tests/support/made_surface.h"
#include "tests/support/temporary_folder.h"
#include "widgets/scene3d/face_mesh.h"
#include "widgets/scene3d/face_surface.h"
#include "widgets/scene3d/vtk_view.h"

#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <vtkPointData.h>

namespace alltact::test {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
const cv::Size kSize{800, 500};

double distance(const cv::Vec3b& a, const cv::Vec3d& b) { return cv::norm(cv::Vec3d(a) - b); }

/// Blue, green, red, as a picture has them.
cv::Vec3d of(MapColour c) { return {double(c.blue), double(c.green), double(c.red)}; }

class FaceSceneTest : public testing::Test {
 protected:
  FaceSceneTest() : renderer_(OffscreenScene::create(kSize).value()) {
    options_.untouched = false;
    options_.camera = false;
    scene().set_options(options_);
    scene().set_viewpoint(Viewpoint::kCamera);
  }
  FaceScene& scene() { return renderer_.scene(); }
  void show(const FaceSurface& surface) { scene().show(surface, MadeSurface::camera()); }
  /// The colour where a pixel of the camera's picture is drawn.
  cv::Vec3b at(cv::Point2d pixel) {
    const cv::Mat image = renderer_.image();
    const auto place = scene().window_pixel_of(pixel);
    if (!place) return {};
    return image.at<cv::Vec3b>(cv::Point(*place));
  }
  MadeSurface made_;
  SceneOptions options_;
  OffscreenScene renderer_;
  const cv::Point2d middle_{479.5, 269.5};
};

TEST_F(FaceSceneTest, ColoursTheFaceByDepthInMillimetres) {
  show(made_.make(193, 109));
  // Straight from the camera a flat top is lit in full.
  EXPECT_LT(distance(at(middle_), of(depth_colour(0.8))), 12);
  EXPECT_LT(distance(at({100, 100}), of(depth_colour(0))), 12);
  options_.top_mm = 1.6;
  scene().set_options(options_);
  EXPECT_LT(distance(at(middle_), of(depth_colour(0.5))), 12);
}

TEST_F(FaceSceneTest, ShowsWhatWasNotMeasuredInGrey) {
  FaceSurface surface = made_.make(193, 109);
  surface.depth_mm(cv::Rect(20, 20, 30, 30)).setTo(kNone);
  show(surface);
  const auto& pixel = surface.pixel.at<cv::Vec2f>(35, 35);
  EXPECT_LT(distance(at({pixel[0], pixel[1]}), of(kNotMeasured)), 12);
}

TEST_F(FaceSceneTest, ShowsDifferencesAroundZero) {
  const FaceSurface surface = made_.make(193, 109);
  const cv::Mat other = surface.depth_mm + 0.5F;
  options_.difference_top_mm = 1;
  scene().set_options(options_);
  scene().show_difference(surface, other, MadeSurface::camera());
  EXPECT_LT(distance(at(middle_), of(cool_to_warm(-0.5))), 12);
  scene().show_difference(surface, surface.depth_mm, MadeSurface::camera());
  EXPECT_LT(distance(at(middle_), of(cool_to_warm(0))), 12);
}

TEST_F(FaceSceneTest, WritesNumbersWithTheLanguagesDecimalMark) {
  show(made_.make(193, 109));
  const cv::Mat point = renderer_.image();
  scene().set_colours({.decimal_mark = ','});
  const cv::Mat changed = cv::Mat(point != renderer_.image()).reshape(1);
  EXPECT_GT(cv::countNonZero(changed), 5);
  EXPECT_LT(cv::countNonZero(changed), 2000) << "nothing but the labels of the colours";
  scene().set_colours({});
  EXPECT_EQ(cv::countNonZero(cv::Mat(point != renderer_.image()).reshape(1)), 0);
}

TEST_F(FaceSceneTest, FindsThePixelUnderThePointer) {
  made_.slope = 0.6;
  show(made_.make(193, 109));
  for (const Viewpoint viewpoint : {Viewpoint::kTilted, Viewpoint::kCamera, Viewpoint::kOutside}) {
    scene().set_viewpoint(viewpoint);
    for (const cv::Point2d pixel :
         {cv::Point2d(50, 60), cv::Point2d(479.5, 269.5), cv::Point2d(900, 500)}) {
      const auto place = scene().window_pixel_of(pixel);
      ASSERT_TRUE(place);
      EXPECT_GT(place->x, 0);
      EXPECT_LT(place->x, kSize.width - 78) << "beside the scale";
      EXPECT_GT(place->y, 0);
      EXPECT_LT(place->y, kSize.height);
      const auto found = scene().pixel_at(place->x, place->y);
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->x, pixel.x, 0.5);
      EXPECT_NEAR(found->y, pixel.y, 0.5);
    }
  }
  EXPECT_FALSE(scene().pixel_at(1, 1)) << "beside the face";
}

TEST_F(FaceSceneTest, TheCamerasOwnViewIsThePictureUpright) {
  show(made_.make(193, 109));
  const auto left = scene().window_pixel_of({10, 269.5}),
             right = scene().window_pixel_of({940, 269.5});
  const auto top = scene().window_pixel_of({479.5, 10});
  ASSERT_TRUE(left && right && top);
  EXPECT_LT(left->x, right->x);
  EXPECT_LT(top->y, left->y);
  scene().set_viewpoint(Viewpoint::kOutside);
  EXPECT_GT(scene().window_pixel_of({10, 269.5})->x, scene().window_pixel_of({940, 269.5})->x)
      << "from behind, left is right";
}

TEST_F(FaceSceneTest, DrawsDepthLargerWhenAsked) {
  show(made_.make(193, 109));
  scene().set_viewpoint(Viewpoint::kSide);
  const double plain =
      scene().window_pixel_of({10, 269.5})->y - scene().window_pixel_of(middle_)->y;
  options_.exaggeration = 5;
  scene().set_options(options_);
  const double larger =
      scene().window_pixel_of({10, 269.5})->y - scene().window_pixel_of(middle_)->y;
  EXPECT_GT(plain, 0) << "pressed towards the camera, which is above";
  EXPECT_NEAR(larger / plain, 5, 0.3);
}

TEST_F(FaceSceneTest, DrawsMarksTheUntouchedFaceAndTheCamera) {
  show(made_.make(193, 109));
  const cv::Mat bare = renderer_.image();
  scene().set_marks({{cv::Point2d(200, 200)}, {{{100, 300}, {500, 300}, {800, 300}}}});
  const cv::Mat marked = renderer_.image();
  EXPECT_GT(cv::countNonZero(cv::Mat(bare != marked).reshape(1)), 300);
  EXPECT_LT(distance(at({200, 200}), {0, 184, 255}), 60);
  scene().set_marks({});
  EXPECT_EQ(cv::countNonZero(cv::Mat(bare != renderer_.image()).reshape(1)), 0);
  for (const auto member : {&SceneOptions::untouched, &SceneOptions::camera}) {
    SceneOptions more = options_;
    more.*member = true;
    scene().set_options(more);
    EXPECT_GT(cv::countNonZero(cv::Mat(bare != renderer_.image()).reshape(1)), 300);
    scene().set_options(options_);
  }
}

TEST_F(FaceSceneTest, MovesByKeysAndIsNotPutBackByTheNextFrame) {
  show(made_.make(193, 109));
  const Eigen::Vector3d first = scene().view_pose().eye;
  scene().turn(20, 10);
  const Eigen::Vector3d turned = scene().view_pose().eye;
  EXPECT_GT((turned - first).norm(), 1);
  show(made_.make(193, 109));
  scene().fit();
  EXPECT_EQ(scene().view_pose().eye, turned);
  scene().set_viewpoint(Viewpoint::kCamera);
  EXPECT_LT((scene().view_pose().eye - first).norm(), 1e-6);
  const double before = scene().window_pixel_of(middle_)->x;
  scene().shift(0.25, 0);
  EXPECT_NEAR(scene().window_pixel_of(middle_)->x - before, 0.25 * kSize.height, 3);
  scene().dolly(2);
  EXPECT_GT(scene().window_pixel_of({900, 269.5})->x, kSize.width)
      << "twice as near, twice as large";
}

TEST_F(FaceSceneTest, TwoScenesMayLookAlike) {
  show(made_.make(50, 40));
  auto other = OffscreenScene::create(kSize).value();
  other.scene().show(made_.make(50, 40), MadeSurface::camera());
  scene().turn(15, 5);
  other.scene().set_view_pose(scene().view_pose());
  EXPECT_EQ(other.scene().view_pose().eye, scene().view_pose().eye);
}

TEST_F(FaceSceneTest, TheTopologyIsMadeOnceForAGrid) {
  for (int i = 0; i < 10; ++i) {
    made_.deepest_mm = 0.1 * i;
    show(made_.make(60, 40));
  }
  EXPECT_EQ(scene().topologies(), 1);
  show(made_.make(61, 40));
  EXPECT_EQ(scene().topologies(), 2);
}

TEST_F(FaceSceneTest, ForgetsAFace) {
  const cv::Mat empty = renderer_.image();
  show(made_.make(60, 40));
  scene().set_marks({{middle_}, {}});
  EXPECT_GT(cv::countNonZero(cv::Mat(empty != renderer_.image()).reshape(1)), 1000);
  scene().forget();
  EXPECT_EQ(cv::countNonZero(cv::Mat(empty != renderer_.image()).reshape(1)), 0);
  EXPECT_FALSE(scene().pixel_at(400, 250));
}

class GripperSceneTest : public FaceSceneTest {
 protected:
  /// Turned so that nothing stands along an axis.
  const RigidTransform first_{rotation_from_rpy_deg({20, -35, 50}), {60, -20, 15}};
  const RigidTransform second_{rotation_from_rpy_deg({-10, 120, 5}), {-250, 40, 30}};
  void show_both(const FaceSurface& first, const FaceSurface& second) {
    scene().show_in_gripper({first, MadeSurface::camera(), first_},
                            {second, MadeSurface::camera(), second_});
  }
  /// Looks as a camera does that sits there.
  void look_with(const RigidTransform& camera) {
    scene().set_view_pose(
        {camera.point({0, 0, -200}), camera.point({0, 0, 100}), camera.direction({0, -1, 0})});
  }
};

TEST_F(GripperSceneTest, PlacesTheFirstFaceWhereItsCameraSits) {
  made_.slope = 0.4;
  show(made_.make(65, 37));
  scene().set_view_pose({{30, -200, -250}, {0, 0, 100}, {0, -1, 0}});
  const std::vector<cv::Point2d> pixels{{50, 60}, middle_, {900, 500}};
  std::vector<cv::Point2d> places;
  for (const auto& pixel : pixels) places.push_back(*scene().window_pixel_of(pixel));
  const cv::Mat alone = renderer_.image();
  show_both(made_.make(65, 37), made_.make(65, 37));
  scene().set_view_pose(
      {first_.point({30, -200, -250}), first_.point({0, 0, 100}), first_.direction({0, -1, 0})});
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto place = scene().window_pixel_of(pixels[i]);
    ASSERT_TRUE(place);
    EXPECT_LT(cv::norm(*place - places[i]), 0.01) << "a turned gripper seen with the same turn";
    const auto pixel = scene().pixel_at(place->x, place->y);
    ASSERT_TRUE(pixel);
    EXPECT_LT(cv::norm(*pixel - pixels[i]), 0.5);
  }
}

TEST_F(GripperSceneTest, ShowsBothFacesOnOneScale) {
  MadeSurface other = made_;
  other.deepest_mm = 0.4;
  const FaceSurface first = made_.make(97, 55), second = other.make(97, 55);
  show_both(first, second);
  const cv::Point centre(kSize.width / 2, kSize.height / 2);
  look_with(first_);
  EXPECT_LT(distance(renderer_.image().at<cv::Vec3b>(centre), of(depth_colour(0.8))), 12);
  look_with(second_);
  EXPECT_LT(distance(renderer_.image().at<cv::Vec3b>(centre), of(depth_colour(0.4))), 12);
  EXPECT_FALSE(scene().pixel_at(centre.x, centre.y)) << "points lie on the first finger";
  show(first);
  EXPECT_EQ(scene().pixel_at(1, 1), std::nullopt);
  scene().set_viewpoint(Viewpoint::kCamera);
  EXPECT_LT(distance(at(middle_), of(depth_colour(0.8))), 12)
      << "alone again, in its camera's frame";
}

TEST_F(GripperSceneTest, LooksSoThatBothAreInSight) {
  const FaceSurface face = made_.make(65, 37);
  for (const Viewpoint viewpoint :
       {Viewpoint::kTilted, Viewpoint::kCamera, Viewpoint::kOutside, Viewpoint::kSide}) {
    show_both(face, face);
    scene().set_viewpoint(viewpoint);
    const auto first = scene().window_pixel_of(middle_);
    // The other way round the second one's place can be asked for.
    const ViewPose look = scene().view_pose();
    scene().show_in_gripper({face, MadeSurface::camera(), second_},
                            {face, MadeSurface::camera(), first_});
    scene().set_view_pose(look);
    const auto second = scene().window_pixel_of(middle_);
    for (const auto& place : {first, second}) {
      ASSERT_TRUE(place);
      EXPECT_GT(place->x, 0);
      EXPECT_LT(place->x, kSize.width - 78);
      EXPECT_GT(place->y, 0);
      EXPECT_LT(place->y, kSize.height);
    }
  }
}

TEST_F(GripperSceneTest, DrawsTheGapAndTheFrames) {
  const FaceSurface face = made_.make(65, 37);
  show_both(face, face);
  const cv::Mat bare = renderer_.image();
  scene().set_gap(NearestPoints{first_.point({0, 0, 100}), second_.point({0, 0, 100})});
  EXPECT_GT(cv::countNonZero(cv::Mat(bare != renderer_.image()).reshape(1)), 300);
  scene().set_gap(std::nullopt);
  EXPECT_EQ(cv::countNonZero(cv::Mat(bare != renderer_.image()).reshape(1)), 0);
  options_.camera = true;
  scene().set_options(options_);
  if (const char* folder = std::getenv("ALLTACT_LOOK_AT"))
    cv::imwrite(std::string(folder) + "/gripper.png", renderer_.image());
  EXPECT_GT(cv::countNonZero(cv::Mat(bare != renderer_.image()).reshape(1)), 600);
}

/// Red, green, blue.
cv::Vec3d colour_of(const FaceMesh& mesh, int column, int row) {
  cv::Vec3d colour;
  mesh.data()->GetPointData()->GetScalars()->GetTuple(row * mesh.drawn_mm().cols + column,
                                                      colour.val);
  return colour;
}

TEST(FaceMesh, PlacesTrianglesAndLightsAFlatFaceInFull) {
  MadeSurface made;
  made.slope = 0.5;
  made.deepest_mm = 0;
  const FaceSurface surface = made.make(20, 10);
  FaceMesh mesh;
  mesh.update(surface.untouched_mm, surface.depth_mm, 1, surface.depth_mm, {});
  EXPECT_EQ(mesh.data()->GetNumberOfPoints(), 200);
  EXPECT_EQ(mesh.data()->GetNumberOfPolys(), 2 * 19 * 9);
  double at[3];
  mesh.data()->GetPoint(0, at);
  EXPECT_NEAR(at[2], made.z_mm + made.slope * at[0], 1e-4);
  const MapColour plain = viridis(0);
  EXPECT_LT(cv::norm(colour_of(mesh, 0, 0) - cv::Vec3d(plain.red, plain.green, plain.blue)), 2)
      << "however it slopes";
}

/// Five hundredths of a millimetre in a face of one colour.
TEST(FaceMesh, LightsAPressFromTheLeftAndLaysAShadowAroundIt) {
  MadeSurface made;
  made.deepest_mm = 0.05;
  made.radius_mm = 1.5;
  const FaceSurface surface = made.make(481, 271);
  FaceMesh mesh;
  mesh.update(surface.untouched_mm, surface.depth_mm, 1, cv::Mat(surface.depth_mm * 0 + 0.5F), {});
  const double flat = cv::norm(colour_of(mesh, 40, 40));
  constexpr int kStep = 5;  // vertices a mm
  EXPECT_GT(cv::norm(colour_of(mesh, 240 - kStep, 135)), 1.05 * flat);
  EXPECT_LT(cv::norm(colour_of(mesh, 240 + kStep, 135)), 0.9 * flat);
  for (const int side : {-1, 1})
    for (const cv::Point at : {cv::Point(240 + side * 9, 135), cv::Point(240, 135 + side * 9)}) {
      EXPECT_LT(cv::norm(colour_of(mesh, at.x, at.y)), 0.96 * flat) << at;
      EXPECT_GT(cv::norm(colour_of(mesh, at.x, at.y)), 0.6 * flat) << at;
    }
}

TEST(FaceMesh, MarksWhatIsBeyondTheScale) {
  const FaceSurface surface = MadeSurface().make(20, 10);
  FaceMesh mesh;
  const cv::Mat flat = cv::Mat::zeros(surface.depth_mm.size(), CV_32FC1);
  for (const auto& [mm, colour] : {std::pair{0.81F, kAboveScale}, {-0.21F, kBelowScale}}) {
    mesh.update(surface.untouched_mm, flat, 1, flat + mm, depth_scale(0.8));
    EXPECT_LT(cv::norm(colour_of(mesh, 5, 5) - cv::Vec3d(colour.red, colour.green, colour.blue)), 3)
        << mm;
  }
}

TEST(FaceGrid, PixelsAndPlacesAreEachOthersInverse) {
  const FaceSurface surface = MadeSurface().make(33, 21);
  for (const cv::Point2d place :
       {cv::Point2d(0, 0), cv::Point2d(32, 20), cv::Point2d(3.25, 7.75)}) {
    const cv::Vec2f pixel = pixel_between(surface.pixel, place);
    const auto back = grid_position_of(surface, {pixel[0], pixel[1]});
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->x, place.x, 1e-4);
    EXPECT_NEAR(back->y, place.y, 1e-4);
  }
  EXPECT_FALSE(grid_position_of(surface, {-1, 100}));
  EXPECT_FALSE(grid_position_of(surface, {100, 542}));
}

TEST(FaceGrid, RaysMeetTheNearerOfTwoFolds) {
  // A sheet folded over itself: z = 10 and z = 20 above the same x.
  cv::Mat sheet(2, 3, CV_32FC3);
  for (int j = 0; j < 2; ++j) {
    sheet.at<cv::Vec3f>(j, 0) = cv::Vec3f(0, float(j), 20);
    sheet.at<cv::Vec3f>(j, 1) = cv::Vec3f(10, float(j), 15);
    sheet.at<cv::Vec3f>(j, 2) = cv::Vec3f(0, float(j), 10);
  }
  const auto place = first_hit(sheet, {2, 0.5, 0}, {0, 0, 1});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, 1.8, 1e-6);
  EXPECT_NEAR(place->y, 0.5, 1e-6);
  EXPECT_FALSE(first_hit(sheet, {2, 0.5, 0}, {0, 0, -1})) << "behind";
  EXPECT_FALSE(first_hit(sheet, {2, 3, 0}, {0, 0, 1})) << "beside";
}

}  // namespace
}  // namespace alltact::test
