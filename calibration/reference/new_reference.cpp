#include "calibration/reference/new_reference.h"

#include "calibration/reference/settings_record.h"
#include "core/finger/finger_store.h"
#include "core/sources/open/open_source.h"
#include "core/utc_time.h"

namespace alltact {
namespace {

constexpr const char* kWork = "making the reference";
constexpr const char* kDate = "reference_date";

/// The reference's files and finger.yaml, together.
Status save_reference(FingerStore& store, Finger& with_reference, FolderChange& files) {
  with_reference.provenance[kDate] = utc_now();
  const auto saved = store.update([&](Finger& finger) {
    take_reference(with_reference, finger);
    return commit_with(finger, files);
  });
  return saved ? Status() : saved.error();
}

}  // namespace

Status commit_with(const Finger& finger, FolderChange& files) {
  if (const Status saved = finger.save(files.staged()); !saved) return saved;
  return files.commit();
}

void take_reference(const Finger& from, Finger& finger) {
  finger.reference = from.reference;
  finger.markers = from.markers;
  finger.contact = from.contact;
  for (const char* key : {kDate, kReferenceSettings}) take_provenance(from, key, finger);
}

bool has_same_reference(const Finger& a, const Finger& b) {
  Finger mixed = b;
  take_reference(a, mixed);
  mixed.camera = a.camera;
  mixed.face = a.face;
  const auto yaml = b.to_yaml(), mixed_yaml = mixed.to_yaml();
  return yaml && mixed_yaml && *yaml == *mixed_yaml;
}

Result<ReferenceReport> give_reference(const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& inputs,
                                       const Job& job,
                                       const ReferenceChoices& choices) {
  const auto store = FingerStore::of(folder);
  const auto before = store->snapshot();
  if (!before) return before.error();
  const auto alone = store->hold_for_work(kWork);
  if (!alone) return alone.error();
  Finger finger = (*before)->finger;
  auto source = open_source(inputs);
  if (!source) return source.error();
  auto files = FolderChange::begin(folder);
  if (!files) return files.error();
  auto report = install_reference(**source, folder, finger, job, choices, files->staged());
  if (!report) return report.error();
  if (const Status saved = save_reference(*store, finger, *files); !saved) return saved.error();
  return report;
}

Result<std::vector<Message>> give_untouched_picture(const std::filesystem::path& folder,
                                                    const UntouchedPicture& picture) {
  const auto store = FingerStore::of(folder);
  const auto before = store->snapshot();
  if (!before) return before.error();
  const auto alone = store->hold_for_work(kWork);
  if (!alone) return alone.error();
  Finger finger = (*before)->finger;
  auto files = FolderChange::begin(folder);
  if (!files) return files.error();
  auto warnings = install_flat_reference(picture, files->staged(), finger);
  if (!warnings) return warnings.error();
  if (const Status saved = save_reference(*store, finger, *files); !saved) return saved.error();
  return warnings;
}

}  // namespace alltact
