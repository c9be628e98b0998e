#include "core/finger/finger_store.h"

#include "core/base/atomic_file.h"
#include "core/base/program.h"
#include "core/base/slow_disk.h"
#include "core/base/utc_time.h"
#include "core/camera/camera.h"
#include "core/finger/force_model.h"

#include <map>

#include <fmt/format.h>
#include <sys/stat.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr auto kLockTimeout = std::chrono::seconds(10);
constexpr const char* kChanging = ".finger.changing";
constexpr const char* kWorking = ".finger.working";

/// Identifies a version of a file: differs after every write; empty: it does not exist.
std::string written(const fs::path& file) {
  const DiskWait waiting(file);
  struct stat of {};
  if (stat(file.c_str(), &of) != 0) return {};
  return fmt::format("{} {} {}.{:09}", of.st_ino, of.st_size, of.st_mtim.tv_sec,
                     of.st_mtim.tv_nsec);
}

/// Warns of dates ahead of the clock: a wrong clock reverses the order of dates.
std::optional<Message> about_clock(const Finger& finger) {
  std::string latest;
  for (const auto& [key, value] : finger.provenance)
    if (key.ends_with("_date") && is_ahead_of_clock(value)) latest = std::max(latest, value);
  if (latest.empty()) return std::nullopt;
  return en::say("{} was last changed at {}, and this computer's clock shows {}: set the clock",
                 finger.name, latest, utc_now());
}

/// Loads everything but the presses.
Result<FingerSnapshot> load(const fs::path& folder, std::uint64_t revision) {
  std::vector<Message> warnings;
  auto finger = Finger::load(folder, &warnings);
  if (!finger) return finger.error();
  auto all = FingerSnapshot::of(folder, std::move(*finger));
  if (!all) return all.error();
  if (auto clock = about_clock(all->finger)) warnings.push_back(std::move(*clock));
  all->revision = revision;
  all->warnings = std::move(warnings);
  return all;
}

/// Reads the finger's force model; a model that cannot be read does not affect the rest.
void load_force(const fs::path& folder, FingerSnapshot& snapshot) {
  if (snapshot.finger.force_model.empty()) return;
  auto model = ForceModel::load(folder / snapshot.finger.force_model);
  if (model)
    snapshot.force = std::make_shared<const ForceModel>(std::move(*model));
  else
    snapshot.force_problem = model.error();
}

/// Completes a change that another program decided before it ended, or is just making.
Status complete(const fs::path& folder) {
  if (!has_open_change(folder)) return {};
  const auto held = LockFile::hold(folder / kChanging, this_process("changing"), kLockTimeout);
  if (held) return complete_change(folder);
  Error why = held.error();
  const Message reason = why.what;
  why.what = en::say("a change of the finger that was interrupted cannot be completed: {}", reason);
  return why;
}

}  // namespace

struct FingerStore::Listening {
  std::recursive_mutex mutex;  // recursive: a listener may end its own listening
  Listener listener;
};

Result<FingerSnapshot> FingerSnapshot::of(const fs::path& folder, Finger finger) {
  const auto camera = Camera::create(finger.camera);
  if (!camera) return camera.error();
  std::optional<Mapping> mapping;
  if (finger.mapping) {
    auto made = Mapping::create(*finger.mapping);
    if (!made) return made.error();
    mapping = std::move(*made);
  }
  return FingerSnapshot{
      folder, 0, std::move(finger), *camera, std::move(mapping), {}, {}, {}, {}, {}, 1, {}, {}};
}

FingerSnapshot FingerSnapshot::without_mapping() const {
  FingerSnapshot blank = *this;
  blank.finger.mapping.reset();
  blank.mapping.reset();
  return blank;
}

std::shared_ptr<FingerStore> FingerStore::of(const fs::path& folder) {
  static std::mutex mutex;
  static std::map<fs::path, std::weak_ptr<FingerStore>> stores;
  std::error_code failed;
  fs::path full = fs::weakly_canonical(folder, failed);
  if (failed) full = folder;
  if (!full.has_filename()) full = full.parent_path();  // the path ended in a slash
  const std::lock_guard lock(mutex);
  std::erase_if(stores, [](const auto& entry) { return entry.second.expired(); });
  auto store = stores[full].lock();
  if (!store) stores[full] = store = std::make_shared<FingerStore>(folder);
  return store;
}

