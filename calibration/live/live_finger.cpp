#include "calibration/live/live_finger.h"

#include "calibration/finger/measuring_presets.h"
#include "calibration/live/frame_measurer.h"
#include "core/finger/force_model.h"
#include "core/image/colour_map.h"
#include "core/image/grey_range.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/pipeline.h"
#include "core/simulation/plan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <mutex>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

Result<FingerPtr> finger_of_scene(const std::filesystem::path& file) {
  const auto scene = Scene::load(file);
  if (!scene) return scene.error();
  const auto plan = Plan::compile(*scene, 1);
  if (!plan) return plan.error();
  auto finger = FingerSnapshot::of({}, plan->finger());
  if (!finger) return finger.error();
  return std::make_shared<const FingerSnapshot>(std::move(*finger));
}

std::optional<Error> force_problem_of(const FingerSnapshot& finger) {
  if (!finger.force) return finger.force_problem;
  const Status belongs = finger.force->belongs_to(finger.finger);
  return belongs ? std::nullopt : std::optional(belongs.error());
}

/// A frame that could not be measured is shown raw.
void measure_into(LiveView& view, Pipeline& pipeline, const FramePtr& frame) {
  auto result = guarded([&] { return pipeline(frame); });
  if (result) {
    view.result = std::move(*result);
    return;
  }
  view.problem = result.error();
  view.result.frame = frame;
  view.result.grey = frame->grey;
}

}  // namespace

/// A finger's pipeline and the number of its opened finger.
struct LiveFinger::Measuring {
  Pipeline pipeline = Pipeline::without_finger();
  std::uint64_t opened = 0;
};

struct LiveFinger::State {
  explicit State(LatestFrameReader frames) : reader(std::move(frames)) {}

  /// For the measuring thread. Returns the one that it replaces.
  std::optional<Measuring> hand_over(Measuring loaded) {
    auto replaced = next.put(std::move(loaded));
    reader.wake();
    return replaced;
  }

  mutable std::mutex mutex;
  FingerStatus status;
  std::shared_ptr<Job> loading;  // the current one
  RequestedLayers layers;
  double depth_top_mm = 1.0;

  LatestFrameReader reader;  // of the measuring thread
  Mailbox<Measuring> next;   // loaded, for the measuring thread
  Mailbox<std::shared_ptr<const LiveView>> view;
};

LiveFinger::LiveFinger(const FrameHub& hub, std::function<void()> on_update)
    : state_(std::make_shared<State>(hub.reader())),
      on_update_(std::move(on_update)),
      worker_([this](const std::stop_token& stop) { measure(stop); }) {}

LiveFinger::~LiveFinger() {
  worker_.request_stop();
  state_->reader.wake();
  const std::lock_guard lock(state_->mutex);
  if (state_->loading) state_->loading->request_stop();
}

void LiveFinger::open(const std::filesystem::path& folder) { load(folder, {}); }

void LiveFinger::open_scene(const std::filesystem::path& scene) { load({}, scene); }

void LiveFinger::load(const std::filesystem::path& folder, const std::filesystem::path& scene) {
  const auto state = state_;
  auto loading = std::make_shared<Job>();
  std::optional<Measuring> replaced;  // freed outside the lock: it may hold a full recording
  std::uint64_t opened = 0;
  {
    const std::lock_guard lock(state->mutex);
    if (state->loading) state->loading->request_stop();
    state->loading = loading;
    opened = state->status.opened + 1;
    state->status = {};
    state->status.opened = opened;
    state->status.folder = folder;
    if (folder.empty() && scene.empty()) {
      replaced = state->hand_over({.opened = opened});
      return;
    }
    state->status.state = FingerState::kLoading;
  }
  Worker([state, loading, opened, folder, scene] {
    FingerStatus status;
    status.opened = opened;
    status.folder = folder;
    Measuring ready{.opened = opened};
    const Status loaded = guarded([&]() -> Status {
      const auto finger = folder.empty() ? finger_of_scene(scene) : open_finger(folder);
      if (!finger) return finger.error();
      status.finger = (*finger)->finger;
      status.warnings = (*finger)->warnings;
      status.force_problem = force_problem_of(**finger);
      auto pipeline = measuring_pipeline(**finger, measuring_settings((*finger)->folder), *loading);
      if (!pipeline) return pipeline.error();
      ready.pipeline = std::move(*pipeline);
      status.has_reference = ready.pipeline.has_reference();
      return {};
    });
    if (!loaded) status.problem = loaded.error();
    status.state = status.problem ? FingerState::kFailed : FingerState::kReady;
    std::optional<Measuring> former;
    const std::lock_guard lock(state->mutex);
    if (state->loading != loading) return;
    status.skipped = state->status.skipped;
    state->status = std::move(status);
    former = state->hand_over(std::move(ready));
  }).end_later();
}

