// Camera files of other programs: the same pixels as in OpenCV, or a sentence.
#include "core/camera/camera_file.h"
#include "tests/support/foreign_cameras.h"
#include "tests/support/temporary_folder.h"

#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

namespace alltact {
namespace {

using test::foreign_files;
using test::ForeignCamera;
using test::ForeignFile;
using test::some_foreign_camera;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

Result<CameraFile> parsed(const std::string& text, const std::string& name = "") {
  return parse_camera(text, "camera.txt", name);
}

std::string refusal(const std::string& text, const std::string& name = "") {
  const auto camera = parsed(text, name);
  return camera ? "read: " + camera->understood.english() : camera.error().sentence();
}

const ForeignFile& file_of(const std::vector<ForeignFile>& files, const std::string& name) {
  for (const ForeignFile& file : files)
    if (file.name == name) return file;
  throw std::runtime_error(name);
}

std::string text_of(const std::string& format, const ForeignCamera& camera = {}) {
  return file_of(foreign_files(camera), format).text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from << "\n" << text;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Random cameras with so many coefficients, seeded by their number.
std::vector<ForeignCamera> random_cameras(std::size_t terms, bool is_fisheye) {
  std::mt19937 random(static_cast<unsigned>(100 * terms) + (is_fisheye ? 1U : 0U));
  std::uniform_real_distribution<double> unit(-1, 1);
  const std::vector<double> scale =
      is_fisheye ? std::vector<double>{0.05, 0.02, 0.01, 0.002}
                 : std::vector<double>{0.2,  0.05, 0.003, 0.003, 0.02,  0.15,
                                       0.05, 0.01, 0.003, 0.002, 0.003, 0.002};
  std::vector<ForeignCamera> cameras;
  for (int i = 0; i < 12; ++i) {
    ForeignCamera c;
    c.width = 640 + 8 * static_cast<int>(random() % 80);
    c.height = 480 + 8 * static_cast<int>(random() % 60);
    c.fx = c.width * (is_fisheye ? 0.55 : 0.8 + 0.3 * unit(random));
    c.fy = c.fx * (1 + 0.03 * unit(random));
    c.cx = c.width / 2.0 + 30 * unit(random);
    c.cy = c.height / 2.0 + 30 * unit(random);
    c.is_fisheye = is_fisheye;
    c.terms.clear();
    for (std::size_t k = 0; k < terms; ++k) c.terms.push_back(scale[k] * unit(random));
    cameras.push_back(c);
  }
  return cameras;
}

/// Largest distance between the pixels of a grid over the image and where OpenCV projects our rays
/// of them, and between OpenCV's projection and ours.
double worst_px(const Camera& camera, const ForeignCamera& c) {
  const cv::Matx33d k(c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1);
  const cv::Vec3d none(0, 0, 0);
  double worst = 0;
  for (int row = 0; row <= 12; ++row)
    for (int column = 0; column <= 16; ++column) {
      const Eigen::Vector2d pixel(column * (c.width - 1) / 16.0, row * (c.height - 1) / 12.0);
      const auto ray = camera.unproject(pixel);
      if (!ray) return 1e9;
      const Eigen::Vector3d at = ray->point_at(75);
      const std::vector<cv::Point3d> point{{at.x(), at.y(), at.z()}};
      std::vector<cv::Point2d> seen;
      if (c.is_fisheye)
        cv::fisheye::projectPoints(point, seen, none, none, k, c.terms);
      else
        cv::projectPoints(point, none, none, k, c.terms, seen);
      const auto ours = camera.project(at);
      if (!ours) return 1e9;
      const Eigen::Vector2d theirs(seen[0].x, seen[0].y);
      worst = std::max({worst, (theirs - pixel).norm(), (theirs - *ours).norm()});
    }
  return worst;
}

TEST(ForeignCamera, ProjectsAsOpenCvDoesOverTheWholePicture) {
  for (const auto& [terms, is_fisheye] :
       {std::pair{std::size_t{4}, false}, {5, false}, {8, false}, {12, false}, {4, true}}) {
    int read = 0;
    double worst = 0;
    for (const ForeignCamera& c : random_cameras(terms, is_fisheye))
      for (const ForeignFile& file : foreign_files(c)) {
        const auto camera = parsed(file.text);
        if (!camera && camera.error().kind == ErrorKind::kFoldedLens) continue;
        ASSERT_TRUE(camera) << file.name << "\n" << camera.error().sentence() << "\n" << file.text;
        const auto made = Camera::create(camera->parameters);
        ASSERT_TRUE(made);
        const double here = worst_px(*made, c);
        EXPECT_LT(here, 1e-6) << file.name << "\n" << file.text;
        worst = std::max(worst, here);
        const std::size_t bar = file.understood.find('|');
        EXPECT_THAT(camera->understood.english(), StartsWith(file.understood.substr(0, bar)));
        EXPECT_THAT(camera->understood.english(), EndsWith(file.understood.substr(bar + 1)));
        EXPECT_EQ(camera->parameters.width_px, c.width);
        EXPECT_EQ(camera->parameters.height_px, c.height);
        ++read;
      }
    std::printf("%zu coefficients%s: %d files, at most %.2g px from OpenCV\n", terms,
                is_fisheye ? " of a fisheye" : "", read, worst);
    EXPECT_GE(read, 80);
  }
}

TEST(ForeignCamera, SaysInOneLineWhatItUnderstood) {
  EXPECT_EQ(refusal(text_of("ros")),
            "read: read as a ROS camera_info file: 960 x 540 px, fx 523.9, plumb_bob with 5 "
            "coefficients");
  EXPECT_EQ(refusal("model: fisheye\nsize: [960, 540]\nfx: 523.9\nfy: 523.9\ncx: 479.5\ncy: 269.5\n"
                    "distortion: [0.01]\n"),
            "read: read as a camera file of this program: 960 x 540 px, fx 523.9, fisheye with 1 "
            "coefficient");
}

TEST(ForeignCamera, PixelsBeginAtTheCentreOfTheFirst) {
  ForeignCamera c;
  c.cx = 479.5, c.cy = 269.5;  // the middle of 960 x 540 px
  for (const ForeignFile& file : foreign_files(c)) {
    const auto camera = parsed(file.text);
    ASSERT_TRUE(camera) << file.name << camera.error().sentence();
    EXPECT_NEAR(camera->parameters.cx_px, 479.5, 1e-12) << file.name;
    EXPECT_NEAR(camera->parameters.cy_px, 269.5, 1e-12) << file.name;
  }
}

TEST(ForeignCamera, CoefficientsThatAreZeroBeyondWhatIsHeldAreRead) {
  ForeignCamera c;
  const std::vector<double> five = c.terms;
  for (const std::size_t count : {8U, 12U, 14U}) {
    c.terms = five;
    c.terms.resize(count);
    const auto camera = parsed(text_of("opencv_yaml", c));
    ASSERT_TRUE(camera) << camera.error().sentence();
    EXPECT_EQ(camera->parameters.distortion, five);
  }
  c.terms.assign(5, 0);
  const auto pinhole = parsed(text_of("ros", c));
  ASSERT_TRUE(pinhole);
  EXPECT_EQ(pinhole->parameters.model, CameraModel::kPinhole);
  c.terms = five;
  c.terms.resize(14);
  c.terms[12] = 0.01;
  EXPECT_THAT(refusal(text_of("opencv_yaml", c)), HasSubstr("a tilted sensor"));
}

TEST(ForeignCamera, AFileThatIsCutOffIsNeverAnotherCameraInSilence) {
  for (const bool is_fisheye : {false, true}) {
    ForeignCamera c;
    if (is_fisheye) c.is_fisheye = true, c.fx = c.fy = 400, c.terms.resize(4);
    for (const ForeignFile& file : foreign_files(c)) {
      const auto entire = parsed(file.text);
      ASSERT_TRUE(entire) << file.name << entire.error().sentence();
      int refused = 0;
      for (std::size_t length = 0; length < file.text.size(); ++length) {
        const auto cut = parsed(file.text.substr(0, length));
        if (!cut) {
          ++refused;
          continue;
        }
        // A mark of a fisheye that is cut off leaves a guess, with a warning.
        ASSERT_TRUE(cut->parameters == entire->parameters || !cut->warnings.empty())
            << file.name << "\n"
            << file.text.substr(0, length);
      }
      EXPECT_GT(refused, 100) << file.name;
    }
  }
}

TEST(ForeignCamera, KeysOfBothKindsAreReadWhereTheyAgree) {
  const std::string ros = text_of("ros");
  const std::string followed =
      "model: brown\nsize: [960, 540]\nfx: 523.889715\nfy: 523.936555\ncx: 479.491722\n"
      "cy: 269.501157\n";
  const auto camera = parsed(ros + followed);
  ASSERT_TRUE(camera) << camera.error().sentence();
  EXPECT_EQ(camera->parameters.distortion, some_foreign_camera().terms);
  EXPECT_THAT(refusal(ros + followed + "distortion: []\n"),
              HasSubstr("contradicts 'distortion_coefficients'"));
  EXPECT_THAT(refusal(ros + replaced(followed, "fx: 523.8", "fx: 524.8")),
              HasSubstr("fx: contradicts 'camera_matrix'"));
  EXPECT_THAT(refusal(ros + replaced(followed, "[960", "[480")),
              HasSubstr("size: contradicts 'image_width'"));
  EXPECT_THAT(refusal(ros + "model: fisheye\n"), HasSubstr("contradicts 'distortion_model'"));
  for (const char* key : {"distortion_coefficients: [-0.03, 0.02, 0, 0, 0]", "dist_coeffs: [0.1]",
                          "k1: -0.03", "distortion_model: plumb_bob", "radial: [-0.03, 0.02]"})
    EXPECT_THAT(refusal(followed + key + "\n"), HasSubstr("is a key of other programs")) << key;
}

TEST(ForeignCamera, UnknownKeysOfTheOwnFormatAreNamed) {
  const std::string own =
      "model: brown\nsize: [960, 540]\nfx: 523.9\nfy: 523.9\ncx: 479.5\ncy: 269.5\n"
      "distortion: [-0.03, 0.02]\n";
  const auto camera = parsed(own +
                             "serial: 12\nport: {gap_mm: 3, plate_mm: 2, plate_index: 1.5, "
                             "medium_index: 1.4, glue: clear}\n");
  ASSERT_TRUE(camera) << camera.error().sentence();
  ASSERT_EQ(camera->warnings.size(), 1U);
  EXPECT_EQ(camera->warnings[0].english(),
            "camera.txt: keys that are not known here were not read: serial, port.glue.");
  EXPECT_TRUE(parsed(own)->warnings.empty());
}

TEST(ForeignCamera, FourNumbersWithoutAModelAreAGuessThatIsNamed) {
  const std::string text =
      "K: [523.9, 0, 479.5, 0, 523.9, 269.5, 0, 0, 1]\nimage_size: [960, 540]\n"
      "D: [-0.03, 0.02, 0.001, 0.0]\n";
  const auto guess = parsed(text);
  ASSERT_TRUE(guess) << guess.error().sentence();
  EXPECT_EQ(guess->parameters.model, CameraModel::kBrown);
  ASSERT_EQ(guess->warnings.size(), 1U);
  EXPECT_THAT(guess->warnings[0].english(), HasSubstr("add 'distortion_model: fisheye'"));
  const auto named = parsed(text + "distortion_model: fisheye\n");
  ASSERT_TRUE(named) << named.error().sentence();
  EXPECT_EQ(named->parameters.model, CameraModel::kFisheye);
  EXPECT_TRUE(named->warnings.empty());
}

TEST(ForeignCamera, OrientationAndWindowMayBeAdded) {
  const auto camera = parsed(text_of("ros") +
                             "orientation: rotate_90\nport: {gap_mm: 3, plate_mm: 2, "
                             "plate_index: 1.5, medium_index: 1.4}\n");
  ASSERT_TRUE(camera) << camera.error().sentence();
  EXPECT_EQ(camera->parameters.orientation, Orientation::kRotate90);
  EXPECT_EQ(camera->parameters.port, (FlatPort{3, 2, 1.5, 1.4}));
  EXPECT_THAT(refusal(text_of("ros") + "orientation: up\n"),
              HasSubstr("orientation: 'up' is not known here. Try: none, flip_u"));
}

TEST(ForeignCamera, OneOfSeveralIsChosenByItsName) {
  const std::string one =
      "  camera_model: pinhole\n  distortion_coeffs: [-0.03, 0.02, 0, 0.001]\n"
      "  distortion_model: radtan\n  intrinsics: [523.9, 523.9, 479.5, 269.5]\n"
      "  resolution: [960, 540]\n";
  const std::string two = "cam0:\n" + one + "cam1:\n" + replaced(one, "[523.9", "[600.5");
  EXPECT_EQ(refusal(two),
            "camera.txt: holds 2 cameras: cam0, cam1. Try: one of them by its name: "
            "'camera.txt#cam0'.");
  EXPECT_EQ(parsed(two, "cam1")->parameters.fx_px, 600.5);
  EXPECT_EQ(parsed("cam0:\n" + one)->parameters.fx_px, 523.9);
  EXPECT_THAT(refusal(two, "cam7"), HasSubstr("holds no camera 'cam7'"));
  const test::TemporaryFolder folder;
  std::ofstream(folder / "chain.yaml") << two;
  const auto loaded = load_camera((folder / "chain.yaml").string() + "#cam1");
  ASSERT_TRUE(loaded) << loaded.error().sentence();
  EXPECT_EQ(loaded->parameters.fx_px, 600.5);

  const std::string stereo =
      "%YAML:1.0\n---\nimage_size: [960, 540]\n"
      "M1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 523.9, 0., 479.5, 0., "
      "523.9, 269.5, 0., 0., 1. ]\nD1: [-0.03, 0.02, 0, 0, 0.01]\n"
      "M2: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 601.5, 0., 479.5, 0., "
      "523.9, 269.5, 0., 0., 1. ]\nD2: [-0.03, 0.02, 0, 0, 0.02]\n";
  EXPECT_THAT(refusal(stereo), HasSubstr("holds 2 cameras: 1, 2"));
  EXPECT_EQ(parsed(stereo, "2")->parameters.fx_px, 601.5);
  EXPECT_EQ(parsed(stereo, "2")->parameters.distortion[4], 0.02);
}

struct BadFile {
  std::string text, sentence;  ///< the latter is part of the refusal
};

TEST(ForeignCamera, BadInputIsRefusedWithASentence) {
  const std::string ros = text_of("ros"), opencv = text_of("opencv_yaml"), mrcal = text_of("mrcal"),
                    photon = text_of("photonvision"), matlab = text_of("matlab_struct");
  ForeignCamera four;
  four.terms.resize(4);
  const std::string kalibr = text_of("kalibr", four), message = text_of("ros_message");
  const std::vector<BadFile> bad{
      {replaced(ros, "523.889715", ".nan"), "camera_matrix: holds '.nan', which is not a finite"},
      {replaced(ros, "523.889715", ".inf"), "holds '.inf', which is not a finite"},
      {replaced(ros, "523.889715", "1e999"), "holds '1e999', which is not a finite"},
      {replaced(ros, "523.889715", "-523.9"), "camera_matrix (fx): must be a number from"},
      {replaced(ros, "523.889715", "0"), "camera_matrix (fx): must be a number from"},
      {replaced(ros, "523.889715", "524a"), "holds '524a'"},
      {replaced(ros, "523.889715", "523,889715"), "holds 10 numbers, not 3 x 3"},
      {replaced(ros, "-0.034062", "nan"), "distortion_coefficients: holds 'nan'"},
      {replaced(ros, "cols: 5", "cols: 4"), "holds 5 numbers, not 1 x 4"},
      {replaced(ros, "image_width: 960\n", ""), "the image size is missing"},
      {replaced(ros, "image_width: 960", "image_width: 960\nwidth: 961"),
       "width: contradicts 'image_width'"},
      {replaced(replaced(ros, "image_width: 960", "image_width: 540"), "image_height: 540",
                "image_height: 960"),
       "the principal point 479.5, 269.5 is the middle of 960 x 540 px, not of 540 x 960"},
      {replaced(ros, "data: [-0.034062, 0.026819, 0.000826, -0.00272, 0.0013]", "data:"),
       "distortion_coefficients: holds no number"},
      {ros.substr(0, ros.find("distortion_model")) + "d", "d: holds no number"},
      {replaced(ros, "image_width: 960", "image_width: 400"),
       "the principal point 479.5, 269.5 lies outside the image of 400 x 540 px"},
      {replaced(ros, "image_width: 960", "image_width: 0"), "0 x 540 is no image size"},
      {replaced(ros, "image_width: 960", "image_width: -960"), "-960 x 540 is no image size"},
      {replaced(ros, "image_width: 960", "image_width: 960.5"), "960.5 x 540 is no image size"},
      {ros + "image_size: [640, 480]\n", "image_size: contradicts 'image_width'"},
      {ros + "image_width: 961\n", "'image_width' is given twice"},
      {ros + "K: [500, 0, 479.5, 0, 500, 269.5, 0, 0, 1]\n", "contradicts"},
      {ros + "---\nimage_width: 3\n", "holds more than one document"},
      {replaced(ros, "plumb_bob", "double_sphere"),
       "distortion_model: the lens model 'double_sphere' cannot be expressed here"},
      {replaced(ros, "plumb_bob", "equidistant"), "has 5 coefficients; a fisheye has 4"},
      {replaced(ros, "523.936555", "0.5, 523.936555"), "holds 10 numbers"},
      {replaced(ros, "523.889715, 0", "523.889715, 2.5"), "has a skew of 2.5"},
      {replaced(ros, "0, 0, 1]", "0, 0, 2]"), "is no camera matrix"},
      {"image_width: 960\nimage_height: 540\ncamera_matrix: [0, 0, 0, 0, 0, 0, 0, 0, 0]\n"
       "distortion_model: plumb_bob\nD: []\n",
       "is 0: this camera is not calibrated"},
      {replaced(message, "binning_x: 0", "binning_x: 2"), "bins its images by 2"},
      {replaced(message, "x_offset: 0", "x_offset: 16"), "sends a part of its image"},
      {replaced(opencv, "dt: d\n   data: [", "dt: d\n   dato: ["), "is a block without 'data'"},
      {"camera_matrix: [523.9, 0, 479.5, 0, 523.9, 269.5, 0, 0, 1]\nimage_size: [960, 540]\n",
       "the distortion coefficients are missing"},
      {"distortion_coefficients: [0.1, 0, 0, 0, 0]\nimage_size: [960, 540]\n",
       "the camera matrix is missing"},
      {"camera_matrix: [523.9, 0, 479.5, 0, 523.9, 269.5, 0, 0, 1]\nimage_size: [960, 540]\n"
       "dist_coeffs: [0.1, 0.2]\n",
       "has 2 coefficients; OpenCV knows 4, 5, 8, 12 and 14"},
      {replaced(kalibr, "pinhole", "omni"), "the lens model 'omni' cannot be expressed here"},
      {replaced(kalibr, "pinhole", "eucm"), "the lens model 'eucm'"},
      {replaced(kalibr, "pinhole", "ds"), "the lens model 'ds'"},
      {replaced(kalibr, "radtan", "fov"), "the lens model 'fov'"},
      {replaced(kalibr, "resolution: [960, 540]", "resolution: [960]"),
       "resolution: holds 1 numbers instead of 2"},
      {replaced(kalibr, "-0.034062, ", ""), "holds 3 numbers instead of 4"},
      {replaced(mrcal, "LENSMODEL_OPENCV5", "LENSMODEL_CAHVOR"),
       "the lens model 'LENSMODEL_CAHVOR' cannot be expressed here. Try: convert it with "
       "mrcal-convert-lensmodel"},
      {replaced(mrcal, "LENSMODEL_OPENCV5",
                "LENSMODEL_SPLINED_STEREOGRAPHIC_order=3_Nx=30_Ny=18_fov_x_deg=170"),
       "the lens model 'LENSMODEL_SPLINED_STEREOGRAPHIC"},
      {replaced(mrcal, "LENSMODEL_OPENCV5", "LENSMODEL_OPENCV8"),
       "intrinsics: holds 9 numbers instead of 12"},
      {replaced(photon, "LENSMODEL_OPENCV", "LENSMODEL_SPLINED_STEREOGRAPHIC"), "the lens model"},
      {replaced(photon, "\"width\":960.0,", ""), "resolution: holds no width and height"},
      {replaced(photon, "distCoeffs", "other"), "'distCoeffs' is missing"},
      {replaced(photon, "\"resolution\"", "\"lensmodel\":\"x\",\"resolution\""),
       "'lensmodel' is given twice"},
      {replaced(matlab, "[540,960]", "[]"), "the image size is missing"},
      {replaced(matlab, "[[523.889715,0,0],[0,", "[[523.889715,0,0],[3,"), "has a skew of 3"},
      {"/**:\n  ros__parameters:\n    camera:\n      model: brown\n      width_px: 960\n",
       "holds parameters of a ROS node"},
      {"name: x\nvalues: [1, 2]\n", "holds no camera that is known here"},
      {std::string("MATLAB 5.0 MAT-file, Platform: GLNXA64\0\0", 40), "is a MAT-file"},
      {std::string("PK\x03\x04zip", 7), "is a packed archive"},
      {std::string("K: 1\0", 5), "is no text file"},
      {"<?xml version=\"1.0\"?>\n<opencv_storage>\n<camera_matrix>", "this is not XML"},
      {replaced(text_of("opencv_xml"), "<rows>3", "<rows>4"), "holds 9 numbers, not 4 x 3"},
  };
  for (const BadFile& file : bad) {
    const std::string sentence = refusal(file.text);
    EXPECT_THAT(sentence, HasSubstr(file.sentence)) << file.text;
    EXPECT_THAT(sentence, StartsWith("camera.txt")) << file.text;
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace alltact
