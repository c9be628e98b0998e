#include "calibration/experiments/experiments.h"

#include "calibration/experiments/experiment_runs.h"
#include "core/either.h"

#include <algorithm>

namespace alltact {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{
      {"localisation",
       en::say("where a touch is, at 9 x 3 places of the face"),
       {"experiment_localisation"},
       run_localisation},
      {"pose", en::say("how a held bar is turned"), {"experiment_pose"}, run_pose},
      {"least-touch",
       en::say("the least depth of a ball that is felt"),
       {"experiment_least_touch"},
       run_min_contact},
      {"least-force",
       en::say("the least force that is felt, on every face"),
       {"experiment_least_force"},
       run_min_force},
      {"direction",
       en::say("from which of 8 sides the finger is pushed"),
       {"experiment_direction", "experiment_references"},
       run_direction},
      {"force",
       en::say("Fx and Fy of pushes, on fingers drawn at random"),
       {"experiment_force"},
       run_force},
      {"references",
       en::say("one untouched picture against a recording of all poses"),
       {"experiment_references"},
       run_references},
      {"room-light",
       en::say("place and force in rooms of 300, 1100 and 2500 lux"),
       {"experiment_room_light", "experiment_room_force", "experiment_force"},
       run_room_light},
      {"thread",
       en::say("relief of an M8 thread, against a single reference"),
       {"experiment_thread_m8"},
       run_thread},
      {"usb-plug",
       en::say("relief of a USB plug, against a single reference"),
       {"experiment_usb_plug"},
       run_usb_plug},
      {"markers",
       en::say("what the ways of finding markers cost and gain"),
       {"demo_presses",
        "hard_hidden_dots",
        "hard_worn_dots",
        "hard_defocus_at_the_base",
        "hard_defocus_at_the_tip",
        "hard_dead_lamp",
        "hard_dirty_skin"},
       run_markers},
      {"time",
       en::say("time of a frame's steps, in full HD with 24 dots"),
       {"experiment_time", "demo_hd_reference"},
       run_time},
  };
  return all;
}

Message simulated_and_real() {
  return en::say(
      "Ours are simulated, with the truth known; the paper's were measured on a real finger.");
}

Result<std::vector<const Experiment*>> experiments_named(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Experiment& experiment : experiments()) known.push_back(experiment.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      return Error{en::say("there is no experiment '{}'", name), "", one_of(known, name)};
  std::vector<const Experiment*> chosen;
  for (const Experiment& experiment : experiments())
    if (names.empty() || std::find(names.begin(), names.end(), experiment.name) != names.end())
      chosen.push_back(&experiment);
  return chosen;
}

}  // namespace alltact
