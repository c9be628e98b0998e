#include "calibration/export/export_finger.h"

#include "calibration/export/export_texts.h"
#include "core/base/atomic_file.h"
#include "core/recording/journal.h"
#include "tests/support/cameras.h"
#include "tests/support/program.h"
#include "tests/support/python.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <yaml-cpp/yaml.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

/// With numbers that have no short decimal form.
Finger whole_finger() {
  Finger finger;
  finger.name = "left-07: \"blue\"";
  finger.camera = pinhole();
  finger.camera.model = CameraModel::kBrown;
  finger.camera.fx_px = 523.9 + 1.0 / 3;
  finger.camera.distortion = {-0.1 / 3, 1e-7};
  finger.camera.orientation = Orientation::kRotate180;
  finger.face.width_mm = 24;
  finger.face.layer_mm = 1.5;
  finger.markers.per_row = 2;
  MappingParameters mapping;
  mapping.along = MappingAlong::kNormal;
  mapping.x_max = 0.5;
  mapping.chebyshev = {2.0, 1.0 / 3};
  finger.mapping = mapping;
  finger.reference = ReferenceFiles{"reference.mkv", "reference.csv", ""};
  finger.contact = ContactSettings{2.5, {{101.5, 40}, {205, 41}, {102, 500}, {206, 499.5}}};
  return finger;
}

