// Untouched pictures of the finger in all its poses, and the one that fits the pose now.
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
#include "core/sensing/reference/reference_picture.h"
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

/// How the reference of a frame is made from the recording.
enum class ReferenceMethod {
  /// The recording's rest frame for all poses, pixel by pixel, as sensors on a rigid base do it
  /// (DTact): for comparison.
  kSingle = 1,
  kNearest,  ///< the one frame whose markers lie nearest, laid over the skin as it lies now
  kLocal,    ///< local linear regression over the nearest frames: closer by several times
};

/// The reference picture of a frame.
struct Reference {
  ReferencePicture picture;  ///< grey levels; NaN where a frame used shows no face
  int frame = -1;            ///< number of the nearest frame in the recording
  double distance_px = 0;    ///< mean distance of the seen markers to that frame's
  bool known_pose = true;    ///< false: further away than the recording's own frames are apart
  bool by_shape = false;     ///< no marker was seen: the face's shape alone tells the pose
  double noise_gain = 1;     ///< standard deviation of the reference's noise / that of one frame
  /// What the recording says that references are off by (reference_error.h), over cells of its
  /// grid; empty for a single picture.
  cv::Mat relative_sd;
  double error_factor = 1;  ///< by what relative_sd is to be multiplied in this pose
  /// The same where not all of the nearest frames show the skin, and others have to tell.
  double outer_error_factor = 1;
  std::vector<HiddenColumn> hidden;  ///< of the face, that the frame does not show

  /// Few recorded frames are near this pose.
  [[nodiscard]] bool is_sparse() const {
    constexpr double kFarBeyond = 3.0;  // times what is usual for the recording
    return error_factor > kFarBeyond;
  }
};

class ReferenceLibrary {
 public:
  /// Reads the recording a finger names, reduced as the finger is (reduced_finger.h): its memory
  /// falls with that. Only the face is kept of every frame, laid over the rest
  /// frame's (the one in the middle of all poses) so that each point of the skin stays at its
  /// place; when that would pass `memory_limit_bytes` only a covering subset of the frames
  /// (farthest-point sampling in marker space). While somebody holds what was read from the same
  /// files for the same camera and face, that is shared, not read again; what another program read
  /// is taken from the user's cache (kept_faces.h), with the same bytes. Errors: files missing or
  /// unreadable, table and video disagree.
  static Result<ReferenceLibrary> load(const FingerSnapshot& finger,
                                       const Job& job,
                                       std::size_t memory_limit_bytes = std::size_t{512} << 20);

  /// The same from frames and a table that are at hand, both at the pixels of `camera`; `video` is
  /// where they are said to come from.
  static Result<ReferenceLibrary> from_frames(const FrameOfRecording& frame,
                                              std::size_t frame_count,
                                              const std::filesystem::path& video,
                                              const MarkerTable& table,
                                              const Finger& finger,
                                              const Camera& camera,
                                              const Job& job,
                                              std::size_t memory_limit_bytes = std::size_t{512}
                                                                               << 20);

  /// The one untouched picture of a flat sensor.
  static Result<ReferenceLibrary> single(const cv::Mat& grey);

  [[nodiscard]] std::size_t frame_count() const;
  [[nodiscard]] std::size_t memory_bytes() const;
  /// nullptr for a single picture.
  [[nodiscard]] const MarkerModel* marker_model() const;
  /// nullptr for a single picture, and where the recording does not tell of one.
  [[nodiscard]] const TwistModel* twist_model() const;
  /// For frames in which the markers are not found. nullptr for a single picture, for a finger
  /// without markers, and where the recording does not tell it.
  [[nodiscard]] const ShapePoses* shape_poses() const;

  /// Index into the library (not the video) of the frame with the least mean distance over the
  /// markers that are seen, by brute force; and that distance.
  struct Nearest {
    int index;
    double distance_px;
  };
  [[nodiscard]] Nearest nearest(const Markers& markers,
                                const std::vector<char>& without = {}) const;

  /// The same distance to where the markers lie in the frames that kLocal combines, taken together
  /// with their weights: how near the pose is to what its reference shows. Where all is one frame,
  /// that of nearest().
  [[nodiscard]] double combined_distance_px(const Markers& markers,
                                            const std::vector<char>& without = {}) const;

  /// The number in the video of each frame, ascending; by index.
  [[nodiscard]] const std::vector<int>& frame_numbers() const;

  /// The reference for a pose, laid over the skin as `shape` and `markers` say that it lies
  /// (face_chart.h). Both are ignored by a single picture. Where no marker is seen, their sd_px
  /// tells how much less sure the reference is. `without` marks frames (by index) that take no
  /// part, as if they had not been recorded; empty: all do. At least two must.
  ///
  /// kLocal: local linear regression over the `neighbours` frames nearest in the finger's modes of
  /// motion. known_pose: distance_px is at most three times the median distance of the recording's
  /// frames to their nearest other, and at least 1.5 px is always allowed. kSingle: frame and
  /// distance_px are those of the rest frame, and nothing is laid over.
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
