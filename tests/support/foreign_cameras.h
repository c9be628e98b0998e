// Camera files as other programs write them, of one camera in OpenCV's numbers.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <opencv2/core.hpp>

namespace alltact::test {

struct ForeignCamera {
  int width = 960, height = 540;
  double fx = 523.889715, fy = 523.936555, cx = 479.491722, cy = 269.501157;
  /// OpenCV's order: 4, 5, 8 or 12 numbers; of a fisheye 4.
  std::vector<double> terms{-0.034062, 0.026819, 0.000826, -0.00272, 0.0013};
  bool is_fisheye = false;
};

inline ForeignCamera some_foreign_camera() { return {}; }

struct ForeignFile {
  std::string name;  ///< of the format
  std::string text;
  std::string understood;  ///< begin and end of the sentence about it
};

namespace foreign {

inline std::string list(const std::vector<double>& numbers, const char* between = ", ") {
  return fmt::format("{}", fmt::join(numbers, between));
}

inline std::string lines(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format("  - {}\n", number);
  return text;
}

inline std::vector<double> matrix(const ForeignCamera& c) {
  return {c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1};
}

inline std::string nested(const std::vector<double>& m) {
  return fmt::format("[[{}, {}, {}], [{}, {}, {}], [{}, {}, {}]]", m[0], m[1], m[2], m[3], m[4],
                     m[5], m[6], m[7], m[8]);
}

inline std::string ros_model(const ForeignCamera& c) {
  return c.is_fisheye ? "equidistant" : c.terms.size() <= 5 ? "plumb_bob" : "rational_polynomial";
}

/// `numbers` writes a list as the value of `data:`.
template <class Numbers>
std::string ros(const ForeignCamera& c, const Numbers& numbers) {
  const auto block = [&](const char* key, int rows, const std::vector<double>& data) {
    return fmt::format("{}:\n  rows: {}\n  cols: {}\n  data:{}", key, rows,
                       data.size() / static_cast<std::size_t>(rows), numbers(data));
  };
  return fmt::format("image_width: {}\nimage_height: {}\ncamera_name: narrow_stereo\n", c.width,
                     c.height) +
         block("camera_matrix", 3, matrix(c)) +
         fmt::format("distortion_model: {}\n", ros_model(c)) +
         block("distortion_coefficients", 1, c.terms) +
         block("rectification_matrix", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}) +
         block("projection_matrix", 3,
               {0.9 * c.fx, 0, c.cx + 3, 0, 0, 0.8 * c.fy, c.cy - 2, 0, 0, 0, 1, 0});
}

inline std::string ros_message(const ForeignCamera& c) {
  return fmt::format(
      "header:\n  stamp:\n    sec: 12\n    nanosec: 5\n  frame_id: camera\nheight: {}\nwidth: {}\n"
      "distortion_model: {}\nd:\n{}k:\n{}r:\n{}p:\n{}binning_x: 0\nbinning_y: 0\n"
      "roi:\n  x_offset: 0\n  y_offset: 0\n  height: 0\n  width: 0\n  do_rectify: false\n---\n",
      c.height, c.width, ros_model(c), lines(c.terms), lines(matrix(c)),
      lines({1, 0, 0, 0, 1, 0, 0, 0, 1}),
      lines({0.9 * c.fx, 0, c.cx + 3, 0, 0, 0.8 * c.fy, c.cy - 2, 0, 0, 0, 1, 0}));
}

/// By OpenCV itself; `ending`: .yml, .xml or .json.
inline std::string opencv(const ForeignCamera& c, const std::string& ending) {
  cv::FileStorage file(ending, cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  file << "calibration_time"
       << "Fri 12 Jan 2024"
       << "image_width" << c.width << "image_height" << c.height << "board_width" << 9
       << "camera_matrix" << cv::Mat(matrix(c), true).reshape(1, 3) << "distortion_coefficients"
       << cv::Mat(c.terms, true) << "fisheye_model" << (c.is_fisheye ? 1 : 0)
       << "avg_reprojection_error" << 0.21;
  return file.releaseAndGetString();
}

inline std::string mrcal(const ForeignCamera& c) {
  return fmt::format(
      "# generated on 2024-01-12\n#   # Command: mrcal-calibrate-cameras\n{{\n"
      "    'lensmodel':  'LENSMODEL_OPENCV{}',\n\n"
      "    # intrinsics are fx,fy,cx,cy,distortion0,distortion1,....\n"
      "    'intrinsics': [ {}, {},],\n\n    'valid_intrinsics_region': [ [ 1., 2. ], ],\n"
      "    'extrinsics': [ 0., 0., 0., 0., 0., 0.,],\n    'imagersize': [ {}, {},],\n"
      "    'icam_intrinsics': 0,\n\n    # The measurements, packed\n"
      "    'optimization_inputs': b'P#Un{{x}}&k!`h, [0]: -Y',\n}}\n",
      c.terms.size(), list({c.fx, c.fy, c.cx, c.cy}), list(c.terms), c.width, c.height);
}

inline std::string photonvision(const ForeignCamera& c, const char* key) {
  return fmt::format(
      R"({{"resolution":{{"width":{}.0,"height":{}.0}},"cameraIntrinsics":{{"rows":3,"cols":3,)"
      R"("type":6,"data":[{}]}},"{}":{{"rows":1,"cols":{},"type":6,"data":[{}]}},)"
      R"("calobjectWarp":[0.0,0.0],"observations":[{{"locationInImageSpace":[{{"x":1.5,"y":2.0}}],)"
      R"("snapshotName":"img0.png"}}],"lensmodel":"LENSMODEL_OPENCV"}})",
      c.width, c.height, list(matrix(c)), key, c.terms.size(), list(c.terms));
}

/// Matlab's numbers: the centre of the top-left pixel is (1, 1).
inline ForeignCamera from_one(ForeignCamera c) {
  c.cx += 1, c.cy += 1;
  return c;
}

}  // namespace foreign

/// A file of each format that can express the camera.
inline std::vector<ForeignFile> foreign_files(const ForeignCamera& c) {
  using namespace foreign;
  const std::size_t count = c.terms.size();
  const std::string what = c.is_fisheye ? "fisheye"
                           : count <= 5 ? "plumb_bob"
                           : count <= 8 ? "rational_polynomial"
                                        : "thin_prism";
  const auto with = [&](const std::string& model) {
    return fmt::format("{} with {} coefficients", model, count);
  };
  const std::string of_ros = "read as a ROS camera_info file|" + with(ros_model(c)),
                    of_opencv = "read as an OpenCV calibration|" + with(what);
  const auto in_line = [](const char* between) {
    return
        [between](const std::vector<double>& data) { return " [" + list(data, between) + "]\n"; };
  };
  std::vector<ForeignFile> files{
      {"ros", ros(c, in_line(", ")), of_ros},
      {"ros_without_commas", ros(c, in_line(" ")), of_ros},
      {"ros_in_lines", ros(c, [](const std::vector<double>& data) { return "\n" + lines(data); }),
       of_ros},
      {"ros_message", ros_message(c), of_ros},
      {"opencv_yaml", opencv(c, ".yml"), of_opencv},
      {"opencv_xml", opencv(c, ".xml"), of_opencv},
      {"opencv_json", opencv(c, ".json"), of_opencv},
      {"python_json",
       fmt::format(R"({{"mtx": {}, "dist": [[{}]], "image_size": [{}, {}], "fisheye": {}}})",
                   nested(matrix(c)), list(c.terms), c.width, c.height, c.is_fisheye),
       of_opencv},
      {"python_yaml",
       fmt::format("K: {}\nD: [{}]\nimg_shape: [{}, {}]\nmodel: {}\n", nested(matrix(c)),
                   list(c.terms), c.height, c.width, c.is_fisheye ? "fisheye" : "pinhole"),
       of_opencv}};
  if (count == 4)
    files.push_back(
        {"kalibr",
         fmt::format("cam0:\n  cam_overlaps: []\n  camera_model: pinhole\n  distortion_coeffs: "
                     "[{}]\n  distortion_model: {}\n  intrinsics: [{}]\n  resolution: [{}, {}]\n"
                     "  rostopic: /cam0/image_raw\n",
                     list(c.terms), c.is_fisheye ? "equi" : "radtan",
                     list({c.fx, c.fy, c.cx, c.cy}), c.width, c.height),
         "read as a Kalibr camera chain|" + with(c.is_fisheye ? "equi" : "radtan")});
  if (c.is_fisheye) return files;
  files.push_back(
      {"mrcal", mrcal(c),
       "read as an mrcal camera model|" + with(fmt::format("LENSMODEL_OPENCV{}", count))});
  const std::string of_photonvision =
      "read as a PhotonVision calibration|" + with("LENSMODEL_OPENCV");
  files.push_back({"photonvision", photonvision(c, "distCoeffs"), of_photonvision});
  files.push_back({"photonvision_before", photonvision(c, "cameraExtrinsics"), of_photonvision});
  if (count > 5) return files;
  const ForeignCamera m = from_one(c);
  const std::string of_matlab =
      "read as Matlab's camera parameters|radial and tangential with 5 coefficients";
  const std::string radial =
      count == 4 ? list({c.terms[0], c.terms[1]}) : list({c.terms[0], c.terms[1], c.terms[4]});
  files.push_back(
      {"matlab_struct",
       fmt::format(R"({{"RadialDistortion":[{}],"TangentialDistortion":[{}],"WorldPoints":[[0,0]],)"
                   R"("EstimateSkew":false,"IntrinsicMatrix":[[{},0,0],[0,{},0],[{},{},1]],)"
                   R"("ImageSize":[{},{}]}})",
                   radial, list({c.terms[2], c.terms[3]}), m.fx, m.fy, m.cx, m.cy, m.height,
                   m.width),
       of_matlab});
  files.push_back(
      {"matlab_struct_now",
       fmt::format(R"({{"RadialDistortion":[{}],"TangentialDistortion":[{}],"K":{},)"
                   R"("ImageSize":[{},{}],"Version":{{"Major":10}}}})",
                   radial, list({c.terms[2], c.terms[3]}), nested(matrix(m)), m.height, m.width),
       of_matlab});
  files.push_back(
      {"matlab_printed",
       fmt::format("intrinsics = \n\n  cameraIntrinsics with properties:\n\n"
                   "             FocalLength: [{} {}]\n          PrincipalPoint: [{} {}]\n"
                   "               ImageSize: [{} {}]\n        RadialDistortion: [{}]\n"
                   "    TangentialDistortion: [{} {}]\n                    Skew: 0\n"
                   "                       K: [3x3 double]\n",
                   m.fx, m.fy, m.cx, m.cy, m.height, m.width, radial, c.terms[2], c.terms[3]),
       of_matlab});
  files.push_back(
      {"matlab_script",
       fmt::format("IntrinsicMatrix = [{} 0 0; 0 {} 0; {} {} 1];\nImageSize = [{} {}];\n"
                   "RadialDistortion = [{}];\nTangentialDistortion = [{} {}];\n",
                   m.fx, m.fy, m.cx, m.cy, m.height, m.width, radial, c.terms[2], c.terms[3]),
       of_matlab});
  return files;
}

}  // namespace alltact::test
