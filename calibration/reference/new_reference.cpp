#include "calibration/reference/new_reference.h"

#include "calibration/reference/settings_record.h"
#include "core/finger/finger_update.h"
#include "core/sources/open/open_source.h"
#include "core/utc_time.h"

namespace alltact {
namespace {

constexpr const char* kWork = "making the reference";
constexpr const char* kDate = "reference_date";

Status save_reference(const std::filesystem::path& folder, Finger& with_reference) {
  with_reference.provenance[kDate] = utc_now();
  const auto saved = update_finger(folder, [&](Finger& finger) {
    take_reference(with_reference, finger);
    return Status();
  });
  return saved ? Status() : saved.error();
}

}  // namespace

void take_reference(const Finger& from, Finger& finger) {
  finger.reference = from.reference;
  finger.markers = from.markers;
  finger.contact = from.contact;
  for (const char* key : {kDate, kReferenceSettings}) take_provenance(from, key, finger);
}

Result<ReferenceReport> give_reference(const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& inputs,
                                       const Job& job,
                                       const ReferenceChoices& choices) {
  auto finger = Finger::load(folder);
  if (!finger) return finger.error();
  const auto alone = hold_for_work(folder, kWork);
  if (!alone) return alone.error();
  auto source = open_source(inputs);
  if (!source) return source.error();
  auto report = install_reference(**source, folder, *finger, job, choices);
  if (!report) return report.error();
  if (const Status saved = save_reference(folder, *finger); !saved) return saved.error();
  return report;
}

Result<std::vector<Message>> give_untouched_picture(const std::filesystem::path& folder,
                                                    const UntouchedPicture& picture) {
  auto finger = Finger::load(folder);
  if (!finger) return finger.error();
  const auto alone = hold_for_work(folder, kWork);
  if (!alone) return alone.error();
  auto warnings = install_flat_reference(picture, folder, *finger);
  if (!warnings) return warnings.error();
  if (const Status saved = save_reference(folder, *finger); !saved) return saved.error();
  return warnings;
}

}  // namespace alltact
