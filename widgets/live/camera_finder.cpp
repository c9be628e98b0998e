#include "widgets/live/camera_finder.h"

#include "core/sources/hot_plug.h"

#include <QMetaObject>
#include <mutex>
#include <thread>

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
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const FoundCamera& x, const FoundCamera& y) {
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
      auto found = lister();
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
  std::thread([shared = shared_] { shared->run(); }).detach();
}

CameraFinder::~CameraFinder() {
  const std::lock_guard lock(shared_->mutex);
  shared_->finder = nullptr;
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(shared_->wake, &one, sizeof one);
}

}  // namespace alltact
