// The faces of a recording, each point of the skin at one place in all of them.
#pragma once

#include "core/finger/finger.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/markers/twist_model.h"
#include "core/sensing/reference/face_picture.h"
#include "core/sensing/reference/kept_faces.h"
#include "core/sensing/reference/marker_table.h"
#include "core/sensing/reference/pose_places.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A frame of a recording by its number in the video, CV_8UC1, oriented as the finger's camera has
/// it.
using FrameOfRecording = std::function<Result<cv::Mat>(std::size_t number)>;

/// A recording whose pictures are read one after the other.
struct RecordingToRead {
  const FrameOfRecording& frame;
  std::size_t count;                   ///< of the video's frames
  const std::filesystem::path& video;  ///< where they are said to come from
  const MarkerTable& table;
};

struct RecordedFaces {
  FaceGrid grid;      ///< of the rest frame, the one in the middle of all poses
  SkinPlaces places;  ///< in it

  std::vector<std::size_t> kept;   ///< rows of the marker table, ascending
  std::vector<FacePicture> faces;  ///< of these rows, on the grid
  std::size_t bytes = 0;           ///< of faces

  std::vector<Eigen::Index> seen;  ///< rows in which the face was found, whether kept or not
  std::vector<EdgeCurves> edges;   ///< of these
  std::vector<FaceChart> charts;   ///< of these, laid on the rest frame's
  /// Of some of these, spread over the recording: to learn the finger's twist from.
  std::vector<TwistModel::Pose> poses;
  /// What the faces were found by, of `seen`, for those who keep them; empty of more than
  /// kMostFramesKept, and of faces that were kept.
  std::vector<FoundFace> found;
};

/// Where the faces would pass `limit_bytes`, only a covering subset is kept (farthest-point
/// sampling in marker space). Errors: a picture that cannot be read; fewer than 2 faces found;
/// stopped.
[[nodiscard]] Result<RecordedFaces> read_recorded_faces(const RecordingToRead& frames,
                                                        const Finger& finger,
                                                        const Camera& camera,
                                                        std::size_t limit_bytes,
                                                        const Job& job);

/// The same from what was kept of it, without a picture; nullopt where that does not fit the table
/// and the camera.
[[nodiscard]] std::optional<RecordedFaces> recorded_faces_again(KeptFaces kept,
                                                                const MarkerTable& table,
                                                                const Finger& finger,
                                                                const Camera& camera);

}  // namespace alltact