Result<FingerPtr> FingerStore::read() {
  const std::string finger_now = written(folder_ / Finger::kFileName);
  const std::string presses_now = written(PressSet::file_in(folder_));
  const std::string measuring_now = written(folder_ / kMeasuringFile);
  const auto force_now = [&](const Finger& finger) {
    return finger.force_model.empty() ? std::string() : written(folder_ / finger.force_model);
  };
  const bool is_same_finger =
      last_ && finger_now == finger_written_ && force_now(last_->finger) == force_written_;
  if (is_same_finger && presses_now == presses_written_ && measuring_now == measuring_written_)
    return last_;
  auto next = is_same_finger ? Result(*last_) : load(folder_, last_ ? last_->revision + 1 : 1);
  if (!next) return next.error();
  const std::string force_written = force_now(next->finger);
  const bool is_same_force = last_ && last_->finger.force_model == next->finger.force_model &&
                             force_written == force_written_;
  if (is_same_force)
    next->force = last_->force, next->force_problem = last_->force_problem;
  else
    load_force(folder_, *next);
  auto presses = PressSet::load(folder_);
  next->presses_problem = presses ? std::nullopt : std::optional(presses.error());
  next->presses = presses ? std::move(*presses) : PressSet();
  const auto measuring = read_file(folder_ / kMeasuringFile);
  next->measuring = measuring ? *measuring : std::string();
  last_ = std::make_shared<const FingerSnapshot>(std::move(*next));
  finger_written_ = finger_now;
  presses_written_ = presses_now;
  force_written_ = force_written;
  measuring_written_ = measuring_now;
  return last_;
}

Result<FingerPtr> FingerStore::snapshot() {
  if (const Status completed = complete(folder_); !completed) return completed.error();
  FingerPtr before;
  auto now = [&] {
    const std::lock_guard lock(mutex_);
    before = last_;
    return read();
  }();
  if (now && before && before != *now) notify(*now, before);
  return now;
}

Result<FingerPtr> FingerStore::update(const std::function<Status(Finger&)>& change) {
  // Without write access the finger's own problem is reported first.
  const auto there = snapshot();
  if (!there) return there.error();
  FingerPtr before = *there;
  auto changed = [&]() -> Result<FingerPtr> {
    const auto held = LockFile::hold(folder_ / kChanging, this_process("changing"), kLockTimeout);
    if (!held) return held.error();
    if (const Status completed = complete_change(folder_); !completed) return completed.error();
    auto finger = Finger::load(folder_);
    if (!finger) return finger.error();
    if (Status status = change(*finger); !status) return status.error();
    if (Status status = finger->save(folder_); !status) return status.error();
    const std::lock_guard lock(mutex_);
    before = last_;
    return read();
  }();
  // Where another thread has read it meanwhile, that one notifies.
  if (changed && before != *changed) notify(*changed, before);
  return changed;
}

Status FingerStore::save_presses(const PressSet& presses) {
  if (Status saved = presses.save(folder_); !saved) return saved;
  const auto now = snapshot();
  return now ? Status() : Status(now.error());
}

Status FingerStore::save_measuring(
    const std::function<Result<std::string>(const fs::path& folder)>& content) {
  {
    const auto held = LockFile::hold(folder_ / kChanging, this_process("changing"), kLockTimeout);
    if (!held) return held.error();
    const auto text = content(folder_);
    if (!text) return text.error();
    if (Status saved = write_file_atomically(folder_ / kMeasuringFile, *text); !saved) return saved;
  }
  const auto now = snapshot();
  return now ? Status() : Status(now.error());
}

Result<LockFile> FingerStore::lock_for_work(const std::string& doing) {
  return LockFile::hold(folder_ / kWorking, this_process(doing), std::chrono::milliseconds(0));
}

