// The same corners through our lens fit and through mrcal's, a calibrator that shares no line with
// ours: focal lengths, and by how much the two lenses disagree on where points are seen. Needs
// mrcal-calibrate-cameras (apt install mrcal); says so where there is none.
#include "calibration/lens/board_views.h"
#include "calibration/lens/calibrate_lens.h"
#include "core/open/open_source.h"
#include "tests/support/boards.h"
#include "tests/support/temporary_folder.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMissing =
    "no mrcal-calibrate-cameras on this computer: apt install mrcal brings it";
constexpr double kFingerMm = 60;

bool has_mrcal() { return std::system("command -v mrcal-calibrate-cameras >/dev/null 2>&1") == 0; }

struct Corners {
  Board board;
  cv::Size size;
  std::vector<BoardView> views;
};

/// mrcal's lens of these corners; its model by name.
std::optional<std::vector<double>> mrcal_lens(const Corners& corners, const std::string& model,
                                              double focal_px) {
  const test::TemporaryFolder folder;
  std::ofstream file(folder / "corners.vnl");
  file << "# filename x y level\n";
  for (std::size_t i = 0; i < corners.views.size(); ++i)
    for (const Eigen::Vector2d& pixel : corners.views[i].pixels)
      file << fmt::format("view{:03}.png {:.10f} {:.10f} 0\n", i, pixel.x(), pixel.y());
  file.close();
  const std::string command = fmt::format(
      "cd {0} && mrcal-calibrate-cameras --corners-cache corners.vnl --lensmodel {1} --focal {2} "
      "--object-spacing {3} --object-width-n {4} --object-height-n {5} --imagersize {6} {7} "
      "--skip-calobject-warp-solve --skip-regularization --outdir {0} 'view*.png' >log 2>&1",
      folder.path().string(), model, focal_px, corners.board.square_mm / 1000,
      corners.board.columns, corners.board.rows, corners.size.width, corners.size.height);
  const bool done = std::system(command.c_str()) == 0;
  std::ostringstream text;
  text << std::ifstream(folder / (done ? "camera-0.cameramodel" : "log")).rdbuf();
  const std::string reported = text.str();
  std::smatch found;
  static const std::regex kIntrinsics(R"('intrinsics':\s*\[([^\]]*)\])");
  if (!done || !std::regex_search(reported, found, kIntrinsics)) {
    std::fprintf(stderr, "mrcal: %s\n", reported.c_str());
    return std::nullopt;
  }
  std::string list = found[1];
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream numbers(list);
  std::vector<double> values;
  for (double value = 0; numbers >> value;) values.push_back(value);
  return values;
}

/// Both lenses side by side. `truth` may be unknown.
void compare(benchmark::State& state, const Corners& corners, const CameraParameters* truth) {
  if (!has_mrcal()) return state.SkipWithError(kMissing);
  for ([[maybe_unused]] const auto _ : state) {
    const auto ours = calibrate_lens(corners.views, corners.size, {}, {});
    const auto other = mrcal_lens(corners, "LENSMODEL_OPENCV5", 0.8 * corners.size.width);
    if (!ours || !other || other->size() != 9) {
      state.SkipWithError("one of the two found no lens");
      continue;
    }
    CameraParameters lens = ours->fit.lens;
    set_lens_numbers(lens, Eigen::Map<const Eigen::VectorXd>(other->data(), 9));
    const auto apart = difference_of(ours->fit.lens, lens, kFingerMm);
    state.counters["fx_ours"] = ours->fit.lens.fx_px;
    state.counters["fx_sd_ours"] = ours->fit.sd(0);
    state.counters["fx_mrcal"] = lens.fx_px;
    if (truth != nullptr) state.counters["fx_truth"] = truth->fx_px;
    if (!apart) continue;
    const double mm_per_px = kFingerMm / lens.fx_px;
    state.counters["median_px"] = apart->median_px;
    state.counters["worst_px"] = apart->worst_px;
    state.counters["worst_mm"] = apart->worst_px * mm_per_px;
  }
}

/// Corners as a lens sees them, with noise.
void BM_SameCornersAsMrcal(benchmark::State& state) {
  const CameraParameters truth = made::board_lens();
  std::mt19937 random(static_cast<unsigned>(state.range(0)));
  const Board board = made::chessboard();
  auto scene = made::board_scene(Camera::create(truth).value(), board, 20, 35, 0.2, random);
  compare(state, {board, {truth.width_px, truth.height_px}, std::move(scene.views)}, &truth);
}
BENCHMARK(BM_SameCornersAsMrcal)->Arg(1)->Arg(2)->Arg(3)->Iterations(1)->Unit(benchmark::kSecond);

/// Corners found in painted pictures.
void BM_SamePicturesAsMrcal(benchmark::State& state) {
  const CameraParameters truth = made::board_lens();
  const Camera camera = Camera::create(truth).value();
  const made::BoardPainter painter(camera);
  std::mt19937 random(static_cast<unsigned>(state.range(0)));
  const Board board = made::chessboard(8, 6, 4);
  const auto scene = made::board_scene(camera, board, 20, 35, 0, random);
  Corners corners{board, camera.size(), {}};
  for (std::size_t i = 0; i < scene.poses.size(); ++i) {
    auto view =
        find_board(painter.paint(
                       scene.poses[i],
                       [&](double x, double y) { return made::chessboard_ink(board, x, y); }, i),
                   board);
    if (!view) continue;
    view->name = scene.views[i].name;
    corners.views.push_back(std::move(*view));
  }
  compare(state, corners, &truth);
}
BENCHMARK(BM_SamePicturesAsMrcal)->Arg(1)->Iterations(1)->Unit(benchmark::kSecond);

/// Real boards through a fisheye, which the two describe in different words: focal lengths alone.
void BM_RealBoardsAsMrcal(benchmark::State& state) {
  const fs::path folder = fs::path(ALLTACT_SOURCE_DIR) / "../shared/data/fisheye_boards";
  if (!fs::exists(folder)) return state.SkipWithError("no pictures of real boards");
  if (!has_mrcal()) return state.SkipWithError(kMissing);
  Corners corners{made::chessboard(6, 6, 10), {}, {}};
  const auto source = open_source({folder});
  const auto found = source ? find_boards(**source, corners.board, Orientation::kNone, {})
                            : Result<LensViews>(source.error());
  if (!found) return state.SkipWithError(found.error().what.english().c_str());
  corners.size = found->size;
  corners.views = found->views;
  LensSettings settings;
  settings.model = CameraModel::kFisheye;
  for ([[maybe_unused]] const auto _ : state) {
    const auto ours = calibrate_lens(corners.views, corners.size, settings, {});
    const auto other = mrcal_lens(corners, "LENSMODEL_OPENCV8", 0.45 * corners.size.width);
    if (!ours || !other) {
      state.SkipWithError("one of the two found no lens");
      continue;
    }
    state.counters["fx_ours"] = ours->fit.lens.fx_px;
    state.counters["fx_sd_ours"] = ours->focal_sd_part * ours->fit.lens.fx_px;
    state.counters["fx_mrcal"] = other->front();
  }
}
BENCHMARK(BM_RealBoardsAsMrcal)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace alltact
