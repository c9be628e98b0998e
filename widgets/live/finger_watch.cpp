#include "widgets/live/finger_watch.h"

#include "core/camera/camera.h"
#include "core/io/picture.h"

#include <chrono>

namespace alltact {
namespace {

constexpr double kTouchedDarker = 0.12;    // of x: about a tenth of a layer
constexpr double kTouchedShare = 0.001;    // of the face: a ball of 4 mm pressed in 0.2 mm is more
constexpr double kTouchedDepth_mm = 0.15;  // noise and old dents stay below

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

FaceTouch touch_by_difference(const Difference& difference) {
  std::size_t measured = 0, dark = 0;
  for (int v = 0; v < difference.x.rows; ++v) {
    const float* x = difference.x.ptr<float>(v);
    for (int u = 0; u < difference.x.cols; ++u) {
      measured += std::isfinite(x[u]) ? 1U : 0U;
      dark += x[u] > static_cast<float>(kTouchedDarker) ? 1U : 0U;
    }
  }
  if (measured == 0) return FaceTouch::kUnknown;
  return static_cast<double>(dark) > kTouchedShare * static_cast<double>(measured)
             ? FaceTouch::kTouched
             : FaceTouch::kFree;
}

}  // namespace

Result<FingerWatch> FingerWatch::create(const std::filesystem::path& folder,
                                        const Finger& finger,
                                        const PipelineSettings& settings,
                                        const Job& job) {
  FingerWatch watch;
  watch.finger_ = finger;
  watch.settings_ = settings;
  auto camera = Camera::create(finger.camera);
  if (!camera) return camera.error();
  watch.camera_ = *camera;
  watch.edge_finder_ = FaceEdgeFinder(
      {settings.edge_method, settings.edge_columns, FaceView{*camera, finger.face.width_mm}});
  watch.rows_.emplace(finger.markers);
  if (folder.empty() || !finger.reference) return watch;
  auto snapshot = FingerSnapshot::of(folder, finger);
  if (!snapshot) return snapshot.error();
  auto pipeline = Pipeline::create(*snapshot, settings, job);
  if (!pipeline) return pipeline.error();
  watch.pipeline_ = std::move(*pipeline);
  return watch;
}

WatchedFrame FingerWatch::operator()(const FramePtr& frame, bool is_next) {
  WatchedFrame watched;
  if (pipeline_) {
    if (!is_next) pipeline_->forget();
    auto result = (*pipeline_)(frame);
    if (result) {
      watched.result = std::move(*result);
      watched.touch = face_touch(watched.result);
      return watched;
    }
    watched.problem = result.error();
  }
  if (!is_next) forget();
  const auto start = std::chrono::steady_clock::now();
  FrameResult& result = watched.result;
  result.frame = frame;
  result.grey = frame->grey;
  if (finger_ && !watched.problem) {
    auto grey = oriented_for(finger_->camera,
                             frame->grey,
                             en::say("the picture"),
                             frame->origin,
                             en::say("the finger that belongs to this camera, or this finger's "
                                     "camera"));
    if (grey) {
      result.grey = *grey;
    } else {
      watched.problem = grey.error();
    }
  }
  if (watched.problem) return watched;
  auto edges = edge_finder_(result.grey);
  result.times_ms.edges = milliseconds_since(start);
  if (edges) {
    result.edges = std::move(*edges);
    if (finger_ && finger_->face.kind == FaceKind::kFinRay) look_for_markers(watched);
  } else {
    result.problems.push_back(en::say("{}.", edges.error().message()));
  }
  result.times_ms.total = milliseconds_since(start);
  return watched;
}

void FingerWatch::forget() {
  if (rows_) rows_->forget();
  dents_.forget();
}

void FingerWatch::look_for_markers(WatchedFrame& watched) {
  FrameResult& result = watched.result;
  auto start = std::chrono::steady_clock::now();
  auto shape = FaceShape::fit(*result.edges, *camera_, finger_->face, settings_.profile_degree);
  result.times_ms.global = milliseconds_since(start);
  if (!shape) {
    result.problems.push_back(en::say("{}.", shape.error().message()));
    return;
  }
  start = std::chrono::steady_clock::now();
  auto seen = (*rows_)(result.grey, *shape);
  const bool is_pressed = dents_(result.grey, *shape).has_value();
  if (dents_.is_ready()) watched.touch = is_pressed ? FaceTouch::kTouched : FaceTouch::kFree;
  result.markers = std::move(seen.markers);
  watched.dots = std::move(seen.dots);
  result.times_ms.markers = milliseconds_since(start);
  result.shape = std::move(*shape);
}

FaceTouch face_touch(const FrameResult& result) {
  if (result.depth) {
    for (const ContactRegion& region : result.regions)
      if (region.deepest_mm > kTouchedDepth_mm) return FaceTouch::kTouched;
    return FaceTouch::kFree;
  }
  return result.difference ? touch_by_difference(*result.difference) : FaceTouch::kUnknown;
}

}  // namespace alltact
