#include "core/finger/finger_update.h"

namespace alltact {
namespace {

constexpr auto kPatience = std::chrono::seconds(10);
constexpr const char* kChanging = ".finger.changing";
constexpr const char* kWorking = ".finger.working";

}  // namespace

Result<Finger> update_finger(const std::filesystem::path& folder,
                             const std::function<Status(Finger&)>& change) {
  // Whoever may not write here is told what is wrong with the finger before that.
  if (const auto there = Finger::load(folder); !there) return there.error();
  const auto held = HeldFile::hold(folder / kChanging, this_process("changing"), kPatience);
  if (!held) return held.error();
  auto finger = Finger::load(folder);
  if (!finger) return finger.error();
  if (Status status = change(*finger); !status) return status.error();
  if (Status status = finger->save(folder); !status) return status.error();
  return finger;
}

void take_provenance(const Finger& from, const std::string& key, Finger& finger) {
  const auto entry = from.provenance.find(key);
  if (entry == from.provenance.end())
    finger.provenance.erase(key);
  else
    finger.provenance[key] = entry->second;
}

Result<HeldFile> hold_for_work(const std::filesystem::path& folder, const std::string& doing) {
  return HeldFile::hold(folder / kWorking, this_process(doing), std::chrono::milliseconds(0));
}

}  // namespace alltact
