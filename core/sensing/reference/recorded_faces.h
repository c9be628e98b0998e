// The faces of a recording, warped to a common grid.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/markers/twist_model.h"
#include "core/sensing/reference/marker_table.h"
#include "core/sensing/reference/recorded_poses.h"
#include "core/sensing/reference/reference_image.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

// Cache of the faces of a recording: opening a finger again takes a tenth of the time.
//
// One file holds one recording's faces. It stores a key of its inputs, so that another recording,
// camera or program does not match, and a checksum to detect damage. The cache can be removed at
// any time; only speed is lost.

/// Recordings with more frames are not cached: they are thinned while they are read. The cache of
/// the other frames would be larger than the data read from it.
inline constexpr std::size_t kMaxCachedFrames = 4096;

/// A row of the marker table in which the face was found.
struct FoundFace {
  std::size_t row = 0;
  FaceEdges edges;
};

struct FaceCache {
  std::vector<FoundFace> found;       ///< rows ascending
  std::vector<std::size_t> retained;  ///< rows whose images follow, ascending
  std::vector<FaceImage> faces;       ///< on the grid of the recording, drift removed
  ReferenceError error;
};

/// Saves the faces in `folder` and removes all but the eight files that were used last. Does
/// nothing where the file would exceed 128 MB.
///   made_from: text key of all inputs
/// Errors: those of writing.
[[nodiscard]] Status save_faces(const std::filesystem::path& folder, const std::string& made_from,
                                const FaceCache& faces);

/// Loads the faces of that key; nullopt: there are none, or the file is damaged.
[[nodiscard]] std::optional<FaceCache> load_faces(const std::filesystem::path& folder,
                                                  const std::string& made_from);

/// The content of such a file.
[[nodiscard]] std::string pack_faces(const FaceCache& faces, const std::string& made_from);

/// Reads `bytes` of such a file; nullopt where they do not match `made_from`. Allocates no more
/// memory than they have.
[[nodiscard]] std::optional<FaceCache> unpack_faces(std::istream& file, std::size_t bytes,
                                                    const std::string& made_from);

/// Returns a frame of a recording by its number in the video: CV_8UC1, oriented as the finger's
/// camera has it.
using RecordingFrameReader = std::function<Result<cv::Mat>(std::size_t number)>;

/// A recording whose images are read one after the other.
struct RecordingInput {
  const RecordingFrameReader& frame;
  std::size_t count;                   ///< of the video's frames
  const std::filesystem::path& video;  ///< for messages: where the frames come from
  const MarkerTable& table;
  /// Edges of the faces in the first frames, by number in the video, where they are known already;
  /// without columns: not known.
  std::span<const FaceEdges> edges = {};

  /// nullptr where the edges of that frame are not known.
  [[nodiscard]] const FaceEdges* known_edges(std::size_t number) const {
    return number < edges.size() && !edges[number].u.empty() ? &edges[number] : nullptr;
  }
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
  /// Of some of these, spread over the recording, from which the finger's twist is learnt, and
  /// their rows.
  std::vector<TwistModel::Pose> poses;
  std::vector<Eigen::Index> posed;
  /// Edges of the faces in `seen`, for the cache. Empty for more than kMaxCachedFrames frames, and
  /// for faces from the cache.
  std::vector<FoundFace> found;
};

/// Where the faces exceed `limit_bytes`, only a covering subset is retained (farthest-point
/// sampling in marker space). Errors: an image that cannot be read; fewer than 2 faces found;
/// stopped.
[[nodiscard]] Result<RecordedFaces> read_recorded_faces(const RecordingInput& frames,
                                                        const Finger& finger, const Camera& camera,
                                                        std::size_t limit_bytes, const Job& job);

/// Those of some rows of the marker table, ascending, renumbered from 0 on, on the same grid. Where
/// their images exceed `limit_bytes`, only a covering subset is retained. table: of these rows. Not
/// for the cache: `found` is empty.
[[nodiscard]] RecordedFaces faces_of_rows(RecordedFaces faces, const std::vector<std::size_t>& rows,
                                          const MarkerTable& table, std::size_t limit_bytes);

/// What read_recorded_faces() returned, from the cache, without images; nullopt where the cache
/// does not fit the table and the camera.
[[nodiscard]] std::optional<RecordedFaces> recorded_faces_from_cache(FaceCache cache,
                                                                     const MarkerTable& table,
                                                                     const Finger& finger,
                                                                     const Camera& camera);

}  // namespace alltact
