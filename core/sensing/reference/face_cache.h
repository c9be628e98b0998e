// Cache of the faces of a recording: opening a finger again takes a tenth of the time.
//
// One file holds one recording's faces. It stores a key of its inputs, so that another recording,
// camera or program does not match, and a checksum to detect damage. The cache can be removed at
// any time; only speed is lost.
#pragma once

#include "core/result.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/reference/face_image.h"
#include "core/sensing/reference/reference_error.h"

#include <cstddef>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

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
[[nodiscard]] Status save_faces(const std::filesystem::path& folder,
                                const std::string& made_from,
                                const FaceCache& faces);

/// Loads the faces of that key; nullopt: there are none, or the file is damaged.
[[nodiscard]] std::optional<FaceCache> load_faces(const std::filesystem::path& folder,
                                                  const std::string& made_from);

/// The content of such a file.
[[nodiscard]] std::string pack_faces(const FaceCache& faces, const std::string& made_from);

/// Reads `bytes` of such a file; nullopt where they do not match `made_from`. Allocates no more
/// memory than they have.
[[nodiscard]] std::optional<FaceCache> unpack_faces(std::istream& file,
                                                    std::size_t bytes,
                                                    const std::string& made_from);

}  // namespace alltact
