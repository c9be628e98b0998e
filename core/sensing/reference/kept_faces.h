// The faces of a recording as they were read before: opening a finger again takes a tenth of the
// time.
//
// One file holds one recording's, whole or not at all. In it stand what it was made from, so that
// another recording, camera or program finds nothing of its own, and a checksum: what is damaged is
// not taken. Nothing else depends on it, and who removes it loses time only.
#pragma once

#include "core/result.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/reference/face_picture.h"
#include "core/sensing/reference/reference_error.h"

#include <cstddef>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// More frames than these are not kept: a long recording is thinned while it is read, and what
/// would be kept of the others would be larger than what they are read for.
inline constexpr std::size_t kMostFramesKept = 4096;

/// A row of the marker table in which the face was found.
struct FoundFace {
  std::size_t row = 0;
  FaceEdges edges;
};

struct KeptFaces {
  std::vector<FoundFace> found;    ///< rows ascending
  std::vector<std::size_t> kept;   ///< rows whose faces follow, ascending
  std::vector<FacePicture> faces;  ///< on the grid of the recording, drift taken out
  ReferenceError error;
};

/// Keeps them in `folder`, of which the eight that were used last stay. Nothing is kept where they
/// would take more than 128 MB.
///   made_from: all that they depend on, in words
/// Errors: those of writing.
[[nodiscard]] Status keep_faces(const std::filesystem::path& folder,
                                const std::string& made_from,
                                const KeptFaces& faces);

/// What was kept of that; nullopt: nothing, or it is damaged.
[[nodiscard]] std::optional<KeptFaces> take_kept_faces(const std::filesystem::path& folder,
                                                       const std::string& made_from);

/// The content of such a file.
[[nodiscard]] std::string packed_faces(const KeptFaces& faces, const std::string& made_from);

/// Reads `bytes` of such a file; nullopt where they are not what was written for `made_from`. Takes
/// no more memory than they have.
[[nodiscard]] std::optional<KeptFaces> unpacked_faces(std::istream& file,
                                                      std::size_t bytes,
                                                      const std::string& made_from);

}  // namespace alltact
