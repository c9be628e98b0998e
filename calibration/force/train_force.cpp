#include "calibration/force/train_force.h"

#include "calibration/force/force_regression.h"
#include "calibration/force/force_table.h"
#include "core/base/atomic_file.h"
#include "core/base/job.h"
#include "core/base/program.h"
#include "core/base/utc_time.h"
#include "core/finger/force_model.h"
#include "core/numerics/checksum.h"
#include "core/sensing/force/force_meter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <opencv2/core/utility.hpp>

namespace alltact {
namespace {

/// Of one kind of regression.
struct HeldOutForce {
  std::vector<ForceMember> members;  ///< by fold, each trained without it
  Eigen::MatrixXd estimated_N;       ///< of each row by the member that held it out
  Eigen::MatrixXd spread_N;          ///< sd of all members, row by row
};

/// error| / s with s = sqrt(floor^2 + spread^2); floor is the errors' root mean square.
struct ForceErrorScores {
  Eigen::VectorXd floor_N;
  Eigen::MatrixXd score;  ///< one row a frame, at least 0
};

/// Runs the folds in parallel; the result does not depend on the number of threads. Incomplete
/// where the job is stopped.
HeldOutForce hold_out_force(const std::vector<ForceInput>& filled, const Eigen::MatrixXd& force_N,
                            const ForceFolds& folds, ForceKind kind,
                            const ForceNetworkOptions& options, const Job& job) {
  HeldOutForce result;
  result.members.resize(static_cast<std::size_t>(folds.count));
  result.estimated_N = Eigen::MatrixXd::Zero(force_N.rows(), force_N.cols());
  cv::parallel_for_(cv::Range(0, folds.count), [&](const cv::Range& range) {
    for (int fold = range.start; fold < range.end && !job.stop_requested(); ++fold)
      result.members[static_cast<std::size_t>(fold)] =
          fit_force_member(filled, force_N, folds.rows_without(fold), kind, options,
                           static_cast<std::uint32_t>(fold));
  });
  if (job.stop_requested()) return result;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(force_N.rows(), force_N.cols()), squares = sum;
  for (int fold = 0; fold < folds.count; ++fold) {
    const ForceMember& member = result.members[static_cast<std::size_t>(fold)];
    for (Eigen::Index row = 0; row < force_N.rows(); ++row) {
      const auto i = static_cast<std::size_t>(row);
      const Eigen::RowVectorXd estimate = member(filled[i]).transpose();
      if (folds.of[i] == fold) result.estimated_N.row(row) = estimate;
      // Relative to the gauge's force, against loss of digits.
      const Eigen::RowVectorXd off = estimate - force_N.row(row);
      sum.row(row) += off, squares.row(row) += off.cwiseAbs2();
    }
  }
  const double count = folds.count;
  result.spread_N = (squares / count - (sum / count).cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  return result;
}

ForceErrorScores error_scores(const HeldOutForce& held_out, const Eigen::MatrixXd& force_N) {
  constexpr double kMinN = 1e-9;  // a table without noise
  const Eigen::MatrixXd error = held_out.estimated_N - force_N;
  ForceErrorScores scores;
  scores.floor_N = (error.colwise().squaredNorm() / static_cast<double>(error.rows()))
                       .cwiseSqrt()
                       .cwiseMax(kMinN)
                       .transpose();
  const Eigen::RowVectorXd floor2 = scores.floor_N.cwiseAbs2().transpose();
  scores.score = error.cwiseAbs().cwiseQuotient(
      (held_out.spread_N.cwiseAbs2().rowwise() + floor2).cwiseSqrt());
  return scores;
}

/// The conformal quantile: the ceil((n + 1) level)-th smallest, or the greatest. Values must not be
/// empty.
double conformal_quantile(std::vector<double> values, double level) {
  const double rank = std::ceil((static_cast<double>(values.size()) + 1) * level);
  const std::size_t index =
      std::min(values.size(), static_cast<std::size_t>(std::max(1.0, rank))) - 1;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index),
                   values.end());
  return values[index];
}

/// Fraction of the rows whose score is not above the quantile of all other folds' scores, by axis.
Eigen::VectorXd covered_part(const Eigen::MatrixXd& score, const ForceFolds& folds, double level) {
  Eigen::VectorXd covered = Eigen::VectorXd::Zero(score.cols());
  for (Eigen::Index axis = 0; axis < score.cols(); ++axis)
    for (int fold = 0; fold < folds.count; ++fold) {
      std::vector<double> others;
      for (const Eigen::Index row : folds.rows_without(fold)) others.push_back(score(row, axis));
      const double quantile = conformal_quantile(std::move(others), level);
      for (const Eigen::Index row : folds.rows_in(fold))
        covered[axis] += score(row, axis) <= quantile ? 1 : 0;
    }
  return covered / static_cast<double>(score.rows());
}

constexpr std::array kForceOrder{ForceKind::kMean, ForceKind::kRidge, ForceKind::kQuadratic,
                                 ForceKind::kNetwork};

Error stopped_training() { return {en::say("stopped before there was a force model"), "", ""}; }

Message kind_word(ForceKind kind) {
  switch (kind) {
    case ForceKind::kMean:
      return en::say("the mean");
    case ForceKind::kRidge:
      return en::say("ridge");
    case ForceKind::kQuadratic:
      return en::say("the quadratic one");
    case ForceKind::kNetwork:
      break;
  }
  return en::say("the network");
}

Eigen::RowVectorXd sd_of(const Eigen::MatrixXd& force_N) {
  const Eigen::RowVectorXd mean = force_N.colwise().mean();
  return ((force_N.rowwise() - mean).colwise().squaredNorm() / static_cast<double>(force_N.rows()))
      .cwiseSqrt();
}

ForceComparison compared(ForceKind kind, const HeldOutForce& held_out,
                         const Eigen::MatrixXd& force_N) {
  const Eigen::MatrixXd error = held_out.estimated_N - force_N;
  const Eigen::RowVectorXd sd = sd_of(force_N);
  ForceComparison result;
  result.kind = kind;
  result.mae_N = error.cwiseAbs().colwise().mean().transpose();
  const Eigen::RowVectorXd squares =
      error.colwise().squaredNorm() / static_cast<double>(error.rows());
  result.rmse_N = squares.cwiseSqrt().transpose();
  result.r2 = (1 - squares.array() / sd.array().square()).matrix().transpose();
  result.relative = result.mae_N.cwiseQuotient(sd.transpose()).mean();
  return result;
}

/// Mean over axes of |error| / sd, by fold.
Eigen::VectorXd errors_by_fold(const HeldOutForce& held_out, const Eigen::MatrixXd& force_N,
                               const ForceFolds& folds) {
  const Eigen::MatrixXd part =
      (held_out.estimated_N - force_N).cwiseAbs() * sd_of(force_N).cwiseInverse().asDiagonal();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(folds.count), count = sum;
  for (Eigen::Index row = 0; row < part.rows(); ++row) {
    const int fold = folds.of[static_cast<std::size_t>(row)];
    sum[fold] += part.row(row).mean(), count[fold] += 1;
  }
  return sum.cwiseQuotient(count);
}

/// Whether the first is better than the second by more than chance.
bool beats(const Eigen::VectorXd& first, const Eigen::VectorXd& second) {
  const Eigen::VectorXd gain = second - first;
  const double mean = gain.mean(), count = static_cast<double>(gain.size());
  const double error =
      std::sqrt((gain.array() - mean).square().sum() / std::max(1.0, count - 1) / count);
  return mean > 0.01 * second.mean() && mean > error;
}

/// The steps of one training, in their order.
class ForceTrainer {
 public:
  ForceTrainer(const ForceTable& table, const ForceTraining& options, const Job& job)
      : table_(table), options_(options), job_(job) {}

