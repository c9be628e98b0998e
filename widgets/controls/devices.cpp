#include "widgets/controls/devices.h"

#include "core/devices/hot_plug.h"
#include "widgets/controls/control_panel.h"
#include "widgets/language.h"

#include <QMetaObject>
#include <algorithm>
#include <atomic>
#include <mutex>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace alltact {
namespace {

// Polling besides udev events. With udev it is rare, because listing opens every camera.
constexpr int kSearchInterval_ms = 30'000;
constexpr int kSearchIntervalWithoutUdev_ms = 2000;
constexpr int kHotPlugDelay_ms = 300;  // udev creates its links shortly after the node

bool is_same(const std::vector<FoundCamera>& a, const std::vector<FoundCamera>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const FoundCamera& x, const FoundCamera& y) {
                      return x.identity.node == y.identity.node &&
                             x.identity.stable_name() == y.identity.stable_name() &&
                             x.problem.has_value() == y.problem.has_value();
                    });
}

}  // namespace

// Shared with the thread, so that a stuck driver does not block the window.
struct CameraFinder::Shared {
  std::mutex mutex;
  CameraFinder* finder = nullptr;  // null after the finder was destroyed
  Lister lister;
  int wake = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  ~Shared() { ::close(wake); }

  void run() {
    const auto plug = HotPlug::watch();
    std::vector<FoundCamera> reported;
    for (bool is_first = true;; is_first = false) {
      std::vector<FoundCamera> found;
      if (const Status listed = guarded([&] { found = lister(); }); !listed) {
        report_unexpected(listed.error());
        found = reported;  // asked again after the next interval
      }
      {
        const std::lock_guard lock(mutex);
        if (finder == nullptr) return;
        if (is_first || !is_same(found, reported)) {
          reported = found;
          QMetaObject::invokeMethod(
              finder,
              [finder = finder, found = std::move(found)]() mutable {
                finder->cameras_ = std::move(found);
                Q_EMIT finder->cameras_changed();
              },
              Qt::QueuedConnection);
        }
      }
      pollfd descriptors[2] = {{wake, POLLIN, 0}, {plug ? plug->descriptor() : -1, POLLIN, 0}};
      const int wait_ms = plug ? kSearchInterval_ms : kSearchIntervalWithoutUdev_ms;
      if (poll(descriptors, 2, wait_ms) > 0 && descriptors[0].revents == 0) {
        static_cast<void>(plug->read());
        poll(descriptors, 1, kHotPlugDelay_ms);
      }
    }
  }
};

CameraFinder::CameraFinder(Lister lister, QObject* parent)
    : QObject(parent), shared_(std::make_shared<Shared>()) {
  shared_->finder = this;
  shared_->lister = lister ? std::move(lister) : [] { return list_cameras(kernel_calls()); };
  worker_ = Worker([shared = shared_] { shared->run(); });
}

CameraFinder::~CameraFinder() {
  const std::lock_guard lock(shared_->mutex);
  shared_->finder = nullptr;
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(shared_->wake, &one, sizeof one);
  worker_.end_later();
}

namespace {

/// "1.4" of "usb-0000:00:14.0-1.4"; empty where the driver reports no USB port.
std::string usb_port(const std::string& bus) {
  const std::size_t dash = bus.rfind('-');
  return bus.rfind("usb-", 0) == 0 && dash > 3 ? bus.substr(dash + 1) : std::string();
}

}  // namespace

QString camera_label(const FoundCamera& camera, const std::vector<FoundCamera>& cameras) {
  const CameraIdentity& identity = camera.identity;
  const QString name = QString::fromStdString(identity.name);
  const auto alike = std::count_if(cameras.begin(), cameras.end(), [&](const FoundCamera& one) {
    return one.identity.name == identity.name;
  });
  if (alike < 2) return name;
  const std::string port = usb_port(identity.bus);
  return port.empty()
             ? ControlPanel::tr("%1 (%2)").arg(name, QString::fromStdString(identity.stable_name()))
             : ControlPanel::tr("%1 (USB port %2)").arg(name, QString::fromStdString(port));
}

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
    return Error{en::say("there is no HID device that can be read"), "",
                 en::say("plugging in a pedal")};
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
    Worker([shared] { shared->button.reset(); }).end_later();
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

Pedal::~Pedal() { Shared::end(std::move(shared_)); }

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
    shared_->button = std::make_unique<HidButton>(open, button->pattern,
                                                  [shared = shared_.get()] { shared->notify(); });
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

void Pedal::stop_learning() { learning_.stop(); }

void Pedal::end_learning(const Result<LearntButton>& learnt,
                         const std::optional<LearntButton>& before) {
  learning_text_ = learnt ? tr("Learnt: %1").arg(QString::fromStdString(learnt->device))
                          : window_sentence(learnt.error().message());
  listen(learnt ? std::optional(*learnt) : before);
}

Lamp::Lamp(HidPorts ports, QObject* parent) : QObject(parent), ports_(std::move(ports)) {
  connect(&setting_work_, &BackgroundWork::finished, this, &Lamp::send);
}

void Lamp::find_devices() {
  finding_.start([this, list = ports_.list](const Job&) {
    return std::function<void()>([this, found = list()] {
      found_ = found;
      Q_EMIT changed();
    });
  });
}

void Lamp::set(const std::optional<DimmerSetting>& requested) {
  requested_ = requested;
  is_sent_ = !requested;
  problem_.reset();
  if (!requested) setting_.reset();
  send();
  Q_EMIT changed();
}

void Lamp::send() {
  if (is_sent_ || setting_work_.is_running()) return;
  is_sent_ = true;
  setting_work_.start(
      [this, requested = *requested_, opened = dimmer_, open = ports_.open](const Job&) {
        const auto result = [&]() -> Result<DimmerSetting> {
          auto& dimmer = *opened;
          if (!dimmer || dimmer->setting().device != requested.device ||
              dimmer->setting().control != requested.control) {
            dimmer.reset();
            auto port = open(requested.device);
            if (!port) return port.error();
            auto made = LedDimmer::create(std::move(*port), requested.device, requested.control);
            if (!made) return made.error();
            dimmer.emplace(std::move(*made));
          }
          if (const Status set = dimmer->set(requested.level); !set) {
            dimmer.reset();  // plugged in again it is another device
            return set.error();
          }
          return dimmer->setting();
        }();
        return std::function<void()>([this, result] {
          if (!requested_) return;
          setting_ = result ? std::optional(*result) : std::nullopt;
          problem_ = result ? std::nullopt : std::optional(result.error());
          Q_EMIT changed();
        });
      });
}

}  // namespace alltact
