#include "core/sensing/pipeline_settings.h"

namespace alltact {

const std::vector<Setting<PipelineSettings>>& pipeline_settings() {
  using S = PipelineSettings;
  static const std::vector<Setting<S>> settings{
      choice_setting<S, EdgeMethod>(
          "edge-method",
          en::say(
              "how the face's edges are placed: half-way crossing to a fiftieth of a pixel, or the "
              "steepest whole pixel"),
          &S::edge_method,
          {{"crossing", EdgeMethod::kCrossing}, {"integer", EdgeMethod::kInteger}}),
      number_setting<S>("edge-columns",
                        en::say("pixel columns averaged into one place on each edge"),
                        &S::edge_columns,
                        1,
                        32),
      number_setting<S>("profile-degree",
                        en::say("degree of the smooth curve through each edge of the face"),
                        &S::profile_degree,
                        2,
                        12),
      choice_setting<S, ReferenceMethod>(
          "reference-method",
          en::say("which untouched picture a frame is compared with: the one of the finger at "
                  "rest, the "
                  "nearest recorded one, or one computed from the nearest several"),
          &S::reference,
          {{"single", ReferenceMethod::kSingle},
           {"nearest", ReferenceMethod::kNearest},
           {"local", ReferenceMethod::kLocal}}),
      choice_setting<S, LightChange>(
          "light-change",
          en::say("whether a change of the light since the reference is read from the untouched "
                  "skin and "
                  "taken out"),
          &S::light,
          {{"corrected", LightChange::kCorrected}, {"ignored", LightChange::kIgnored}}),
      number_setting<S>(
          "smoothing-px",
          en::say("standard deviation of the smoothing before depth is read, in pixels; 0: none"),
          &S::smoothing_px,
          0.0,
          8.0),
      number_setting<S>("contact-threshold-mm",
                        en::say("depth that counts as touched, in millimetres"),
                        &S::contact_threshold_mm,
                        0.01,
                        5.0),
  };
  return settings;
}

}  // namespace alltact
