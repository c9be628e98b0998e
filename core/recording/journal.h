// What a recording's frames were, a line each, beside the video: NAME.mkv has NAME.frames.csv.
//
//   # alltact-frames/1
//   frame,time_ns,sequence,controls
//   0,81234567890,0,Exposure=200; Gain=3
//   # 2 frames before frame 1 never came from the camera
//   1,81334567890,3,Exposure=200; Gain=3
//
// A line that begins with '#' is a remark for people. time_ns is the clock of capture, to the
// nanosecond (the video itself knows milliseconds); sequence is the source's own count; controls is
// what camera and light were set to (see frame_settings.h).
#pragma once

#include "core/frame.h"
#include "core/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

[[nodiscard]] std::filesystem::path journal_of(const std::filesystem::path& video);

/// Writes one; every line lies in the file when the call returns. Not for several threads at once.
class JournalWriter {
 public:
  /// What was in the file is gone. `source`: told at its top.
  [[nodiscard]] static Result<JournalWriter> create(const std::filesystem::path& file,
                                                    std::string_view source);
  JournalWriter(JournalWriter&& other) noexcept;
  JournalWriter& operator=(JournalWriter&& other) noexcept;
  ~JournalWriter();

  /// The next frame, numbered from 0.
  [[nodiscard]] Status add(const Frame& frame);
  [[nodiscard]] Status remark(std::string_view sentence);
  /// Waits until all is on the disk.
  [[nodiscard]] Status finish();
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  JournalWriter() = default;
  Status write(std::string_view text);

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t frames_ = 0;
  std::uint64_t bytes_ = 0;  // of whole lines
};

struct JournalEntry {
  std::int64_t time_ns = 0;
  std::uint64_t sequence = 0;
  std::shared_ptr<const std::string> controls;  ///< null where none were told
};

/// The frames' lines in order, up to the first that is not whole (a crash leaves such). Nothing
/// where there is no journal. Error: a frame is older than the one before it; nothing tells which
/// of the two times is true.
[[nodiscard]] Result<std::vector<JournalEntry>> read_journal(const std::filesystem::path& file);

/// Adds a remark to a journal that nobody writes any more, in place of a last line that is not
/// whole.
[[nodiscard]] Status remark_in_journal(const std::filesystem::path& file,
                                       std::string_view sentence);

}  // namespace alltact
