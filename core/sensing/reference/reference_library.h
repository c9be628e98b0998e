// Reference images of the finger in all its poses, and the reference for the current pose.
#pragma once

#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/markers/twist_model.h"
#include "core/sensing/reference/hidden_ends.h"
#include "core/sensing/reference/marker_table.h"
#include "core/sensing/reference/recorded_faces.h"
#include "core/sensing/reference/reference_image.h"
#include "core/sensing/reference/reference_weights.h"
#include "core/sensing/reference/shape_poses.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// How the reference of a frame is computed from the recording.
enum class ReferenceMethod {
  /// The recording's rest frame for all poses, pixel by pixel, as sensors on a rigid base do it
  /// (DTact): for comparison.
  kSingle = 1,
  kNearest,  ///< the one frame with the nearest markers, warped to the skin's current position
  kLocal,    ///< local linear regression over the nearest frames: several times closer
};

/// The reference image of a frame.
struct Reference {
  ReferenceImage image;    ///< grey levels; NaN where a frame used shows no face
  int frame = -1;          ///< number of the nearest frame in the recording
  double distance_px = 0;  ///< mean distance of the seen markers to that frame's
  bool known_pose = true;  ///< false: further away than the recording's own frames are apart
  bool by_shape = false;  ///< no marker was seen: the pose is estimated from the face's shape alone
  double noise_gain = 1;  ///< standard deviation of the reference's noise / that of one frame
  /// Relative error of references by the recording (reference_error.h), over cells of its grid;
  /// empty for a single image.
  cv::Mat relative_sd;
  double error_factor = 1;  ///< factor of relative_sd in this pose
  /// The same where not all of the nearest frames show the skin, and others replace them.
  double outer_error_factor = 1;
  std::vector<HiddenColumn> hidden;  ///< columns of the face that the frame does not show

  /// Few recorded frames are near this pose.
  [[nodiscard]] bool is_sparse() const {
    constexpr double kFarBeyond = 3.0;  // times what is typical of the recording
    return error_factor > kFarBeyond;
  }
};

class ReferenceLibrary {
 public:
  /// Reads the recording that a finger names, reduced as the finger is (reduced_finger.h), which
  /// reduces its memory as well. Only the face of every frame is stored, warped to the rest frame
  /// (the one in the middle of all poses), so that each point of the skin has a fixed position.
  /// Where that would exceed `memory_limit_bytes`, only a covering subset of the frames is retained
  /// (farthest-point sampling in marker space).
  /// Libraries of the same files, camera and face share their data while any of them exists. Data
  /// that another process read is loaded from the user's cache (face_cache.h), with the same bytes.
  /// Errors: files missing or unreadable; table and video disagree.
  static Result<ReferenceLibrary> load(const FingerSnapshot& finger,
                                       const Job& job,
                                       std::size_t memory_limit_bytes = std::size_t{512} << 20);

  /// The same from given frames and a table, both at the pixels of `camera`; `video` names their
  /// source in messages.
  static Result<ReferenceLibrary> from_frames(const RecordingFrameReader& frame,
                                              std::size_t frame_count,
                                              const std::filesystem::path& video,
                                              const MarkerTable& table,
                                              const Finger& finger,
                                              const Camera& camera,
                                              const Job& job,
                                              std::size_t memory_limit_bytes = std::size_t{512}
                                                                               << 20);

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
  /// seen markers, by brute force; and that distance.
  struct Nearest {
    int index;
    double distance_px;
  };
  [[nodiscard]] Nearest nearest(const Markers& markers,
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
  [[nodiscard]] Reference reference_for(const Markers& markers,
                                        const FaceShape& shape,
                                        ReferenceMethod method,
                                        const std::vector<char>& without = {},
                                        int neighbours = kPoseNeighbours) const;

 private:
  struct Content;
  explicit ReferenceLibrary(std::shared_ptr<const Content> content)
      : content_(std::move(content)) {}
  static Result<std::shared_ptr<const Content>> read(const std::filesystem::path& video_file,
                                                     const MarkerTable& table,
                                                     const FingerSnapshot& finger,
                                                     const std::optional<std::string>& made_from,
                                                     const Job& job,
                                                     std::size_t memory_limit_bytes);
  std::shared_ptr<const Content> content_;
};

}  // namespace alltact
