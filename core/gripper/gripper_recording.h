// Reads the results of `alltact reconstruct` of two fingers, and joins them in time.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/gripper/held_object.h"

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
  std::optional<std::int64_t> time_ns;     ///< of capture; empty for images
  std::optional<ObservedContact> contact;  ///< the largest one; empty without a contact
  /// Columns of the face, ascending, and the standard deviation of its z there.
  std::vector<double> face_u, face_z_sd_mm;

  /// Linear between the columns; nullopt where the line holds no data of the face.
  [[nodiscard]] std::optional<double> z_sd_mm(double u) const;
};

/// Errors, with file and line: not readable; invalid JSON; a value of the wrong type or not finite;
/// an invalid covariance. Lines of older files may lack keys; the others are read.
[[nodiscard]] Result<std::vector<RecordedContacts>> read_recorded_contacts(
    const std::filesystem::path& file);
/// Parses the file's content; `origin` names it in errors.
[[nodiscard]] Result<std::vector<RecordedContacts>> parse_recorded_contacts(
    const std::string& content, const std::filesystem::path& origin);

/// Pairs of simultaneous frames.
struct PairedFrames {
  bool by_time = false;  ///< false: a recording has no times, so paired by order
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<std::size_t> unpaired_first, unpaired_second;  ///< frames without a partner
};

/// By time: mutual nearest neighbours at most `tolerance_ns` apart; each frame at most once, in
/// order of time.
[[nodiscard]] PairedFrames paired_frames(const std::vector<RecordedContacts>& first,
                                         const std::vector<RecordedContacts>& second,
                                         std::int64_t tolerance_ns);

// The motor's position during a recording.

/// A table of motor positions by time, on the clock of the frames: time_ns and turns, in order of
/// time, of any form that core/base/table.h describes. Other units stand in the names, such as t_ms
/// or "angle [deg]". A value.
class MotorLog {
 public:
  /// Errors, with file and line: not readable; those of Table; a time that is not after the
  /// previous one; fewer than two lines.
  static Result<MotorLog> load(const std::filesystem::path& file);
  static Result<MotorLog> parse(const std::string& content, const std::filesystem::path& origin);

  /// Linear between the lines; nullopt before the first and after the last.
  [[nodiscard]] std::optional<double> turns_at(std::int64_t time_ns) const;
  [[nodiscard]] std::int64_t first_ns() const { return lines_.front().first; }
  [[nodiscard]] std::int64_t last_ns() const { return lines_.back().first; }
  [[nodiscard]] const Message& understood() const { return understood_; }  ///< of Table
  [[nodiscard]] const std::vector<Message>& remarks() const { return remarks_; }

 private:
  std::vector<std::pair<std::int64_t, double>> lines_;
  Message understood_;
  std::vector<Message> remarks_;
};

}  // namespace alltact
