// Measures the newest frame on a separate thread, with the open finger.
#pragma once

#include "core/base/worker.h"
#include "core/finger/finger_store.h"
#include "core/sensing/frame_result.h"
#include "core/sources/source.h"

#include <functional>
#include <memory>
#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

// Overlays with the measurement of each pixel: CV_8UC4, premultiplied blue, green, red, alpha.

/// An overlay that is stored only where it shows something.
struct PartLayer {
  cv::Mat pixels;  ///< empty: nowhere
  cv::Point at;    ///< of its first pixel, in the oriented image
};

/// The depth map in colours (depth_colour), more transparent at small depths and bulges.
[[nodiscard]] PartLayer depth_layer(const DepthMap& depth, double top_mm);
/// Stripes falling to the right where a pixel is flagged kSaturated, to the left where kTooDark,
/// level and white where the depth is at a limit (is_at_limit). Without a measurement `grey` alone
/// decides both (grey_range.h), on the face only, where that is known. Size: the oriented image's;
/// empty where nothing is flagged. `grey`: CV_8UC1, the result's.
[[nodiscard]] cv::Mat faults_layer(const cv::Mat& grey, const FrameResult& result);

/// Yellow where brightness bends sharply from pixel to pixel, beyond its noise: a sharp image shows
/// the most. Size and `grey` as above.
[[nodiscard]] cv::Mat focus_layer(const cv::Mat& grey, const FrameResult& result);

/// Overlays that are too expensive for the painting thread.
struct RequestedLayers {
  bool depth = false;
  bool faults = false;
  bool focus = false;
};

/// A frame for display. Layers are CV_8UC4, premultiplied blue, green, red, alpha, the oriented
/// image's size; empty where not requested or not available.
struct LiveView {
  /// Of a frame that could not be measured: the frame and its raw grey image.
  FrameResult result;
  std::optional<Error> problem;  ///< why it could not be measured
  std::optional<PartLayer> depth_layer;
  cv::Mat faults_layer, focus_layer;
  double depth_top_mm = 0;   ///< end of the depth layer's scale
  std::uint64_t opened = 0;  ///< of the finger that measured it, FingerStatus::opened
};

enum class FingerState { kNone = 1, kLoading, kReady, kFailed };

struct FingerStatus {
  FingerState state = FingerState::kNone;
  std::uint64_t opened =
      0;  ///< number of the opened finger; until it is loaded, the previous one measures
  std::filesystem::path folder;  ///< empty for a finger that a scene describes
  std::optional<Finger> finger;
  bool has_reference = false;  ///< loaded, so that frames are compared with it
  std::optional<Error> problem;
  std::optional<Error> force_problem;  ///< why it estimates no forces although it names a model
  std::vector<Message> warnings;
  std::uint64_t skipped = 0;  ///< frames that were never measured: newer ones had arrived
};

/// Any thread may call any function.
class LiveFinger {
 public:
  /// `on_update` is called on the measuring thread whenever there is a new view to take.
  LiveFinger(const FrameHub& hub, std::function<void()> on_update);
  /// Waits for the frame that is being measured. finish_workers() waits for a finger that is being
  /// loaded.
  ~LiveFinger();
  LiveFinger(const LiveFinger&) = delete;
  LiveFinger& operator=(const LiveFinger&) = delete;

  /// Loads on a separate thread; the open finger stays in use until then. An empty folder closes
  /// it.
  void open(const std::filesystem::path& folder);
  /// The finger that a scene describes: it has no folder.
  void open_scene(const std::filesystem::path& scene);
  void set_layers(RequestedLayers layers);
  /// Depth at the end of the colour scale, mm.
  void set_depth_top_mm(double top_mm);
  /// The newest view that has not been taken; null: none.
  [[nodiscard]] std::shared_ptr<const LiveView> take();
  [[nodiscard]] FingerStatus status() const;

 private:
  struct Measuring;
  struct State;
  void load(const std::filesystem::path& folder, const std::filesystem::path& scene);
  void measure(const std::stop_token& stop);

  std::shared_ptr<State> state_;
  std::function<void()> on_update_;
  Worker worker_;
};

}  // namespace alltact