void LiveFinger::measure(const std::stop_token& stop) {
  constexpr std::chrono::hours kUntilWoken{1};
  constexpr std::chrono::milliseconds kRunning{50};  // longer than between two live frames
  Measuring now;
  FramePtr last;
  while (!stop.stop_requested()) {
    FramePtr frame = state_->reader.next(kUntilWoken);
    // The last frame of a source that has ended is shown; a finger opened later measures it, too.
    if (!frame && !state_->next.is_empty()) {
      frame = state_->reader.next(kRunning);
      if (!frame) frame = last;
    }
    if (!frame) continue;
    if (auto next = state_->next.take()) now = std::move(*next);
    RequestedLayers layers;
    auto view = std::make_shared<LiveView>();
    {
      const std::lock_guard lock(state_->mutex);
      layers = state_->layers;
      view->depth_top_mm = state_->depth_top_mm;
    }
    const bool is_next = last && last->origin == frame->origin && frame->sequence > last->sequence;
    last = frame;
    if (!is_next) now.pipeline.forget();
    measure_into(*view, now.pipeline, frame);
    view->opened = now.opened;
    const FrameResult& result = view->result;
    const Status drawn = guarded([&] {
      if (layers.depth && result.depth)
        view->depth_layer = depth_layer(*result.depth, view->depth_top_mm);
      if (layers.faults) view->faults_layer = faults_layer(result.grey, result);
      if (layers.focus) view->focus_layer = focus_layer(result.grey, result);
    });
    if (!drawn) view->problem = drawn.error();
    {
      const std::lock_guard lock(state_->mutex);
      state_->status.skipped = state_->reader.missed();
    }
    if (!state_->view.put(std::move(view))) on_update_();
  }
}

void LiveFinger::set_layers(RequestedLayers layers) {
  const std::lock_guard lock(state_->mutex);
  state_->layers = layers;
}

void LiveFinger::set_depth_top_mm(double top_mm) {
  const std::lock_guard lock(state_->mutex);
  state_->depth_top_mm = top_mm;
}

std::shared_ptr<const LiveView> LiveFinger::take() { return state_->view.take().value_or(nullptr); }

FingerStatus LiveFinger::status() const {
  const std::lock_guard lock(state_->mutex);
  return state_->status;
}

namespace {

constexpr double kFaint_mm = 0.05;  // smaller depths have no colour: noise of an untouched face
constexpr double kFull_mm = 0.25;   // full colour from here on
constexpr double kStrongest = 0.85;
constexpr int kStripe_px = 6;

using Pixel = cv::Vec4b;                              // blue, green, red, alpha
using DepthColours = std::array<std::uint32_t, 258>;  // the same, as one number

Pixel premultiplied(MapColour colour, double alpha) {
  const auto times = [&](std::uint8_t channel) {
    return static_cast<std::uint8_t>(std::lround(alpha * channel));
  };
  return {times(colour.blue), times(colour.green), times(colour.red), times(255)};
}

/// From -kBulgeFraction to 1 of the top in even steps, between the colours beyond the scale; zero
/// is step kZeroStep.
constexpr float kZeroStep = static_cast<float>(1 + 255 * kBulgeFraction / (1 + kBulgeFraction));

DepthColours depth_colours(double top_mm) {
  DepthColours table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double part = (1 + kBulgeFraction) * (static_cast<double>(i) - 1) / 255 - kBulgeFraction;
    const double strength =
        std::clamp((std::abs(part * top_mm) - kFaint_mm) / (kFull_mm - kFaint_mm), 0.0, 1.0);
    const MapColour colour = i == 0                  ? kBelowScale
                             : i + 1 == table.size() ? kAboveScale
                                                     : depth_colour(part);
    table[i] = std::bit_cast<std::uint32_t>(premultiplied(colour, kStrongest * strength).val);
  }
  return table;
}

/// Whether any of `count` depths has a colour; NaN has none.
ALLTACT_WIDE bool has_colour(const float* depth_mm, int count) {
  constexpr auto faint = static_cast<float>(kFaint_mm);
  std::int32_t any = 0;
  for (int u = 0; u < count; ++u) any |= std::abs(depth_mm[u]) > faint ? 1 : 0;
  return any != 0;
}

void colour_part(const float* depth_mm, float steps_per_mm, int count, const DepthColours& colours,
                 std::uint32_t* pixels) {
  for (int u = 0; u < count; ++u) {
    const float at = depth_mm[u] * steps_per_mm + kZeroStep;
    pixels[u] =
        std::isfinite(at) ? colours[static_cast<std::size_t>(std::clamp(at, 0.0F, 257.0F))] : 0;
  }
}

