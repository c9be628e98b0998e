// `alltact`: everything the Studio does, without a screen. It prints its commands and its version
// at once. For anything else it loads the library of the commands, with all that measuring needs.
#include "app/console/command_names.h"
#include "app/console/load_library.h"

#include <cstdio>
#include <cstring>
#include <exception>

namespace {

bool asks_for_help(int argc, char** argv) {
  return argc == 2 && (std::strcmp(argv[1], "--help") == 0 || std::strcmp(argv[1], "-h") == 0 ||
                       std::strcmp(argv[1], "--version") == 0);
}

int print_help(int argc, char** argv) {
  CLI::App program;
  alltact::describe(program);
  for (const alltact::CommandName& command : alltact::kCommands)
    alltact::add_command(program, command.name);
  CLI11_PARSE(program, argc, argv);
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  if (asks_for_help(argc, argv)) return print_help(argc, argv);
  const alltact::Loaded commands = alltact::load_function("commands", "alltact_run");
  if (commands.function != nullptr)
    return reinterpret_cast<int (*)(int, char**)>(commands.function)(argc, argv);
  std::fprintf(stderr,
               "A part of this program cannot be loaded: %s. Try: installing the program again.\n",
               commands.problem.c_str());
  return 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "The program cannot start: %s. Try: close other programs.\n", error.what());
  return 1;
}
