// Where the frames of a Matroska file lie, from its structure alone: quick, and for files that a
// crash cut off as well.
#pragma once

#include "core/result.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace alltact {

struct MatroskaIndex {
  struct Block {
    std::int64_t time;           ///< in the file's time steps
    std::int64_t data_bytes_at;  ///< of the block's content, from the file's beginning
    std::int64_t cluster_at;     ///< of the cluster it belongs to
    bool is_key;
    // What the cluster's check sum was computed over; no bytes where it has none.
    std::int64_t checked_from, checked_bytes;
    std::uint32_t check_sum;
  };
  std::vector<Block> blocks;  ///< whole ones only, in the file's order, of all its tracks
  bool has_length = false;    ///< false: whoever wrote the file has not come to its end
  bool is_walkable = false;   ///< false: something damaged or half lies behind the last block
};

/// Reads the elements' heads only (IETF RFC 8794, RFC 9559). Error: it cannot be read, or is no
/// Matroska file.
[[nodiscard]] Result<MatroskaIndex> index_matroska(const std::filesystem::path& file);

/// False when the bytes around a block are not those that were written. `descriptor`: the open
/// file. True where there is no check sum.
[[nodiscard]] bool is_undamaged(int descriptor, const MatroskaIndex::Block& block);

}  // namespace alltact
