// A finger that is measured for hours, and calibrated anew meanwhile.
#pragma once

#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/pipeline.h"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace alltact {

/// Looks into the finger's folder again and again. What is found there is made ready on a thread of
/// its own; what was open goes on until then. Used by one thread.
class FollowedFinger {
 public:
  /// Makes the pipeline that a finger is measured by.
  using MakePipeline =
      std::function<Result<Pipeline>(const FingerSnapshot& finger, const Job& job)>;

  /// Errors: those of FingerStore::snapshot and `make`. The latter is also called on the other
  /// thread, one call at a time.
  [[nodiscard]] static Result<std::unique_ptr<FollowedFinger>> open(
      const std::filesystem::path& folder,
      MakePipeline make,
      const Job& job,
      std::chrono::milliseconds between_looks = std::chrono::seconds(2));
  ~FollowedFinger();  ///< loading is asked to stop, and waited for
  FollowedFinger(const FollowedFinger&) = delete;
  FollowedFinger& operator=(const FollowedFinger&) = delete;

  /// As it was when the pipeline was made.
  [[nodiscard]] const FingerSnapshot& finger() const { return *now_.finger; }
  [[nodiscard]] Pipeline& pipeline() { return now_.pipeline; }

  /// Goes on with what stands in the folder now, where that is ready. True when it does.
  [[nodiscard]] bool take_news();
  /// Why it does not, once for each change that cannot be used.
  [[nodiscard]] std::optional<Error> take_problem();

 private:
  struct Ready {
    FingerPtr finger;
    Pipeline pipeline;
  };
  FollowedFinger(std::shared_ptr<FingerStore> store,
                 MakePipeline make,
                 Ready now,
                 std::chrono::milliseconds between_looks);
  void look(const std::stop_token& stop, std::chrono::milliseconds between_looks);
  void look_once();

  std::shared_ptr<FingerStore> store_;
  MakePipeline make_;
  Ready now_;
  // Of the other thread: what it has looked at last.
  FingerPtr looked_at_;
  std::string unreadable_;  // what was said of it
  Job loading_;

  std::mutex mutex_;  // over:
  std::condition_variable_any ending_;
  std::optional<Ready> next_;
  std::optional<Error> problem_;

  std::jthread thread_;  // last: it ends first
};

}  // namespace alltact
