#include "calibration/finger/finger_evidence.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/finger/calibration_report.h"
#include "core/finger/reduced_finger.h"
#include "core/io/image_file.h"
#include "core/recording/matroska_index.h"
#include "core/recording/video_file.h"
#include "core/sensing/reference/flat_reference.h"
#include "core/sensing/reference/marker_table.h"
#include "core/utc_time.h"

#include <algorithm>
#include <map>
#include <mutex>

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

bool has_content(const fs::path& file) {
  std::error_code failed;
  return fs::is_regular_file(file, failed) && fs::file_size(file, failed) > 0;
}

/// Size and time of a file, from its folder entry.
std::string stamp_of(const fs::path& file) {
  std::error_code failed;
  const auto size = fs::file_size(file, failed);
  const auto written = fs::last_write_time(file, failed);
  return failed ? file.string() + " absent"
                : fmt::format("{} {} {}", file.string(), size, written.time_since_epoch().count());
}

/// States of references by their files: requested at every refresh of a window.
class StateCache {
 public:
  [[nodiscard]] std::optional<ReferenceState> find(const std::string& key) {
    const std::lock_guard lock(mutex_);
    const auto found = states_.find(key);
    return found == states_.end() ? std::nullopt : std::optional(found->second);
  }
  void put(const std::string& key, ReferenceState state) {
    constexpr std::size_t kMost = 1000;
    const std::lock_guard lock(mutex_);
    if (states_.size() >= kMost) states_.clear();
    states_[key] = state;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, ReferenceState> states_;
};

ReferenceState recording_state(const FingerSnapshot& snapshot) {
  const ReferenceFiles& files = *snapshot.finger.reference;
  const fs::path video = snapshot.folder / files.video, markers = snapshot.folder / files.markers;
  std::error_code failed;
  if (!fs::exists(video, failed) || !fs::exists(markers, failed)) return ReferenceState::kMissing;
  if (!has_content(video) || !has_content(markers)) return ReferenceState::kCut;
  // Opening would repair a recording that a crash truncated: its structure is checked first.
  if (const auto index = index_matroska(video);
      index && (!index->has_length || !index->is_walkable || index->blocks.empty()))
    return ReferenceState::kCut;
  const auto table = MarkerTable::load(markers, snapshot.finger.marker_count());
  if (!table || table->frames.empty()) return ReferenceState::kCut;
  auto recording = VideoFile::open(video);
  if (!recording ||
      static_cast<std::size_t>(std::max(0, table->frames.back())) >= recording->frame_count())
    return ReferenceState::kCut;
  const auto frame = recording->frame(0);
  if (!frame || (*frame)->grey.empty()) return ReferenceState::kCut;
  const auto image = image_for(snapshot, (*frame)->grey, "", video.string(), "");
  return image ? ReferenceState::kIntact : ReferenceState::kOtherImage;
}

ReferenceState image_state(const FingerSnapshot& snapshot) {
  const fs::path image = snapshot.folder / snapshot.finger.reference->image;
  std::error_code failed;
  if (!fs::exists(image, failed)) return ReferenceState::kMissing;
  if (!read_grey_image(image)) return ReferenceState::kCut;
  return flat_reference(snapshot) ? ReferenceState::kIntact : ReferenceState::kOtherImage;
}

}  // namespace

std::optional<double> days_between(const std::string& then, const std::string& now) {
  constexpr double kDay_s = 86400;
  const auto then_s = unix_seconds(then), now_s = unix_seconds(now);
  if (!then_s || !now_s) return std::nullopt;
  return (*now_s - *then_s) / kDay_s;
}

ReferenceState reference_state(const FingerSnapshot& snapshot) {
  const auto& reference = snapshot.finger.reference;
  if (!reference) return ReferenceState::kAbsent;
  std::string key = fmt::format("{} {} {}",
                                snapshot.reduced_by,
                                camera_fingerprint(snapshot.finger.camera),
                                snapshot.finger.marker_count());
  for (const std::string& name : {reference->image, reference->video, reference->markers})
    if (!name.empty()) key += '\n' + stamp_of(snapshot.folder / name);
  static StateCache cache;
  if (const auto known = cache.find(key)) return *known;
  const ReferenceState state =
      reference->image.empty() ? recording_state(snapshot) : image_state(snapshot);
  cache.put(key, state);
  return state;
}

CalibrationEvidence evidence_in(const FingerSnapshot& snapshot,
                                const std::string& now,
                                const std::string& passed) {
  Finger finger = snapshot.finger;
  if (snapshot.reduced_by > 1) finger.camera = snapshot.full_camera;
  CalibrationEvidence evidence = evidence_of(finger);
  evidence.reference = reference_state(snapshot);
  evidence.repeat_command = Message::typed(repeat_command(snapshot.folder));
  // The checksum covers fields outside the record: markers, and files of earlier versions.
  if (evidence.changed.empty() && finger.mapping_record)
    if (const auto inputs = CalibrationInputs::load(snapshot.folder);
        inputs && !inputs->finger_checksum.empty() &&
        inputs->finger_checksum != finger_checksum(finger))
      evidence.changed.push_back(en::say("camera, face or markers"));
  const auto made = snapshot.finger.provenance.find("calibration_date");
  for (const std::string& time :
       {made == snapshot.finger.provenance.end() ? std::string() : made->second, passed})
    if (const auto days = days_between(time, now))
      evidence.days_unchecked = std::min(*days, evidence.days_unchecked.value_or(*days));
  return evidence;
}

}  // namespace alltact
