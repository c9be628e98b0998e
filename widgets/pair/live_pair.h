// A second finger beside the live one: its own source, in time with the first, and what both tell
// together in their gripper.
#pragma once

#include "widgets/background_work.h"
#include "widgets/live/live_session.h"
#include "widgets/pair/pair_reading.h"

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

/// What is open beside the first finger.
struct SecondCamera {
  std::filesystem::path finger;               ///< folder
  std::vector<std::filesystem::path> source;  ///< as LiveSession::open_source
  std::filesystem::path gripper;              ///< gripper.yaml or its folder; empty: none
  std::optional<double> motor_turns;          ///< none: the middle of its range
  bool operator==(const SecondCamera&) const = default;
};

/// An object of the window's thread; the gripper is read, and distances measured, beside it.
class LivePair : public QObject {
  Q_OBJECT
 public:
  /// `first` outlives it; its opener opens the second source.
  explicit LivePair(LiveSession& first, QObject* parent = nullptr);

  /// None closes it.
  void open(const std::optional<SecondCamera>& second);
  [[nodiscard]] const std::optional<SecondCamera>& opened() const { return opened_; }
  /// Null before the first open().
  [[nodiscard]] LiveSession* second() const { return second_.get(); }

  /// What is to be shown; nullopt before both have a view, and while nothing is open.
  [[nodiscard]] const std::optional<ViewPair>& pair() const { return pair_; }
  /// Null without a gripper.
  [[nodiscard]] const OpenGripper* gripper() const { return gripper_.get(); }
  [[nodiscard]] std::optional<double> motor_turns() const;
  /// The latest; of a pair that may be older than pair().
  [[nodiscard]] const std::optional<PairReading>& reading() const { return reading_; }
  /// Why there is no reading; of the second source or finger where it is these.
  [[nodiscard]] std::optional<Error> problem() const;

 Q_SIGNALS:
  void pair_ready();
  /// opened(), gripper(), reading() or problem() changed.
  void changed();

 private:
  void add(std::size_t which);
  void load_gripper();
  void measure();
  void take(const Result<PairReading>& reading);

  LiveSession& first_;
  std::unique_ptr<LiveSession> second_;
  std::optional<SecondCamera> opened_;
  ViewPairing pairing_;
  std::optional<ViewPair> pair_;
  std::shared_ptr<const OpenGripper> gripper_;
  std::filesystem::path gripper_of_;  // what gripper_ or its problem was read from
  std::optional<Error> gripper_problem_, reading_problem_;
  std::optional<PairReading> reading_;
  struct Asked {
    std::array<std::shared_ptr<const LiveView>, 2> views;
    double motor_turns;
    bool operator==(const Asked&) const = default;
  };
  std::optional<Asked> asked_;  // of the work that goes on, or went on last
  BackgroundWork loading_, measuring_;
};

}  // namespace alltact
