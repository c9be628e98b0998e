#include "calibration/reference/reference_recording.h"

#include "calibration/reference/make_reference.h"
#include "core/base/atomic_file.h"
#include "core/base/slow_disk.h"
#include "core/base/utc_time.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "core/open/open_source.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr double kTouchSigmas = 5.0;
constexpr double kTouchFloorPx = 0.2;  // of every marker at once: a camera that moves or warms up

// Noise of a sum of offsets: that of one offset times the root of their number, doubled because the
// rest layout was measured too. Never below a shift of all markers without contact.
double touch_threshold_px(double marker_noise_px, std::size_t markers) {
  const auto count = static_cast<double>(markers);
  return std::max(kTouchSigmas * marker_noise_px * std::sqrt(2 * count), kTouchFloorPx * count);
}

/// The motion of a marker that no frame shows is unknown, and with it its estimate in one frame.
std::vector<Eigen::Vector2d> rest_markers(const NumberedRecording& numbered, std::size_t rest) {
  std::vector<Eigen::Vector2d> positions;
  for (const Marker& marker : *numbered.markers[rest]) {
    const auto m = static_cast<int>(positions.size());
    const bool is_missing = std::binary_search(numbered.missing.begin(), numbered.missing.end(), m);
    const Dot& typical = numbered.typical[positions.size()];
    positions.emplace_back(is_missing ? typical.u : marker.u, is_missing ? typical.v : marker.v);
  }
  return positions;
}

void remark(const MarkerTable& table, ReferenceReport& report) {
  std::size_t estimated = 0;
  for (const auto& row : table.seen)
    estimated +=
        static_cast<std::size_t>(std::count(row.begin(), row.end(), 0)) - report.missing.size();
  if (estimated > 0)
    report.remarks.push_back(
        en::say("{} marker positions in {} frames are estimates, because the markers were "
                "covered or not found",
                estimated, report.frames_retained));
  if (report.uncompared > 0)
    report.remarks.push_back(
        en::say("{} frames show poses that occur at no other time; it is unknown whether something "
                "pressed on the contact face in them",
                report.uncompared));
  if (report.frames_retained + report.repeated < 100)
    report.remarks.push_back(
        en::say("{} frames are few: one minute (about 1500 frames) over all bending directions "
                "gives closer references",
                report.frames_retained));
  for (const Message& missing : report.coverage.missing())
    report.remarks.push_back(en::say("Not yet seen: {}", missing));
}

// True: the image is in the folder. One of an earlier recording is removed.
bool write_problem(const fs::path& folder, const cv::Mat& problem) {
  std::error_code ignored;
  if (!problem.empty() && write_image(folder / kReferenceProblem, problem)) return true;
  fs::remove(folder / kReferenceProblem, ignored);
  return false;
}

}  // namespace

bool is_in(const std::vector<FrameRange>& ranges, std::size_t frame) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const FrameRange& range) { return range.holds(static_cast<int>(frame)); });
}

Result<ReferenceReport> install_reference(Source& source, const fs::path& folder, Finger& finger,
                                          const Job& job, const ReferenceChoices& choices) {
  return install_reference(source, folder, finger, job, [&] { return choices; });
}

Result<ReferenceReport> install_reference(Source& source, const fs::path& folder, Finger& finger,
                                          const Job& job, const ChoicesWhenRead& choices,
                                          const fs::path& into) {
  if (finger.face.kind != FaceKind::kFinRay)
    return Error{en::say("this finger has no markers to record a reference with"), folder.string(),
                 en::say("a flat sensor needs one untouched image")};
  const auto camera = Camera::create(finger.camera);
  if (!camera) return camera.error();
  MadeReference made;
  const fs::path files = into.empty() ? folder : into;
  const Status written =
      write_file_atomically(files / kReferenceVideo, [&](const fs::path& temporary) -> Status {
        try {
          const Status status =
              make_reference(source, *camera, finger, job, choices, folder, temporary, made);
          return status ? made.table.save(files / kReferenceTable) : status;
        } catch (const std::exception& problem) {
          return Error{
              en::say("the recording could not be processed ({})", std::string(problem.what())),
              folder.string(), ""};
        }
      });
  const bool is_drawn = write_problem(folder, made.problem);
  if (!written) {
    Error error = written.error();
    if (is_drawn)
      error.advice = en::clauses(
          {error.advice, en::say("{} shows what was found", folder / kReferenceProblem)});
    return error;
  }
  const MarkerTable& table = made.table;
  ReferenceReport& report = made.report;
  Finger described = with_markers(finger, made.numbered);
  finger.reference = described.reference;
  finger.markers = described.markers;
  ContactSettings contact;
  contact.rest_markers = rest_markers(made.numbered, made.rest);
  contact.threshold_px =
      touch_threshold_px(made.numbered.marker_noise_px, contact.rest_markers.size());
  finger.contact = std::move(contact);
  for (Message& warning : record_settings(made.settings, RecordingKind::kReference, finger))
    report.warnings.push_back(std::move(warning));
  if (is_drawn)
    report.remarks.push_back(en::say("{} shows what was found", folder / kReferenceProblem));
  remark(table, report);
  for (Message& assumed : source.remarks()) report.remarks.push_back(std::move(assumed));
  job.report(1.0, en::say("reference installed"));
  return std::move(report);
}

