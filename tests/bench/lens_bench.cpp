// What a lens calibration costs: finding a board in one picture, and the fit with all its judging.
#include "calibration/lens/calibrate_lens.h"
#include "tests/support/boards.h"

#include <random>

#include <benchmark/benchmark.h>

namespace alltact {
namespace {

void BM_FindChessboard(benchmark::State& state) {
  const Board board = made::chessboard(8, 6, 4);
  const Camera camera = Camera::create(made::board_lens()).value();
  std::mt19937 random(1);
  const auto scene = made::board_scene(camera, board, 1, 30, 0, random);
  const cv::Mat image = made::BoardPainter(camera).paint(
      scene.poses[0], [&](double x, double y) { return made::chessboard_ink(board, x, y); }, 1);
  for ([[maybe_unused]] const auto _ : state) {
    if (!find_board(image, board)) state.SkipWithError("no board found");
  }
}
BENCHMARK(BM_FindChessboard)->Unit(benchmark::kMillisecond);

void BM_CalibrateLens(benchmark::State& state) {
  const Camera camera = Camera::create(made::board_lens()).value();
  std::mt19937 random(2);
  const auto scene = made::board_scene(camera, made::chessboard(), static_cast<int>(state.range(0)),
                                       35, 0.2, random);
  for ([[maybe_unused]] const auto _ : state) {
    const auto found = calibrate_lens(scene.views, camera.size(), {}, {});
    if (!found) {
      state.SkipWithError("no lens found");
      continue;
    }
    state.counters["fx_sd_percent"] = 100 * found->fit.sd(0) / found->fit.lens.fx_px;
    state.counters["fx_off_percent"] =
        100 * (found->fit.lens.fx_px / camera.parameters().fx_px - 1);
  }
}
BENCHMARK(BM_CalibrateLens)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alltact
