// The command line as a whole, in the library that holds all commands.
#include "app/commands/commands.h"
#include "app/console/command_names.h"

#include <opencv2/core/utils/logger.hpp>

namespace alltact {
namespace {

/// Wrong usage is told in one line; help is for those who ask for it.
int usage_status(const CLI::App& program, const CLI::ParseError& error) {
  const int status = program.exit(error, std::cout, std::cerr);
  return status == 0 ? 0 : 2;
}

int run(int argc, char** argv) {
  // Decoders' own messages would stand beside our sentences and say less.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  CLI::App program;
  describe(program);
  Chosen chosen;
  add_new(program, chosen);
  add_simulate(program, chosen);
  add_lens(program, chosen);
  add_reference(program, chosen);
  add_calibrate(program, chosen);
  add_reconstruct(program, chosen);
  add_merge(program, chosen);
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
  bool json = false;
  for (CLI::App* command : program.get_subcommands({}))
    command->add_flag("--json", json, "One JSON object on standard output instead of text");

  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return usage_status(program, error);
  }
  Console console(json);
  try {
    return console.finish(chosen(console));
  } catch (const std::exception& error) {
    return console.finish(Error{en::say("unexpected: {}", std::string(error.what())),
                                "",
                                en::say("reporting this as a defect")});
  }
}

}  // namespace
}  // namespace alltact

extern "C" __attribute__((visibility("default"))) int alltact_run(int argc, char** argv) {
  return alltact::run(argc, argv);
}
