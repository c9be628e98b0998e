#include "calibration/lens/measure_lens.h"

#include "calibration/lens/lens_views.h"
#include "core/io/message_json.h"
#include "core/program.h"
#include "core/sources/open/open_source.h"
#include "core/utc_time.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {

Result<LensCalibration> measure_lens(const std::vector<std::filesystem::path>& inputs,
                                     const Board& board,
                                     const LensSettings& settings,
                                     const Job& job) {
  SourceOptions how;
  how.job = &job;
  const auto source = open_source(inputs, how);
  if (!source) return source.error();
  const auto found = find_boards(**source, board, Orientation::kNone, job);
  if (!found) return found.error();
  return calibrate_lens(found->views, found->size, settings, job);
}

LensRecord lens_record(const Board& board, const LensCalibration& done) {
  LensRecord record;
  record["date"] = utc_now();
  record["program_version"] = program_version();
  record["board"] = board.words().english();
  record["square_mm"] = fmt::format("{}", board.square_mm);
  record["views"] = fmt::format("{}", done.used.size());
  record["fx_sd_px"] = fmt::format("{:.4f}", done.fit.sd(0));
  record["fy_sd_px"] = fmt::format("{:.4f}", done.fit.sd(1));
  record["focal_sd_percent"] = fmt::format("{:.4f}", 100 * done.focal_sd_part);
  record["corner_px"] = fmt::format("{:.4f}", done.fit.sigma_px);
  if (done.held_out) record["held_out_px"] = fmt::format("{:.4f}", done.held_out->error_px);
  record["verdict"] = done.verdict.sentence.english();
  record["verdict_message"] = message_json(done.verdict.sentence).dump();
  return record;
}

}  // namespace alltact
