// Everything that is measured in one frame.
#pragma once

#include "core/base/message.h"
#include "core/finger/force_model.h"
#include "core/image/frame.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/contact/finger_contact.h"
#include "core/sensing/contact/push.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/depth/light_gain.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/reference/reference_image.h"

#include <chrono>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Duration of each step, milliseconds of wall clock.
struct StepTimes {
  double prepare = 0, edges = 0, global = 0, markers = 0, reference = 0, local = 0, contact = 0;
  double force = 0;
  double total = 0;
};

/// Everything that is measured in one frame. Fields that could not be estimated are empty;
/// `problems` holds the reasons.
struct FrameResult {
  FramePtr frame;
  cv::Mat grey;  ///< the oriented image, reduced and averaged as the settings require
  /// Binning factor from the frame to `grey`; everything else is in pixels of `grey`
  int reduced_by = 1;
  int mesh_step_px = 1;  ///< from one vertex of its surface to the next
  std::optional<FaceEdges> edges;
  std::optional<FaceShape> shape;  ///< with the twist that the markers show
  std::optional<Markers> markers;
  MarkerMethod marker_method =
      MarkerMethod::kBlobs;  ///< that found them, where there is a reference
  /// Unnumbered dots of a finger without a reference recording, in frames whose two rows are not
  /// even.
  std::vector<Dot> dots;
  std::optional<Reference> reference;
  std::optional<Difference> difference;  ///< of a finger without a mapping
  std::optional<DepthMap> depth;         ///< of a finger with a mapping
  std::optional<Push> push;
  std::vector<ContactRegion> regions;
  /// Empty where the frame could not be compared with its reference, and without a face.
  std::optional<ContactEvidence> evidence;
  /// Of this frame's evidence and of the frames before (FingerContactTracker); only of a finger
  /// with a reference.
  std::optional<FingerContact> contact;
  std::optional<Force> force;  ///< of a finger with a force model
  StepTimes times_ms;
  std::vector<Message> problems;
};

/// Whether something presses into the contact face (ContactEvidence); empty also without evidence.
[[nodiscard]] inline std::optional<bool> is_face_pressed(const FrameResult& result) {
  return result.evidence ? result.evidence->is_face_pressed : std::nullopt;
}

/// 3D points of the contact face, CV_32FC3 (x, y, z in mm, camera frame), NaN without depth: p_CF =
/// p_LUF - (0, 0, d).
[[nodiscard]] cv::Mat contact_face_points_mm(const FrameResult& result, const Face& face);

/// The same points and their depth at every mesh_step_px-th column and row: the vertices of a
/// surface.
struct FaceVertices {
  cv::Mat points_mm;  ///< CV_32FC3
  cv::Mat depth_mm;   ///< CV_32FC1
};
[[nodiscard]] FaceVertices contact_face_vertices(const FrameResult& result, const Face& face);

// How long the steps of a frame take.

/// Writes the time since the last lap into a field of StepTimes.
class StopWatch {
 public:
  void lap(double& milliseconds) {
    const auto now = Clock::now();
    milliseconds = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
  }
  void total(double& milliseconds) const {
    milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

// Faults of a full frame, as sentences for a person.

/// Checks an image before anything is found in it. Three faults are reported:
/// - black: its brightest thousandth lies below 16 grey levels;
/// - saturated: over a third of it lies at kClippedFrom of grey_range.h or above;
/// - blank: all of it lies within 3 neighbouring grey levels, except a thousandth on either side.
///   Noise alone spans more.
/// Reads every eighth pixel of every eighth row. grey: CV_8UC1.
[[nodiscard]] std::optional<Message> image_fault(const cv::Mat& grey);

/// True when `now` is `before` read again and not the camera's next frame. Either both share their
/// memory, or both state an origin and agree in origin, name, number and time of capture (a
/// recording's frame that was read twice).
[[nodiscard]] bool is_same_frame(const Frame& before, const Frame& now);

/// True when both images agree to the last grey level, which no two exposures do.
[[nodiscard]] bool is_same_image(const cv::Mat& a, const cv::Mat& b);

/// Faults of a measured face:
/// - its end is hidden, however little of it;
/// - more than a fiftieth of it is saturated, or unknown to its reference;
/// - it is far darker (by half) or brighter (by a third) than its reference recording;
/// - more than a tenth of it is brighter than its reference, so that it is another finger's face.
///   Contacts only darken.
[[nodiscard]] std::vector<Message> face_faults(const FlagFractions& shares, const LightGain& light);

}  // namespace alltact
