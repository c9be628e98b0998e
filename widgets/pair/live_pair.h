// A second live finger: its own source, synchronised with the first, and joint readings of both in
// their gripper.
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

/// The second finger and its source.
struct SecondCamera {
  std::filesystem::path finger;               ///< folder
  std::vector<std::filesystem::path> source;  ///< as LiveSession::open_source
  std::filesystem::path gripper;              ///< gripper.yaml or its folder; empty: none
  std::optional<double> motor_turns;          ///< none: the middle of its range
  bool operator==(const SecondCamera&) const = default;
};

/// Belongs to the window's thread; reads the gripper and measures distances on background threads.
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

  /// Views to be shown; nullopt before both have a view, and while nothing is open.
  [[nodiscard]] const std::optional<ViewPair>& pair() const { return pair_; }
  /// Null without a gripper.
  [[nodiscard]] const OpenGripper* gripper() const { return gripper_.get(); }
  [[nodiscard]] std::optional<double> motor_turns() const;
  /// The latest reading; its pair may be older than pair().
  [[nodiscard]] const std::optional<PairReading>& reading() const { return reading_; }
  /// Why there is no reading, including problems of the second source and finger.
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
  std::filesystem::path gripper_of_;  // file of gripper_ or of its problem
  std::optional<Error> gripper_problem_, reading_problem_;
  std::optional<PairReading> reading_;
  struct Request {
    std::array<std::shared_ptr<const LiveView>, 2> views;
    double motor_turns;
    bool operator==(const Request&) const = default;
  };
  std::optional<Request> request_;  // of the running or last measurement
  BackgroundWork loading_, measuring_;
};

}  // namespace alltact
