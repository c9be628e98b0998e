#include "calibration/export/export_texts.h"
#include "core/yaml/yaml_writer.h"

#include <cctype>

#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

/// `who`: "OpenCV".
Status has_camera_matrix(const CameraParameters& camera, const std::string& who) {
  Message which;
  if (camera.model == CameraModel::kOrthographic) which = en::say("an orthographic camera");
  if (camera.port) which = en::say("a camera behind a window");
  if (which.empty()) return {};
  return Error{en::say("{} has no camera matrix, so {} has no form for it", which, who),
               "",
               en::say("json, or zip for the whole finger")};
}

/// Missing coefficients are zero.
std::vector<double> all_coefficients(const CameraParameters& camera) {
  std::vector<double> all = camera.distortion;
  all.resize(camera.model == CameraModel::kFisheye ? 4 : 5, 0.0);
  return all;
}

/// ROS allows letters, digits and '_' only.
std::string ros_name(const std::string& name) {
  std::string plain = name;
  for (char& letter : plain)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  return plain;
}

std::string ros_matrix(std::string_view key, int rows, const std::vector<double>& data) {
  return fmt::format("{}:\n  rows: {}\n  cols: {}\n  data: {}\n",
                     key,
                     rows,
                     data.size() / static_cast<std::size_t>(rows),
                     yaml_numbers(data));
}

}  // namespace

Result<std::string> opencv_camera(const Finger& finger) {
  const CameraParameters& camera = finger.camera;
  if (Status status = has_camera_matrix(camera, "OpenCV"); !status) return status.error();
  const cv::Mat matrix = (cv::Mat_<double>(3, 3) << camera.fx_px,
                          0,
                          camera.cx_px,
                          0,
                          camera.fy_px,
                          camera.cy_px,
                          0,
                          0,
                          1);
  // Pixels are those after orientation, the centre of the top-left one at (0, 0), as in OpenCV.
  cv::FileStorage file(".yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  file << "camera_name" << finger.name;
  file << "image_width" << camera.width_px << "image_height" << camera.height_px;
  file << "camera_matrix" << matrix;
  const bool is_fisheye = camera.model == CameraModel::kFisheye;
  file << "distortion_model" << std::string(is_fisheye ? "fisheye" : "plumb_bob");
  file << "distortion_coefficients" << cv::Mat(all_coefficients(camera), true).t();
  return file.releaseAndGetString();
}

Result<std::string> ros_camera_info(const Finger& finger) {
  const CameraParameters& camera = finger.camera;
  if (Status status = has_camera_matrix(camera, "ROS"); !status) return status.error();
  const double fx = camera.fx_px, fy = camera.fy_px, cx = camera.cx_px, cy = camera.cy_px;
  std::string text;
  if (camera.orientation != Orientation::kNone)
    text = fmt::format("# Of the camera's picture after this turn: {}\n",
                       to_string(camera.orientation));
  text += fmt::format("image_width: {}\nimage_height: {}\ncamera_name: {}\n",
                      camera.width_px,
                      camera.height_px,
                      yaml_text(ros_name(finger.name)));
  text += ros_matrix("camera_matrix", 3, {fx, 0, cx, 0, fy, cy, 0, 0, 1});
  text += fmt::format("distortion_model: {}\n",
                      camera.model == CameraModel::kFisheye ? "equidistant" : "plumb_bob");
  text += ros_matrix("distortion_coefficients", 1, all_coefficients(camera));
  text += ros_matrix("rectification_matrix", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1});
  text += ros_matrix("projection_matrix", 3, {fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0});
  return text;
}

}  // namespace alltact
