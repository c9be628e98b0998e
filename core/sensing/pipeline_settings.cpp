#include "core/sensing/pipeline_settings.h"

namespace alltact {
namespace {

using S = PipelineSettings;

std::vector<Setting<S>> settings_of_edges() {
  return {
      trading(choice_setting<S, EdgeMethod>(
                  "edge-method",
                  en::say("how the face's edges are placed: half-way crossing to a fiftieth of "
                          "a pixel, or the steepest whole pixel"),
                  &S::edge_method,
                  {{"crossing", EdgeMethod::kCrossing}, {"integer", EdgeMethod::kInteger}}),
              {en::say("'crossing' tells the finger's bend, and with it where a press lies, "
                       "several times closer"),
               en::say("'crossing' takes a little longer"),
               {"integer", "crossing"}}),
      trading(number_setting<S>("edge-columns",
                                en::say("pixel columns averaged into one place on each edge"),
                                &S::edge_columns,
                                1,
                                32),
              {en::say("more hide the noise of dark pictures; beyond 16 a bent finger's edge "
                       "is no longer straight within them"),
               en::say("fewer make more places, each of which the curve has to be fitted to"),
               {"32", "16", "8", "4", "2"}}),
      trading(number_setting<S>("profile-degree",
                                en::say("degree of the smooth curve through each edge of the face"),
                                &S::profile_degree,
                                2,
                                12),
              {en::say("higher follows sharper bends; too high follows noise where the edge is "
                       "hidden"),
               en::say("higher makes the fit longer"),
               {"3", "5", "7", "9"}})};
}

std::vector<Setting<S>> settings_of_depth() {
  return {trading(choice_setting<S, ReferenceMethod>(
                      "reference-method",
                      en::say("which untouched picture a frame is compared with: the one of the "
                              "finger at rest, the "
                              "nearest recorded one, or one computed from the nearest several"),
                      &S::reference,
                      {{"single", ReferenceMethod::kSingle},
                       {"nearest", ReferenceMethod::kNearest},
                       {"local", ReferenceMethod::kLocal}}),
                  {en::say("'local' keeps depth of a bent finger right between the recorded poses; "
                           "'single' is right at rest alone"),
                   en::say("'local' adds up several pictures instead of one"),
                   {"single", "nearest", "local"}}),
          trading(choice_setting<S, LightChange>(
                      "light-change",
                      en::say("whether a change of the light since the reference is read from the "
                              "untouched skin and "
                              "taken out"),
                      &S::light,
                      {{"corrected", LightChange::kCorrected}, {"ignored", LightChange::kIgnored}}),
                  {en::say("'corrected' keeps depth right when the room or the lamp changes"),
                   en::say("'corrected' looks once over the untouched skin"),
                   {"ignored", "corrected"}}),
          trading(number_setting<S>(
                      "smoothing-px",
                      en::say("standard deviation of the smoothing before depth is read, in "
                              "pixels; 0: none"),
                      &S::smoothing_px,
                      0.0,
                      8.0),
                  {en::say("more quiets the depth of a smooth contact and rounds off edges and "
                           "threads"),
                   en::say("more takes longer, none the least"),
                   {"0", "1", "2", "4"}}),
          number_setting<S>("contact-threshold-mm",
                            en::say("depth that counts as touched, in millimetres"),
                            &S::contact_threshold_mm,
                            0.01,
                            5.0)};
}

}  // namespace

const std::vector<Setting<PipelineSettings>>& pipeline_settings() {
  static const std::vector<Setting<S>> settings = [] {
    std::vector<Setting<S>> all = settings_of_edges();
    for (Setting<S>& setting : settings_of_depth()) all.push_back(std::move(setting));
    return all;
  }();
  return settings;
}

PipelineSettings paper_settings() {
  PipelineSettings settings;
  settings.edge_method = EdgeMethod::kInteger;
  settings.edge_columns = 1;
  settings.reference = ReferenceMethod::kNearest;
  settings.light = LightChange::kIgnored;
  settings.smoothing_px = 0.0;
  return settings;
}

}  // namespace alltact
