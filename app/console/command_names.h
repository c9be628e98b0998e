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
    CommandName{"simulate", "Renders a scene, with the truth next to it"},
    CommandName{"lens", "Calibrates a lens from images of a flat board"},
    CommandName{"reference",
                "Installs a recording of the finger, bent in all directions without contact"},
    CommandName{"calibrate", "Calibrates depth with presses of a ball of known radius"},
    CommandName{"reconstruct", "Computes depth and 3D points from images"},
    CommandName{"merge", "Joins the parts of a reconstruction that several computers shared"},
    CommandName{"inspect", "Inspects a recording by a recipe: readings, tolerances, decisions"},
    CommandName{"serve", "Measures a source live, for other programs on this computer"},
    CommandName{"record", "Records a source without loss; recorded frames survive a kill"},
    CommandName{"force", "Trains a force model from marker positions and gauge readings"},
    CommandName{"check",
                "Checks whether a finger is fit to use, and lists what is missing, stale or weak"},
    CommandName{"export", "Writes the calibration for other programs"},
    CommandName{"gripper",
                "Computes camera poses of two fingers at a motor position, and what they hold"},
    CommandName{"devices",
                "Lists cameras and HID devices, with the problems of those that can't be used"},
    CommandName{"study", "Compares the time and accuracy of each setting, on this finger"},
    CommandName{"experiments",
                "Repeats the source paper's experiments in simulation, next to its own figures"},
    CommandName{"demo",
                "Demonstrates a full day in a minute: simulated finger, reference, calibration, "
                "reconstruction, report"},
    CommandName{"thumbnail",
                "Writes a small image of depth or of a mesh, as file managers show it"},
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
      "`alltact COMMAND --help` describes a command with all its options.");
}

}  // namespace alltact
