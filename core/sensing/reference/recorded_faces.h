// The faces of a recording, warped to a common grid.
#pragma once

#include "core/finger/finger.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/markers/twist_model.h"
#include "core/sensing/reference/edge_positions.h"
#include "core/sensing/reference/face_cache.h"
#include "core/sensing/reference/face_image.h"
#include "core/sensing/reference/marker_table.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Returns a frame of a recording by its number in the video: CV_8UC1, oriented as the finger's
/// camera has it.
using RecordingFrameReader = std::function<Result<cv::Mat>(std::size_t number)>;

/// A recording whose images are read one after the other.
struct RecordingInput {
  const RecordingFrameReader& frame;
  std::size_t count;                   ///< of the video's frames
  const std::filesystem::path& video;  ///< for messages: where the frames come from
  const MarkerTable& table;
};

struct RecordedFaces {
  FaceGrid grid;            ///< of the rest frame, the one in the middle of all poses
  SkinPositions positions;  ///< in the grid

  std::vector<std::size_t> retained;  ///< rows of the marker table, ascending
  std::vector<FaceImage> faces;       ///< of these rows, on the grid
  std::size_t bytes = 0;              ///< of faces

  std::vector<Eigen::Index> seen;  ///< rows in which the face was found, whether retained or not
  std::vector<EdgeCurves> edges;   ///< of these
  std::vector<FaceChart> charts;   ///< of these, registered to the rest frame's
  /// Of some of these, spread over the recording, from which the finger's twist is learnt.
  std::vector<TwistModel::Pose> poses;
  /// Edges of the faces in `seen`, for the cache. Empty for more than kMaxCachedFrames frames, and
  /// for faces from the cache.
  std::vector<FoundFace> found;
};

/// Where the faces exceed `limit_bytes`, only a covering subset is retained (farthest-point
/// sampling in marker space). Errors: an image that cannot be read; fewer than 2 faces found;
/// stopped.
[[nodiscard]] Result<RecordedFaces> read_recorded_faces(const RecordingInput& frames,
                                                        const Finger& finger,
                                                        const Camera& camera,
                                                        std::size_t limit_bytes,
                                                        const Job& job);

/// The same from the cache, without images; nullopt where the cache does not fit the table and the
/// camera.
[[nodiscard]] std::optional<RecordedFaces> recorded_faces_from_cache(FaceCache cache,
                                                                     const MarkerTable& table,
                                                                     const Finger& finger,
                                                                     const Camera& camera);

}  // namespace alltact
