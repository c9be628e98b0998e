// Positions of the frames in a Matroska file, from its structure alone: fast, and valid for
// truncated files as well.
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
