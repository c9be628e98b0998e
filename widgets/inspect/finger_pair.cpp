#include "widgets/inspect/finger_pair.h"

#include "core/finger/finger_store.h"

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// The contact face without vertical exaggeration.
cv::Mat contact_face(const FaceSurface& surface) {
  cv::Mat face = surface.untouched_mm.clone();
  for (int j = 0; j < face.rows; ++j)
    for (int i = 0; i < face.cols; ++i)
      if (const float depth = surface.depth_mm.at<float>(j, i); std::isfinite(depth))
        face.at<cv::Vec3f>(j, i)[2] -= depth;
  return face;
}

}  // namespace

FingerPair::FingerPair(const Inspection& first, QObject* parent) : QObject(parent), first_(first) {
  connect(&inspection_, &Inspection::frame_ready, this, [this] {
    measure();
    Q_EMIT changed();
  });
  connect(&inspection_, &Inspection::state_changed, this, [this] {
    follow();
    Q_EMIT changed();
  });
  connect(&reading_, &BackgroundWork::finished, this, [this] {
    measure();
    Q_EMIT changed();
  });
  connect(&measuring_, &BackgroundWork::finished, this, [this] {
    measure();
    Q_EMIT changed();
  });
}

FingerPair::~FingerPair() = default;

void FingerPair::set_first(const fs::path& finger) {
  if (folders_[0] == finger) return;
  folders_[0] = finger;
  if (is_open()) read_mounts();
}

void FingerPair::open(const std::optional<SecondFinger>& second) {
  if (second_ == second) return;
  second_ = second;
  folders_[1] = second ? second->finger : fs::path();
  partner_ = {};
  inspection_.set_finger(folders_[1]);
  inspection_.open(second ? second->recording : fs::path());
  if (second) read_mounts();
  follow();
  Q_EMIT changed();
}

void FingerPair::follow() {
  const auto &own = first_.recording(), &other = inspection_.recording();
  if (!is_open() || !own || !other || !first_.frame()) return;
  static const FrameTimes kNone;
  const MatchedFrame partner = match_frame(first_.frame()->number,
                                           own->times_ns ? *own->times_ns : kNone,
                                           other->times_ns ? *other->times_ns : kNone,
                                           other->count);
  const bool is_new = partner.number != partner_.number;
  partner_ = partner;
  if (is_new) inspection_.show_frame(partner.number);
  measure();
}

void FingerPair::read_mounts() {
  reading_.restart([this, folders = folders_, disk = disk_](const Job&) {
    disk->wait();
    auto mounts = std::make_shared<std::map<fs::path, FingerMount>>();
    auto problem = std::make_shared<std::optional<Error>>();
    for (const fs::path& folder : folders) {
      if (folder.empty()) continue;
      const auto opened = open_finger(folder);
      if (opened)
        (*mounts)[folder] = {(*opened)->finger.name, (*opened)->finger.gripper_from_camera};
      else
        *problem = opened.error();
    }
    return std::function<void()>([this, mounts, problem] {
      mounts_ = *mounts;
      read_problem_ = *problem;
    });
  });
}

const FingerMount* FingerPair::mount(bool is_second) const {
  const auto found = mounts_.find(folder(is_second));
  return found == mounts_.end() ? nullptr : &found->second;
}

QString FingerPair::name(bool is_second) const {
  if (const FingerMount* known = mount(is_second)) return QString::fromStdString(known->name);
  return QString::fromStdString(folder(is_second).filename().string());
}

bool FingerPair::has_both_poses() const {
  const FingerMount *first = mount(false), *second = mount(true);
  return is_open() && first != nullptr && second != nullptr && first->gripper_from_camera &&
         second->gripper_from_camera;
}

RigidTransform FingerPair::pose(bool is_second) const {
  return *mount(is_second)->gripper_from_camera;
}

std::optional<FramePair> FingerPair::frames() const {
  const auto &own = first_.frame(), &other = inspection_.frame();
  if (!is_open() || !own || !other || !own->surface || !other->surface) return std::nullopt;
  return FramePair{own, other};
}

std::optional<NearestPoints> FingerPair::gap() const {
  const auto now = frames();
  if (!now || !measured_ || !has_both_poses() || !(measured_->frames == *now) ||
      measured_->poses != std::array{pose(false), pose(true)})
    return std::nullopt;
  return measured_->gap;
}

void FingerPair::measure() {
  const auto now = frames();
  if (!now || !has_both_poses() || measuring_.is_running()) return;
  const std::array poses{pose(false), pose(true)};
  if (measured_ && measured_->frames == *now && measured_->poses == poses) return;
  measuring_.start([this, frames = *now, poses](const Job&) {
    const auto gap = nearest_points({contact_face(*frames.first->surface), poses[0]},
                                    {contact_face(*frames.second->surface), poses[1]});
    return std::function<void()>([this, frames, poses, gap] {
      measured_ = Measured{frames, poses, gap};
    });
  });
}

std::optional<Error> FingerPair::problem() const {
  if (const auto written = disk_->problem()) return written;
  return is_open() ? read_problem_ : std::nullopt;
}

void FingerPair::set_pose(const fs::path& folder,
                          const std::optional<RigidTransform>& gripper_from_camera) {
  disk_->add([folder, gripper_from_camera]() -> Status {
    const auto changed = FingerStore::of(folder)->update([&](Finger& finger) {
      finger.gripper_from_camera = gripper_from_camera;
      return Status();
    });
    return changed ? Status() : changed.error();
  });
  read_mounts();
}

}  // namespace alltact