  Result<TrainedForce> train(const std::vector<Eigen::Vector2d>& rest_px) {
    auto folds = force_folds(table_, options_.split, options_.seed);
    if (!folds) return folds.error();
    folds_ = std::move(*folds);
    if (options_.creep_s > 0 && table_.time_s.size() == 0)
      return Error{en::say("creep is an input only where the table has times"),
                   std::string("--creep-s"),
                   en::say("a table with a column t_s, or leaving creep out")};
    make_inputs(rest_px);
    if (Status status = compare(); !status) return status.error();
    const ForceKind selected = options_.kind.value_or(simplest());
    select(selected);
    if (!options_.comparison_only)
      if (Status status = add_controls(); !status) return status.error();
    remark(selected);
    return std::move(result_);
  }

 private:
  [[nodiscard]] static std::size_t at(ForceKind kind) { return static_cast<std::size_t>(kind) - 1; }

  void make_inputs(const std::vector<Eigen::Vector2d>& rest_px) {
    ForceModel& model = result_.model;
    model.axes = table_.axes;
    model.marker_count = table_.marker_count;
    model.rest_px = rest_px;
    model.creep_s = options_.creep_s;
    for (Eigen::Index m = static_cast<Eigen::Index>(model.rest_px.size()); m < table_.marker_count;
         ++m) {
      const double seen = std::max(1.0, table_.seen.col(m).sum());
      model.rest_px.emplace_back(table_.layouts.col(2 * m).dot(table_.seen.col(m)) / seen,
                                 table_.layouts.col(2 * m + 1).dot(table_.seen.col(m)) / seen);
    }
    inputs_ = force_inputs(table_, model.rest_px);
    model.range = learn_force_range(inputs_);
    if (model.creep_s > 0) compute_creep(model.creep_s);
  }

