// What the window costs in time: until its picture moves, and how old the picture is when it is
// shown.
#include "calibration/reference/reference_recording.h"
#include "core/finger/finger_store.h"
#include "core/simulation/plan.h"
#include "tests/studio/studio_rig.h"
#include "tests/support/own_cache.h"
#include "widgets/image/outline_editor.h"
#include "widgets/scene3d/vtk_view.h"

#include <QApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <fstream>

#include <benchmark/benchmark.h>
#include <opencv2/imgcodecs.hpp>
#include <sys/resource.h>

namespace alltact::test {
namespace {

double percentile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

/// From nothing to the second picture of a simulated finger in a shown window.
void until_the_picture_moves(benchmark::State& state) {
  static_cast<void>(MadeFingers::get());
  for ([[maybe_unused]] const auto _ : state) {
    StudioOptions options;
    options.source = {MadeFingers::get().bending()};
    Studio studio(options);
    int shown = 0;
    QObject::connect(&studio.session(), &LiveSession::view_ready, [&] { ++shown; });
    wait_until([&] { return shown >= 2; });
    state.PauseTiming();
    studio.close();
    state.ResumeTiming();
  }
}
BENCHMARK(until_the_picture_moves)->Unit(benchmark::kMillisecond)->Iterations(5)->UseRealTime();

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Depth for all frames from now on, as a calibrated finger has it.
Status give_mapping(const std::filesystem::path& folder) {
  auto finger = Finger::load(folder);
  if (!finger) return finger.error();
  finger->mapping.emplace();
  finger->mapping->kind = MappingKind::kMoebius;
  finger->mapping->x_max = 0.7;
  finger->mapping->a_mm = 1.5;
  finger->mapping->b = 0.5;
  return finger->save(folder);
}

/// A camera's 1920 x 1080 MJPEG, a simulated finger in it; what the finger tells found and drawn:
/// edges and markers, with a reference depth and contacts too. Without a reference the markers are
/// two plain rows. recorded: everything that comes, meanwhile. cores: what the whole program takes,
/// the made-up camera's share included.
void age_of_full_hd(benchmark::State& state) {
  const bool has_reference = state.range(0) != 0;
  const auto frames_per_s = static_cast<std::uint32_t>(state.range(1));
  const bool is_recorded = state.range(2) != 0;
  const TemporaryFolder folder;
  std::ofstream(folder / "hd.yaml") << small_scene(false, 1920);
  const Plan plan = Plan::compile(Scene::load(folder / "hd.yaml").value(), 1).value();
  FakeOptions camera;
  camera.sizes = {{1920, 1080}};
  camera.rates = {frames_per_s};
  constexpr int kPackets = 30;
  for (int i = 0; i < kPackets; ++i)
    cv::imencode(".jpg", plan.render(i), camera.packets.emplace_back());
  FakeCamera fake(camera);
  NewFinger description;
  description.finger = folder / "finger";
  description.camera = folder / "camera.yaml";
  description.width_mm = 24;
  description.layer_mm = 1.5;
  description.per_row = 6;
  const Status saved = save_camera(description.camera, plan.finger().camera);
  auto finger = make_finger(description);
  if (!saved || !finger) return state.SkipWithError("no finger");
  if (has_reference && (!set_reference(description.finger, {folder / "hd.yaml"}, Job()) ||
                        !give_mapping(description.finger)))
    return state.SkipWithError("no reference");
  for ([[maybe_unused]] const auto _ : state) {
    StudioOptions options;
    options.opener = with_camera(fake);
    options.source = {"camera"};
    options.finger = description.finger;
    Studio studio(options);
    wait_until([&] { return studio.session().status().finger.state == FingerState::kReady; },
               60000);
    QTest::qWait(500);
    const std::size_t before = studio.session().ages_ms().size();
    if (is_recorded) studio.session().start_recording(folder / "hd.mkv");
    const double busy_before = processor_seconds();
    QElapsedTimer clock;
    clock.start();
    QTest::qWait(8000);
    state.counters["cores"] =
        (processor_seconds() - busy_before) / (1e-3 * static_cast<double>(clock.elapsed()));
    if (is_recorded) {
      studio.session().stop_recording();
      wait_until(
          [&] { return studio.session().status().recording.state == RecordingState::kDone; });
    }
    const auto& ages = studio.session().ages_ms();
    const auto& counts = studio.session().status().recording.counts;
    const std::vector<double> all(ages.begin() + static_cast<std::ptrdiff_t>(before), ages.end());
    const auto& view = studio.session().view();
    state.counters["markers"] = view && view->result.markers ? view->result.markers->size() : 0;
    state.counters["frame_ms"] = studio.session().times_ms().total;
    state.counters["age_p50_ms"] = percentile(all, 0.5);
    state.counters["age_p95_ms"] = percentile(all, 0.95);
    state.counters["shown"] = static_cast<double>(all.size());
    state.counters["recorded"] = static_cast<double>(counts.recorded);
    state.counters["dropped"] = static_cast<double>(counts.dropped);
    studio.close();
  }
}
BENCHMARK(age_of_full_hd)
    ->ArgNames({"reference", "frames_per_s", "recorded"})
    ->Args({0, 30, 1})
    ->Args({1, 30, 1})
    ->Args({1, 60, 1})
    ->Args({1, 60, 0})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime();

/// A hand drags a ball's outline by its rim over a Full HD picture in a view of that size: from
/// the hand's move to all that is painted, magnifier and all. On its own; kept at 16 ms or less.
void drag_of_an_outline(benchmark::State& state) {
  CameraParameters lens;
  lens.model = CameraModel::kBrown;
  lens.width_px = 1920;
  lens.height_px = 1080;
  lens.fx_px = lens.fy_px = 1047.8;
  lens.cx_px = 959.5;
  lens.cy_px = 539.5;
  lens.distortion = {-0.12, 0.02, 0.001, -0.0005, 0};
  OutlineEditor editor;
  editor.resize(1920, 1080);
  editor.show();
  cv::Mat grey(1080, 1920, CV_8UC1);
  cv::randu(grey, 0, 255);
  editor.show_image(grey, {});
  editor.set_ball(ShownBall{Camera::create(lens).value(), 4, {9, -4, 52}, true});
  QImage screen(1920, 1080, QImage::Format_ARGB32_Premultiplied);
  const auto place = image_outline(*editor.ball()).value();
  const QPoint rim = editor.transform().to_widget({place.right_u, place.centre.y()}).toPoint();
  QTest::mousePress(&editor, Qt::LeftButton, {}, rim);
  std::vector<double> times_ms;
  int step = 0;
  for ([[maybe_unused]] const auto _ : state) {
    ++step;
    const auto begin = std::chrono::steady_clock::now();
    QMouseEvent move(QEvent::MouseMove, QPointF(rim + QPoint(step % 40, step % 7)),
                     editor.mapToGlobal(QPointF(rim)), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&editor, &move);
    editor.render(&screen);
    times_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
            .count());
  }
  state.counters["p95_ms"] = percentile(times_ms, 0.95);
}
BENCHMARK(drag_of_an_outline)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alltact::test

int main(int argc, char** argv) {
  const alltact::test::OwnCache cache;
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  benchmark::Initialize(&argc, argv);
  alltact::VtkView::prepare_application();
  QApplication application(argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
