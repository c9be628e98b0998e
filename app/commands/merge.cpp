#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "core/batch/parts.h"

#include <fmt/format.h>

namespace alltact {

Status run_merge(const std::vector<Path>& folders, Console& console) {
  const auto merged = merge_parts(folders);
  if (!merged) return merged.error();
  console.say(fmt::format("{} frames, {} of them without depth; results in {}",
                          merged->frames,
                          merged->failed,
                          merged->results.parent_path().string()));
  Console::Json& answer = console.answer();
  answer["frames"] = merged->frames;
  answer["failed"] = merged->failed;
  answer["results"] = merged->results.string();
  return {};
}

void add_merge(CLI::App& program, Chosen& chosen) {
  auto folders = std::make_shared<std::vector<Path>>();
  CLI::App* command = add_command(program, "merge");
  command
      ->add_option("DIR",
                   *folders,
                   "Where `alltact reconstruct --shard` left its parts; the results go into the "
                   "first")
      ->required();
  command->callback(
      [=, &chosen] { chosen = [=](Console& console) { return run_merge(*folders, console); }; });
}

}  // namespace alltact