FaceShape::Rows face_rows(const FrameResult& result, int u, int height) {
  if (!result.shape || u >= result.shape->width_px()) return {0, height - 1};
  const auto rows = result.shape->rows(u, 1.0);
  return {std::max(0, rows.first), std::min(height - 1, rows.last)};
}

/// Flags of each pixel; without a measurement those that the image itself implies, as live image
/// and as reference.
cv::Mat fault_flags(const cv::Mat& grey, const FrameResult& result) {
  if (result.depth) return result.depth->flags;
  if (result.difference) return result.difference->flags;
  const double dark_below = result.edges ? too_dark_below(result.edges->noise_sd) : kTooDarkBelow;
  cv::Mat flags(grey.size(), CV_8UC1, cv::Scalar(kOffFace));
  for (int u = 0; u < grey.cols; ++u) {
    const FaceShape::Rows rows = face_rows(result, u, grey.rows);
    for (int v = rows.first; v <= rows.last; ++v) {
      const int level = grey.at<std::uint8_t>(v, u);
      flags.at<std::uint8_t>(v, u) = level >= kClippedFrom ? kSaturated
                                     : level < dark_below  ? kTooDark
                                                           : kMeasured;
    }
  }
  return flags;
}

}  // namespace

PartLayer depth_layer(const DepthMap& depth, double top_mm) {
  constexpr int kPart = 128;  // columns of a row, few of which show a colour
  const cv::Mat& map = depth.depth_mm;
  std::vector<cv::Rect> parts;
  cv::Rect all;
  for (int v = 0; v < map.rows; ++v)
    for (int u = 0; u < map.cols; u += kPart) {
      const cv::Rect part(u, v, std::min(kPart, map.cols - u), 1);
      if (!has_colour(map.ptr<float>(v) + u, part.width)) continue;
      all = parts.empty() ? part : all | part;
      parts.push_back(part);
    }
  if (parts.empty()) return {};
  const DepthColours colours = depth_colours(top_mm);
  const float scale = static_cast<float>(255 / ((1 + kBulgeFraction) * top_mm));
  PartLayer layer{cv::Mat::zeros(all.size(), CV_8UC4), all.tl()};
  for (const cv::Rect& part : parts)
    colour_part(map.ptr<float>(part.y) + part.x, scale, part.width, colours,
                layer.pixels.ptr<std::uint32_t>(part.y - all.y) + (part.x - all.x));
  return layer;
}

cv::Mat faults_layer(const cv::Mat& grey, const FrameResult& result) {
  static const Pixel bright = premultiplied({230, 60, 40}, 1),
                     dark = premultiplied({60, 150, 255}, 1),
                     white = premultiplied({255, 255, 255}, 1);
  const cv::Mat flags = fault_flags(grey, result);
  const auto is_fault = [](std::uint8_t flag) {
    return flag == kSaturated || flag == kTooDark || is_at_limit(flag);
  };
  if (std::none_of(flags.begin<std::uint8_t>(), flags.end<std::uint8_t>(), is_fault)) return {};
  cv::Mat layer = cv::Mat::zeros(grey.size(), CV_8UC4);
  for (int v = 0; v < grey.rows; ++v) {
    const auto* flag = flags.ptr<std::uint8_t>(v);
    auto* pixel = layer.ptr<Pixel>(v);
    for (int u = 0; u < grey.cols; ++u) {
      if (flag[u] == kSaturated && (u - v + grey.rows * kStripe_px) % kStripe_px < kStripe_px / 2)
        pixel[u] = bright;
      if (is_at_limit(flag[u]) && v % kStripe_px < kStripe_px / 3) pixel[u] = white;
      if (flag[u] == kTooDark && (u + v) % kStripe_px < kStripe_px / 2) pixel[u] = dark;
    }
  }
  return layer;
}

cv::Mat focus_layer(const cv::Mat& grey, const FrameResult& result) {
  // The Laplacian of independent noise has the root of 20 times its standard deviation.
  constexpr double kMinBend = 16, kNoiseSds = 5, kNoiseGain = 4.47;
  const double noise_sd = result.edges ? result.edges->noise_sd : 1.0;
  cv::Mat bend;
  cv::Laplacian(grey, bend, CV_16S, 1, 1, 0, cv::BORDER_REPLICATE);
  cv::Mat layer = cv::Mat::zeros(grey.size(), CV_8UC4);
  layer.setTo(cv::Scalar(premultiplied({250, 230, 40}, 1)),
              cv::abs(bend) > std::max(kMinBend, kNoiseSds * kNoiseGain * noise_sd));
  return layer;
}

}  // namespace alltact