/// As `whole_finger` lies on a disk, with a reference that nobody reads here.
fs::path saved(const TemporaryFolder& folder, const Finger& finger) {
  fs::create_directories(folder / "finger/presses");
  const Status saved = finger.save(folder / "finger");
  EXPECT_TRUE(saved.ok()) << (saved.ok() ? "" : saved.error().sentence());
  test::write_text(folder / "finger/reference.mkv", std::string(100'000, 'v'));
  test::write_text(folder / "finger/reference.csv", "frame,number\n");
  test::write_text(folder / "finger/presses/press_0.png", "picture");
  test::write_text(folder / "finger/presses/.notes", "hidden");
  return folder / "finger";
}

const std::vector<ExportForm> kAll = {ExportForm::kOpencv, ExportForm::kRos, ExportForm::kJson,
                                      ExportForm::kZip};

TEST(ExportFinger, RosCameraInfoHoldsTheMatricesThatItsReadersWant) {
  const Finger finger = whole_finger();
  const auto text = ros_camera_info(finger);
  ASSERT_TRUE(text.ok());
  EXPECT_THAT(*text, HasSubstr("\norientation: rotate_180\n"));
  const YAML::Node info = YAML::Load(*text);
  EXPECT_EQ(info["image_width"].as<int>(), 960);
  EXPECT_EQ(info["image_height"].as<int>(), 540);
  EXPECT_EQ(info["camera_name"].as<std::string>(), "left_07___blue_");
  EXPECT_EQ(info["distortion_model"].as<std::string>(), "plumb_bob");
  const auto numbers = [&](const char* key, int rows, int cols) {
    EXPECT_EQ(info[key]["rows"].as<int>(), rows) << key;
    EXPECT_EQ(info[key]["cols"].as<int>(), cols) << key;
    return info[key]["data"].as<std::vector<double>>();
  };
  const double fx = finger.camera.fx_px, fy = finger.camera.fy_px;
  EXPECT_THAT(numbers("camera_matrix", 3, 3), ElementsAre(fx, 0, 479.5, 0, fy, 269.5, 0, 0, 1));
  EXPECT_THAT(numbers("distortion_coefficients", 1, 5), ElementsAre(-0.1 / 3, 1e-7, 0, 0, 0));
  EXPECT_THAT(numbers("rectification_matrix", 3, 3), ElementsAre(1, 0, 0, 0, 1, 0, 0, 0, 1));
  EXPECT_THAT(numbers("projection_matrix", 3, 4),
              ElementsAre(fx, 0, 479.5, 0, 0, fy, 269.5, 0, 0, 0, 1, 0));
  Finger fisheye = finger;
  fisheye.camera.model = CameraModel::kFisheye;
  const YAML::Node other = YAML::Load(*ros_camera_info(fisheye));
  EXPECT_EQ(other["distortion_model"].as<std::string>(), "equidistant");
  EXPECT_EQ(other["distortion_coefficients"]["data"].size(), 4U);
}

/// ROS takes a list only when all of it is of one kind, and a node's parameter has one kind.
void expect_real_numbers(const YAML::Node& list) {
  for (const auto& item : list)
    EXPECT_NE(item.Scalar().find_first_of(".e"), std::string::npos) << item.Scalar();
}

TEST(ExportFinger, RosParametersSayTheUnitsAndAllDigits) {
  const Finger finger = whole_finger();
  const auto text = ros_parameters(finger);
  ASSERT_TRUE(text.ok());
  const YAML::Node all = YAML::Load(*text)["/**"]["ros__parameters"];
  EXPECT_EQ(all["finger_name"].as<std::string>(), finger.name);
  EXPECT_EQ(all["camera"]["orientation"].as<std::string>(), "rotate_180");
  EXPECT_EQ(all["face"]["kind"].as<std::string>(), "fin_ray");
  EXPECT_EQ(all["face"]["width_mm"].Scalar(), "24.0");
  EXPECT_EQ(all["face"]["layer_mm"].as<double>(), 1.5);
  const YAML::Node mapping = all["mapping"];
  EXPECT_EQ(mapping["along"].as<std::string>(), "normal");
  EXPECT_THAT(mapping["chebyshev_mm"].as<std::vector<double>>(), ElementsAre(2.0, 1.0 / 3));
  const auto made = Mapping::create(*finger.mapping);
  const auto powers = mapping["powers_mm"].as<std::vector<double>>();
  double depth = 0;
  for (std::size_t k = powers.size(); k-- > 0;) depth = 0.3 * depth + powers[k];
  EXPECT_NEAR(depth, made->depth_mm(0.3), 1e-12);
  for (const char* key : {"domain", "chebyshev_mm", "powers_mm"}) expect_real_numbers(mapping[key]);
  EXPECT_THAT(all["contact"]["rest_markers_v_px"].as<std::vector<double>>(),
              ElementsAre(40, 41, 500, 499.5));
  expect_real_numbers(all["contact"]["rest_markers_v_px"]);
  Finger bare = finger;
  bare.mapping.reset();
  bare.contact.reset();
  const YAML::Node less = YAML::Load(*ros_parameters(bare))["/**"]["ros__parameters"];
  EXPECT_FALSE(less["mapping"]);
  EXPECT_FALSE(less["contact"]);
}

TEST(ExportFinger, JsonHoldsWhatALoaderNeeds) {
  const Finger finger = whole_finger();
  const auto json = nlohmann::json::parse(*calibration_json(finger));
  EXPECT_EQ(json.at("camera").at("orientation"), "rotate_180");
  EXPECT_EQ(json.at("camera").at("fx_px").get<double>(), finger.camera.fx_px);
  EXPECT_EQ(json.at("mapping").at("chebyshev_mm").at(1).get<double>(), 1.0 / 3);
  EXPECT_EQ(json.at("mapping").at("along"), "normal");
  EXPECT_EQ(json.at("reference").at("video"), "reference.mkv");
  EXPECT_EQ(json.at("reference").at("markers"), "reference.csv");
  EXPECT_EQ(calibration_json(finger)->find("null"), std::string::npos) << "every number is finite";
  Finger windowed = finger;
  windowed.camera.port = FlatPort{1, 2, 1.49, 1.41};
  EXPECT_EQ(nlohmann::json::parse(*calibration_json(windowed)).at("camera").at("port").at("gap_mm"),
            1.0);
  for (const auto& none : {opencv_camera(windowed), ros_camera_info(windowed)}) {
    ASSERT_FALSE(none.ok());
    EXPECT_THAT(none.error().sentence(), HasSubstr("behind a window has no camera matrix"));
  }
}

TEST(ExportFinger, TellsWhereTheCameraSitsInTheGripper) {
  Finger finger = whole_finger();
  EXPECT_FALSE(nlohmann::json::parse(*calibration_json(finger)).contains("gripper_from_camera"));
  // A quarter turn about z: x of the camera is y of the gripper.
  finger.gripper_from_camera = RigidTransform{
      Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ())), {1.5, -20, 80.25}};
  const auto json = nlohmann::json::parse(*calibration_json(finger)).at("gripper_from_camera");
  const YAML::Node ros =
      YAML::Load(*ros_parameters(finger))["/**"]["ros__parameters"]["gripper_from_camera"];
  const double half = std::sqrt(0.5);
  const std::vector<double> place{1.5, -20, 80.25}, turn{half, 0, 0, half};
  EXPECT_EQ(json.at("translation_mm").get<std::vector<double>>(), place);
  EXPECT_EQ(ros["translation_mm"].as<std::vector<double>>(), place);
  for (std::size_t i = 0; i < turn.size(); ++i) {
    EXPECT_NEAR(json.at("rotation_wxyz").at(i).get<double>(), turn[i], 1e-15);
    EXPECT_NEAR(ros["rotation_wxyz"][i].as<double>(), turn[i], 1e-15);
  }
  expect_real_numbers(ros["translation_mm"]);
}

