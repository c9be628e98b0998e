// A finger that is measured for hours, and may be calibrated anew meanwhile.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/base/worker.h"
#include "core/finger/finger_store.h"
#include "core/sensing/pipeline.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace alltact {

/// Polls the finger's folder for changes. A changed finger is loaded on a separate thread; the open
/// one stays in use until then. Used by one thread.
class WatchedFinger {
 public:
  /// Makes the pipeline that a finger is measured by.
  using MakePipeline =
      std::function<Result<Pipeline>(const FingerSnapshot& finger, const Job& job)>;

  /// Errors: those of FingerStore::snapshot and `make`. `make` is also called on the other thread,
  /// one call at a time.
  [[nodiscard]] static Result<std::unique_ptr<WatchedFinger>> open(
      const std::filesystem::path& folder, MakePipeline make, const Job& job,
      std::chrono::milliseconds poll_interval = std::chrono::seconds(2));
  ~WatchedFinger();  ///< requests loading to stop, and waits
  WatchedFinger(const WatchedFinger&) = delete;
  WatchedFinger& operator=(const WatchedFinger&) = delete;

  /// The finger at the time when the pipeline was made.
  [[nodiscard]] const FingerSnapshot& finger() const { return *now_.finger; }
  [[nodiscard]] Pipeline& pipeline() { return now_.pipeline; }

  /// Switches to the folder's present finger, if it is loaded. True when it switches.
  [[nodiscard]] bool take_update();
  /// Why a change cannot be used, once for each change.
  [[nodiscard]] std::optional<Error> take_problem() { return problem_.take(); }

 private:
  struct Ready {
    FingerPtr finger;
    Pipeline pipeline;
  };
  WatchedFinger(std::shared_ptr<FingerStore> store, MakePipeline make, Ready now,
                std::chrono::milliseconds poll_interval);
  void poll_once();

  std::shared_ptr<FingerStore> store_;
  MakePipeline make_;
  Ready now_;
  // Of the other thread: the last finger it has read.
  FingerPtr last_seen_;
  std::string unreadable_;  // its reported problem
  Job loading_;

  Mailbox<Ready> next_;
  Mailbox<Error> problem_;

  Worker worker_;  // last: it ends first
};

}  // namespace alltact
