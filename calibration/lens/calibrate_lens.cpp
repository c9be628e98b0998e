#include "calibration/lens/calibrate_lens.h"

#include "calibration/lens/board_views.h"
#include "calibration/lens/lens_fit.h"
#include "core/base/message.h"
#include "core/base/message_json.h"
#include "core/base/program.h"
#include "core/base/utc_time.h"
#include "core/numerics/median.h"
#include "core/open/open_source.h"

#include <map>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

constexpr double kOutlierScatter = 2.5;  // times the median view's
constexpr double kMinScatterPx = 0.05;   // below, no view is an outlier
constexpr double kGoodCornersPx = 0.3;   // above, focus, motion or the board is at fault
constexpr double kBlurred = 1.6;         // times the median view's edge width

/// Robust scatter of one coordinate of all corners of a view, outliers included.
double scatter_px(const std::vector<double>& errors_px) {
  std::vector<double> errors = errors_px;
  return upper_median(errors) / 1.1774;
}

Message outlier_reason(const BoardView& view, const LensFit& fit, std::size_t index, double scatter,
                       double median_scatter, double median_edge_px) {
  const Message found =
      en::say("its corners are {:.2f} px off the lens model, those of the others {:.2f} px",
              scatter, median_scatter);
  if (view.edge_px > kBlurred * median_edge_px)
    return en::say(
        "blurred, by motion or focus: its edges are {:.1f} px wide, those of the "
        "others {:.1f} px",
        view.edge_px, median_edge_px);
  const std::vector<double> ones(view.pixels.size(), 1.0);
  BoardPose flat_pose = fit.poses[index], bent_pose = flat_pose;
  Eigen::Vector4d shape;
  const double flat = fit_pose(view, fit.lens, ones, flat_pose);
  const double bent = fit_pose(view, fit.lens, ones, bent_pose, &shape);
  if (bent < 0.5 * flat)
    return en::clauses({found, en::say("the board is bent; glue it to something stiff")});
  const auto wrong = std::count(fit.weights[index].begin(), fit.weights[index].end(), 0.0);
  if (scatter < kOutlierScatter * median_scatter)
    return en::say("{} of its {} corners are misplaced: covered, reflected or blurred", wrong,
                   view.pixels.size());
  return en::clauses({found, en::say("moved during the exposure, or not this board")});
}

/// Views in which more than a quarter of the corners are outliers, or that scatter 2.5 times as
/// much as the median view, by their index; with the reasons.
std::map<std::size_t, Message> outlier_views(const std::vector<BoardView>& views,
                                             const LensFit& fit) {
  std::vector<double> scatters, edges;
  for (std::size_t i = 0; i < views.size(); ++i) {
    scatters.push_back(scatter_px(fit.errors_px[i]));
    edges.push_back(views[i].edge_px);
  }
  std::vector<double> sorted = scatters;
  const double median_scatter = upper_median(sorted);
  const double median_edge_px = upper_median(edges);
  std::map<std::size_t, Message> outliers;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto wrong = std::count(fit.weights[i].begin(), fit.weights[i].end(), 0.0);
    const bool scattered =
        scatters[i] > kOutlierScatter * median_scatter && scatters[i] > kMinScatterPx;
    if (!scattered && 4 * static_cast<std::size_t>(wrong) <= views[i].pixels.size()) continue;
    outliers[i] = outlier_reason(views[i], fit, i, scatters[i], median_scatter, median_edge_px);
  }
  return outliers;
}

/// The board's defect in words; empty when there is none.
Message board_problem(const BoardShape& shape, const LensFit& fit) {
  Message problem;
  if (shape.is_stretched)
    problem =
        en::say("its squares are {:.2f} % {} than they are high", 100 * std::abs(shape.stretch),
                shape.stretch > 0 ? en::say("wider") : en::say("narrower"));
  if (shape.is_bent) {
    const Message bent =
        en::say("it is bent by about {:.2g} mm from its middle to its corners", shape.bend_mm);
    problem = problem.empty() ? bent : en::say("{}, and {}", problem, bent);
  }
  return en::say(
      "the board is not flat and even as assumed: {}; corrected for this, fx would be {:.2f} "
      "instead of {:.2f} px; use a board on glass or metal",
      problem, shape.lens.fx_px, fit.lens.fx_px);
}

