#include "app/commands/commands.h"

#include "app/console/command_names.h"
#include "app/console/completions_and_man_pages.h"
#include "app/console/flags.h"
#include "app/console/parse.h"
#include "app/console/studio_arguments.h"
#include "calibration/finger/measuring_presets.h"
#include "core/base/guarded.h"
#include "core/base/program.h"
#include "core/base/slow_disk.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>

namespace alltact {
namespace {

bool is_of_mapping(const std::string& setting) {
  const auto& beyond = mapping_independent_settings();
  return std::find(beyond.begin(), beyond.end(), setting) == beyond.end();
}

}  // namespace

Result<PipelineSettings> stored_settings(const std::filesystem::path& finger,
                                         const std::string& preset) {
  if (!preset.empty()) return preset_settings(finger, preset);
  const auto presets = presets_of_finger(finger);
  if (!presets) return presets.error();
  return presets->now;
}

void warn_of_other_settings(const PipelineSettings& stored, const PipelineSettings& requested,
                            Console& console) {
  for (const auto& setting : pipeline_settings())
    if (is_of_mapping(setting.name) && setting.get(stored) != setting.get(requested))
      console.warn(fmt::format("Warning: --{} is {}, but the finger was calibrated with {}.",
                               setting.name, setting.get(requested), setting.get(stored)));
}

// The command line program, in the library that holds all commands.

namespace {

/// Prints wrong usage in one line; help is printed only on request.
int usage_status(const CLI::App& program, const CLI::ParseError& error) {
  const int status = program.exit(error, std::cout, std::cerr);
  return status == 0 ? 0 : 2;
}

/// A page is named after a program, or alltact-COMMAND.
Result<std::string> page_named(const CLI::App& alltact, const CLI::App& studio,
                               const std::string& page) {
  if (page == alltact.get_name()) return man_page(alltact, program_version());
  if (page == studio.get_name()) return man_page(studio, program_version());
  for (const CLI::App* command : alltact.get_subcommands({}))
    if (page == alltact.get_name() + "-" + command->get_name())
      return man_page(alltact, program_version(), command);
  return Error{en::say("there is no such program or command"), page, ""};
}

/// Files to install with the programs, generated from their command lines:
/// `--completions bash|zsh|fish PROGRAM` and `--man PAGE`; nullopt where neither is given.
std::optional<Result<std::string>> generated_text(const CLI::App& alltact, int argc, char** argv) {
  const bool wants_page = argc == 3 && std::strcmp(argv[1], "--man") == 0;
  const bool wants_completions = argc == 4 && std::strcmp(argv[1], "--completions") == 0;
  if (!wants_page && !wants_completions) return std::nullopt;
  CLI::App studio;
  StudioArguments arguments;
  describe_studio(studio, arguments, program_version());
  if (wants_page) return page_named(alltact, studio, argv[2]);
  const std::string program = argv[3];
  if (program != alltact.get_name() && program != studio.get_name())
    return Error{en::say("there is no such program"), program, ""};
  return completions(program == studio.get_name() ? studio : alltact, argv[2]);
}

int print(const Result<std::string>& text) {
  if (!text)
    std::fprintf(stderr, "%s\n", text.error().sentence().c_str());
  else
    std::fputs(text->c_str(), stdout);
  return text && std::fflush(stdout) == 0 ? 0 : 2;
}

void add_commands(CLI::App& program, Chosen& chosen, bool& json) {
  describe(program);
  add_new(program, chosen);
  add_simulate(program, chosen);
  add_lens(program, chosen);
  add_reference(program, chosen);
  add_calibrate(program, chosen);
  add_reconstruct(program, chosen);
  add_merge(program, chosen);
  add_inspect(program, chosen);
  add_serve(program, chosen);
  add_record(program, chosen);
  add_force(program, chosen);
  add_check(program, chosen);
  add_export(program, chosen);
  add_gripper(program, chosen);
  add_devices(program, chosen);
  add_study(program, chosen);
  add_experiments(program, chosen);
  add_demo(program, chosen);
  add_thumbnail(program, chosen);
  for (CLI::App* command : program.get_subcommands({}))
    command->add_flag("--json", json, "Prints one JSON object on standard output instead of text");
}

/// In addition to the command's own output.
void say_slow_disk(const std::filesystem::path& file) {
  fmt::print(stderr, "{}\n", slow_disk(file).sentence());
}

/// Starts OpenCV's threads while there is memory for them: where their start fails, their next user
/// would wait without end.
void begin_threads() {
#if defined(__SANITIZE_THREAD__)
  return set_opencv_threads(1);
#endif
  try {
    std::thread([] {}).join();
    cv::parallel_for_({0, 2 * cv::getNumThreads()}, [](const cv::Range&) {});
  } catch (const std::exception&) {
    cv::setNumThreads(1);
  }
}

int run(int argc, char** argv) {
  // Decoders' own messages would mix with this program's sentences.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  CLI::App program;
  Chosen chosen;
  bool json = false;
  add_commands(program, chosen, json);
  if (const auto text = generated_text(program, argc, argv)) return print(*text);
  try {
    parse(program, argc, argv);
  } catch (const CLI::ParseError& error) {
    return usage_status(program, error);
  }
  Console console(json);
  for (const Message& warning : number_warnings())
    console.warn(fmt::format("Warning: {}", warning));
  try {
    begin_threads();
    const DiskWatch slow_disks(kDiskTimeout, say_slow_disk);
    return console.finish(chosen(console));
  } catch (...) {
    return console.finish(caught_error());
  }
}

}  // namespace

}  // namespace alltact

extern "C" __attribute__((visibility("default"))) int alltact_run(int argc, char** argv) {
  return alltact::run(argc, argv);
}
