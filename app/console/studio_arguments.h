// Command-line arguments of `alltact-studio`.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace alltact {

struct StudioArguments {
  std::string finger, source;
};

inline void describe_studio(CLI::App& program, StudioArguments& arguments, std::string version) {
  program.name("alltact-studio");
  program.description("AllTact Studio: a clear silicone finger as a measuring instrument.");
  program.set_version_flag("--version", "alltact-studio " + std::move(version));
  program.add_option("FINGER", arguments.finger,
                     "Folder of the finger to open; a scene or a video is taken as the source");
  program
      .add_option("--source", arguments.source,
                  "Source of the images: a camera (by a name from 'alltact devices'), a video, a "
                  "folder of images, or a scene (a simulated finger)")
      ->type_name("SOURCE");
  program.footer("Exit status: 0 closed by hand, 1 there is no display, 2 wrong usage.");
}

}  // namespace alltact
