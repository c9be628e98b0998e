// One Matroska file of one video stream, each packet on the disk before the next is asked for. For
// this folder's own .cpp files.
#pragma once

#include "core/recording/libav.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace alltact {

/// What a file says of itself.
struct MatroskaTag {
  std::string name, text;
};
/// By which a recording is known as written here (is_our_recording).
[[nodiscard]] MatroskaTag of_recordings();

/// A file being written. Whatever ends the program, the packets that write() took stay readable:
/// each is a cluster of its own and lies in the file when write() returns. As long as it is open
/// the file is locked (flock), so that nobody takes it for one that a crash left behind.
/// Not for several threads at once.
class MatroskaFile {
 public:
  /// `parameters` of the stream; packets are stamped in milliseconds. What was in the file is gone.
  [[nodiscard]] static Result<MatroskaFile> create(const std::filesystem::path& file,
                                                   const AVCodecParameters& parameters,
                                                   double frames_per_s,
                                                   const MatroskaTag& tag = of_recordings());
  MatroskaFile(MatroskaFile&&) noexcept;
  MatroskaFile& operator=(MatroskaFile&&) noexcept;
  ~MatroskaFile();

  /// After an error the file is cut back to its last whole packet and takes no more.
  [[nodiscard]] Status write(AVPacket& packet);
  /// The index and the length, without which the file is readable but slow to seek in; then waits
  /// until all is on the disk. Error: they could not be written; the packets stay readable.
  [[nodiscard]] Status finish();

  [[nodiscard]] std::uint64_t bytes() const;
  [[nodiscard]] int descriptor() const;

 private:
  struct State;
  explicit MatroskaFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// True for a file that was written here.
[[nodiscard]] bool is_our_recording(const AVFormatContext& input);

}  // namespace alltact
