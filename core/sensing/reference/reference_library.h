// Reference images of the finger in all its poses, and the reference for the current pose.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/marker_model.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/markers/twist_model.h"
#include "core/sensing/reference/face_chart.h"
#include "core/sensing/reference/marker_table.h"
#include "core/sensing/reference/recorded_faces.h"
#include "core/sensing/reference/recorded_poses.h"
#include "core/sensing/reference/reference_image.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Main memory for the faces of a recording: 125 of a camera of 1920 x 1080 pixels.
inline constexpr std::size_t kRecordedFaces_bytes = std::size_t{160} << 20;

class ReferenceLibrary {
 public:
  /// Reads the recording that a finger names, reduced as the finger is (finger_store.h), which
  /// reduces its memory as well. Only the face of every frame is stored, warped to the rest frame
  /// (the one in the middle of all poses), so that each point of the skin has a fixed position.
  /// Where that would exceed `memory_limit_bytes`, only a covering subset of the frames is retained
  /// (farthest-point sampling in marker space).
  /// Libraries of the same files, camera and face share their data while any of them exists. Data
  /// that another process read is loaded from the user's cache, with the same bytes.
  /// Errors: files missing or unreadable; table and video disagree.
  static Result<ReferenceLibrary> load(const FingerSnapshot& finger, const Job& job,
                                       std::size_t memory_limit_bytes = kRecordedFaces_bytes);

  /// The same from given frames, at the pixels of `camera` as is their table.
  static Result<ReferenceLibrary> from_frames(
      const RecordingInput& frames, const Finger& finger, const Camera& camera, const Job& job,
      std::size_t memory_limit_bytes = kRecordedFaces_bytes);

  /// The same from faces that were read before. table: of their rows. video: for messages.
  static Result<ReferenceLibrary> from_faces(RecordedFaces faces, const MarkerTable& table,
                                             const Finger& finger, const Camera& camera,
                                             const std::filesystem::path& video);

  /// The one reference image of a flat sensor.
  static Result<ReferenceLibrary> single(const cv::Mat& grey);

  [[nodiscard]] std::size_t frame_count() const;
  [[nodiscard]] std::size_t memory_bytes() const;
  /// nullptr for a single image.
  [[nodiscard]] const MarkerModel* marker_model() const;
  /// nullptr for a single image, and where the recording does not show the twist.
  [[nodiscard]] const TwistModel* twist_model() const;
  /// For frames in which the markers are not found. nullptr for a single image, for a finger
  /// without markers, and where the recording shows too little.
  [[nodiscard]] const ShapePoses* shape_poses() const;

  /// Index into the library (not the video) of the frame with the smallest mean distance over the
  /// seen markers, and that distance.
  [[nodiscard]] NearestFrame nearest(const Markers& markers,
                                     const std::vector<char>& without = {}) const;

  /// The same distance to the weighted mean of the markers in the frames that kLocal combines: how
  /// near the pose is to its reference. Equals nearest() where there is only one frame.
  [[nodiscard]] double combined_distance_px(const Markers& markers,
                                            const std::vector<char>& without = {}) const;

  /// The number in the video of each frame, ascending; by index.
  [[nodiscard]] const std::vector<int>& frame_numbers() const;

  /// The reference for a pose, warped to the skin by `shape` and `markers` (face_chart.h). A single
  /// image ignores both. Where no marker is seen, their sd_px increases the error of the reference.
  /// `without` marks frames (by index) to exclude, as if they had not been recorded; empty: none.
  /// At least two must remain.
  ///
  /// kLocal: local linear regression over the `neighbours` frames nearest in the finger's modes of
  /// motion. known_pose: distance_px is at most three times the median distance of the recording's
  /// frames to their nearest other, and 1.5 px is always allowed. kSingle: frame and distance_px
  /// are those of the rest frame, and nothing is warped.
  [[nodiscard]] Reference reference_for(const Markers& markers, const FaceShape& shape,
                                        ReferenceMethod method,
                                        const std::vector<char>& without = {},
                                        int neighbours = kPoseNeighbours) const;

 private:
  struct Content;
  explicit ReferenceLibrary(std::shared_ptr<const Content> content)
      : content_(std::move(content)) {}
  std::shared_ptr<const Content> content_;
};

// The reference image of a flat sensor.

/// The reference image that the finger names, converted like frames of this snapshot. Errors: it
/// names none; the file cannot be read; its size is not the camera's.
[[nodiscard]] Result<cv::Mat> flat_reference(const FingerSnapshot& snapshot);

}  // namespace alltact