/// fx and fy differ: what explains it; empty when they do not.
Message aspect_problem(const LensCalibration& calibration) {
  const PixelAspect aspect = pixel_aspect(calibration);
  const double percent = 100 * std::abs(aspect.ratio - 1);
  const Message wider = aspect.ratio > 1 ? en::say("wider") : en::say("narrower");
  switch (aspect.cause) {
    case AspectCause::kNone:
      return {};
    case AspectCause::kBoard:
      return en::say(
          "fx and fy differ by {:.1f} %: a board with squares that are {:.1f} % {} than high "
          "explains it, and pixels are then square; measure the board's width and height with a "
          "caliper, and print it without scaling",
          percent, 100 * std::abs(calibration.shape->stretch), wider);
    case AspectCause::kImage:
      return en::say(
          "fx and fy differ by {:.1f} %, although the board is square within {:.1f} %: the camera "
          "stretches its images, or its pixels are not square",
          percent, 100 * calibration.shape->stretch_sd);
    case AspectCause::kUndecided:
      break;
  }
  return en::say(
      "fx and fy differ by {:.1f} %: a board printed {:.1f} % {} than high and pixels that are not "
      "square look alike in these views. The board is likelier: measure its width and height with "
      "a caliper, and turn it by 90 degrees in half of the views",
      percent, percent, wider);
}

/// The distance of the boards contradicts that of the finger: the size of the squares is likely in
/// another unit. Empty when it does not.
Message distance_problem(const LensCalibration& calibration, double distance_mm) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < calibration.used.size(); ++i)
    distances.push_back(calibration.fit.poses[i](calibration.used[i].board_mm.front()).norm());
  const double board_mm = upper_median(distances);
  constexpr double kOtherUnit = 50;  // a camera that is sharp at one of them is not at the other
  if (board_mm * kOtherUnit >= distance_mm && board_mm <= kOtherUnit * distance_mm) return {};
  return en::say(
      "with squares of this size the boards are {:.2g} mm from the lens, and the finger {:g} mm: "
      "give --square-mm in millimetres, not in {}",
      board_mm, distance_mm, board_mm < distance_mm ? en::say("metres") : en::say("micrometres"));
}

Error too_few(std::size_t count) {
  return {en::say("only {} different views of the board are left; at least {} are needed", count,
                  kFewestViews),
          "",
          en::say("{} images or more, with the board tilted and in all parts of the image",
                  kEnoughViews)};
}

LensViewReport& report_of(LensCalibration& calibration, const std::string& name) {
  return *std::find_if(calibration.views.begin(), calibration.views.end(),
                       [&](const LensViewReport& report) { return report.name == name; });
}

void reject_view(LensCalibration& calibration, std::size_t index, const Message& reason) {
  const auto at = static_cast<std::ptrdiff_t>(index);
  report_of(calibration, calibration.used[index].name).rejection = reason;
  calibration.used.erase(calibration.used.begin() + at);
  if (index < calibration.fit.poses.size())
    calibration.fit.poses.erase(calibration.fit.poses.begin() + at);
}

/// Mean distance of the corners in both views; infinite when they share too few.
double distance_between(const BoardView& a, const BoardView& b) {
  double sum = 0;
  int shared = 0;
  for (std::size_t i = 0, k = 0; i < a.board_mm.size(); ++i) {
    // The corners of both have the same order; some may be missing.
    std::size_t found = k;
    while (found < b.board_mm.size() && b.board_mm[found] != a.board_mm[i]) ++found;
    if (found == b.board_mm.size()) continue;
    k = found + 1;
    sum += (a.pixels[i] - b.pixels[found]).norm();
    ++shared;
  }
  if (2 * shared < static_cast<int>(a.pixels.size()))
    return std::numeric_limits<double>::infinity();
  return sum / shared;
}

