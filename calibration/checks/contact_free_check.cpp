#include "calibration/checks/contact_free_check.h"

#include "calibration/finger/measuring_presets.h"
#include "calibration/reference/contact_search.h"
#include "core/open/open_source.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kWorst = 0.95;  // fraction of the face with less false depth

/// The absolute depth that the worst twentieth of the face's patches exceeds.
double worst_patch_mm(const DepthMap& depth) {
  std::vector<float> patches;
  for (int row = 0; row < depth.cells_mm.rows; ++row)
    for (int column = 0; column < depth.cells_mm.cols; ++column) {
      const cv::Point middle(column * kDepthCellPx + kDepthCellPx / 2,
                             row * kDepthCellPx + kDepthCellPx / 2);
      if (middle.x >= depth.flags.cols || middle.y >= depth.flags.rows) continue;
      if (depth.flags.at<std::uint8_t>(middle) == kMeasured)
        patches.push_back(std::abs(depth.cells_mm.at<float>(row, column)));
    }
  if (patches.empty()) return 0;
  const auto at = patches.begin() +
                  static_cast<std::ptrdiff_t>(kWorst * (static_cast<double>(patches.size()) - 1.0));
  std::nth_element(patches.begin(), at, patches.end());
  return static_cast<double>(*at);
}

Message sentence_of(const ContactFreeCheck& check) {
  const Message how = check.light_change < 0 ? en::say("darker") : en::say("brighter");
  const Message figures = en::say(
      "the face is {:.1f} % {} than in its reference; false depth {:.3f} mm in its worst 5 % "
      "({:.3f} mm without light correction; up to {:.3f} mm is noise)",
      100.0 * std::abs(check.light_change), how, check.false_depth_mm, check.uncorrected_mm,
      check.limit_mm);
  switch (check.verdict) {
    case CheckVerdict::kPass:
      return en::at(en::say("pass"), figures);
    case CheckVerdict::kDrifting:
      return en::clauses({en::at(en::say("drifting"), figures),
                          en::say("let the lamps warm up, check exposure and gain, and record the "
                                  "reference again if it persists")});
    case CheckVerdict::kTooFew:
      return en::clauses({en::at(en::say("too few to judge"), figures),
                          en::say("a check needs {} images, {} could be measured", kCheckPresses,
                                  check.image_count)});
    case CheckVerdict::kRecalibrate:
      break;
  }
  return en::at(en::say("record the reference again"), figures);
}

}  // namespace

Result<ContactFreeCheck> check_contact_free(const FingerSnapshot& snapshot,
                                            const std::vector<std::filesystem::path>& images,
                                            const Job& job) {
  const std::filesystem::path& folder = snapshot.folder;
  if (!snapshot.mapping)
    return Error{en::say("the finger is not calibrated yet"), folder.string(),
                 en::say("calibrate with ball presses")};
  const Mapping& mapping = *snapshot.mapping;
  const PipelineSettings settings = measuring_settings(folder);
  auto pipeline = Pipeline::create(snapshot, settings, Job(job, 0.0, 0.6));
  if (!pipeline) return pipeline.error();
  auto source = open_source(images);
  if (!source) return source.error();
  ContactFreeCheck check;
  double noise_mm = 0;
  for (;;) {
    if (job.stop_requested()) return Error{en::say("stopped before the check was done"), "", ""};
    const auto frame = (*source)->next();
    if (!frame) return frame.error();
    if (!*frame) break;
    if (!(*source)->is_continuous()) pipeline->forget();
    const auto result = (*pipeline)(*frame);
    if (!result) return result.error();
    if (!result->depth || !result->reference->known_pose || result->reference->by_shape) {
      check.left_out.push_back(en::say("{}: {}", (*frame)->name,
                                       result->problems.empty()
                                           ? en::say("nothing could be measured")
                                           : result->problems.front()));
      continue;
    }
    DifferenceOptions as_it_is;
    as_it_is.smoothing = smoothing_of(settings.smoothing_px);
    as_it_is.noise_sd = result->edges ? result->edges->noise_sd : as_it_is.noise_sd;
    const DepthMap uncorrected =
        depth_map(result->grey, *result->reference, *result->shape, as_it_is, mapping);
    DifferenceOptions corrected = as_it_is;
    corrected.correct_light = true;
    auto suspect = find_reference_suspect(
        difference(result->grey, *result->reference, *result->shape, corrected), *result->shape);
    if (suspect && (!check.suspect || suspect->brighter > check.suspect->brighter)) {
      suspect->frame = result->reference->frame;
      check.suspect = suspect;
    }
    ++check.image_count;
    check.light_change += result->depth->light.change();
    check.false_depth_mm += worst_patch_mm(*result->depth);
    check.uncorrected_mm += worst_patch_mm(uncorrected);
    noise_mm += result->depth->noise_mm;
  }
  if (check.image_count == 0) {
    const Message none = en::say("none of the images can be compared with the reference");
    return Error{check.left_out.empty() ? none : en::say("{} ({})", none, check.left_out.front()),
                 folder, en::say("images of the untouched finger in recorded poses")};
  }
  for (double* mean :
       {&check.light_change, &check.false_depth_mm, &check.uncorrected_mm, &noise_mm})
    *mean /= check.image_count;
  check.limit_mm = std::max(kMinErrorMm, 3.0 * noise_mm);
  check.verdict = check_verdict({.count = check.image_count,
                                 .positions = check.image_count,
                                 .error = check.false_depth_mm,
                                 .drifting_above = check.limit_mm,
                                 .recalibrate_above = check.limit_mm,
                                 .light_change = std::abs(check.light_change),
                                 .light_drifting_above = kLightLimit,
                                 .light_recalibrate_above = kLightOff,
                                 .reference_has_contact = check.suspect.has_value()});
  check.sentence = sentence_of(check);
  if (check.suspect) check.sentence = en::clauses({check.sentence, sentence_of(*check.suspect)});
  return check;
}

}  // namespace alltact
