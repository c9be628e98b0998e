#include "calibration/export/export_finger.h"

#include "calibration/checks/finger_check.h"
#include "calibration/export/export_texts.h"
#include "calibration/finger/calibrate_finger.h"
#include "calibration/finger/measuring_presets.h"
#include "core/base/atomic_file.h"
#include "core/base/utc_time.h"
#include "core/base/zip_file.h"
#include "core/recording/journal.h"

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// With the settings of the finger's calibration, and its current verdict.
Result<std::string> json_of(const Finger& finger, const fs::path& finger_folder) {
  std::optional<Verdict> worth;
  if (const auto snapshot = FingerSnapshot::of(finger_folder, finger))
    worth = worth_of(*snapshot, utc_now()).verdict;
  return calibration_json(finger, calibrated_settings(finger_folder), worth);
}

constexpr const char* kZipName = "finger.zip";

bool has_form(const std::vector<ExportForm>& forms, ExportForm form) {
  return std::find(forms.begin(), forms.end(), form) != forms.end();
}

Result<std::vector<ReportFile>> texts(const Finger& finger, const fs::path& finger_folder,
                                      const std::vector<ExportForm>& forms) {
  std::vector<ReportFile> files;
  std::optional<Error> problem;  // the first
  const auto add = [&](ExportForm form, const char* name, const auto& make) {
    if (problem || !has_form(forms, form)) return;
    if (Result<std::string> content = make(); content)
      files.push_back({name, std::move(content).value()});
    else
      problem = content.error();
  };
  add(ExportForm::kOpencv, "camera.opencv.yaml", [&] { return opencv_camera(finger); });
  add(ExportForm::kRos, "camera_info.yaml", [&] { return ros_camera_info(finger); });
  add(ExportForm::kRos, "parameters.yaml", [&] { return ros_parameters(finger); });
  add(ExportForm::kJson, "calibration.json", [&] { return json_of(finger, finger_folder); });
  if (!problem) return files;
  if (problem->where.empty()) problem->where = finger_folder.string();
  return *problem;
}

/// Every path is below "".
bool is_below(const fs::path& inner, const fs::path& outer) {
  std::error_code ignored;
  const fs::path a = fs::weakly_canonical(inner / "", ignored),
                 b = fs::weakly_canonical(outer / "", ignored);
  const auto ends = std::mismatch(b.begin(), b.end(), a.begin(), a.end());
  return ends.first == b.end() || ends.first->empty();
}

/// Every file of the finger's folder but `left_out`, in the order of their names. Error: something
/// that a zip cannot hold; nothing else is left out.
Result<std::vector<ZipEntry>> files_below(const fs::path& finger_folder,
                                          const std::vector<fs::path>& left_out) {
  std::vector<ZipEntry> entries;
  std::error_code failed;
  fs::recursive_directory_iterator entry(finger_folder, failed);
  for (; !failed && entry != fs::recursive_directory_iterator(); entry.increment(failed)) {
    std::error_code ignored;
    const bool is_folder = entry->is_directory(ignored);
    if (is_folder && !entry->is_symlink(ignored)) continue;
    if (is_folder || !entry->is_regular_file(ignored))
      return Error{is_folder ? en::say("is a link to another folder, which a zip cannot hold")
                             : en::say("is neither a file nor a folder, so a zip cannot hold it"),
                   entry->path().string(), en::say("moving it out of the finger's folder")};
    if (std::find(left_out.begin(), left_out.end(), entry->path()) != left_out.end()) continue;
    const fs::path name = "finger" / entry->path().lexically_relative(finger_folder);
    entries.push_back({name.generic_string(), entry->path(), {}});
  }
  if (failed)
    return Error{en::say("the finger's folder could not be read: {}", failed.message()),
                 finger_folder.string(),
                 en::say("check its permissions, and that its disk is connected")};
  std::sort(entries.begin(), entries.end(),
            [](const ZipEntry& a, const ZipEntry& b) { return a.name < b.name; });
  return entries;
}

Result<std::vector<ZipEntry>> zip_entries(const Finger& finger, const fs::path& finger_folder,
                                          const fs::path& folder) {
  if (is_below(folder, finger_folder))
    return Error{en::say("a zip of the finger cannot be in the finger's own folder"),
                 folder.string(), en::say("another folder")};
  auto json = json_of(finger, finger_folder);
  if (!json) return json.error();
  std::vector<fs::path> left_out = unused_recordings(finger, finger_folder);
  for (std::size_t i = 0, count = left_out.size(); i < count; ++i)
    left_out.push_back(journal_of(left_out[i]));
  auto entries = files_below(finger_folder, left_out);
  if (!entries) return entries.error();
  entries->insert(entries->begin(), {"calibration.json", {}, std::move(json).value()});
  return entries;
}

}  // namespace

const std::vector<ExportFormInfo>& export_forms() {
  static const std::vector<ExportFormInfo> forms = {
      {ExportForm::kOpencv, "opencv", "camera.opencv.yaml"},
      {ExportForm::kRos, "ros", "camera_info.yaml, parameters.yaml"},
      {ExportForm::kJson, "json", "calibration.json"},
      {ExportForm::kZip, "zip", kZipName}};
  return forms;
}

std::optional<ExportForm> export_form_from(std::string_view word) {
  for (const ExportFormInfo& info : export_forms())
    if (info.word == word) return info.form;
  return std::nullopt;
}

std::string export_command(const fs::path& finger_folder, const std::vector<ExportForm>& forms,
                           const fs::path& folder) {
  std::vector<std::string_view> words;
  for (const ExportFormInfo& info : export_forms())
    if (has_form(forms, info.form)) words.push_back(info.word);
  return fmt::format("alltact export {} --to {} -o {}", shell_quoted(finger_folder.string()),
                     fmt::join(words, ","), shell_quoted(folder.string()));
}

std::vector<fs::path> unused_recordings(const Finger& finger, const fs::path& finger_folder) {
  std::vector<fs::path> found;
  std::error_code failed;
  for (fs::directory_iterator entry(finger_folder, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    const fs::path& file = entry->path();
    const bool is_used = finger.reference && file == finger_folder / finger.reference->video;
    std::error_code ignored;
    if (file.extension() == ".mkv" && !is_used && fs::exists(journal_of(file), ignored))
      found.push_back(file);
  }
  std::sort(found.begin(), found.end());
  return found;
}

Status export_finger(const FingerSnapshot& snapshot, const std::vector<ExportForm>& forms,
                     const fs::path& folder, const Job& job, std::vector<fs::path>* written) {
  const Finger& finger = snapshot.finger;
  const fs::path& finger_folder = snapshot.folder;
  const auto parts = texts(finger, finger_folder, forms);
  if (!parts) return parts.error();
  std::optional<std::vector<ZipEntry>> entries;
  if (has_form(forms, ExportForm::kZip)) {
    auto found = zip_entries(finger, finger_folder, folder);
    if (!found) return found.error();
    entries = std::move(found).value();
  }
  if (Status status = make_folder(folder); !status) return status;
  const auto done = [&](const fs::path& file) {
    if (written != nullptr) written->push_back(file);
  };
  for (const ReportFile& part : *parts) {
    const fs::path file = folder / part.name;
    if (job.stop_requested())
      return Error{en::say("stopped before it was written"), file.string(), ""};
    if (Status status = write_file_atomically(file, part.content); !status) return status;
    done(file);
  }
  if (!entries) return {};
  const fs::path file = folder / kZipName;
  if (Status status = write_zip(file, *entries, job); !status) return status;
  done(file);
  return {};
}

}  // namespace alltact
