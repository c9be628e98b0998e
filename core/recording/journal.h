// The frames of a recording, a line each, next to the video: NAME.mkv has NAME.frames.csv.
//
//   # alltact-frames/1
//   frame,time_ns,sequence,controls
//   0,81234567890,0,Exposure=200; Gain=3
//   # 2 frames before frame 1 never came from the camera
//   1,81334567890,3,Exposure=200; Gain=3
//
// A line that begins with '#' is a remark for people. time_ns is the clock of capture, to the
// nanosecond (the video itself has milliseconds), and empty where the source has none. sequence is
// the source's own count; controls are the settings of camera and light (see frame.h).
#pragma once

#include "core/base/descriptor.h"
#include "core/base/result.h"
#include "core/image/frame.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

[[nodiscard]] std::filesystem::path journal_of(const std::filesystem::path& video);

/// Writes a journal; each line is in the file when the call returns. Not for several threads at
/// once.
class JournalWriter {
 public:
  /// Creates or overwrites the file. `source`: written at its top.
  [[nodiscard]] static Result<JournalWriter> create(const std::filesystem::path& file,
                                                    std::string_view source);

  /// The next frame, numbered from 0.
  [[nodiscard]] Status add(const Frame& frame);
  [[nodiscard]] Status remark(std::string_view sentence);
  /// Waits until everything is on the disk.
  [[nodiscard]] Status finish();
  [[nodiscard]] int descriptor() const { return descriptor_.number(); }

 private:
  JournalWriter() = default;
  Status write(std::string_view text);

  std::filesystem::path file_;
  Descriptor descriptor_;
  std::uint64_t frames_ = 0;
  std::uint64_t bytes_ = 0;  // of complete lines
};

struct JournalEntry {
  std::optional<std::int64_t> time_ns;  ///< empty where the frame had none
  std::uint64_t sequence = 0;
  std::shared_ptr<const std::string> controls;  ///< null where the frame had none
};

/// Returns the frames' lines in order, up to the first incomplete one, which a crash may leave.
/// Empty where there is no journal. Error: a frame is older than the one before it, so that one of
/// the two times is wrong.
[[nodiscard]] Result<std::vector<JournalEntry>> read_journal(const std::filesystem::path& file);

/// Adds a remark to a finished journal, replacing an incomplete last line.
[[nodiscard]] Status remark_in_journal(const std::filesystem::path& file,
                                       std::string_view sentence);

}  // namespace alltact
