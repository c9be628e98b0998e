// The one owner of a finger's folder: gives what stands in it, and is the only way to change that.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/finger/mapping.h"
#include "core/finger/press_set.h"
#include "core/io/held_file.h"
#include "core/message.h"
#include "core/result.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct ForceModel;

/// Where a finger keeps what it measures with (calibration/finger/measuring_presets.h).
inline constexpr const char* kMeasuringFile = "measuring.yaml";

/// What a folder held at one moment. The reference recording, which is large, is read when it is
/// needed and shared by all who need it: ReferenceLibrary::load.
struct FingerSnapshot {
  std::filesystem::path folder;
  std::uint64_t revision = 0;  ///< grows with every change of finger.yaml that the store has seen
  Finger finger;
  Camera camera;
  std::optional<Mapping> mapping;  ///< of a finger that is calibrated
  PressSet presses;
  std::optional<Error> presses_problem;     ///< why `presses` is empty though something is kept
  std::vector<Message> warnings;            ///< what is strange in finger.yaml
  std::shared_ptr<const ForceModel> force;  ///< of a finger whose forces are told
  std::optional<Error> force_problem;       ///< why `force` is null though the finger names one
  int reduced_by = 1;  ///< pixels a side that are one here (reduced_finger.h); 1: none are
  CameraParameters whole_camera;  ///< of the pictures that come, where they are reduced
  std::string measuring;          ///< what kMeasuringFile holds; empty: it is not there

  /// Of a finger that is at hand, whatever stands in its folder. Errors: those of Camera::create
  /// and Mapping::create.
  [[nodiscard]] static Result<FingerSnapshot> of(const std::filesystem::path& folder,
                                                 Finger finger);
  /// The same, not calibrated.
  [[nodiscard]] FingerSnapshot without_mapping() const;
};
using FingerPtr = std::shared_ptr<const FingerSnapshot>;

/// Any thread may call any function. Programs exclude each other as threads do.
class FingerStore {
 public:
  /// The store of a folder: one in a program, however many ask for it.
  [[nodiscard]] static std::shared_ptr<FingerStore> of(const std::filesystem::path& folder);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// What stands there now: read again only where another program has changed it. Errors: those of
  /// Finger::load, Camera::create and Mapping::create.
  [[nodiscard]] Result<FingerPtr> snapshot();

  /// Reads finger.yaml as it is now, lets `change` change it, and writes it whole: one after
  /// another among threads and programs, so that nothing that another wrote in between is lost.
  /// Gives what stands there then. `change` should take what has been worked out already: others
  /// wait for it, up to ten seconds. Errors: those of snapshot(), `change` and Finger::save, and
  /// then the file is as it was; another program holds the finger longer than that.
  [[nodiscard]] Result<FingerPtr> update(const std::function<Status(Finger&)>& change);

  /// Keeps what is said of the presses, whole or not at all.
  [[nodiscard]] Status keep_presses(const PressSet& presses);

  /// Keeps what `content` gives for kMeasuringFile, whole or not at all; one after another among
  /// threads and programs. Errors: those of `content` and snapshot(), and then the file is as it
  /// was.
  [[nodiscard]] Status keep_measuring(
      const std::function<Result<std::string>(const std::filesystem::path& folder)>& content);

  /// For work of minutes on a finger (calibrating, recording its reference) that two must not do at
  /// once; update() goes on beside it. Error: another is at it, who is named.
  ///   doing: what is done, for those who come second ("calibrating")
  [[nodiscard]] Result<HeldFile> hold_for_work(const std::string& doing);

  /// Told of every change, with what stands there since and what stood there before, on the thread
  /// that made or found it.
  using Listener = std::function<void(const FingerPtr& now, const FingerPtr& before)>;
  /// Ends when it is destroyed: the listener is not called, and not being called, from then on.
  [[nodiscard]] std::shared_ptr<void> listen(Listener listener);

  explicit FingerStore(std::filesystem::path folder) : folder_(std::move(folder)) {}
  FingerStore(const FingerStore&) = delete;
  FingerStore& operator=(const FingerStore&) = delete;

 private:
  struct Listening;
  [[nodiscard]] Result<FingerPtr> read();
  void tell(const FingerPtr& now, const FingerPtr& before);

  std::filesystem::path folder_;
  std::mutex mutex_;
  FingerPtr last_;
  /// Which files `last_` was read from.
  std::string finger_written_, presses_written_, force_written_, measuring_written_;
  std::list<std::weak_ptr<Listening>> listening_;
};

/// The store's snapshot of a folder.
[[nodiscard]] Result<FingerPtr> open_finger(const std::filesystem::path& folder);

/// Sets an entry of the provenance to what it is in `from`, or removes it where that has none.
void take_provenance(const Finger& from, const std::string& key, Finger& finger);

}  // namespace alltact
