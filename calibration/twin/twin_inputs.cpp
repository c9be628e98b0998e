#include "calibration/finger/calibration_inputs.h"
#include "calibration/finger/measuring_presets.h"
#include "calibration/presses/press.h"
#include "calibration/reference/reference_recording.h"
#include "calibration/twin/twin.h"
#include "core/sensing/face/face_pixels.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <limits>
#include <set>

namespace alltact {
namespace {

constexpr float kSaturated = 253.5F;  // grey levels: the true brightness may be any higher value
constexpr double kMargin_px = 4;      // of the face's edges: blur mixes in the background

/// The finger and its measurement: an orthographic camera's plane may lie anywhere.
struct Measuring {
  const FingerSnapshot& finger;
  PipelineSettings settings;
  std::optional<Pipeline> pipeline;  ///< of a finger with edges or a recording
  /// CV_8UC1, oriented; empty: the recording is the reference
  std::vector<cv::Mat> untouched;
  std::optional<ReferenceImage> one;  ///< the first of these
  cv::Mat shared;                     ///< of a flat sensor: reference of all presses

  [[nodiscard]] bool is_flat() const { return finger.finger.face.kind == FaceKind::kFlat; }
};

Result<std::vector<cv::Mat>> read_untouched(const FingerSnapshot& finger,
                                            std::vector<std::filesystem::path> files) {
  const auto& reference = finger.finger.reference;
  if (files.empty() && reference && !reference->image.empty())
    files.push_back(finger.folder / reference->image);
  if (files.empty() && (!reference || reference->video.empty()))
    return Error{en::say("there is no untouched image of this finger to compare with"),
                 finger.folder, en::say("--reference with an image in which nothing touches it")};
  std::vector<cv::Mat> all;
  for (const std::filesystem::path& file : files) {
    const auto image = read_untouched_image(file);
    if (!image) return image.error();
    const auto grey =
        oriented_for(finger.finger.camera, image->grey, en::say("the untouched image"), file,
                     en::say("an image of this finger, at the size of its camera"));
    if (!grey) return grey.error();
    all.push_back(*grey);
  }
  return all;
}

Result<Measuring> make_measuring(const FingerSnapshot& finger, const TwinFiles& files,
                                 const Job& job) {
  Measuring measuring{finger, settings_for_presses(measuring_settings(finger.folder)), {}, {}, {},
                      {}};
  auto untouched = read_untouched(finger, files.untouched);
  if (!untouched) return untouched.error();
  measuring.untouched = std::move(*untouched);
  if (!measuring.untouched.empty()) {
    cv::Mat grey;
    measuring.untouched.front().convertTo(grey, CV_32F);
    measuring.one.emplace(grey);
  }
  if (measuring.is_flat()) return measuring;
  if (measuring.one) {
    measuring.pipeline.emplace(
        Pipeline::without_reference(finger.without_mapping(), measuring.settings));
    return measuring;
  }
  auto pipeline = Pipeline::create(finger.without_mapping(), measuring.settings, job);
  if (!pipeline) return pipeline.error();
  measuring.pipeline.emplace(std::move(*pipeline));
  return measuring;
}

/// The reference on the face, NaN outside.
cv::Mat on_face(const cv::Mat& reference, const FaceShape& shape) {
  cv::Mat result(reference.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  for (const FaceRun& run : face_runs(shape, kMargin_px, reference.size()).runs) {
    const cv::Rect part(run.first, run.row, run.size(), 1);
    reference(part).copyTo(result(part));
  }
  result.setTo(std::numeric_limits<float>::quiet_NaN(), reference > kSaturated);
  return result;
}

/// A press with its face, before its ball is known.
struct AnalysedPress {
  cv::Mat grey, reference;
  std::optional<FaceShape> shape;
  std::optional<Difference> difference;
  Message problem;
};

Result<AnalysedPress> see(Measuring& measuring, const FramePtr& frame) {
  AnalysedPress seen;
  std::optional<Reference> reference;
  if (measuring.is_flat()) {
    const auto grey =
        oriented_for(measuring.finger.finger.camera, frame->grey, en::say("the image"),
                     frame->origin, en::say("an image of this finger, at the size of its camera"));
    if (!grey) return grey.error();
    seen.grey = *grey;
    seen.shape = FaceShape::plane(measuring.finger.camera, measuring.finger.finger.face);
  } else {
    measuring.pipeline->forget();
    auto result = (*measuring.pipeline)(frame);
    if (!result) return result.error();
    seen.grey = result->grey;
    seen.shape = std::move(result->shape);
    seen.difference = std::move(result->difference);
    reference = std::move(result->reference);
    if (!seen.shape || (!measuring.one && (!seen.difference || reference->by_shape))) {
      seen.problem =
          result->problems.empty() ? en::say("no face was found") : result->problems.front();
      return seen;
    }
  }
  if (measuring.one) {
    reference.emplace();
    reference->image = *measuring.one;
    DifferenceOptions options;
    options.smoothing = smoothing_of(measuring.settings.smoothing_px);
    seen.difference = difference(seen.grey, *reference, *seen.shape, options);
  }
  if (!measuring.one || !measuring.is_flat()) {
    seen.reference = on_face(reference->image.grey(), *seen.shape);
  } else {
    if (measuring.shared.empty()) measuring.shared = on_face(reference->image.grey(), *seen.shape);
    seen.reference = measuring.shared;
  }
  return seen;
}

/// The twin's press, or the reason why there is none.
Result<TwinPress> press_from(const Measuring& measuring, const std::string& name,
                             AnalysedPress seen, const PressSet& press_set) {
  if (!seen.problem.empty()) return Error{seen.problem, "", ""};
  const PressNote& note = press_set.of(name);
  if (note.excluded) return Error{en::say("excluded"), "", ""};
  if (!note.is_ball()) return Error{en::say("it was not made with a ball"), "", ""};
  const Press press{name,
                    std::move(*seen.difference),
                    *seen.shape,
                    press_set.radius_of(name),
                    note.ball_mm,
                    note.depth,
                    {}};
  const Face& face = measuring.finger.finger.face;
  const auto guess =
      note.ball_mm ? guess_of_manual_ball(press, face, *note.ball_mm) : find_ball(press, face);
  if (!guess) return guess.error();
  return TwinPress{name,
                   seen.grey,
                   seen.reference,
                   std::move(*seen.shape),
                   press.ball_radius_mm,
                   guess->centre_mm,
                   guess->disc_px,
                   guess->disc_radius_px,
                   note.depth};
}

Result<PressSet> press_set_for(const FingerSnapshot& finger, const TwinFiles& files) {
  PressSet press_set = finger.presses;
  if (files.press_set.ball_radius_mm > 0) press_set.ball_radius_mm = files.press_set.ball_radius_mm;
  for (const auto& [name, note] : files.press_set.notes) press_set.say(name, note);
  if (!(press_set.ball_radius_mm > 0))
    return Error{en::say("the radius of the ball that was pressed is not known"), finger.folder,
                 en::say("--ball-radius-mm with the radius of the ball")};
  return press_set;
}

Result<PressInput> presses_of(const FingerSnapshot& finger, const TwinFiles& files) {
  if (!files.presses.files.empty() || !files.presses.frames.empty()) return files.presses;
  auto stored = stored_presses(finger.folder);
  if (!stored) return stored.error();
  if (stored->empty())
    return Error{en::say("no press was specified, and the finger has none"), finger.folder,
                 en::say("images of a ball of known radius pressed into its face")};
  PressInput presses;
  presses.files = std::move(*stored);
  return presses;
}

}  // namespace

Result<TwinMeasured> measure_for_twin(const FingerSnapshot& finger, const TwinFiles& files,
                                      const Job& job) {
  const auto press_set = press_set_for(finger, files);
  if (!press_set) return press_set.error();
  const auto presses = presses_of(finger, files);
  if (!presses) return presses.error();
  auto measuring = make_measuring(finger, files, job);
  if (!measuring) return measuring.error();
  auto source = open_presses(*presses);
  if (!source) return source.error();
  TwinMeasured measured;
  measured.input.name = finger.finger.name;
  measured.input.camera = finger.finger.camera;
  measured.input.face = finger.finger.face;
  measured.input.untouched = measuring->untouched;
  std::set<std::string> names;
  for (;;) {
    if (job.stop_requested()) return Error{en::say("stopped before the twin was found"), "", ""};
    const auto frame = (*source)->next();
    if (!frame) return frame.error();
    if (!*frame) break;
    const std::string name = (*frame)->name;
    if (!names.insert(name).second)
      return Error{en::say("two presses are called '{}'", name), (*frame)->origin,
                   en::say("giving the images different names")};
    auto seen = see(*measuring, *frame);
    if (!seen) return seen.error();
    auto press = press_from(*measuring, name, std::move(*seen), *press_set);
    if (press)
      measured.input.presses.push_back(std::move(*press));
    else
      measured.left_out.push_back(en::say("{}: {}", name, press.error().what));
  }
  for (const auto& [name, note] : files.press_set.notes)
    if (!names.contains(name)) return Error{en::say("no press is named '{}'", name), "", ""};
  if (measured.input.presses.empty())
    return Error{
        en::say("no press can be used: {}", en::clauses(measured.left_out)), "",
        en::say("images of this finger with the ball pressed 0.3 mm or more into its face")};
  return measured;
}

}  // namespace alltact
