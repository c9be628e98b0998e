#include "app/studio/workspace.h"

#include "core/base/program.h"
#include "widgets/undo_step.h"

#include <chrono>

namespace alltact {
namespace {

constexpr std::chrono::seconds kBetweenLooksAtFinger{2};
using InputsChange = ValueChange<Workspace::Inputs>;

std::filesystem::path absolute_path(const std::filesystem::path& folder) {
  std::error_code ignored;
  return folder.empty() ? folder : std::filesystem::absolute(folder, ignored);
}

void put_first(const std::filesystem::path& path, std::vector<std::filesystem::path>& recent) {
  std::erase(recent, path);
  recent.insert(recent.begin(), path);
  if (recent.size() > kMaxRecentFingers) recent.resize(kMaxRecentFingers);
}

/// A video, a folder of images or a scene of the user's: no camera, no scene of the program. By its
/// name alone, since its disk may not answer.
bool is_own_file(const std::filesystem::path& source) {
  const bool is_device = !source.has_parent_path() || source.string().starts_with("/dev/");
  const auto shipped = find_resource("scenes/" + source.filename().string());
  return !is_device && !(shipped && *shipped == source);
}

}  // namespace

QString short_name(const std::filesystem::path& path) {
  const auto own = path.has_filename() ? path : path.parent_path();
  // A folder that is only called what it holds has its name from the one above.
  const bool is_general = own.filename() == "finger" && own.has_parent_path();
  const auto name = is_general ? own.parent_path().filename() / own.filename() : own.filename();
  return QString::fromStdString(name.string());
}

Workspace::Workspace(LiveSession& session, QUndoStack& undo,
                     const std::optional<SessionState>& last)
    : session_(session), undo_(undo) {
  connect(&poll_timer_, &QTimer::timeout, this, [this] {
    if (!store_) return;
    polling_.start([store = store_](const Job&) {  // the store notifies its listeners
      [[maybe_unused]] const auto finger = store->snapshot();
      return std::function<void()>([] {});
    });
  });
  poll_timer_.start(kBetweenLooksAtFinger);
  if (!last) return;
  state_.recent_fingers = last->recent_fingers;
  state_.recent_sources = last->recent_sources;
  state_.controls = last->controls;
}

void Workspace::open_finger(const std::filesystem::path& folder) {
  const auto requested = absolute_path(folder);
  if (requested != state_.finger) undo_.clear();
  set_finger(requested);
}

void Workspace::open_source(const Inputs& inputs) {
  if (inputs == state_.source) return set_source(inputs);
  undo_.push(new InputsChange(
      [inputs] {
        return inputs.empty() ? tr("close the source")
                              : tr("open source %1").arg(short_name(inputs.front()));
      },
      state_.source, inputs, [this](const Inputs& requested) { set_source(requested); }));
}

void Workspace::begin_with(const std::filesystem::path& finger, const Inputs& source) {
  if (!finger.empty()) set_finger(absolute_path(finger));
  if (!source.empty()) set_source(source);
}

void Workspace::listen_to_finger() {
  listening_.reset();
  store_.reset();
  const auto& folder = state_.finger;
  if (folder.empty()) return;
  store_ = FingerStore::of(folder);
  listening_ = store_->listen([this, folder](const FingerPtr& now, const FingerPtr& before) {
    if (now->revision == before->revision && now->measuring == before->measuring)
      return;  // annotations of presses changed
    const auto follow = [this, folder] {
      if (folder != state_.finger) return;
      session_.open_finger(folder);
      Q_EMIT finger_rewritten();
    };
    QMetaObject::invokeMethod(this, follow, Qt::QueuedConnection);
  });
}

void Workspace::set_finger(const std::filesystem::path& folder) {
  state_.finger = folder;
  listen_to_finger();
  session_.open_finger(folder);
  if (!folder.empty()) put_first(folder, state_.recent_fingers);
  Q_EMIT finger_changed();
  Q_EMIT recent_fingers_changed();
  Q_EMIT changed();
}

void Workspace::forget_finger(const std::filesystem::path& folder) {
  if (std::erase(state_.recent_fingers, folder) == 0) return;
  Q_EMIT recent_fingers_changed();
  Q_EMIT changed();
}

void Workspace::set_source(const Inputs& inputs) {
  state_.source = inputs;
  if (inputs.empty()) {
    session_.close_source();
  } else {
    session_.set_lock(state_.is_locked);
    session_.open_source(inputs, stored_controls());
    if (inputs.size() == 1 && is_own_file(inputs.front()))
      put_first(absolute_path(inputs.front()), state_.recent_sources);
  }
  Q_EMIT source_changed();
  Q_EMIT changed();
}

void Workspace::store_control(const ControlValue& control) {
  auto& stored = stored_controls();
  std::erase_if(stored, [&](const ControlValue& old) { return old.id == control.id; });
  stored.push_back(control);
  Q_EMIT changed();
}

void Workspace::store_lock(bool is_locked) {
  state_.is_locked = is_locked;
  Q_EMIT changed();
}

std::vector<ControlValue>& Workspace::stored_controls() {
  return state_.controls[source_name().toStdString()];
}

QString Workspace::source_name() const {
  return state_.source.empty() ? tr("none", "source") : short_name(state_.source.front());
}

bool Workspace::changes_source(const QUndoCommand& step) {
  if (dynamic_cast<const InputsChange*>(&step) != nullptr) return true;
  for (int i = 0; i < step.childCount(); ++i)
    if (changes_source(*step.child(i))) return true;
  return false;
}

}  // namespace alltact
