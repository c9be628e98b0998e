#include "calibration/checks/gage_study.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Core>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>

namespace alltact {
namespace {

constexpr double kPooledAbove = 0.05;   // of the interaction's p
constexpr double kMostSquares = 1e100;  // their squares are finite as well
constexpr double kTail = 0.025;         // on each side of an interval of 95 %

/// Values of each part and operator, in the order of the readings.
struct Crossed {
  std::vector<std::string> parts, operators;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> cells;
};

std::size_t index_of(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  const auto index = static_cast<std::size_t>(found - names.begin());
  if (found == names.end()) names.push_back(name);
  return index;
}

Crossed crossed(const std::vector<GageReading>& readings) {
  Crossed all;
  for (const GageReading& reading : readings) {
    const std::size_t part = index_of(all.parts, reading.part);
    all.cells[{part, index_of(all.operators, reading.operator_name)}].push_back(reading.value);
  }
  return all;
}

/// "finger 2 by Ann"
Message cell_name(const Crossed& all, std::size_t part, std::size_t person) {
  return en::say("{} by {}", all.parts[part], all.operators[person]);
}

Status check(const Crossed& all) {
  const Message advice = en::say("each operator measures each part two times or more");
  if (all.parts.size() < 2 && all.operators.size() < 2)
    return Error{en::say("a gage study needs two parts or two operators"), "", advice};
  std::size_t repeats = 0;
  for (std::size_t part = 0; part < all.parts.size(); ++part)
    for (std::size_t person = 0; person < all.operators.size(); ++person) {
      const auto found = all.cells.find({part, person});
      const Message cell = cell_name(all, part, person);
      if (found == all.cells.end())
        return Error{en::say("there is no reading of {}", cell), "", advice};
      const std::size_t count = found->second.size();
      if (count < 2) return Error{en::say("there is only one reading of {}", cell), "", advice};
      if (repeats != 0 && count != repeats) {
        const Message first = cell_name(all, 0, 0);
        return Error{
            en::say("there are {} readings of {}, but {} of {}", count, cell, repeats, first), "",
            en::say("the same number of readings of each part by each operator")};
      }
      repeats = count;
    }
  return {};
}

AnovaRow row(double ss, double df) {
  AnovaRow row;
  row.ss = ss;
  row.df = static_cast<int>(df);
  row.ms = df > 0 ? ss / df : 0;
  return row;
}

/// Compares with the mean square that remains where the row has no effect.
void compare(AnovaRow& row, const AnovaRow& with) {
  if (row.df < 1 || with.df < 1 || !(with.ms > 0)) return;
  row.f = row.ms / with.ms;
  row.p = boost::math::cdf(boost::math::complement(boost::math::fisher_f(row.df, with.df), *row.f));
}

/// A sum of mean squares, each with its factor > 0.
using Sum = std::vector<std::pair<double, const AnovaRow*>>;

SdInterval interval_of(const Sum& sum) {
  double variance = 0, below = 0, above = 0;
  for (const auto& [factor, row] : sum) {
    if (row->df < 1) continue;
    const boost::math::chi_squared chi2(row->df);
    const double term = factor * row->ms;
    const double low = 1 - row->df / boost::math::quantile(boost::math::complement(chi2, kTail));
    const double high = row->df / boost::math::quantile(chi2, kTail) - 1;
    variance += term;
    below += low * low * term * term;
    above += high * high * term * term;
  }
  return {std::sqrt(std::max(0.0, variance - std::sqrt(below))),
          std::sqrt(variance + std::sqrt(above))};
}

void add_anova(const Crossed& all, GageStudy& study) {
  const auto p = static_cast<Eigen::Index>(all.parts.size());
  const auto o = static_cast<Eigen::Index>(all.operators.size());
  const double r = study.repeats;
  // Of differences to the first value: a large mean costs no digits.
  const double origin = all.cells.begin()->second.front();
  Eigen::MatrixXd means(p, o);
  double within = 0;
  for (const auto& [cell, values] : all.cells) {
    double mean = 0;
    for (const double value : values) mean += (value - origin) / r;
    for (const double value : values) within += std::pow(value - origin - mean, 2);
    means(static_cast<Eigen::Index>(cell.first), static_cast<Eigen::Index>(cell.second)) = mean;
  }
  const double mean = means.mean();
  study.mean = origin + mean;
  const Eigen::VectorXd part_means = means.rowwise().mean().array() - mean;
  const Eigen::RowVectorXd operator_means = means.colwise().mean().array() - mean;
  const Eigen::MatrixXd rest =
      ((means.array() - mean).matrix().colwise() - part_means).rowwise() - operator_means;
  const auto parts = static_cast<double>(p), operators = static_cast<double>(o);
  study.by_part = row(operators * r * part_means.squaredNorm(), parts - 1);
  study.by_operator = row(parts * r * operator_means.squaredNorm(), operators - 1);
  study.interaction = row(r * rest.squaredNorm(), (parts - 1) * (operators - 1));
  study.repetition = row(within, parts * operators * (r - 1));
  study.total = row(study.by_part.ss + study.by_operator.ss + study.interaction.ss + within,
                    parts * operators * r - 1);
}

}  // namespace

double GageStudy::percent(double sd) const { return total_sd > 0 ? 100 * sd / total_sd : 0; }

double GageStudy::percent_of(double tolerance, double sd) { return 100 * 6 * sd / tolerance; }

Result<GageStudy> gage_study(const std::vector<GageReading>& readings) {
  for (const GageReading& reading : readings)
    if (!std::isfinite(reading.value))
      return Error{en::say("a reading of {} is no number", reading.part), "",
                   en::say("leaving it out")};
  const Crossed all = crossed(readings);
  if (const Status complete = check(all); !complete) return complete.error();
  GageStudy study;
  study.parts = all.parts;
  study.operators = all.operators;
  study.repeats = static_cast<int>(all.cells.begin()->second.size());
  add_anova(all, study);
  if (!(study.total.ss < kMostSquares))
    return Error{en::say("the readings differ too much to be squared"), "",
                 en::say("readings of one unit")};

  compare(study.interaction, study.repetition);
  study.is_pooled =
      study.interaction.df > 0 && (!study.interaction.p || *study.interaction.p > kPooledAbove);
  AnovaRow rest = study.repetition;
  if (study.is_pooled)
    rest =
        row(study.repetition.ss + study.interaction.ss, study.repetition.df + study.interaction.df);
  const bool has_interaction = study.interaction.df > 0 && !study.is_pooled;
  const AnovaRow& expected = has_interaction ? study.interaction : rest;
  compare(study.by_part, expected);
  compare(study.by_operator, expected);

  const auto p = static_cast<double>(all.parts.size()), r = static_cast<double>(study.repeats);
  const auto o = static_cast<double>(all.operators.size());
  const auto excess = [](const AnovaRow& row, const AnovaRow& above, double count) {
    return row.df > 0 ? std::max(0.0, (row.ms - above.ms) / count) : 0.0;
  };
  const double by_operator = excess(study.by_operator, expected, p * r);
  const double by_interaction = has_interaction ? excess(study.interaction, rest, r) : 0;
  const double by_part = excess(study.by_part, expected, o * r);
  study.repeatability = std::sqrt(rest.ms);
  study.operators_sd = std::sqrt(by_operator);
  study.interaction_sd = std::sqrt(by_interaction);
  study.reproducibility = std::sqrt(by_operator + by_interaction);
  study.gage = std::sqrt(rest.ms + by_operator + by_interaction);
  study.parts_sd = std::sqrt(by_part);
  study.total_sd = std::sqrt(rest.ms + by_operator + by_interaction + by_part);
  study.repeatability_95 = interval_of({{1, &rest}});
  Sum sum;
  if (has_interaction)
    sum = {{1 / (p * r), &study.by_operator},
           {(p - 1) / (p * r), &study.interaction},
           {(r - 1) / r, &rest}};
  else if (study.by_operator.df > 0)
    sum = {{1 / (p * r), &study.by_operator}, {1 - 1 / (p * r), &rest}};
  else
    sum = {{1, &rest}};
  study.gage_95 = interval_of(sum);
  study.gage_95.high = std::max(study.gage_95.high, study.gage);  // where a variance was negative
  if (study.gage > 0)
    study.categories =
        static_cast<int>(std::min(1e6, std::sqrt(2.0) * study.parts_sd / study.gage));
  return study;
}

std::vector<GageReading> balanced(const std::vector<GageReading>& readings, std::size_t& left_out) {
  const Crossed all = crossed(readings);
  std::size_t each = readings.size();
  for (std::size_t part = 0; part < all.parts.size(); ++part)
    for (std::size_t person = 0; person < all.operators.size(); ++person) {
      const auto found = all.cells.find({part, person});
      if (found != all.cells.end()) each = std::min(each, found->second.size());
    }
  std::vector<GageReading> last;
  std::map<std::pair<std::string, std::string>, std::size_t> taken;
  for (auto reading = readings.rbegin(); reading != readings.rend(); ++reading)
    if (++taken[{reading->part, reading->operator_name}] <= each) last.push_back(*reading);
  std::reverse(last.begin(), last.end());
  left_out = readings.size() - last.size();
  return last;
}

Message gage_sentence(const GageStudy& study, double tolerance_mm) {
  const Message gage = en::say(
      "Gage R&R: standard deviation {:.4f} mm (95 %: {:.4f} to {:.4f}), {:.1f} % of the "
      "variation",
      study.gage, study.gage_95.low, study.gage_95.high, study.percent(study.gage));
  if (!(tolerance_mm > 0)) return en::say("{}.", gage);
  return en::say("{}, {:.1f} % of the tolerance.", gage,
                 GageStudy::percent_of(tolerance_mm, study.gage));
}

}  // namespace alltact
