#include "app/commands/reconstruct_part.h"

#include "core/io/atomic_file.h"

#include <fmt/format.h>

namespace alltact {

std::string name_of_run(const ReconstructOptions& options, std::size_t frame_count) {
  std::string all = fmt::format("{} {} {}", ALLTACT_VERSION, options.as_paper, frame_count);
  for (const Path& input : options.inputs) all += " " + input.filename().string();
  for (const bool is_requested : {options.depth,
                                  options.depth16,
                                  options.depth_video,
                                  options.depth_sd,
                                  options.sd_causes,
                                  options.flags,
                                  options.limits,
                                  options.points,
                                  options.image})
    all += is_requested ? '1' : '0';
  for (const std::string& kind : options.surfaces) all += " " + kind;
  for (const auto& setting : pipeline_settings())
    all += fmt::format(" {}={}", setting.name, setting.get(options.pipeline));
  if (const auto finger = read_file(options.finger / Finger::kFileName)) all += *finger;
  std::uint64_t sum = 0xcbf29ce484222325U;  // FNV-1a
  for (const char letter : all) sum = (sum ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
  return fmt::format("{:016x}", sum);
}

Result<BatchFrames> requested_frames(const ReconstructOptions& options,
                                     const Source& source,
                                     const Pipeline& pipeline) {
  if (!options.part) return BatchFrames{};
  const auto count = source.count();
  if (!count)
    return Error{en::say("only recordings can be reconstructed in parts"),
                 options.inputs.front().string(),
                 en::say("record it first")};
  if (pipeline.has_long_memory())
    return Error{options.as_paper
                     ? en::say("the source paper's method follows the markers through all frames, "
                               "so that no part can be measured by itself")
                     : en::say("the finger's force model knows creep, which depends on all frames "
                               "before, so that no part can be measured by itself"),
                 options.finger.string(),
                 en::say("without --shard")};
  return frames_of(*options.part, *count);
}

}  // namespace alltact