  /// In the order of time within each block.
  void compute_creep(double creep_s) {
    std::vector<std::size_t> order(inputs_.size());
    std::iota(order.begin(), order.end(), 0);
    const auto before = [&](std::size_t a, std::size_t b) {
      if (!table_.block.empty() && table_.block[a] != table_.block[b])
        return table_.block[a] < table_.block[b];
      return table_.time_s[static_cast<Eigen::Index>(a)] <
             table_.time_s[static_cast<Eigen::Index>(b)];
    };
    std::stable_sort(order.begin(), order.end(), before);
    CreepMean mean(creep_s);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::size_t row = order[i];
      if (i > 0 && !table_.block.empty() && table_.block[row] != table_.block[order[i - 1]])
        mean.forget();
      inputs_[row].crept_px =
          mean(inputs_[row].displacement_px, table_.time_s[static_cast<Eigen::Index>(row)]);
    }
  }

  Status compare() {
    for (const ForceKind kind : kForceOrder) {
      job_.report(0.12 * static_cast<double>(at(kind)),
                  en::say("training {}, leaving out one block at a time", kind_word(kind)));
      held_out_.push_back(
          hold_out_force(inputs_, table_.force_N, folds_, kind, options_.network, job_));
      if (job_.stop_requested()) return stopped_training();
      result_.comparison.push_back(compared(kind, held_out_.back(), table_.force_N));
      by_fold_.push_back(errors_by_fold(held_out_.back(), table_.force_N, folds_));
    }
    return {};
  }

  [[nodiscard]] ForceKind simplest() const {
    ForceKind best = ForceKind::kMean;
    for (const ForceKind kind : kForceOrder)
      if (beats(by_fold_[at(kind)], by_fold_[at(best)])) best = kind;
    return best;
  }

  void select(ForceKind kind) {
    HeldOutForce& held_out = held_out_[at(kind)];
    const ForceErrorScores errors = error_scores(held_out, table_.force_N);
    ForceModel& model = result_.model;
    model.kind = kind;
    model.members = held_out.members;
    model.scores.floor_N = errors.floor_N;
    model.scores.rms = model.scores.quantile_90 = model.scores.quantile_95 =
        Eigen::VectorXd::Zero(table_.axes);
    constexpr double kMinScore = 1e-6;
    for (Eigen::Index axis = 0; axis < table_.axes; ++axis) {
      const auto column = errors.score.col(axis);
      const std::vector<double> all(column.begin(), column.end());
      model.scores.rms[axis] =
          std::max(kMinScore, std::sqrt(column.squaredNorm() / static_cast<double>(column.size())));
      model.scores.quantile_90[axis] = std::max(kMinScore, conformal_quantile(all, 0.90));
      model.scores.quantile_95[axis] = std::max(kMinScore, conformal_quantile(all, 0.95));
    }
    result_.covered_90 = covered_part(errors.score, folds_, 0.90);
    result_.covered_95 = covered_part(errors.score, folds_, 0.95);
    result_.held_out_N = held_out.estimated_N;
    result_.label_noise_N = force_label_noise_N(table_, folds_).cwiseMin(result_.of(kind).rmse_N);
  }

  /// Adds controls of the comparison: a random split and shuffled forces.
  Status add_controls() {
    const auto random = force_folds(table_, ForceSplit::kRandom, options_.seed);
    if (!random) return random.error();
    const Eigen::MatrixXd shuffled = shuffled_forces();
    ForceNetworkOptions single = options_.network;
    single.members = 1;
    for (const ForceKind kind : kForceOrder) {
      ForceComparison& row = result_.comparison[at(kind)];
      job_.report(0.5 + 0.12 * static_cast<double>(at(kind)),
                  en::say("testing {} by frames and with shuffled forces", kind_word(kind)));
      row.random_mae_N =
          compared(kind, hold_out_force(inputs_, table_.force_N, *random, kind, single, job_),
                   table_.force_N)
              .mae_N;
      row.shuffled_r2 =
          compared(kind, hold_out_force(inputs_, shuffled, folds_, kind, single, job_), shuffled)
              .r2.mean();
      if (job_.stop_requested()) return stopped_training();
    }
    return {};
  }

