// The one way in which a finger that is there is changed.
#pragma once

#include "core/finger/finger.h"
#include "core/io/held_file.h"
#include "core/result.h"

#include <filesystem>
#include <functional>
#include <string>

namespace alltact {

/// Reads finger.yaml as it is now, lets `change` change it, and writes it whole: one after another
/// among threads and programs, so that nothing that another wrote in between is lost. Gives the
/// finger as it was written. `change` should take what has been worked out already: others wait
/// for it, up to ten seconds. Errors: those of Finger::load, `change` and Finger::save, and then
/// the file is as it was; another program holds the finger longer than that.
[[nodiscard]] Result<Finger> update_finger(const std::filesystem::path& folder,
                                           const std::function<Status(Finger&)>& change);

/// Sets an entry of the provenance to what it is in `from`, or removes it where that has none.
void take_provenance(const Finger& from, const std::string& key, Finger& finger);

/// For work of minutes on a finger (calibrating, recording its reference) that two must not do at
/// once; changes by update_finger go on beside it. Error: another is at it, who is named.
///   doing: what is done, for those who come second ("calibrating")
[[nodiscard]] Result<HeldFile> hold_for_work(const std::filesystem::path& folder,
                                             const std::string& doing);

}  // namespace alltact
