// A recording reconstructed in parts, each by a process of its own, and brought together again.
#pragma once

#include "core/batch/batch.h"
#include "core/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

/// Part `number` (from 1) of `of`.
struct Part {
  int number = 1, of = 1;
};

/// "3/8". Error: not of this form, or no 1 <= number <= of <= 10000.
[[nodiscard]] Result<Part> part_of(const std::string& text);

/// The frames of a part: whole pieces (batch.h), as evenly as they go; none where there are fewer
/// pieces than parts.
[[nodiscard]] BatchFrames frames_of(const Part& part, std::size_t frame_count);

/// What a part's process leaves beside the files of its frames.
struct PartResults {
  Part part;
  std::string run;  ///< the same for all parts that belong together, and for no others
  std::size_t first = 0, frame_count = 0;  ///< of this part; of the whole recording
  bool is_continuous = true;
  std::vector<std::string> lines;  ///< FrameLine::to_json() of each of its frames
};
/// results.part-3-of-8.jsonl
[[nodiscard]] std::string part_file(const Part& part);
/// depth.part-3-of-8.mkv, where a video of the depth is asked for
[[nodiscard]] std::string part_video(const Part& part);
[[nodiscard]] Status write_part(const std::filesystem::path& folder, const PartResults& results);

struct MergedParts {
  std::size_t frames = 0, failed = 0;
  std::filesystem::path results;
};
/// Makes results.jsonl in the first folder from the parts in all of them, the same as that of one
/// process, moves the files of the others' frames there, joins their videos of depth where there
/// are any, and removes the parts. Errors: no parts;
/// parts of different runs; missing, twice the same, or damaged ones; two frames of one name; a
/// file cannot be moved or written. Until results.jsonl is there, parts stay where they are.
[[nodiscard]] Result<MergedParts> merge_parts(const std::vector<std::filesystem::path>& folders);

}  // namespace alltact
