// What the face in 3D costs in time: made of a frame, brought up to date, drawn.
#include "core/open/open_source.h"
#include "core/sensing/pipeline.h"
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
  for ([[maybe_unused]] const auto _ : state)
    benchmark::DoNotOptimize(face_surface(result, face, grid.width, grid.height));
  state.counters["vertices"] = grid.area();
}
BENCHMARK(surface_of_a_frame)->Arg(25000)->Arg(100000)->Unit(benchmark::kMillisecond);

/// A finger with so many vertices, as deep as this.
std::shared_ptr<InspectedFrame> made_frame(long vertices, double depth_mm) {
  const double side = std::sqrt(static_cast<double>(vertices) * 16 / 9);
  const cv::Size grid(static_cast<int>(side), static_cast<int>(side * 9 / 16));
  MadeSurface made;
  made.deepest_mm = depth_mm;
  auto frame = std::make_shared<InspectedFrame>();
  frame->surface = made.make(grid.width, grid.height);
  for (int i = 0; i < grid.width; ++i) frame->surface->along_mm.push_back(0.1 * i);
  frame->surface->has_body = true;
  frame->camera = MadeSurface::camera();
  return frame;
}

void show(InspectPane& pane) {
  pane.set_options({});
  pane.resize(960, 640);
  pane.show();
  static_cast<void>(QTest::qWaitForWindowExposed(&pane));
}

/// In a window of 1280 x 800, as fast as it goes; nothing but the camera moves.
void turned_in_3d(benchmark::State& state) {
  if (!VtkView::is_supported()) return state.SkipWithError("needs a screen with OpenGL: xvfb-run");
  InspectPane pane(PaneContent::kFirst);
  show(pane);
  pane.show_frames({made_frame(state.range(0), 0.8)});
  FacePane& face = *pane.face_pane();
  const auto turn = [&] {
    const int before = face.renders();
    QKeyEvent key(QEvent::KeyPress, Qt::Key_Left, Qt::NoModifier);
    QCoreApplication::sendEvent(&face, &key);
    while (face.renders() == before) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  };
  for (int i = 0; i < 5; ++i) turn();
  double longest_ms = 0;
  for ([[maybe_unused]] const auto _ : state) {
    QElapsedTimer timer;
    timer.start();
    turn();
    longest_ms = std::max(longest_ms, 1e-6 * static_cast<double>(timer.nsecsElapsed()));
  }
  state.counters["vertices"] = static_cast<double>(state.range(0));
  state.counters["longest_ms"] = longest_ms;
  state.counters["per_s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(turned_in_3d)
    ->Arg(25000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(60)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// From the pointer to the pixel under it.
void pointed_at_in_3d(benchmark::State& state) {
  if (!VtkView::is_supported()) return state.SkipWithError("needs a screen with OpenGL: xvfb-run");
  InspectPane pane(PaneContent::kFirst);
  show(pane);
  pane.show_frames({made_frame(state.range(0), 0.8)});
  const FaceScene& scene = pane.face_pane()->scene();
  double x = 300;
  for ([[maybe_unused]] const auto _ : state) {
    benchmark::DoNotOptimize(scene.pixel_at(x, 320));
    x = x < 600 ? x + 1 : 300;
  }
}
BENCHMARK(pointed_at_in_3d)->Arg(25000)->Arg(100000)->Unit(benchmark::kMillisecond);

/// In a window of 1280 x 800, as fast as it goes.
void shown_in_3d(benchmark::State& state) {
  if (!VtkView::is_supported()) return state.SkipWithError("needs a screen with OpenGL: xvfb-run");
  InspectPane pane(PaneContent::kFirst);
  show(pane);
  std::vector<std::shared_ptr<InspectedFrame>> frames;
  for (int i = 0; i < 10; ++i) frames.push_back(made_frame(state.range(0), 0.1 * i));
  std::size_t next = 0;
  const auto show_next = [&] {
    pane.show_frames({frames[next++ % frames.size()]});
    const int before = pane.face_pane() == nullptr ? 0 : pane.face_pane()->renders();
    while (pane.face_pane()->renders() == before) QCoreApplication::processEvents();
  };
  for (int i = 0; i < 5; ++i) show_next();  // shaders are made once
  for ([[maybe_unused]] const auto _ : state) show_next();
  state.counters["vertices"] = static_cast<double>(state.range(0));
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
