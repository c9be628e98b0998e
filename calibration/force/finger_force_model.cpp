#include "calibration/force/finger_force_model.h"

#include "core/finger/force_model.h"
#include "core/io/atomic_file.h"
#include "core/numerics/checksum.h"
#include "core/program.h"
#include "core/utc_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kForceFolder = "force";
constexpr const char* kForceBefore = "force_before";  // provenance: the model before this one
constexpr const char* kForceDate = "force_date";
constexpr const char* kForceTable = "table";          // in the model's record
constexpr const char* kForceSplit = "split";          // in the record, too
constexpr const char* kRequestedKind = "asked_kind";  // in the record: a kind, or "auto"
constexpr const char* kNoForce = "none";

std::string hash_of(std::string_view text) {
  Checksum checksum;
  checksum.add(text.data(), text.size());
  return checksum.text();
}

/// Minimum distance of neighbouring markers of a row at rest.
double rest_spacing_px(const std::vector<Eigen::Vector2d>& rest) {
  double min_px = std::numeric_limits<double>::infinity();
  const std::size_t per_row = rest.size() / 2;
  for (std::size_t m = 1; m < rest.size(); ++m)
    if (m != per_row) min_px = std::min(min_px, (rest[m] - rest[m - 1]).norm());
  return min_px;
}

std::string numbers_text(const Eigen::VectorXd& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{}{:.4g}", text.empty() ? "" : " ", value);
  return text;
}

/// Records the figures of a training in the model.
void write_record(const TrainedForce& trained, const ForceTraining& options, ForceModel& model) {
  auto& record = model.record;
  record[kRequestedKind] = options.kind ? to_string(*options.kind) : "auto";
  record[kForceSplit] = std::string(kForceSplits.at(static_cast<std::size_t>(options.split) - 1));
  record["rows"] = fmt::format("{}", trained.held_out_N.rows());
  for (const ForceComparison& row : trained.comparison)
    record["held_out_" + to_string(row.kind) + "_n"] = numbers_text(row.mae_N);
  record["covered_90"] = numbers_text(trained.covered_90);
  record["covered_95"] = numbers_text(trained.covered_95);
  record["label_noise_n"] = numbers_text(trained.label_noise_N);
  record["program_version"] = program_version();
}

std::string force_before(const Finger& finger) {
  return finger.force_model.empty() ? std::string(kNoForce) : finger.force_model;
}

}  // namespace

Status check_force_markers(const ForceTable& table, const Finger& finger) {
  const Message advice = en::say("a table of this finger's markers");
  if (finger.marker_count() == 0)
    return Error{en::say("the finger has no markers, so they cannot tell a force"),
                 finger.name,
                 en::say("a finger with markers")};
  if (!finger.contact)
    return Error{en::say("the finger has no reference, so it is not known where its markers rest"),
                 finger.name,
                 en::say("alltact reference")};
  if (table.marker_count != finger.marker_count())
    return Error{en::say("the table has {} markers, the finger has {}",
                         table.marker_count,
                         finger.marker_count()),
                 finger.name,
                 advice};
  const auto& rest = finger.contact->rest_markers;
  double nearest_px = std::numeric_limits<double>::infinity();
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    double squares = 0, count = 0;
    for (Eigen::Index m = 0; m < table.marker_count; ++m)
      if (table.seen(row, m) > 0.5) {
        squares += (table.layouts.row(row).segment<2>(2 * m).transpose() -
                    rest[static_cast<std::size_t>(m)])
                       .squaredNorm();
        count += 1;
      }
    nearest_px = std::min(nearest_px, std::sqrt(squares / count));
  }
  if (nearest_px > rest_spacing_px(rest))
    return Error{
        en::say("the table's markers are another finger's: in every row they lie {:.0f} px "
                "or more from where this finger's rest",
                nearest_px),
        finger.name,
        advice};
  return {};
}

