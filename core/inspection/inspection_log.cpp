#include "core/inspection/inspection_log.h"

#include "core/base/message.h"
#include "core/base/table.h"
#include "core/batch/batch.h"
#include "core/sensing/depth/depth_sd.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include <fmt/format.h>

namespace alltact {
namespace {

std::vector<InspectedReading> not_measured(const InspectionRecipe& recipe, const Message& reason) {
  InspectedReading reading;
  reading.reading.reason = reason;
  return std::vector<InspectedReading>(recipe.readings.size(), reading);
}

std::vector<InspectedReading> readings_of(const BatchFrame& frame, const Pipeline& pipeline,
                                          const Mapping& mapping, const InspectionRecipe& recipe) {
  if (!frame.result)
    return not_measured(recipe, frame.problem ? frame.problem->message() : Message());
  const FrameResult& result = *frame.result;
  cv::Mat sd_mm;
  if (result.depth && result.shape && result.reference)
    sd_mm = depth_sd_and_limits(*result.depth, *result.reference, *result.shape, mapping).sd_mm;
  return inspect_frame(
      {result, pipeline.finger().face, mapping, pipeline.settings().smoothing_px, sd_mm}, recipe);
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.9g}", *value) : std::string();
}

/// Slope of the straight line of least squares through (x, y), with its standard deviation.
std::optional<MeasuredValue> slope(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 3) return std::nullopt;
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (!(xx > 0)) return std::nullopt;
  const double slope = xy / xx;
  for (std::size_t i = 0; i < x.size(); ++i)
    squares += std::pow(y[i] - mean_y - slope * (x[i] - mean_x), 2);
  return MeasuredValue{slope, std::sqrt(squares / (n - 2) / xx)};
}

void add_figures(const std::vector<double>& values, ReadingSummary& summary) {
  if (values.empty()) return;
  const auto n = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / n;
  for (const double value : values) squares += (value - mean) * (value - mean);
  summary.mean = mean;
  if (values.size() > 1) summary.sd = std::sqrt(squares / (n - 1));
  summary.min = *std::min_element(values.begin(), values.end());
  summary.max = *std::max_element(values.begin(), values.end());
}

ReadingSummary summary_of(const std::vector<InspectedRow>& rows, std::size_t reading) {
  ReadingSummary summary;
  std::vector<double> values, times, indices;
  for (const InspectedRow& row : rows) {
    const InspectedReading& one = row.readings[reading];
    summary.measured += one.reading.measured ? 1 : 0;
    summary.passed += one.conformity == Conformity::kPass ? 1 : 0;
    summary.failed += one.conformity == Conformity::kFail ? 1 : 0;
    summary.undecided += one.conformity == Conformity::kUndecided ? 1 : 0;
    if (!one.reading.measured || one.reading.is_lower_bound) continue;
    values.push_back(one.reading.measured->value);
    indices.push_back(static_cast<double>(row.index));
    if (row.time_s) times.push_back(*row.time_s);
  }
  add_figures(values, summary);
  summary.is_trend_per_second = !values.empty() && times.size() == values.size();
  summary.trend = slope(summary.is_trend_per_second ? times : indices, values);
  return summary;
}

}  // namespace

std::string InspectionLog::to_csv() const {
  std::string csv = "index,frame,time_s,reading,what,value,sd,unit,lower,upper,decision,remark\n";
  for (const InspectedRow& row : rows)
    for (std::size_t i = 0; i < recipe.readings.size(); ++i) {
      const RecipeReading& of = recipe.readings[i];
      const auto& [reading, decision] = row.readings[i];
      std::optional<double> value, sd;
      if (reading.measured) value = reading.measured->value;
      if (value && reading.measured->sd > 0 && std::isfinite(reading.measured->sd))
        sd = reading.measured->sd;
      const std::string remark =
          reading.is_lower_bound ? "at least: the layer ends here" : reading.reason.english();
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", row.index, table_cell(row.frame),
                         number(row.time_s), table_cell(of.name), to_string(of.what), number(value),
                         number(sd), unit_of(of.what), number(of.lower), number(of.upper),
                         to_string(decision), table_cell(remark));
    }
  return csv;
}

std::vector<ReadingSummary> InspectionLog::summaries() const {
  std::vector<ReadingSummary> all;
  for (std::size_t i = 0; i < recipe.readings.size(); ++i) all.push_back(summary_of(rows, i));
  return all;
}

Conformity InspectionLog::verdict() const {
  bool has_tolerance = false, is_undecided = false, is_missing = false;
  for (const InspectedRow& row : rows)
    for (std::size_t i = 0; i < row.readings.size(); ++i) {
      const RecipeReading& of = recipe.readings[i];
      if (!of.lower && !of.upper) continue;
      has_tolerance = true;
      const Conformity one = row.readings[i].conformity;
      if (one == Conformity::kFail) return one;
      is_undecided = is_undecided || one == Conformity::kUndecided;
      is_missing = is_missing || one == Conformity::kNotMeasured;
    }
  if (!has_tolerance) return Conformity::kNoTolerance;
  if (is_missing) return Conformity::kNotMeasured;
  return is_undecided ? Conformity::kUndecided : Conformity::kPass;
}

std::vector<InspectedReading> inspect_frame(const MeasuredFace& face,
                                            const InspectionRecipe& recipe) {
  const FrameResult& result = face.result;
  if (!result.depth)
    return not_measured(recipe, result.problems.empty() ? Message() : result.problems.front());
  std::vector<InspectedReading> readings;
  for (const RecipeReading& of : recipe.readings) {
    InspectedReading inspected;
    const auto a = pixel_of(result, of.a), b = pixel_of(result, of.b);
    if (a && b)
      inspected.reading = FaceReader(face, *a, *b, of.filter)(of.what);
    else
      inspected.reading.reason = en::say("the frame does not show both positions");
    inspected.conformity = conformity(inspected.reading, of);
    readings.push_back(std::move(inspected));
  }
  return readings;
}

Result<InspectionLog> inspect(Source& source, std::vector<Pipeline>& pipelines,
                              const Mapping& mapping, const InspectionRecipe& recipe,
                              const Job& job) {
  InspectionLog log{recipe, {}, {}};
  std::mutex lock;
  const auto count = static_cast<double>(source.count().value_or(0));
  std::size_t taken = 0;
  BatchWork work;
  work.write = [&](BatchFrame& frame, const Pipeline& pipeline) -> Result<FrameLine> {
    InspectedRow row{frame.index, {}, {}, readings_of(frame, pipeline, mapping, recipe)};
    if (frame.frame) {
      row.frame = frame.frame->name;
      row.time_s = time_s(*frame.frame);
    }
    FrameLine line;
    line.frame = row.frame;
    const std::lock_guard hold(lock);
    log.rows.push_back(std::move(row));
    return line;
  };
  work.take = [&](std::size_t index, FrameLine&& line) -> Status {
    taken = index + 1;
    if (count > 0)
      job.report(static_cast<double>(taken) / count,
                 en::say("{} of {:.0f}: {}", taken, count, line.frame));
    return {};
  };
  const Status measured = measure_batch(source, pipelines, {}, work, job);
  if (!measured) return measured.error();
  if (job.stop_requested()) return Error{en::say("stopped before all frames were done"), "", ""};
  if (log.rows.empty())
    return Error{en::say("the recording has no frames"), "", en::say("another recording")};
  log.remarks = source.remarks();
  std::sort(log.rows.begin(), log.rows.end(),
            [](const InspectedRow& x, const InspectedRow& y) { return x.index < y.index; });
  return log;
}

}  // namespace alltact