Result<std::vector<Message>> install_flat_reference(const UntouchedImage& image,
                                                    const fs::path& folder, Finger& finger) {
  if (finger.face.kind != FaceKind::kFlat)
    return Error{en::say("only a flat sensor uses one untouched image as its reference"),
                 image.origin, en::say("a recording of the bending, untouched finger")};
  const auto camera = Camera::create(finger.camera);
  if (!camera) return camera.error();
  const auto fitting = oriented_for(finger.camera, image.grey, en::say("the image"), image.origin,
                                    en::say("an untouched image taken with this sensor's camera"));
  if (!fitting) return fitting.error();
  constexpr const char* kImage = "reference.png";
  const Status written = write_image(folder / kImage, image.grey, image.controls);
  if (!written) return written.error();
  finger.reference = ReferenceFiles{"", "", kImage};
  Frame frame;
  if (!image.controls.empty()) frame.controls = std::make_shared<const std::string>(image.controls);
  SettingsMonitor settings;
  settings.add(frame);
  return record_settings(settings, RecordingKind::kReference, finger);
}

Result<UntouchedImage> read_untouched_image(const fs::path& file) {
  UntouchedImage image;
  auto grey = read_grey_image(file, &image.controls);
  if (!grey) return grey.error();
  image.grey = std::move(grey).value();
  image.origin = file;
  return image;
}

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
                                      const Job& job, const ReferenceChoices& choices) {
  auto source = open_source(inputs);
  if (!source) return source.error();
  return set_reference(folder, **source, job, [&] { return choices; });
}

Result<ReferenceReport> set_reference(const std::filesystem::path& folder, Source& source,
                                      const Job& job, const ChoicesWhenRead& choices) {
  const auto store = FingerStore::of(folder);
  const auto before = store->snapshot();
  if (!before) return before.error();
  const auto lock = store->lock_for_work(kWork);
  if (!lock) return lock.error();
  Finger finger = (*before)->finger;
  auto files = FolderChange::begin(folder);
  if (!files) return files.error();
  auto report = install_reference(source, folder, finger, job, choices, files->staged());
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
          std::filesystem::copy_file(copy / name, temporary,
                                     std::filesystem::copy_options::overwrite_existing, failed);
          if (!failed) return {};
          return Error{en::say("the finger could not be copied: {}", failed.message()),
                       (copy / name).string(), ""};
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

namespace {

std::string stored(const Finger& finger, const char* key) {
  const auto found = finger.provenance.find(key);
  return found == finger.provenance.end() ? std::string() : found->second;
}

}  // namespace

std::vector<Message> record_settings(const SettingsMonitor& seen, RecordingKind kind,
                                     Finger& finger) {
  const bool is_reference = kind == RecordingKind::kReference;
  const char* key = is_reference ? kReferenceSettings : kPressSettings;
  const Message reference = en::say("reference"), presses = en::say("presses");
  const Message taken = is_reference ? reference : en::say("set of presses");
  std::vector<Message> warnings;
  if (!seen.change().empty())
    warnings.push_back(
        en::say("The {} was taken with changing settings of camera or light: {}. Lock them, and "
                "record it again.",
                taken, seen.change()));
  const Message other =
      differences(stored(finger, is_reference ? kPressSettings : kReferenceSettings), seen.first());
  if (!other.empty())
    warnings.push_back(
        en::say("The {} and the {} were taken with different settings: {}. Depth comes from "
                "comparing their brightness: record one of them again.",
                is_reference ? reference : presses, is_reference ? presses : reference, other));
  if (seen.first().empty()) {
    finger.provenance.erase(key);
  } else {
    finger.provenance[key] = seen.first();
  }
  return warnings;
}

Message other_settings_than_stored(const Frame& frame, const Finger& finger) {
  if (frame.controls == nullptr) return {};
  std::string before = stored(finger, kPressSettings);
  if (before.empty()) before = stored(finger, kReferenceSettings);
  const Message other = differences(before, *frame.controls);
  if (other.empty()) return {};
  return en::say(
      "The finger was calibrated with other settings: {}. Restore them, or calibrate again.",
      other);
}

}  // namespace alltact
