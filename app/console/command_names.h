// The commands of `alltact`, listed without loading their library.
#pragma once

#include <array>
#include <cassert>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace alltact {

struct CommandName {
  const char* name;
  const char* what;
};

/// In the order of a day with a new finger.
inline constexpr std::array kCommands = {
    CommandName{"new", "Makes the folder of a new finger"},
    CommandName{"simulate", "Renders a scene, with the truth beside it"},
    CommandName{"lens", "Calibrates a lens from pictures of a flat board"},
    CommandName{"reference",
                "Installs a recording of the finger bent in all ways but touched nowhere"},
    CommandName{"calibrate", "Learns depth from presses of a ball of known radius"},
    CommandName{"reconstruct", "Turns pictures into depth and 3D points"},
    CommandName{"merge",
                "Brings the parts of a reconstruction that several computers shared together"},
    CommandName{"serve", "Measures a source live, for other programs on this computer"},
    CommandName{"record", "Records a source without loss, and without losing anything when killed"},
    CommandName{"force", "Learns forces from where the markers are, with a gauge beside"},
    CommandName{"check", "Is this finger fit to use? What is missing, stale or weak"},
    CommandName{"export", "Writes the calibration for other programs"},
    CommandName{"gripper",
                "Where the cameras of two fingers are for a motor position, and what they hold"},
    CommandName{"devices",
                "Cameras and HID devices found, with what is wrong with those that can't be used"},
    CommandName{"study", "What each setting costs in time and brings in accuracy, on this finger"},
    CommandName{"experiments",
                "The source paper's experiments in simulation, beside the paper's own figures"},
    CommandName{"demo",
                "A whole day in a minute: simulated finger, reference, calibration, "
                "reconstruction, report"},
    CommandName{"thumbnail", "A small picture of depth or of a mesh, as file managers show it"},
};

/// Adds one of kCommands, still without its options.
inline CLI::App* add_command(CLI::App& program, std::string_view name) {
  for (const CommandName& command : kCommands)
    if (name == command.name) return program.add_subcommand(command.name, command.what);
  assert(!"a command that is not listed");
  return nullptr;
}

/// Name, version and the text below the help.
inline void describe(CLI::App& program) {
  program.name("alltact");
  program.description(
      "AllTact: turns a clear silicone finger with a camera inside into a measuring instrument.");
  program.set_version_flag("--version", std::string("alltact ") + ALLTACT_VERSION);
  program.require_subcommand(1);
  program.footer(
      "Exit status: 0 done, 1 the work could not be done, 2 wrong usage.\n"
      "`alltact COMMAND --help` tells everything about a command.");
}

}  // namespace alltact