std::shared_ptr<void> FingerStore::listen(Listener listener) {
  auto listening = std::make_shared<Listening>();
  listening->listener = std::move(listener);
  const std::lock_guard lock(mutex_);
  listening_.push_back(listening);
  return std::shared_ptr<void>(listening.get(), [listening](void*) {
    const std::lock_guard ending(listening->mutex);
    listening->listener = nullptr;
  });
}

void FingerStore::notify(const FingerPtr& now, const FingerPtr& before) {
  std::vector<std::shared_ptr<Listening>> all;
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(listening_, [](const auto& one) { return one.expired(); });
    for (const auto& one : listening_)
      if (auto listening = one.lock()) all.push_back(std::move(listening));
  }
  for (const auto& one : all) {
    const std::lock_guard calling(one->mutex);
    if (one->listener) one->listener(now, before);
  }
}

Result<FingerPtr> open_finger(const fs::path& folder) {
  return FingerStore::of(folder)->snapshot();
}

void copy_provenance(const Finger& from, const std::string& key, Finger& finger) {
  const auto entry = from.provenance.find(key);
  if (entry == from.provenance.end())
    finger.provenance.erase(key);
  else
    finger.provenance[key] = entry->second;
}

FingerSnapshot reduced_finger(const FingerSnapshot& finger, int by) {
  if (by == 1 || finger.reduced_by != 1) return finger;
  const CameraParameters parameters = reduced_camera(finger.finger.camera, by);
  auto camera = Camera::create(parameters);
  if (!camera) return finger;
  FingerSnapshot reduced = finger;
  reduced.reduced_by = by;
  reduced.full_camera = finger.finger.camera;
  reduced.finger.camera = parameters;
  reduced.camera = std::move(camera).value();
  if (auto& contact = reduced.finger.contact) {
    contact->threshold_px /= by;
    for (Eigen::Vector2d& marker : contact->rest_markers)
      marker = {reduced_px(marker.x(), by), reduced_px(marker.y(), by)};
  }
  if (auto& reference = reduced.finger.reference; reference && reference->positions)
    reference->positions->from_u_px = reduced_px(reference->positions->from_u_px, by);
  return reduced;
}

Result<cv::Mat> image_for(const FingerSnapshot& finger, const cv::Mat& raw, const Message& what,
                          const Where& where, const Message& advice) {
  const CameraParameters& camera =
      finger.reduced_by == 1 ? finger.finger.camera : finger.full_camera;
  auto turned = oriented_for(camera, raw, what, where, advice);
  if (!turned) return turned.error();
  return reduced_image(*turned, finger.reduced_by);
}

Result<Finger> make_finger(const NewFinger& requested, CameraFile* camera_file) {
  std::error_code ignored;
  const std::filesystem::path file = requested.finger / Finger::kFileName;
  if (std::filesystem::exists(file, ignored)) {
    return Error{en::say("there is a finger already, and it is never overwritten"), file.string(),
                 en::say("another folder, or moving that one away")};
  }
  const auto camera = load_camera(requested.camera);
  if (!camera) return camera.error();
  if (camera_file != nullptr) *camera_file = *camera;

  Finger finger;
  finger.name = requested.name;
  if (finger.name.empty())
    finger.name =
        std::filesystem::absolute(requested.finger / "").parent_path().filename().string();
  finger.camera = camera->parameters;
  finger.lens_record = camera->lens;
  finger.face.kind = requested.kind;
  finger.face.width_mm = requested.width_mm;
  finger.face.layer_mm = requested.layer_mm;
  finger.face.plane_z_mm = requested.plane_z_mm;
  finger.markers.per_row = requested.per_row;
  finger.markers.polarity = requested.polarity;
  finger.gripper_from_camera = requested.gripper_from_camera;
  finger.provenance["program_version"] = program_version();
  if (const Status status = finger.validate(); !status) return status.error();
  if (const Status status = make_folder(requested.finger); !status) return status.error();
  if (const Status status = finger.save(requested.finger); !status) return status.error();
  return finger;
}

}  // namespace alltact
