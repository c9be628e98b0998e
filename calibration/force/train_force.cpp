#include "calibration/force/train_force.h"

#include "calibration/force/held_out_force.h"
#include "core/force/force_meter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr std::array kForceOrder{
    ForceKind::kMean, ForceKind::kRidge, ForceKind::kQuadratic, ForceKind::kNetwork};

Error stopped_training() {
  return {en::say("stopped before there was a force model"), "", ""};
}

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

ForceComparison compared(ForceKind kind,
                         const HeldOutForce& held_out,
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
Eigen::VectorXd errors_by_fold(const HeldOutForce& held_out,
                               const Eigen::MatrixXd& force_N,
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
                  en::say("training {} without one block after the other", kind_word(kind)));
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
          compared(kind,
                   hold_out_force(inputs_, table_.force_N, *random, kind, single, job_),
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
                  relative(ForceKind::kNetwork),
                  relative(ForceKind::kRidge)));
    if (selected != ForceKind::kMean &&
        !beats(by_fold_[at(selected)], by_fold_[at(ForceKind::kMean)]))
      remarks.push_back(
          en::say("What is kept does not beat the mean of the table: these markers do not tell the "
                  "force."));
    else if (selected == ForceKind::kMean)
      remarks.push_back(
          en::say("Nothing beats the mean of the table: these markers do not tell the force."));
    if (folds_.by_time)
      remarks.push_back(
          en::say("The table has no column 'block': {} stretches of rows that follow each other "
                  "were held out.",
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
    input.displacement_px = Eigen::VectorXd::Zero(2 * table.marker_count);
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
                                 const ForceTraining& options,
                                 const Job& job) {
  assert(rest_px.empty() || static_cast<int>(rest_px.size()) == table.marker_count);
  return ForceTrainer(table, options, job).train(rest_px);
}

}  // namespace alltact