  [[nodiscard]] Eigen::MatrixXd shuffled_forces() const {
    const auto order = drawn_order(table_.rows(), options_.seed, "force shuffled");
    Eigen::MatrixXd shuffled(table_.rows(), table_.axes);
    for (Eigen::Index row = 0; row < shuffled.rows(); ++row)
      shuffled.row(row) = table_.force_N.row(order[static_cast<std::size_t>(row)]);
    return shuffled;
  }

  void remark(ForceKind selected) {
    std::vector<Message>& remarks = result_.remarks;
    const auto relative = [&](ForceKind kind) { return 100 * result_.of(kind).relative; };
    if (!beats(by_fold_[at(ForceKind::kNetwork)], by_fold_[at(ForceKind::kRidge)]))
      remarks.push_back(
          en::say("The network does not beat ridge: their errors are {:.1f} % and {:.1f} % of the "
                  "forces' standard deviation.",
                  relative(ForceKind::kNetwork), relative(ForceKind::kRidge)));
    if (selected != ForceKind::kMean &&
        !beats(by_fold_[at(selected)], by_fold_[at(ForceKind::kMean)]))
      remarks.push_back(en::say(
          "The chosen model does not beat the table's mean: these markers do not show the force."));
    else if (selected == ForceKind::kMean)
      remarks.push_back(
          en::say("Nothing beats the mean of the table: these markers do not show the force."));
    if (folds_.by_time)
      remarks.push_back(
          en::say("The table has no column 'block': {} sections of consecutive rows were held out.",
                  folds_.count));
    else if (folds_.count < 4)
      remarks.push_back(en::say("Only {} groups could be held out: errors and intervals are rough.",
                                folds_.count));
  }

  const ForceTable& table_;
  const ForceTraining& options_;
  const Job& job_;
  ForceFolds folds_;
  std::vector<ForceInput> inputs_;
  std::vector<HeldOutForce> held_out_;
  std::vector<Eigen::VectorXd> by_fold_;
  TrainedForce result_;
};

}  // namespace

std::vector<ForceInput> force_inputs(const ForceTable& table,
                                     const std::vector<Eigen::Vector2d>& rest_px) {
  std::vector<ForceInput> inputs(static_cast<std::size_t>(table.rows()));
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    ForceInput& input = inputs[static_cast<std::size_t>(row)];
    input.seen = table.seen.row(row).transpose();
    input.displacement_px = Eigen::VectorXd::Zero(Eigen::Index{2} * table.marker_count);
    for (Eigen::Index m = 0; m < table.marker_count; ++m)
      if (input.seen[m] > 0.5)
        input.displacement_px.segment<2>(2 * m) =
            table.layouts.row(row).segment<2>(2 * m).transpose() -
            rest_px[static_cast<std::size_t>(m)];
    if (table.has_position() && table.position_mm.row(row).allFinite())
      input.position_mm = table.position_mm.row(row).transpose();
  }
  return inputs;
}

Eigen::VectorXd force_label_noise_N(const ForceTable& table, const ForceFolds& folds) {
  std::vector<std::size_t> order(static_cast<std::size_t>(table.rows()));
  std::iota(order.begin(), order.end(), 0);
  if (table.time_s.size() > 0)
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return table.time_s[static_cast<Eigen::Index>(a)] <
             table.time_s[static_cast<Eigen::Index>(b)];
    });
  Eigen::VectorXd noise = Eigen::VectorXd::Zero(table.axes);
  for (Eigen::Index axis = 0; axis < table.axes; ++axis) {
    std::vector<double> bends;
    for (std::size_t i = 1; i + 1 < order.size(); ++i) {
      if (folds.of[order[i - 1]] != folds.of[order[i]] ||
          folds.of[order[i]] != folds.of[order[i + 1]])
        continue;
      const auto force = [&](std::size_t k) {
        return table.force_N(static_cast<Eigen::Index>(order[k]), axis);
      };
      bends.push_back(std::abs(force(i - 1) - 2 * force(i) + force(i + 1)));
    }
    if (bends.empty()) {
      noise[axis] = sd_of(table.force_N)[axis];
      continue;
    }
    const auto middle = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 2);
    std::nth_element(bends.begin(), middle, bends.end());
    constexpr double kMedianOfNormal = 0.67449;
    noise[axis] = *middle / kMedianOfNormal / std::sqrt(6.0);  // 1 + 4 + 1 variances
  }
  return noise;
}

