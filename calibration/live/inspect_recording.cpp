#include "calibration/live/inspect_recording.h"

#include "calibration/finger/measuring_presets.h"
#include "core/base/table.h"
#include "core/batch/batch.h"
#include "core/finger/finger_store.h"
#include "core/open/open_source.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace alltact {

Result<InspectionLog> inspect_recording(const InspectionOrder& order, const Job& job) {
  const auto finger = open_finger(order.finger);
  if (!finger) return finger.error();
  if (!(*finger)->mapping)
    return Error{en::say("the finger is not calibrated yet"), order.finger,
                 en::say("alltact calibrate with ball presses")};
  SourceOptions how;
  how.pace = Pace::kOnDemand;
  how.job = &job;
  auto source = open_source(order.inputs, how);
  if (!source) return source.error();
  const PipelineSettings settings = measuring_settings(order.finger);
  auto pipelines = batch_pipelines(batch_threads(order.threads),
                                   [&] { return Pipeline::create(**finger, settings, job); });
  if (!pipelines) return pipelines.error();
  return inspect(**source, *pipelines, *(*finger)->mapping, order.recipe, job);
}

namespace {

/// The input, or the videos in it.
std::vector<std::filesystem::path> recordings_of(const std::filesystem::path& input) {
  std::vector<std::filesystem::path> videos;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(input, ignored))
    if (entry.is_regular_file(ignored) && is_video(entry.path())) videos.push_back(entry.path());
  if (videos.empty()) return {input};
  std::sort(videos.begin(), videos.end());
  return videos;
}

std::string figure(const std::optional<double>& value) {
  return value ? fmt::format("{:.9g}", *value) : std::string();
}

}  // namespace

Result<std::vector<InspectedRecording>> inspect_recordings(const InspectionOrder& order,
                                                           const Job& job) {
  std::vector<std::filesystem::path> recordings;
  for (const auto& input : order.inputs)
    for (auto& recording : recordings_of(input)) recordings.push_back(std::move(recording));
  if (recordings.empty()) return Error{en::say("there is no recording"), "", ""};
  std::vector<InspectedRecording> inspected;
  const auto count = static_cast<double>(recordings.size());
  for (const auto& recording : recordings) {
    const auto before = static_cast<double>(inspected.size());
    InspectionOrder one = order;
    one.inputs = {recording};
    auto log = inspect_recording(one, Job(job, before / count, (before + 1) / count));
    if (job.stop_requested())
      return Error{en::say("stopped before all recordings were inspected"), recording, ""};
    inspected.push_back({recording, {}, {}});
    if (log)
      inspected.back().log = std::move(*log);
    else
      inspected.back().problem = log.error().message();
  }
  return inspected;
}

std::string csv_of(const std::vector<InspectedRecording>& recordings) {
  std::string csv =
      "recording,reading,what,unit,frames,measured,mean,sd,min,max,trend,trend_sd,trend_per,"
      "passed,failed,undecided,problem\n";
  for (const InspectedRecording& one : recordings) {
    const std::string name = table_cell(one.recording.filename().string());
    if (!one.log) {
      csv += fmt::format("{},,,,,,,,,,,,,,,,{}\n", name, table_cell(one.problem.english()));
      continue;
    }
    const auto summaries = one.log->summaries();
    for (std::size_t i = 0; i < summaries.size(); ++i) {
      const RecipeReading& of = one.log->recipe.readings[i];
      const ReadingSummary& all = summaries[i];
      const std::string trend =
          all.trend ? fmt::format("{:.9g},{:.9g},{}", all.trend->value, all.trend->sd,
                                  all.is_trend_per_second ? "s" : "frame")
                    : std::string(",,");
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},\n", name, table_cell(of.name),
                         to_string(of.what), unit_of(of.what), one.log->rows.size(), all.measured,
                         figure(all.mean), figure(all.sd), figure(all.min), figure(all.max), trend,
                         all.passed, all.failed, all.undecided);
    }
  }
  return csv;
}

}  // namespace alltact