Result<TrainedForce> train_finger_force(const fs::path& folder,
                                        const ForceTable& table,
                                        const ForceTraining& options,
                                        const Job& job) {
  const auto store = FingerStore::of(folder);
  const auto before = store->snapshot();
  if (!before) return before.error();
  const Finger& finger = (*before)->finger;
  if (const Status fits = check_force_markers(table, finger); !fits) return fits.error();
  const auto lock = store->lock_for_work("training the force model");
  if (!lock) return lock.error();
  auto trained = train_force(table, finger.contact->rest_markers, options, job);
  if (!trained) return trained.error();
  const std::string csv = table.to_csv();
  const fs::path table_file = fs::path(kForceFolder) / ("table-" + hash_of(csv) + ".csv");
  ForceModel& model = trained->model;
  model.missing = finger.markers.missing;
  write_record(*trained, options, model);
  model.record[kForceTable] = table_file.generic_string();
  if (const Status valid = model.validate(); !valid) return valid.error();
  const std::string json = model.to_json();
  const fs::path model_file = fs::path(kForceFolder) / ("model-" + hash_of(json) + ".json");
  if (const Status made = make_folder(folder / kForceFolder); !made) return made.error();
  if (const Status written = write_file_atomically(folder / table_file, csv); !written)
    return written.error();
  if (const Status written = write_file_atomically(folder / model_file, json); !written)
    return written.error();
  const auto saved = store->update([&](Finger& now) -> Status {
    if (const Status fits = model.belongs_to(now); !fits) return fits;
    if (now.force_model != model_file.generic_string())
      now.provenance[kForceBefore] = force_before(now);
    now.force_model = model_file.generic_string();
    now.provenance[kForceDate] = utc_now();
    return {};
  });
  if (!saved) return saved.error();
  return trained;
}

Result<FingerPtr> revert_force(const fs::path& folder) {
  return FingerStore::of(folder)->update([&](Finger& finger) -> Status {
    const auto before = finger.provenance.find(kForceBefore);
    if (before == finger.provenance.end())
      return Error{en::say("there is no force model to take back"), folder, ""};
    const std::string file = before->second == kNoForce ? std::string() : before->second;
    if (!file.empty())
      if (const auto model = ForceModel::load(folder / file); !model) return model.error();
    finger.provenance[kForceBefore] = force_before(finger);
    finger.force_model = file;
    return {};
  });
}

namespace {

/// The current model of a finger. Error: none, or it cannot be read.
Result<std::shared_ptr<const ForceModel>> stored_model(const fs::path& folder) {
  const auto snapshot = FingerStore::of(folder)->snapshot();
  if (!snapshot) return snapshot.error();
  if ((*snapshot)->force_problem) return *(*snapshot)->force_problem;
  if (!(*snapshot)->force)
    return Error{en::say("the finger has no force model yet"),
                 folder,
                 en::say("giving the table to train with")};
  return (*snapshot)->force;
}

}  // namespace

Result<ForceTraining> stored_force_training(const fs::path& folder) {
  const auto model = stored_model(folder);
  if (!model) return model.error();
  ForceTraining training;
  training.creep_s = (*model)->creep_s;
  const auto value_of = [&](const char* key) {
    const auto found = (*model)->record.find(key);
    return found == (*model)->record.end() ? std::string() : found->second;
  };
  const auto split = std::find(kForceSplits.begin(), kForceSplits.end(), value_of(kForceSplit));
  if (split != kForceSplits.end())
    training.split = static_cast<ForceSplit>(split - kForceSplits.begin() + 1);
  const auto kind = std::find(kForceKinds.begin(), kForceKinds.end(), value_of(kRequestedKind));
  if (kind != kForceKinds.end())
    training.kind = static_cast<ForceKind>(kind - kForceKinds.begin() + 1);
  return training;
}

Result<ForceTable> stored_force_table(const fs::path& folder) {
  const auto model = stored_model(folder);
  if (!model) return model.error();
  const auto& record = (*model)->record;
  const auto table = record.find(kForceTable);
  if (table == record.end() || fs::path(table->second).parent_path() != fs::path(kForceFolder))
    return Error{en::say("the force model does not say which table it is of"),
                 folder,
                 en::say("giving the table to train with")};
  return ForceTable::load(folder / table->second);
}

}  // namespace alltact
