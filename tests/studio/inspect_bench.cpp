// What the face in 3D costs in time: made of a frame, brought up to date, drawn.
#include "core/sensing/pipeline.h"
#include "core/sources/open/open_source.h"
#include "tests/studio/studio_rig.h"
#include "tests/support/made_surface.h"
#include "widgets/inspect/inspect_pane.h"
#include "widgets/scene3d/face_surface.h"

#include <QElapsedTimer>
#include <QTest>

#include <benchmark/benchmark.h>

namespace alltact::test {
namespace {

FrameResult measured_frame() {
  const auto& folder = MadeFingers::get().calibrated();
  const Finger finger = Finger::load(folder).value();
  auto pipeline = Pipeline::create(FingerSnapshot::of(folder, finger).value(), {}, Job()).value();
  return pipeline(open_source({MadeFingers::get().touched()}).value()->next().value()).value();
}

/// Off the window's thread: a frame's depth becomes a grid of points.
void surface_of_a_frame(benchmark::State& state) {
  const FrameResult result = measured_frame();
  const Face face = Finger::load(MadeFingers::get().calibrated()).value().face;
  const cv::Size grid = grid_for(result, static_cast<int>(state.range(0)));
  for (auto step : state)
    benchmark::DoNotOptimize(face_surface(result, face, grid.width, grid.height));
  state.counters["vertices"] = grid.area();
}
BENCHMARK(surface_of_a_frame)->Arg(25000)->Arg(100000)->Unit(benchmark::kMillisecond);

/// In a window of 1280 x 800, as fast as it goes.
void shown_in_3d(benchmark::State& state) {
  if (!VtkView::is_supported()) return state.SkipWithError("needs a screen with OpenGL: xvfb-run");
  FrameResult result;
  InspectPane pane(PaneContent::kFirst);
  InspectOptions options;
  options.scene.camera = options.scene.untouched = true;
  pane.set_options(options);
  pane.resize(960, 640);
  pane.show();
  static_cast<void>(QTest::qWaitForWindowExposed(&pane));
  const double side = std::sqrt(static_cast<double>(state.range(0)) * 16 / 9);
  const cv::Size grid(static_cast<int>(side), static_cast<int>(side * 9 / 16));
  const auto frame_at = [&](double depth_mm) {
    MadeSurface made;
    made.deepest_mm = depth_mm;
    auto frame = std::make_shared<InspectedFrame>();
    frame->surface = made.make(grid.width, grid.height);
    frame->camera = MadeSurface::camera();
    return frame;
  };
  std::vector<std::shared_ptr<InspectedFrame>> frames;
  for (int i = 0; i < 10; ++i) frames.push_back(frame_at(0.1 * i));
  std::size_t next = 0;
  const auto show_next = [&] {
    pane.show_frame(frames[next++ % frames.size()]);
    const int before = pane.face_pane() == nullptr ? 0 : pane.face_pane()->renders();
    while (pane.face_pane()->renders() == before) QCoreApplication::processEvents();
  };
  for (int i = 0; i < 5; ++i) show_next();  // shaders are made once
  for (auto step : state) show_next();
  state.counters["vertices"] = grid.area();
  state.counters["per_s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(shown_in_3d)
    ->Arg(25000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(60)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace alltact::test