void reject_repeats(LensCalibration& calibration, cv::Size size) {
  const double limit = 0.005 * std::hypot(size.width, size.height);
  for (std::size_t i = 1; i < calibration.used.size();) {
    const auto same = std::find_if(calibration.used.begin(),
                                   calibration.used.begin() + static_cast<std::ptrdiff_t>(i),
                                   [&](const BoardView& before) {
                                     return distance_between(before, calibration.used[i]) < limit;
                                   });
    if (calibration.used.begin() + static_cast<std::ptrdiff_t>(i) == same) {
      ++i;
    } else {
      reject_view(calibration, i, en::say("shows the board exactly where {} shows it", same->name));
    }
  }
}

/// Estimates first poses with the first lens; rejects views that it cannot have seen.
Status start(LensCalibration& calibration, cv::Size size, CameraModel model) {
  const auto lens = first_lens(calibration.used, model, size);
  if (!lens) return lens.error();
  calibration.fit.lens = *lens;
  const Camera camera = Camera::create(*lens).value();
  for (std::size_t i = 0; i < calibration.used.size();) {
    const auto poses = poses_of(calibration.used[i], camera);
    if (poses.empty()) {
      reject_view(calibration, i, en::say("no flat board can look like this"));
      continue;
    }
    calibration.fit.poses.push_back(poses.front());
    ++i;
  }
  if (calibration.used.size() < kFewestViews) return too_few(calibration.used.size());
  return {};
}

/// Numbers of coefficients to try, largest first.
std::vector<int> coefficient_counts(CameraModel model) {
  if (model == CameraModel::kFisheye) return {4, 2, 1, 0};
  return {5, 4, 2, 0};
}

bool is_sound(const LensFit& fit) { return Camera::create(fit.lens).ok(); }

/// Fits as many coefficients as the views determine, and returns their number. A fit of the first
/// one alone gives the start.
Result<int> fit_stepwise(LensCalibration& calibration, const Job& job) {
  if (const auto rough = fit_lens(calibration.used, calibration.fit, 1, job);
      rough && is_sound(*rough))
    calibration.fit = *rough;
  Error problem;
  for (const int coefficients : coefficient_counts(calibration.fit.lens.model)) {
    LensFit begin = calibration.fit;
    if (coefficients == 0) begin.lens.distortion.clear();
    auto fit = fit_lens(calibration.used, begin, coefficients, job);
    if (job.stop_requested())
      return Error{en::say("stopped before the lens was estimated"), "", ""};
    if (fit) {
      const auto camera = Camera::create(fit->lens);
      if (camera) {
        calibration.fit = std::move(*fit);
        return coefficients;
      }
      problem = camera.error();
      problem.advice = en::say("views that reach into the image's corners, or another --model");
    } else {
      problem = fit.error();
    }
  }
  return problem;
}

/// A small board looks nearly the same in two tilts. The fitted lens shows which pose is
/// better.
bool turn_wrong_poses(LensCalibration& calibration) {
  const auto camera = Camera::create(calibration.fit.lens);
  if (!camera) return false;
  bool turned = false;
  LensFit& fit = calibration.fit;
  for (std::size_t i = 0; i < calibration.used.size(); ++i) {
    BoardPose current = fit.poses[i];
    const double now = fit_pose(calibration.used[i], fit.lens, fit.weights[i], current);
    for (BoardPose other : poses_of(calibration.used[i], *camera)) {
      if (!(fit_pose(calibration.used[i], fit.lens, fit.weights[i], other) < 0.999 * now)) continue;
      fit.poses[i] = other;
      turned = true;
      break;
    }
  }
  return turned;
}

Status fit_again(LensCalibration& calibration, int coefficients, const Job& job) {
  auto fit = fit_lens(calibration.used, calibration.fit, coefficients, job);
  if (!fit) return fit.error();
  if (const auto camera = Camera::create(fit->lens); !camera) return camera.error();
  calibration.fit = std::move(*fit);
  return {};
}

