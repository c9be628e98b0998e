// A Matroska file with one video stream, each packet on the disk before the next is written. Only
// for .cpp files of this folder.
#pragma once

#include "core/recording/libav.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace alltact {

/// A tag of a file.
struct MatroskaTag {
  std::string name, text;
};
/// The tag that marks recordings of this program (is_own_recording).
[[nodiscard]] MatroskaTag recording_tag();

/// A file being written. Packets that write() took stay readable after any crash: each is a cluster
/// of its own and is in the file when write() returns. The open file is locked (flock), so that
/// nobody repairs it as an interrupted one. Not for several threads at once.
class MatroskaFile {
 public:
  /// `parameters` of the stream; packets have time stamps in milliseconds. Overwrites the file.
  [[nodiscard]] static Result<MatroskaFile> create(const std::filesystem::path& file,
                                                   const AVCodecParameters& parameters,
                                                   double frames_per_s,
                                                   const MatroskaTag& tag = recording_tag());
  MatroskaFile(MatroskaFile&&) noexcept;
  MatroskaFile& operator=(MatroskaFile&&) noexcept;
  ~MatroskaFile();

  /// After an error the file is truncated to its last complete packet and takes no more.
  [[nodiscard]] Status write(AVPacket& packet);
  /// Writes the index and the length, without which the file is readable but slow to seek in, then
  /// waits until everything is on the disk. Error: they could not be written; the packets stay
  /// readable.
  [[nodiscard]] Status finish();

  [[nodiscard]] std::uint64_t bytes() const;
  [[nodiscard]] int descriptor() const;

 private:
  struct State;
  explicit MatroskaFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// True for a recording of this program.
[[nodiscard]] bool is_own_recording(const AVFormatContext& input);

}  // namespace alltact
