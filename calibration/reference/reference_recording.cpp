#include "calibration/reference/reference_recording.h"

#include "calibration/reference/make_reference.h"
#include "calibration/reference/settings_record.h"
#include "core/io/atomic_file.h"
#include "core/io/image_file.h"

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

void remark(const MarkerTable& table, ReferenceReport& report) {
  std::size_t estimated = 0;
  for (const auto& row : table.seen)
    estimated +=
        static_cast<std::size_t>(std::count(row.begin(), row.end(), 0)) - report.missing.size();
  if (estimated > 0)
    report.remarks.push_back(
        en::say("{} marker positions in {} frames are estimates, because the markers were "
                "covered or not found",
                estimated,
                report.frames_retained));
  if (report.uncompared > 0)
    report.remarks.push_back(
        en::say("{} frames show poses that no other frame shows at another time; whether something "
                "pressed on the contact face in them is not known",
                report.uncompared));
  if (report.frames_retained + report.repeated < 100)
    report.remarks.push_back(
        en::say("{} frames are few: a recording of a minute (about 1500 frames) over all "
                "directions of bending gives closer references",
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
  return std::any_of(ranges.begin(), ranges.end(), [&](const FrameRange& range) {
    return range.holds(static_cast<int>(frame));
  });
}

Result<ReferenceReport> install_reference(Source& source,
                                          const fs::path& folder,
                                          Finger& finger,
                                          const Job& job,
                                          const ReferenceChoices& choices,
                                          const fs::path& into) {
  if (finger.face.kind != FaceKind::kFinRay)
    return Error{en::say("this finger has no markers to record a reference with"),
                 folder.string(),
                 en::say("a flat sensor takes one untouched picture")};
  const auto camera = Camera::create(finger.camera);
  if (!camera) return camera.error();
  MadeReference made;
  made.report.coverage = MotionCoverage(choices.need);
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
              folder.string(),
              ""};
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
  for (const Marker& marker : *made.numbered.markers[made.rest])
    contact.rest_markers.emplace_back(marker.u, marker.v);
  contact.threshold_px =
      touch_threshold_px(made.numbered.marker_noise_px, contact.rest_markers.size());
  finger.contact = std::move(contact);
  for (Message& warning : record_settings(made.settings, RecordingKind::kReference, finger))
    report.warnings.push_back(std::move(warning));
  if (is_drawn)
    report.remarks.push_back(en::say("{} shows what was found", folder / kReferenceProblem));
  remark(table, report);
  job.report(1.0, en::say("reference installed"));
  return std::move(report);
}

Result<std::vector<Message>> install_flat_reference(const UntouchedImage& image,
                                                    const fs::path& folder,
                                                    Finger& finger) {
  if (finger.face.kind != FaceKind::kFlat)
    return Error{en::say("only a flat sensor takes one untouched picture as its reference"),
                 image.origin,
                 en::say("a recording of the bending, untouched finger")};
  const auto camera = Camera::create(finger.camera);
  if (!camera) return camera.error();
  const auto fitting =
      oriented_for(finger.camera,
                   image.grey,
                   en::say("the picture"),
                   image.origin,
                   en::say("an untouched picture taken with this sensor's camera"));
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

}  // namespace alltact