TEST(ExportFinger, TheZipHoldsEveryFileOfTheFinger) {
  const TemporaryFolder folder;
  const Finger finger = whole_finger();
  const fs::path from = saved(folder, finger);
  std::vector<fs::path> written;
  const Status status = export_finger(FingerSnapshot::of(from, finger).value(), kAll,
                                      folder / "out", Job(), &written);
  ASSERT_TRUE(status.ok()) << status.error().sentence();
  EXPECT_EQ(written.size(), 5U);
  const test::ProgramRun run = test::run_shell(std::string(test::kPython) + " -m zipfile -e '" +
                                               (folder / "out/finger.zip").string() + "' '" +
                                               (folder / "unpacked").string() + "'");
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(test::contents_of(folder / "unpacked/finger"), test::contents_of(from));
  EXPECT_EQ(test::text_of(folder / "unpacked/calibration.json"),
            test::text_of(folder / "out/calibration.json"));
  EXPECT_TRUE(Finger::load(folder / "unpacked/finger").ok());
}

TEST(ExportFinger, TheZipLeavesOutTakesThatTheFingerDoesNotUse) {
  const TemporaryFolder folder;
  const Finger finger = whole_finger();
  const fs::path from = saved(folder, finger);
  ASSERT_TRUE(unused_recordings(finger, from).empty());
  const auto before = test::contents_of(from);
  for (const char* take : {"bending_2.mkv", "bending_1.mkv"}) {
    ASSERT_TRUE(write_file_atomically(from / take, "a take"));
    ASSERT_TRUE(write_file_atomically(journal_of(from / take), "its journal"));
  }
  EXPECT_EQ(unused_recordings(finger, from),
            (std::vector<fs::path>{from / "bending_1.mkv", from / "bending_2.mkv"}));
  ASSERT_TRUE(export_finger(FingerSnapshot::of(from, finger).value(), {ExportForm::kZip},
                            folder / "out", Job(), nullptr));
  const test::ProgramRun run = test::run_shell(std::string(test::kPython) + " -m zipfile -e '" +
                                               (folder / "out/finger.zip").string() + "' '" +
                                               (folder / "unpacked").string() + "'");
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(test::contents_of(folder / "unpacked/finger"), before);
  // A video that nobody recorded here is none of them.
  ASSERT_TRUE(write_file_atomically(from / "notes.mkv", "somebody's own"));
  EXPECT_EQ(unused_recordings(finger, from).size(), 2U);
}

TEST(ExportFinger, WhatAZipCannotHoldIsRefusedBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  const Finger finger = whole_finger();
  const fs::path from = saved(folder, finger);
  const auto refused = [&](const fs::path& to, const char* why) {
    std::vector<fs::path> written;
    const Status status =
        export_finger(FingerSnapshot::of(from, finger).value(), kAll, to, Job(), &written);
    ASSERT_FALSE(status.ok());
    EXPECT_THAT(status.error().sentence(), HasSubstr(why));
    EXPECT_TRUE(written.empty());
    EXPECT_FALSE(fs::exists(to / "calibration.json"));
  };
  refused(from, "the finger's own folder");
  refused(from / "export/here", "the finger's own folder");
  fs::create_directory(folder / "elsewhere");
  fs::create_directory_symlink(folder / "elsewhere", from / "link");
  refused(folder / "out", "link to another folder");
  fs::remove(from / "link");
  fs::create_symlink("/dev/null", from / "device");
  refused(folder / "out", "neither a file nor a folder");
  fs::remove(from / "device");
  EXPECT_TRUE(export_finger(FingerSnapshot::of(from, finger).value(), kAll, folder / "finger-out",
                            Job(), nullptr)
                  .ok());
}

TEST(ExportFinger, StoppedItTellsWhatIsThere) {
  const TemporaryFolder folder;
  const Finger finger = whole_finger();
  const fs::path from = saved(folder, finger);
  Job* running = nullptr;
  Job job([&](double, const Message&) { running->request_stop(); });
  running = &job;
  std::vector<fs::path> written;
  const Status status =
      export_finger(FingerSnapshot::of(from, finger).value(), kAll, folder / "out", job, &written);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().sentence(), HasSubstr("stopped"));
  EXPECT_EQ(written.size(), 4U);
  EXPECT_EQ(test::contents_of(folder / "out").size(), 4U);
}

}  // namespace
}  // namespace alltact
