// Matroska files: written so that a crash loses nothing, and indexed from their structure alone.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

struct AVCodecParameters;
struct AVFormatContext;
struct AVPacket;

namespace alltact {

// A Matroska file with one video stream, each packet on the disk before the next is written. Only
// for .cpp files of this folder.

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

// Positions of the frames in a Matroska file, from its structure alone: fast, and valid for
// truncated files as well.

struct MatroskaIndex {
  struct Block {
    std::int64_t time;           ///< in the file's time steps
    std::int64_t data_bytes_at;  ///< of the block's content, from the file's beginning
    std::int64_t cluster_at;     ///< of the cluster it belongs to
    bool is_key;
    // The range of the cluster's check sum; 0 bytes where it has none.
    std::int64_t checked_from, checked_bytes;
    std::uint32_t check_sum;
  };
  std::vector<Block> blocks;  ///< complete ones only, in the file's order, of all its tracks
  bool has_length = false;    ///< false: the writer did not finish the file
  bool is_walkable = false;   ///< false: the file is damaged or incomplete behind the last block
};

/// Reads only the heads of the elements (IETF RFC 8794, RFC 9559). Error: it cannot be read, or is
/// no Matroska file.
[[nodiscard]] Result<MatroskaIndex> index_matroska(const std::filesystem::path& file);

/// Verifies the check sum around a block; true where there is none. `descriptor`: the open file.
[[nodiscard]] bool is_undamaged(int descriptor, const MatroskaIndex::Block& block);

}  // namespace alltact
