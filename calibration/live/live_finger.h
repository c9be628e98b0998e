// The newest frame measured, on a thread of its own, with whatever finger is open.
#pragma once

#include "calibration/live/layers.h"
#include "core/finger/finger_store.h"
#include "core/sensing/pipeline.h"
#include "core/sources/frame_hub.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <opencv2/core.hpp>

namespace alltact {

/// What the pictures over the frame show that costs more than a painter should spend.
struct WantedLayers {
  bool depth = false;
  bool faults = false;
};

/// A frame as it is shown. Layers are CV_8UC4, premultiplied blue, green, red, alpha, the oriented
/// picture's size; empty where not wanted or not to be had.
struct LiveView {
  /// Of a frame that could not be measured the frame and its grey picture as it came.
  FrameResult result;
  std::optional<Error> problem;  ///< why it could not
  std::optional<PartLayer> depth_layer;
  cv::Mat faults_layer;
  double depth_top_mm = 0;   ///< end of the depth layer's scale
  std::uint64_t opened = 0;  ///< of the finger that measured it, FingerStatus::opened
};

enum class FingerState { kNone = 1, kLoading, kReady, kFailed };

struct FingerStatus {
  FingerState state = FingerState::kNone;
  std::uint64_t opened =
      0;  ///< counts what was opened; until it is loaded, the one before measures
  std::filesystem::path folder;  ///< empty for a finger that a scene describes
  std::optional<Finger> finger;
  bool has_reference = false;  ///< loaded, so that frames are compared with it
  std::optional<Error> problem;
  std::optional<Error> force_problem;  ///< why it tells no forces though it names a model
  std::vector<Message> warnings;
  std::uint64_t skipped = 0;  ///< frames that came and were never measured: newer ones had come
};

/// Any thread may call any function.
class LiveFinger {
 public:
  /// `news` is called on the measuring thread whenever there is a view that was not taken yet.
  LiveFinger(const FrameHub& hub, std::function<void()> news);
  ~LiveFinger();  ///< ends the threads; loading is asked to stop and not waited for
  LiveFinger(const LiveFinger&) = delete;
  LiveFinger& operator=(const LiveFinger&) = delete;

  /// Loads on a thread of its own; what was open goes on until then. An empty folder closes it.
  void open(const std::filesystem::path& folder);
  /// The finger that a scene describes: it has no folder.
  void open_scene(const std::filesystem::path& scene);
  void set_layers(WantedLayers layers);
  /// Depth that the colours end at, mm.
  void set_depth_top_mm(double top_mm);
  /// The newest view that was not taken yet.
  [[nodiscard]] std::shared_ptr<const LiveView> take();
  [[nodiscard]] FingerStatus status() const;

 private:
  struct Loading;
  struct Measuring;
  struct State;
  void load(const std::filesystem::path& folder, const std::filesystem::path& scene);
  /// A finger has been loaded since the last frame was measured.
  [[nodiscard]] bool has_news_for_last() const;
  void measure(const std::stop_token& stop);

  std::shared_ptr<State> state_;
  LatestFrameReader reader_;
  std::function<void()> news_;
  std::jthread thread_;
};

}  // namespace alltact
