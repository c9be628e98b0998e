#include "core/sensing/pipeline_settings.h"

#include "core/base/message.h"
#include "core/base/typed_number.h"
#include "core/finger/finger_store.h"
#include "core/sensing/face/face_shape.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace alltact {

#ifndef __clang__  // Clang cannot evaluate its std::string in a constant expression
static_assert(PipelineSettings{}.profile_degree == kDefaultProfileDegree);
#endif

namespace {

using S = PipelineSettings;

constexpr const char* kFullFace = "all";
constexpr double kMaxFace_mm = 1000;

bool has_edges(const Finger& finger) { return finger.face.kind == FaceKind::kFinRay; }

bool has_markers(const Finger& finger) {
  return has_edges(finger) && finger.markers.per_row > 0 &&
         !(finger.reference && finger.reference->positions);
}

bool has_distortion(const Finger& finger) {
  const std::vector<double>& terms = finger.camera.distortion;
  return finger.camera.model == CameraModel::kFisheye ||
         std::any_of(terms.begin(), terms.end(), [](double term) { return term != 0; });
}

bool maps_along_normal(const Finger& finger) {
  return finger.mapping && finger.mapping->along == MappingAlong::kNormal;
}

std::string region_text(const FaceRegion& region) {
  if (region == FaceRegion{}) return kFullFace;
  return fmt::format("{}-{}", region.from_mm, region.to_mm);
}

std::optional<FaceRegion> region_from(std::string_view text) {
  if (text == kFullFace) return FaceRegion{};
  FaceRegion region;
  const std::size_t dash = text.find('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const auto from = parse_typed_number(text.substr(0, dash), {DecimalMark::kPoint, "mm"});
  const auto to = parse_typed_number(text.substr(dash + 1), {DecimalMark::kPoint, "mm"});
  if (!from || !to) return std::nullopt;
  region.from_mm = *from;
  region.to_mm = *to;
  const bool is_part =
      region.from_mm >= 0 && region.to_mm > region.from_mm && region.to_mm <= kMaxFace_mm;
  return is_part ? std::optional(region) : std::nullopt;
}

Setting<S> region_setting() {
  Setting<S> setting{"region",
                     en::say("the part of the face to measure depth on, in millimetres along it "
                             "from its base; all else counts as off the face"),
                     {},
                     {},
                     {}};
  setting.range.other = "all, or FROM-TO in mm such as 20-60";
  setting.get = [](const S& s) { return region_text(s.region); };
  setting.set = [](S& s, std::string_view text) -> Status {
    const auto region = region_from(text);
    if (!region)
      return Error{
          en::say("'{}' is not 'all' or a part of the face in mm such as 20-60", printable(text)),
          std::string("region"), ""};
    s.region = *region;
    return {};
  };
  setting.phrase = [](const S& s) {
    return s.region == FaceRegion{} ? en::say("depth on the full face")
                                    : en::say("depth from {:g} to {:g} mm along the face",
                                              s.region.from_mm, s.region.to_mm);
  };
  return setting;
}

std::vector<Setting<S>> image_settings() {
  return {
      with_trade_off(
          choice_setting<S, Resolution>(
              "resolution",
              en::say("pixels used to measure an image: all of them, or means of 2 by 2 or 4 by 4 "
                      "of them; results in pixels then refer to that image"),
              &S::resolution,
              {{"whole", Resolution::kFull, en::say("every pixel")},
               {"half", Resolution::kHalf, en::say("half the pixels per side")},
               {"quarter", Resolution::kQuarter, en::say("a quarter of the pixels per side")}}),
          {en::say("'whole' detects small contacts and steep edges, and numbers small dots"),
           en::say("'half' uses a quarter of the pixels and of the recording's memory, 'quarter' a "
                   "sixteenth"),
           {"quarter", "half", "whole"}}),
      with_trade_off(
          number_setting<S>(
              "average-frames",
              en::say("images of one source whose running mean is measured; 1: each by itself. A "
                      "moving finger then appears at its average position, and blurred"),
              &S::average_frames, 1, 64,
              [](int n) { return en::count("{} images averaged", "{} image averaged", n); }),
          {en::say("more reduce the noise of a finger that holds still, by their square root"),
           en::say(
               "more delay the results, by half their number; adding them up takes a little time"),
           {"1"}}),
      with_trade_off(region_setting(),
                     {en::say("'all' misses no contact"),
                      en::say("depth takes less time, in proportion to the part's length"),
                      {kFullFace}})};
}

std::vector<Setting<S>> edge_settings() {
  return {
      with_trade_off(choice_setting<S, EdgeMethod>(
                         "edge-method",
                         en::say("how the face's edges are located: half-height crossing to a "
                                 "fiftieth of a pixel, or the steepest pixel"),
                         &S::edge_method,
                         {{"crossing", EdgeMethod::kCrossing, en::say("subpixel edges")},
                          {"integer", EdgeMethod::kInteger, en::say("integer-pixel edges")}}),
                     {en::say("'crossing' measures the finger's bend, and so press positions, "
                              "several times more accurately"),
                      en::say("'crossing' takes a little longer"),
                      {"integer", "crossing"},
                      {},
                      has_edges}),
      with_trade_off(
          number_setting<S>(
              "edge-columns", en::say("pixel columns averaged into one position on each edge"),
              &S::edge_columns, 1, 32,
              [](int n) { return en::count("edges from {} columns", "edges from {} column", n); }),
          {en::say("more reduce the noise of dark images; beyond 16 a bent finger's edge is no "
                   "longer straight within them"),
           en::say("fewer make more positions, to each of which the curve must be fitted"),
           {"32", "16", "8", "4", "2"},
           {},
           has_edges}),
      with_trade_off(
          number_setting<S>("profile-degree",
                            en::say("degree of the smooth curve through each edge of the face"),
                            &S::profile_degree, 2, 12,
                            [](int degree) { return en::say("edge curve of degree {}", degree); }),
          {en::say("higher follows sharper bends; too high follows noise where the edge is "
                   "hidden"),
           en::say("higher makes the fit slower"),
           {"3", "5", "7", "9"},
           {},
           has_edges}),
      with_trade_off(
          choice_setting<S, bool>(
              "undistortion",
              en::say("whether the lens distortion is removed from every point, or the lens is "
                      "assumed to have none"),
              &S::undistort,
              {{"exact", true, en::say("lens corrected at every point")},
               {"none", false, en::say("lens assumed distortion-free")}}),
          {en::say("'exact' measures shape and positions correctly up to the image's corners"),
           en::say("'exact' looks up each ray separately"),
           {"none", "exact"},
           {},
           has_distortion})};
}

std::vector<Setting<S>> marker_settings() {
  return {
      with_trade_off(
          choice_setting<S, MarkerMethod>(
              "marker-method",
              en::say("how the engraved dots are found and numbered: spots tracked by the finger's "
                      "motion, the source paper's two sorted rows, or a convolutional network in "
                      "every frame"),
              &S::marker_method,
              {{"blobs", MarkerMethod::kBlobs, en::say("markers tracked as spots")},
               {"paper", MarkerMethod::kPaper, en::say("markers as two sorted rows")},
               {"network", MarkerMethod::kNetwork, en::say("markers found by a network")}}),
          {en::say("'network' finds more dots that are worn, dark or badly lit; 'paper' loses its "
                   "numbers where dots are hidden"),
           en::say("'network' takes many times as long"),
           {"paper", "blobs", "network"},
           {"network"},
           has_markers}),
      text_setting<S>(
          "marker-network",
          en::say("the network for marker-method network, and for paper where one is "
                  "named: an ONNX file, also a detector such as YOLO11"),
          &S::marker_network, fmt::format("a file, or {}", kBuiltInNetwork),
          [](const std::string& network) { return en::say("marker network {}", network); })};
}

std::vector<Setting<S>> depth_settings() {
  return {
      with_trade_off(
          choice_setting<S, ReferenceMethod>(
              "reference-method",
              en::say("which untouched image a frame is compared with: the one of the finger at "
                      "rest, the nearest recorded one, or one computed from several near ones"),
              &S::reference,
              {{"single", ReferenceMethod::kSingle, en::say("compared with the image at rest")},
               {"nearest", ReferenceMethod::kNearest, en::say("compared with the nearest image")},
               {"local", ReferenceMethod::kLocal, en::say("compared with several images")}}),
          {en::say("'local' measures depth of a bent finger correctly between the recorded poses; "
                   "'single' only at rest"),
           en::say("'local' adds up several images instead of one"),
           {"single", "nearest", "local"},
           {},
           has_edges}),
      with_trade_off(
          number_setting<S>(
              "reference-neighbours",
              en::say("recorded images from which reference-method local computes the reference"),
              &S::reference_neighbours, 2, 32,
              [](int n) {
                return en::count("reference from {} images", "reference from {} image", n);
              }),
          {en::say("more leave less noise in the reference; too many reach too far from "
                   "the pose"),
           en::say("each is added up in every frame"),
           {"2", "4", "8", "16"},
           {},
           has_edges}),
      with_trade_off(
          choice_setting<S, bool>(
              "light-change",
              en::say("whether a change of light since the reference is measured on the untouched "
                      "skin and removed"),
              &S::correct_light,
              {{"corrected", true, en::say("light corrected")},
               {"ignored", false, en::say("light as recorded")}}),
          {en::say("'corrected' corrects depth when the room or the lamp changes"),
           en::say("'corrected' analyses the untouched skin once"),
           {"ignored", "corrected"}}),
      with_trade_off(
          number_setting<S>("smoothing-px",
                            en::say("standard deviation of the smoothing before depth is computed, "
                                    "in pixels; 0: none"),
                            &S::smoothing_px, 0.0, 8.0,
                            [](double sd_px) {
                              return sd_px == 0 ? en::say("no smoothing")
                                                : en::say("smoothing of {:g} px", sd_px);
                            }),
          {en::say("more reduces the noise of a smooth contact and rounds off edges and threads"),
           en::say("more takes longer, none is fastest"),
           {"0", "1", "2", "4"}}),
      with_trade_off(
          choice_setting<S, bool>(
              "rays",
              en::say("how a layer pressed in along its normal is converted to z: looked up where "
                      "the normal leads, or at the same pixel as if all rays were parallel"),
              &S::exact_rays,
              {{"exact", true, en::say("exact rays through the layer")},
               {"parallel", false, en::say("parallel rays through the layer")}}),
          {en::say("'exact' measures a contact on a sloping face at its true position and depth; "
                   "'parallel' up to a layer's thickness off"),
           en::say("'exact' looks up every pixel of a contact once more"),
           {"parallel", "exact"},
           {},
           maps_along_normal}),
      number_setting<S>("contact-threshold-mm",
                        en::say("depth that counts as contact, in millimetres"),
                        &S::contact_threshold_mm, 0.01, 5.0,
                        [](double mm) { return en::say("contact from {:g} mm of depth", mm); })};
}

// No study varies it: no frame is measured with it.
Setting<S> mesh_setting() {
  return with_trade_off(
      number_setting<S>("mesh-step-px",
                        en::say("pixels from one vertex to the next in surfaces that "
                                "are saved or shown in 3D; 1: every pixel"),
                        &S::mesh_step_px, 1, 16,
                        [](int px) { return en::say("a vertex every {} px", px); }),
      {en::say("1 preserves every measured edge"),
       en::say("time and size fall with its square"),
       {}});
}

}  // namespace

const std::vector<Setting<PipelineSettings>>& pipeline_settings() {
  static const std::vector<Setting<S>> settings = [] {
    std::vector<Setting<S>> all = image_settings();
    for (const auto& more : {edge_settings(), marker_settings(), depth_settings()})
      all.insert(all.end(), more.begin(), more.end());
    all.push_back(mesh_setting());
    return all;
  }();
  return settings;
}

const std::vector<std::string>& mapping_independent_settings() {
  static const std::vector<std::string> names{"resolution", "average-frames",       "region",
                                              "rays",       "contact-threshold-mm", "mesh-step-px"};
  return names;
}

PipelineSettings settings_for_presses(PipelineSettings settings) {
  const PipelineSettings defaults;
  settings.resolution = defaults.resolution;
  settings.average_frames = defaults.average_frames;
  settings.region = defaults.region;
  settings.exact_rays = defaults.exact_rays;
  settings.contact_threshold_mm = defaults.contact_threshold_mm;
  settings.mesh_step_px = defaults.mesh_step_px;
  return settings;
}

FingerSnapshot finger_as_measured(const FingerSnapshot& finger, const PipelineSettings& settings) {
  FingerSnapshot measured = reduced_finger(finger, binning_factor(settings.resolution));
  if (settings.undistort || !has_distortion(measured.finger)) return measured;
  CameraParameters plain = measured.finger.camera;
  plain.model = CameraModel::kPinhole;
  plain.distortion.clear();
  auto camera = Camera::create(plain);
  if (!camera) return measured;
  measured.finger.camera = plain;
  measured.camera = std::move(camera).value();
  return measured;
}

}  // namespace alltact