/// Returns the number of coefficients.
Result<int> fit_without_outliers(LensCalibration& calibration, const Job& job) {
  constexpr int kMaxRounds = 4;
  for (int round = 0; round < kMaxRounds; ++round) {
    const auto coefficients = fit_stepwise(calibration, job);
    if (!coefficients) return coefficients;
    if (turn_wrong_poses(calibration))
      if (const Status status = fit_again(calibration, *coefficients, job); !status)
        return status.error();
    const auto outliers = outlier_views(calibration.used, calibration.fit);
    if (outliers.empty()) return coefficients;
    for (auto outlier = outliers.rbegin(); outlier != outliers.rend(); ++outlier)
      reject_view(calibration, outlier->first, outlier->second);
    if (calibration.used.size() < kFewestViews) return too_few(calibration.used.size());
  }
  return fit_stepwise(calibration, job);
}

/// Dots: replaces measured centres by true ones, and fits the lens to those.
Status fit_without_dot_bias(LensCalibration& calibration, int coefficients, const Job& job) {
  std::vector<double> parts;
  for (const BoardView& view : calibration.used)
    if (view.dot_part > 0) parts.push_back(view.dot_part);
  if (parts.empty()) return {};
  const auto& board = calibration.used.front().board_mm;
  double spacing_mm = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < board.size(); ++i)
    spacing_mm = std::min(spacing_mm, (board[i] - board[0]).norm());
  const double radius_mm = 0.5 * upper_median(parts) * spacing_mm;
  const std::vector<BoardView> measured = calibration.used;
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < measured.size(); ++i)
      calibration.used[i] =
          without_dot_bias(measured[i], calibration.fit.lens, calibration.fit.poses[i], radius_mm);
    if (const Status status = fit_again(calibration, coefficients, job); !status) return status;
  }
  return {};
}

void report_views(LensCalibration& calibration) {
  const LensFit& fit = calibration.fit;
  for (std::size_t i = 0; i < calibration.used.size(); ++i) {
    LensViewReport& report = report_of(calibration, calibration.used[i].name);
    double sum = 0, used = 0;
    for (std::size_t k = 0; k < fit.weights[i].size(); ++k) {
      if (fit.weights[i][k] == 0) continue;
      sum += fit.errors_px[i][k] * fit.errors_px[i][k];
      ++used;
    }
    report.error_px = std::sqrt(sum / std::max(1.0, 2 * used));
    report.left_out = static_cast<int>(fit.weights[i].size() - static_cast<std::size_t>(used));
    report.tilt_deg = tilt_deg(calibration.used[i], fit.poses[i]).norm();
  }
}

void judge(LensCalibration& calibration, double distance_mm, int coefficients, const Job& job) {
  const LensFit& fit = calibration.fit;
  job.report(0.6, en::say("leaving views out"));
  calibration.held_out = cross_validate(calibration.used, fit, coefficients, job);
  job.report(0.9, en::say("comparing halves"));
  calibration.halves = compare_halves(calibration.used, fit, coefficients, distance_mm, job);
  calibration.coverage = coverage_of(calibration.used, fit);
  const Eigen::Vector4d covariance_sd = fit.covariance.diagonal().head<4>().cwiseSqrt();
  const Eigen::Vector4d by_views = lens_sd_px(fit, calibration.held_out, calibration.halves, {});
  const double disagreement = by_views.head<2>().cwiseQuotient(covariance_sd.head<2>()).maxCoeff();
  calibration.shape = board_shape(calibration.used, fit, coefficients, disagreement, job);
  const Eigen::Vector4d sd_px =
      lens_sd_px(fit, calibration.held_out, calibration.halves, calibration.shape);
  calibration.fit.lens.sd_px.assign(sd_px.begin(), sd_px.end());
  calibration.focal_sd_part = std::max(sd_px[0] / fit.lens.fx_px, sd_px[1] / fit.lens.fy_px);
  calibration.verdict = lens_verdict(calibration, distance_mm);
}