Result<TrainedForce> train_force(const ForceTable& table,
                                 const std::vector<Eigen::Vector2d>& rest_px,
                                 const ForceTraining& options, const Job& job) {
  assert(rest_px.empty() || static_cast<int>(rest_px.size()) == table.marker_count);
  return ForceTrainer(table, options, job).train(rest_px);
}

namespace {

namespace fs = std::filesystem;

constexpr const char* kForceFolder = "force";
constexpr const char* kForceBefore = "force_before";  // provenance: the model before this one
constexpr const char* kForceDate = "force_date";
constexpr const char* kForceTable = "table";          // in the model's record
constexpr const char* kForceSplit = "split";          // in the record, too
constexpr const char* kRequestedKind = "asked_kind";  // in the record: a kind, or "auto"
constexpr const char* kNoForce = "none";

std::string hash_of(std::string_view text) {
  Checksum checksum;
  checksum.add(text.data(), text.size());
  return checksum.text();
}

/// Minimum distance of neighbouring markers of a row at rest.
double rest_spacing_px(const std::vector<Eigen::Vector2d>& rest) {
  double min_px = std::numeric_limits<double>::infinity();
  const std::size_t per_row = rest.size() / 2;
  for (std::size_t m = 1; m < rest.size(); ++m)
    if (m != per_row) min_px = std::min(min_px, (rest[m] - rest[m - 1]).norm());
  return min_px;
}

std::string numbers_text(const Eigen::VectorXd& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{}{:.4g}", text.empty() ? "" : " ", value);
  return text;
}

/// Records the figures of a training in the model.
void write_record(const TrainedForce& trained, const ForceTraining& options, ForceModel& model) {
  auto& record = model.record;
  record[kRequestedKind] = options.kind ? to_string(*options.kind) : "auto";
  record[kForceSplit] = std::string(kForceSplits.at(static_cast<std::size_t>(options.split) - 1));
  record["rows"] = fmt::format("{}", trained.held_out_N.rows());
  for (const ForceComparison& row : trained.comparison)
    record["held_out_" + to_string(row.kind) + "_n"] = numbers_text(row.mae_N);
  record["covered_90"] = numbers_text(trained.covered_90);
  record["covered_95"] = numbers_text(trained.covered_95);
  record["label_noise_n"] = numbers_text(trained.label_noise_N);
  record["program_version"] = program_version();
}

std::string force_before(const Finger& finger) {
  return finger.force_model.empty() ? std::string(kNoForce) : finger.force_model;
}

}  // namespace

Status check_force_markers(const ForceTable& table, const Finger& finger) {
  const Message advice = en::say("a table of this finger's markers");
  if (finger.marker_count() == 0)
    return Error{en::say("the finger has no markers to estimate a force from"), finger.name,
                 en::say("a finger with markers")};
  if (!finger.contact)
    return Error{
        en::say("the finger has no reference, so the rest positions of its markers are unknown"),
        finger.name, en::say("alltact reference")};
  if (table.marker_count != finger.marker_count())
    return Error{en::say("the table has {} markers, the finger has {}", table.marker_count,
                         finger.marker_count()),
                 finger.name, advice};
  const auto& rest = finger.contact->rest_markers;
  double nearest_px = std::numeric_limits<double>::infinity();
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    double squares = 0, count = 0;
    for (Eigen::Index m = 0; m < table.marker_count; ++m)
      if (table.seen(row, m) > 0.5) {
        squares += (table.layouts.row(row).segment<2>(2 * m).transpose() -
                    rest[static_cast<std::size_t>(m)])
                       .squaredNorm();
        count += 1;
      }
    nearest_px = std::min(nearest_px, std::sqrt(squares / count));
  }
  if (nearest_px > rest_spacing_px(rest))
    return Error{en::say("the table's markers belong to another finger: in every row they are "
                         "{:.0f} px or more from this finger's rest positions",
                         nearest_px),
                 finger.name, advice};
  return {};
}

Result<TrainedForce> train_for_finger(const Finger& finger, const ForceTable& table,
                                      const ForceTraining& options, const Job& job) {
  if (const Status fits = check_force_markers(table, finger); !fits) return fits.error();
  auto trained = train_force(table, finger.contact->rest_markers, options, job);
  if (!trained) return trained.error();
  trained->model.missing = finger.markers.missing;
  write_record(*trained, options, trained->model);
  return trained;
}

