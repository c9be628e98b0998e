// Reconstructs a recording in parts, each by a process of its own, and merges them.
#pragma once

#include "core/base/result.h"
#include "core/batch/batch.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

/// Part `number` (from 1) of `of`.
struct Part {
  int number = 1, of = 1;
};

/// Parses "3/8". Error: not of this form, or not 1 <= number <= of <= 10000.
[[nodiscard]] Result<Part> part_of(const std::string& text);

/// The frames of a part: complete pieces (batch.h), as evenly as possible; none where there are
/// fewer pieces than parts.
[[nodiscard]] BatchFrames frames_of(const Part& part, std::size_t frame_count);

/// Results of a part's process, apart from the files of its frames.
struct PartResults {
  Part part;
  std::string run;                         ///< the same for all parts of one run, and for no others
  std::size_t first = 0, frame_count = 0;  ///< of this part; of the entire recording
  bool is_continuous = true;
  std::vector<std::string> lines;   ///< FrameLine::to_json() of each of its frames
  std::filesystem::path file = {};  ///< where merge_parts() read it from; not stored
};
/// results.part-3-of-8.jsonl
[[nodiscard]] std::string part_file(const Part& part);
/// depth.part-3-of-8.mkv, where a depth video is requested
[[nodiscard]] std::string part_video(const Part& part);
[[nodiscard]] Status write_part(const std::filesystem::path& folder, const PartResults& results);

struct MergedParts {
  std::size_t frames = 0, failed = 0;
  std::filesystem::path results;
};
/// Writes results.jsonl to the first folder from the parts in all of them, identical to that of one
/// process. Moves the files of the other folders' frames there, joins depth videos where there are
/// any, and removes the parts. Errors: no parts; parts of different runs; missing, duplicate or
/// damaged ones; two frames of one name; a file cannot be moved or written. Until results.jsonl
/// exists, parts stay where they are.
[[nodiscard]] Result<MergedParts> merge_parts(const std::vector<std::filesystem::path>& folders);

}  // namespace alltact
