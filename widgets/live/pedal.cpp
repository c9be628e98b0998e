#include "widgets/live/pedal.h"

#include "widgets/language.h"

#include <QMetaObject>
#include <atomic>
#include <mutex>
#include <thread>

namespace alltact {
namespace {

constexpr int kPollInterval_ms = 250;  // for problems of the device
constexpr int kLearnTimeout_ms = 20'000;

Result<LearntButton> learn_from_all(const HidPorts& ports, const Job& job) {
  std::vector<std::unique_ptr<HidPort>> open;
  std::vector<std::string> names;
  for (const FoundHid& hid : ports.list()) {
    auto port = hid.problem ? *hid.problem : ports.open(hid.identity.node);
    if (!port) continue;
    open.push_back(std::move(*port));
    names.push_back(hid.identity.stable_name());
  }
  if (open.empty())
    return Error{
        en::say("there is no HID device that can be read"), "", en::say("plugging in a pedal")};
  std::vector<HidPort*> listening;
  for (const auto& port : open) listening.push_back(port.get());
  const auto found = learn_button(listening, kLearnTimeout_ms, job);
  if (!found) return found.error();
  return LearntButton{names[found->first], found->second};
}

}  // namespace

// Shared with the threads, so that a device that does not answer does not block the window.
struct Pedal::Shared {
  std::mutex mutex;
  Pedal* pedal = nullptr;  // null after it was destroyed, or listens to another device
  std::atomic<bool> is_opened{false};
  std::unique_ptr<HidButton> button;

  void notify() {
    const std::lock_guard lock(mutex);
    if (pedal != nullptr)
      QMetaObject::invokeMethod(
          pedal, [pedal = pedal] { Q_EMIT pedal->pressed(); }, Qt::QueuedConnection);
  }
  /// Ends the listening thread on another thread, because that may block.
  static void end(std::shared_ptr<Shared> shared) {
    if (!shared) return;
    {
      const std::lock_guard lock(shared->mutex);
      shared->pedal = nullptr;
    }
    std::thread([shared] { shared->button.reset(); }).detach();
  }
};

Pedal::Pedal(HidPorts ports, QObject* parent) : QObject(parent), ports_(std::move(ports)) {
  connect(&timer_, &QTimer::timeout, this, &Pedal::check_status);
  connect(&learning_, &BackgroundWork::progressed, this, [this] {
    const QString text = learning_.fraction() > 0    ? tr("Press it once more.")
                         : !learning_.what().empty() ? tr("Press the pedal twice now.")
                                                     : tr("Leave the pedal alone for a moment.");
    if (std::exchange(learning_text_, text) != text) Q_EMIT changed();
  });
  connect(&learning_, &BackgroundWork::finished, this, &Pedal::changed);
}

Pedal::~Pedal() {
  Shared::end(std::move(shared_));
}

void Pedal::listen(const std::optional<LearntButton>& button) {
  Shared::end(std::exchange(shared_, nullptr));
  button_ = button;
  problem_.reset();
  timer_.stop();
  if (button) {
    shared_ = std::make_shared<Shared>();
    shared_->pedal = this;
    const auto open = [shared = shared_.get(), opener = ports_.open, device = button->device] {
      auto port = opener(device);
      shared->is_opened = true;
      return port;
    };
    // It begins at once and may report before the assignment is done.
    const std::lock_guard lock(shared_->mutex);
    shared_->button = std::make_unique<HidButton>(
        open, button->pattern, [shared = shared_.get()] { shared->notify(); });
    timer_.start(kPollInterval_ms);
  }
  Q_EMIT changed();
}

void Pedal::check_status() {
  if (!shared_->is_opened) return;
  const Status status = shared_->button->status();
  const bool was_well = !problem_.has_value();
  problem_ = status ? std::nullopt : std::optional(status.error());
  if (was_well != status.ok()) Q_EMIT changed();
}

void Pedal::learn() {
  if (is_learning()) return;
  learning_text_ = tr("Leave the pedal alone for a moment.");
  const auto before = button_;
  listen(std::nullopt);  // the learnt presses must have no effect
  learning_.start([this, ports = ports_, before](const Job& job) {
    auto learnt = std::make_shared<Result<LearntButton>>(learn_from_all(ports, job));
    return std::function<void()>([this, learnt, before] { end_learning(*learnt, before); });
  });
  Q_EMIT changed();
}

void Pedal::stop_learning() {
  learning_.stop();
}

void Pedal::end_learning(const Result<LearntButton>& learnt,
                         const std::optional<LearntButton>& before) {
  learning_text_ = learnt ? tr("Learnt: %1").arg(QString::fromStdString(learnt->device))
                          : window_sentence(learnt.error().message());
  listen(learnt ? std::optional(*learnt) : before);
}

}  // namespace alltact
