// The ground truth of a simulated frame.
#pragma once

#include "core/finger/finger.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace alltact {

// Ground truth of what presses on the finger in one frame, and how hard.

/// Camera frame, mm, N. `along` and `across` are positions on the finger: along it from the face's
/// base, and across from its middle line.
struct ContactTruth {
  std::string name;  ///< of the effect: "ball#2"
  PushedFace face = PushedFace::kContact;
  double along_mm = 0, across_mm = 0;
  double depth_mm = 0;  ///< maximum press depth along z; 0: the layer is not indented
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();  ///< of the undeformed outer side there
  /// Unit vector into the finger: the direction of the push.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  /// Rotation of a body with a direction: from the finger's length towards +y, about the normal.
  std::optional<double> angle_deg;
  std::optional<Eigen::Vector3d> force_N;  ///< on the finger; empty where the scene gives no force
  std::optional<Eigen::Isometry3d> camera_from_object;
};

/// The requested parts of a frame's truth.
enum class TruthDetail {
  kAll,
  kWithoutImages,  ///< images stay empty: costs next to nothing
};

/// From the same analytic geometry as the image, never from its pixels. Camera frame, mm, px.
struct Truth {
  cv::Mat depth_mm;  ///< CV_32FC1, the image's size, along z; NaN off the face
  cv::Mat
      untouched_z_mm;  ///< CV_32FC1, z of the locally undeformed face above the pixel's view point
  cv::Mat view_z_mm;   ///< CV_32FC1, z of the view face; NaN off the face
  struct Dot {
    double u, v;
    bool visible;
  };
  /// Centres of the dots in the image, by number; empty without markers.
  std::vector<Dot> markers;
  /// depth_mm: maximum press depth along z.
  struct Ball {
    Eigen::Vector3d centre_mm;
    double radius_mm;
    double depth_mm;
  };
  std::optional<Ball> ball;            ///< the first one in the scene
  std::vector<Ball> balls;             ///< all presses of this frame, in the scene's order
  std::vector<ContactTruth> contacts;  ///< all contacts of the finger, in the scene's order
  std::map<std::string, double> pose;  ///< degrees of freedom of the finger, by name: q1_mm, ...
  /// Everything except the images, as one JSON object (a frame's entry in truth.json).
  [[nodiscard]] std::string to_json() const;
};

/// The surface at a pixel's centre.
enum class PixelLabel : std::uint8_t { kNothing = 0, kFace, kSide, kDot, kFoldOverDot };

/// Ground truth for every pixel, in the image's size, from the same geometry and light as the
/// image, at the frame's own time.
struct TruthMaps {
  cv::Mat contact;  ///< CV_8UC1: 1 + number in Truth::contacts; 0: no contact
  /// CV_32FC3: unit normal of the deformed outer side, away from the camera, camera frame; NaN off
  /// the face.
  cv::Mat normal;
  /// CV_32FC1, grey levels: the light that would reach the sensor if nothing pressed into the face,
  /// the finger's pose and the lamps being the same.
  cv::Mat untouched_grey;
  cv::Mat labels;  ///< CV_8UC1, Seen
};

// A simulated frame after transport from the camera.

struct SentFrame {
  cv::Mat grey;
  /// The packet; null unless the scene has mjpeg.
  std::shared_ptr<const std::vector<std::uint8_t>> jpeg;
};

/// Whether and when a frame arrives.
struct Arrival {
  bool is_dropped = false;  ///< it never arrives
  double late_ms = 0;       ///< delay
};

}  // namespace alltact