void remark(LensCalibration& calibration, double distance_mm, int coefficients, const Job& job) {
  const int max_count = coefficient_counts(calibration.fit.lens.model).front();
  if (coefficients < max_count)
    calibration.remarks.push_back(
        en::say("with {} distortion coefficients the lens folds over inside the image or stays "
                "undetermined; {} are used",
                max_count, coefficients));
  if (calibration.shape && calibration.shape->has_defect())
    calibration.remarks.push_back(board_problem(*calibration.shape, calibration.fit));
  for (const Message& problem :
       {aspect_problem(calibration), distance_problem(calibration, distance_mm)})
    if (!problem.empty()) calibration.remarks.push_back(problem);
  if (calibration.fit.sigma_px > kGoodCornersPx)
    calibration.remarks.push_back(
        en::say("corners scatter by {:.2f} px; good boards give 0.2 or less: check focus, motion, "
                "and whether the board is flat",
                calibration.fit.sigma_px));
  if (job.stop_requested())
    calibration.remarks.push_back(en::say("stopped before everything was evaluated"));
}

std::vector<Choice<MarkerDictionary>> dictionary_choices() {
  using D = MarkerDictionary;
  std::vector<Choice<D>> choices;
  for (const D one : {D::kAny, D::k4x4, D::k5x5, D::k6x6, D::k7x7, D::kOriginal, D::kApril16h5,
                      D::kApril25h9, D::kApril36h10, D::kApril36h11})
    choices.push_back({to_string(one), one});
  return choices;
}

}  // namespace

Board LensSettings::applied_to(Board board) const {
  board.pattern = pattern;
  board.dictionary = dictionary;
  board.marker_part = marker_part;
  board.tag_spacing = tag_spacing;
  return board;
}

const std::vector<Setting<LensSettings>>& lens_settings() {
  using S = LensSettings;
  static const std::vector<Setting<S>> table{
      choice_setting<S, BoardPattern>("pattern", en::say("Pattern printed on the board"),
                                      &S::pattern,
                                      {{"chessboard", BoardPattern::kChessboard},
                                       {"charuco", BoardPattern::kCharuco},
                                       {"dots", BoardPattern::kDots},
                                       {"asymmetric_dots", BoardPattern::kAsymmetricDots},
                                       {"aprilgrid", BoardPattern::kAprilGrid}}),
      choice_setting<S, CameraModel>(
          "model", en::say("brown up to about 120 degrees of view, fisheye beyond"), &S::model,
          {{"brown", CameraModel::kBrown}, {"fisheye", CameraModel::kFisheye}}),
      number_setting<S, double>("distance-mm", en::say("Distance of the finger, for errors in mm"),
                                &S::distance_mm, 1.0, 10000.0),
      choice_setting<S, MarkerDictionary>(
          "dictionary", en::say("ChArUco, AprilGrid: family of the markers; any tries all"),
          &S::dictionary, dictionary_choices()),
      number_setting<S, double>("marker-part",
                                en::say("ChArUco: a marker's side as a fraction of a square's"),
                                &S::marker_part, 0.2, 0.95),
      number_setting<S, double>("tag-spacing",
                                en::say("AprilGrid: gap of two tags as a fraction of a tag's side"),
                                &S::tag_spacing, 0.05, 2.0)};
  return table;
}

