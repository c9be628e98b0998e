// What `alltact reconstruct` left of two fingers, read again and joined in time.
#pragma once

#include "core/gripper/held_object.h"
#include "core/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace alltact {

/// A line of results.jsonl.
struct RecordedContacts {
  std::string frame;
  std::optional<std::int64_t> time_ns;  ///< of capture; absent of pictures
  std::optional<SeenContact> contact;   ///< the largest one; absent where nothing is touched
  /// Columns of the face, ascending, and the standard deviation of its z there.
  std::vector<double> face_u, face_z_sd_mm;

  /// Straight between the columns; nullopt where the line says nothing of the face.
  [[nodiscard]] std::optional<double> z_sd_mm(double u) const;
};

/// Errors, with file and line: not readable; no JSON; a value that is not of its kind or not
/// finite; a covariance that is none. Lines of older files, which lack keys, are read as far as
/// they go.
[[nodiscard]] Result<std::vector<RecordedContacts>> read_recorded_contacts(
    const std::filesystem::path& file);
/// The file's content; `origin` names it in errors.
[[nodiscard]] Result<std::vector<RecordedContacts>> parse_recorded_contacts(
    const std::string& content, const std::filesystem::path& origin);

/// Which frames belong together.
struct PairedFrames {
  bool by_time = false;  ///< false: one of both has no times, so in their order
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<std::size_t> alone_first, alone_second;  ///< frames without a partner
};

/// By time: each with the nearest of the other recording, if that one's nearest it is and they are
/// no more than `tolerance_ns` apart; each at most once, in the order of time.
[[nodiscard]] PairedFrames paired_frames(const std::vector<RecordedContacts>& first,
                                         const std::vector<RecordedContacts>& second,
                                         std::int64_t tolerance_ns);

}  // namespace alltact
