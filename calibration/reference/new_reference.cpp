#include "calibration/reference/new_reference.h"

#include "calibration/reference/make_reference.h"
#include "calibration/reference/settings_record.h"
#include "core/finger/finger_store.h"
#include "core/io/atomic_file.h"
#include "core/io/disk_wait.h"
#include "core/sources/open/open_source.h"
#include "core/utc_time.h"

namespace alltact {
namespace {

constexpr const char* kWork = "making the reference";
constexpr const char* kDate = "reference_date";

/// The reference's files and finger.yaml, together.
Status save_reference(FingerStore& store, const Finger& with_reference, FolderChange& files) {
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
  for (const char* key : {kDate, kReferenceSettings}) copy_provenance(from, key, finger);
}

bool has_same_reference(const Finger& a, const Finger& b) {
  Finger mixed = b;
  take_reference(a, mixed);
  mixed.camera = a.camera;
  mixed.face = a.face;
  const auto yaml = b.to_yaml(), mixed_yaml = mixed.to_yaml();
  return yaml && mixed_yaml && *yaml == *mixed_yaml;
}

Result<ReferenceReport> set_reference(const std::filesystem::path& folder,
                                      const std::vector<std::filesystem::path>& inputs,
                                      const Job& job,
                                      const ReferenceChoices& choices) {
  const auto store = FingerStore::of(folder);
  const auto before = store->snapshot();
  if (!before) return before.error();
  const auto lock = store->lock_for_work(kWork);
  if (!lock) return lock.error();
  Finger finger = (*before)->finger;
  auto source = open_source(inputs);
  if (!source) return source.error();
  auto files = FolderChange::begin(folder);
  if (!files) return files.error();
  auto report = install_reference(**source, folder, finger, job, choices, files->staged());
  if (!report) return report.error();
  finger.provenance[kDate] = utc_now();
  if (const Status saved = save_reference(*store, finger, *files); !saved) return saved.error();
  return report;
}

Status copy_reference(const std::filesystem::path& copy, const std::filesystem::path& folder) {
  const auto made = Finger::load(copy);
  if (!made) return made.error();
  if (!made->reference)
    return Error{en::say("the finger has no reference recording"), copy.string(), ""};
  const auto store = FingerStore::of(folder);
  const auto lock = store->lock_for_work(kWork);
  if (!lock) return lock.error();
  auto files = FolderChange::begin(folder);
  if (!files) return files.error();
  for (const char* name : {kReferenceVideo, kReferenceTable}) {
    const Status copied = write_file_atomically(
        files->staged() / name, [&](const std::filesystem::path& temporary) -> Status {
          const DiskWait waiting(folder / name);
          std::error_code failed;
          std::filesystem::copy_file(
              copy / name, temporary, std::filesystem::copy_options::overwrite_existing, failed);
          if (!failed) return {};
          return Error{en::say("the finger could not be copied: {}", failed.message()),
                       (copy / name).string(),
                       ""};
        });
    if (!copied) return copied;
  }
  return save_reference(*store, *made, *files);
}

Result<std::vector<Message>> set_untouched_image(const std::filesystem::path& folder,
                                                 const UntouchedImage& image) {
  const auto store = FingerStore::of(folder);
  const auto before = store->snapshot();
  if (!before) return before.error();
  const auto lock = store->lock_for_work(kWork);
  if (!lock) return lock.error();
  Finger finger = (*before)->finger;
  auto files = FolderChange::begin(folder);
  if (!files) return files.error();
  auto warnings = install_flat_reference(image, files->staged(), finger);
  if (!warnings) return warnings.error();
  finger.provenance[kDate] = utc_now();
  if (const Status saved = save_reference(*store, finger, *files); !saved) return saved.error();
  return warnings;
}

}  // namespace alltact