BoardView without_dot_bias(const BoardView& view, const CameraParameters& lens,
                           const BoardPose& pose, double dot_radius_mm) {
  constexpr int kSides = 64;
  const Eigen::VectorXd numbers = lens_numbers(lens);
  const std::span<const double> row(numbers.data(), static_cast<std::size_t>(numbers.size()));
  BoardView corrected = view;
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    const auto centre = project_by(lens.model, row, pose(view.board_mm[i]));
    if (!centre) continue;
    // Centroid of the outline's polygon; the origin is near it against cancellation.
    std::vector<Eigen::Vector2d> outline;
    for (int side = 0; side < kSides; ++side) {
      const double turn = 2 * M_PI * side / kSides;
      const Eigen::Vector3d rim(dot_radius_mm * std::cos(turn), dot_radius_mm * std::sin(turn), 0);
      if (const auto seen = project_by(lens.model, row, pose(view.board_mm[i] + rim)))
        outline.push_back(seen->pixel - centre->pixel);
    }
    if (outline.size() < kSides) continue;
    double area = 0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Eigen::Vector2d &a = outline[k], &b = outline[(k + 1) % outline.size()];
      const double cross = a.x() * b.y() - a.y() * b.x();
      area += cross / 2;
      moment += (a + b) * (cross / 6);
    }
    if (area != 0) corrected.pixels[i] -= moment / area;
  }
  return corrected;
}

Result<LensCalibration> calibrate_lens(std::vector<BoardView> views, cv::Size size,
                                       const LensSettings& settings, const Job& job) {
  std::sort(views.begin(), views.end(),
            [](const BoardView& a, const BoardView& b) { return a.name < b.name; });
  LensCalibration calibration;
  for (const BoardView& view : views) {
    calibration.views.emplace_back();
    calibration.views.back().name = view.name;
    calibration.views.back().corners = static_cast<int>(view.pixels.size());
  }
  calibration.used = std::move(views);
  const std::size_t given = calibration.used.size();
  if (given < kFewestViews) return too_few(given);
  reject_repeats(calibration, size);
  if (calibration.used.size() < kFewestViews) {
    if (calibration.used.size() == 1)
      return Error{en::say("all {} views show the board in the same position", given), "",
                   en::say("move and tilt the board, or the camera, between images")};
    return too_few(calibration.used.size());
  }
  job.report(0, en::say("estimating a first lens"));
  if (const Status status = start(calibration, size, settings.model); !status)
    return status.error();
  job.report(0.2, en::say("fitting the lens"));
  const auto coefficients = fit_without_outliers(calibration, job);
  if (!coefficients) return coefficients.error();
  if (const Status status = fit_without_dot_bias(calibration, *coefficients, job); !status)
    return status.error();
  report_views(calibration);
  judge(calibration, settings.distance_mm, *coefficients, job);
  remark(calibration, settings.distance_mm, *coefficients, job);
  return calibration;
}

Result<LensCalibration> measure_lens(const std::vector<std::filesystem::path>& inputs,
                                     const Board& board, const LensSettings& settings,
                                     const Job& job) {
  SourceOptions how;
  how.job = &job;
  const auto source = open_source(inputs, how);
  if (!source) return source.error();
  const auto found = find_boards(**source, board, Orientation::kNone, job);
  if (!found) return found.error();
  auto calibration = calibrate_lens(found->views, found->size, settings, job);
  if (calibration) {
    const auto remarks = print_remarks(found->board);
    calibration->remarks.insert(calibration->remarks.begin(), remarks.begin(), remarks.end());
    for (Message& assumed : (*source)->remarks())
      calibration->remarks.push_back(std::move(assumed));
  }
  return calibration;
}

LensRecord lens_record(const Board& board, const LensCalibration& done) {
  LensRecord record;
  record["date"] = utc_now();
  record["program_version"] = program_version();
  record["board"] = board.words().english();
  record["square_mm"] = fmt::format("{}", board.square_mm);
  record["views"] = fmt::format("{}", done.used.size());
  if (done.halves)
    record["fx_of_halves_px"] =
        fmt::format("{:.4f} {:.4f}", done.halves->numbers[0][0], done.halves->numbers[1][0]);
  record["focal_sd_percent"] = fmt::format("{:.4f}", 100 * done.focal_sd_part);
  record["corner_px"] = fmt::format("{:.4f}", done.fit.sigma_px);
  if (done.held_out) record["held_out_px"] = fmt::format("{:.4f}", done.held_out->error_px);
  record["verdict"] = done.verdict.sentence.english();
  record["verdict_message"] = message_json(done.verdict.sentence).dump();
  return record;
}

}  // namespace alltact
