#include "calibration/study/study_presets.h"

#include "core/program.h"
#include "core/utc_time.h"

#include <fmt/format.h>

namespace alltact {

MeasuringPresets presets_to_save(const AccuracyStudy& study, const std::string& machine) {
  MeasuringPresets saved;
  saved.date = utc_now();
  saved.program_version = program_version();
  saved.machine = machine;
  saved.about = fmt::format("{}, {} pictures", study.about.english(), study.rows.front().frames);
  saved.calibrated = saved.now = study.rows.front().settings;
  const StudyPresets found = presets_of(study);
  const auto add = [&](const char* name, std::optional<std::size_t> number) {
    if (!number) return;
    const StudyRow& row = study.rows[*number];
    if (!row.depth) return;
    saved.presets.push_back(
        {name, row.settings, frame_ms(study, row), row.depth->median_mm, row.depth->p95_mm});
  };
  add("fast", found.fast);
  add("balanced", found.balanced);
  add("finest", found.finest);
  return saved;
}

}  // namespace alltact