Status install_force(const fs::path& folder, const ForceTable& table, TrainedForce& trained) {
  const auto store = FingerStore::of(folder);
  const std::string csv = table.to_csv();
  const fs::path table_file = fs::path(kForceFolder) / ("table-" + hash_of(csv) + ".csv");
  ForceModel& model = trained.model;
  model.record[kForceTable] = table_file.generic_string();
  if (const Status valid = model.validate(); !valid) return valid.error();
  const std::string json = model.to_json();
  const fs::path model_file = fs::path(kForceFolder) / ("model-" + hash_of(json) + ".json");
  if (const Status made = make_folder(folder / kForceFolder); !made) return made.error();
  if (const Status written = write_file_atomically(folder / table_file, csv); !written)
    return written.error();
  if (const Status written = write_file_atomically(folder / model_file, json); !written)
    return written.error();
  const auto saved = store->update([&](Finger& now) -> Status {
    if (const Status fits = model.belongs_to(now); !fits) return fits;
    if (now.force_model != model_file.generic_string())
      now.provenance[kForceBefore] = force_before(now);
    now.force_model = model_file.generic_string();
    now.provenance[kForceDate] = utc_now();
    return {};
  });
  if (!saved) return saved.error();
  return {};
}

Result<TrainedForce> train_finger_force(const fs::path& folder, const ForceTable& table,
                                        const ForceTraining& options, const Job& job) {
  const auto store = FingerStore::of(folder);
  const auto before = store->snapshot();
  if (!before) return before.error();
  const auto lock = store->lock_for_work("training the force model");
  if (!lock) return lock.error();
  auto trained = train_for_finger((*before)->finger, table, options, job);
  if (!trained) return trained.error();
  if (const Status installed = install_force(folder, table, *trained); !installed)
    return installed.error();
  return trained;
}

Result<FingerPtr> revert_force(const fs::path& folder) {
  return FingerStore::of(folder)->update([&](Finger& finger) -> Status {
    const auto before = finger.provenance.find(kForceBefore);
    if (before == finger.provenance.end())
      return Error{en::say("there is no force model to revert"), folder, ""};
    const std::string file = before->second == kNoForce ? std::string() : before->second;
    if (!file.empty())
      if (const auto model = ForceModel::load(folder / file); !model) return model.error();
    finger.provenance[kForceBefore] = force_before(finger);
    finger.force_model = file;
    return {};
  });
}

namespace {

/// The current model of a finger. Error: none, or it cannot be read.
Result<std::shared_ptr<const ForceModel>> stored_model(const fs::path& folder) {
  const auto snapshot = FingerStore::of(folder)->snapshot();
  if (!snapshot) return snapshot.error();
  if ((*snapshot)->force_problem) return *(*snapshot)->force_problem;
  if (!(*snapshot)->force)
    return Error{en::say("the finger has no force model yet"), folder,
                 en::say("giving the table to train with")};
  return (*snapshot)->force;
}

}  // namespace

Result<ForceTraining> stored_force_training(const fs::path& folder) {
  const auto model = stored_model(folder);
  if (!model) return model.error();
  ForceTraining training;
  training.creep_s = (*model)->creep_s;
  const auto value_of = [&](const char* key) {
    const auto found = (*model)->record.find(key);
    return found == (*model)->record.end() ? std::string() : found->second;
  };
  const auto split = std::find(kForceSplits.begin(), kForceSplits.end(), value_of(kForceSplit));
  if (split != kForceSplits.end())
    training.split = static_cast<ForceSplit>(split - kForceSplits.begin() + 1);
  const auto kind = std::find(kForceKinds.begin(), kForceKinds.end(), value_of(kRequestedKind));
  if (kind != kForceKinds.end())
    training.kind = static_cast<ForceKind>(kind - kForceKinds.begin() + 1);
  return training;
}

Result<ForceTable> stored_force_table(const fs::path& folder) {
  const auto model = stored_model(folder);
  if (!model) return model.error();
  const auto& record = (*model)->record;
  const auto table = record.find(kForceTable);
  if (table == record.end() || fs::path(table->second).parent_path() != fs::path(kForceFolder))
    return Error{en::say("the force model does not name its table"), folder,
                 en::say("giving the table to train with")};
  return ForceTable::load(folder / table->second);
}

}  // namespace alltact
