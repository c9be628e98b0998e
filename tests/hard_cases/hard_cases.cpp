#include "tests/hard_cases/hard_cases.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr double kAbsurd = 1e100;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// values - truth| / scale; infinite where they cannot be compared.
double error_of(const HardQuestion& question, const std::vector<double>& values) {
  if (values.size() != question.truth.size()) return kInfinite;
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    sum += std::pow((values[i] - question.truth[i]) / question.scale, 2);
  return std::isfinite(sum) ? std::sqrt(sum) : kInfinite;
}

/// Contribution of each answer by the row's measure: its error, signed or squared where needed.
double worth_of(HardMeasure measure, const HardQuestion& question, const HardAnswer& answer) {
  const bool is_pair = measure == HardMeasure::kSdAccuracy;
  if (answer.values.size() != (is_pair ? 2 : question.truth.size())) return kInfinite;
  const double off = answer.values[0] - question.truth[0];
  switch (measure) {
    case HardMeasure::kBias:
    case HardMeasure::kBiasInSd:
      return off / question.scale;
    case HardMeasure::kSdAccuracy:
      if (!(answer.values[1] > 0 && std::abs(off) <= question.scale)) return kInfinite;
      return std::pow(off / answer.values[1], 2);
    default:
      return error_of(question, answer.values);
  }
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double sd_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / (static_cast<double>(values.size()) - 1));
}

double rms_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// One figure from the contributions of all valid numbers.
double figure_of(HardMeasure measure, const std::vector<double>& worth) {
  switch (measure) {
    case HardMeasure::kWorst:
    case HardMeasure::kWrong:
      return *std::max_element(worth.begin(), worth.end());
    case HardMeasure::kRms:
      return rms_of(worth);
    case HardMeasure::kBias:
      return std::abs(mean_of(worth));
    case HardMeasure::kBiasInSd:
      return std::abs(mean_of(worth)) / sd_of(worth);
    case HardMeasure::kSpread:
      return std::abs(rms_of(worth) - 1);
    case HardMeasure::kSdAccuracy:
      return std::abs(mean_of(worth) - 1);
  }
  return kInfinite;
}

bool is_due(const HardQuestion& question, const HardAnswer& answer) {
  return answer.values.empty() && question.due != HardRefusal::kOther &&
         answer.refusal == question.due;
}

}  // namespace

void HardRow::ask(HardQuestion question, HardAnswer naive_answer, HardAnswer own_answer) {
  questions.push_back(std::move(question));
  naive_answers.push_back(std::move(naive_answer));
  own_answers.push_back(std::move(own_answer));
}

HardScore score(const HardRow& row, const std::vector<HardAnswer>& answers) {
  assert(answers.size() == row.questions.size());
  std::vector<double> worth;
  std::size_t with_number = 0, answered = 0, wrong = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const HardQuestion& question = row.questions[i];
    if (question.truth.empty()) {
      wrong += !is_due(question, answers[i]);
      continue;
    }
    ++with_number;
    if (answers[i].values.empty()) continue;
    ++answered;
    worth.push_back(worth_of(row.measure, question, answers[i]));
    // Absurd values must not hide in an overflow.
    if (!(std::abs(worth.back()) < kAbsurd)) worth.back() = kInfinite;
    wrong += row.measure == HardMeasure::kWrong && !(worth.back() <= 1);
  }
  HardScore result;
  if (with_number == 0) return {kInfinite, 0};
  result.answered = static_cast<double>(answered) / static_cast<double>(with_number);
  if (row.measure == HardMeasure::kWrong)
    result.error = static_cast<double>(wrong) / static_cast<double>(answers.size());
  else
    result.error = wrong > 0 || worth.empty() ? kInfinite : figure_of(row.measure, worth);
  const bool has_false_number =
      row.measure != HardMeasure::kWrong &&
      std::any_of(worth.begin(), worth.end(), [](double one) { return !std::isfinite(one); });
  if (has_false_number || !std::isfinite(result.error)) result.error = kInfinite;
  return result;
}

HardCase judged(const HardRow& row, const std::vector<HardAnswer>& own) {
  return {row.what,        row.naive, row.unit,        score(row, row.naive_answers),
          score(row, own), row.bound, row.min_answered};
}

HardAnswer refused(const Error& error) {
  switch (error.kind) {
    case ErrorKind::kFoldedLens:
      return refused(HardRefusal::kFoldedLens);
    case ErrorKind::kUncertainFace:
      return refused(HardRefusal::kNoDistance);
    case ErrorKind::kUndeterminedLens:
      return refused(HardRefusal::kUnprovenLens);
    default:
      return refused();
  }
}

FaceShape flat_sensor(const cv::Size& size, double mm_per_px) {
  CameraParameters p;
  p.model = CameraModel::kOrthographic;
  p.width_px = size.width, p.height_px = size.height;
  p.cx_px = 0.5 * (size.width - 1), p.cy_px = 0.5 * (size.height - 1);
  p.mm_per_px = mm_per_px;
  Face face;
  face.kind = FaceKind::kFlat;
  face.layer_mm = 1.5;
  face.plane_z_mm = 20.0;
  return FaceShape::plane(Camera::create(p).value(), face);
}

std::vector<HardRow> hard_rows() {
  std::vector<HardRow> all;
  for (const auto group : {hard_directions, hard_outlines, hard_faces, hard_curves, hard_lenses,
                           hard_brightness, hard_contacts})
    for (HardRow& row : group()) all.push_back(std::move(row));
  return all;
}

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (const HardRow& row : hard_rows()) all.push_back(judged(row, row.own_answers));
  return all;
}

}  // namespace alltact
