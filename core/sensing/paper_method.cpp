#include "core/sensing/paper_method.h"

#include "core/numerics/image_noise.h"
#include "core/sensing/contact/face_contact.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/depth/pixel_flags.h"
#include "core/sensing/paper_face.h"
#include "core/sensing/stop_watch.h"

namespace alltact {
namespace {

Error unsuitable_finger(Message what, const FingerSnapshot& finger) {
  return {std::move(what),
          (finger.folder / Finger::kFileName).string(),
          en::say("our own method, which needs no dots, or a recording of a finger that has them")};
}

DifferenceOptions paper_difference_options(double noise_sd) {
  DifferenceOptions options;
  options.smoothing = smoothing_of(0.0);
  options.correct_light = false;
  options.noise_sd = noise_sd;
  return options;
}

}  // namespace

Result<PaperMethod> PaperMethod::create(const FingerSnapshot& finger, const Job& job) {
  if (finger.finger.face.kind == FaceKind::kFlat) {
    auto untouched = ReferenceLibrary::load(finger, job);
    if (!untouched) return untouched.error();
    return flat(std::move(untouched).value(), finger);
  }
  const auto& files = finger.finger.reference;
  if (!files || files->video.empty())
    return Error{en::say("the finger has no reference recording"),
                 (finger.folder / Finger::kFileName).string(),
                 en::say("alltact reference with a video of the untouched finger bending")};
  if (finger.finger.markers.per_row < 1 || files->positions)
    return unsuitable_finger(
        en::say("the source paper's method chooses its reference by the markers, and this finger "
                "has none"),
        finger);
  if (!finger.finger.markers.missing.empty())
    return unsuitable_finger(
        en::say("the source paper's method sorts two whole rows, and {} of this finger's dots are "
                "missing",
                finger.finger.markers.missing.size()),
        finger);
  auto read = PaperReference::read(finger.folder / files->video, finger.finger, finger.camera, job);
  if (!read) return read.error();
  PaperMethod method(finger);
  method.reference_ = std::make_shared<const PaperReference>(std::move(read).value());
  return method;
}

PaperMethod PaperMethod::flat(ReferenceLibrary untouched, const FingerSnapshot& finger) {
  PaperMethod method(finger);
  method.plane_ = FaceShape::plane(finger.camera, finger.finger.face);
  method.untouched_ = std::move(untouched);
  return method;
}

PaperMethod PaperMethod::with(std::optional<Mapping> mapping) const {
  PaperMethod other = *this;
  other.mapping_ = std::move(mapping);
  other.forget();
  return other;
}

Result<FrameResult> PaperMethod::operator()(const FramePtr& frame) {
  StopWatch watch;
  FrameResult result;
  result.frame = frame;
  auto grey = oriented_for(finger_.camera,
                           frame->grey,
                           en::say("the picture"),
                           frame->origin,
                           en::say("a picture at the size that the finger was calibrated with"));
  if (!grey) return grey.error();
  result.grey = std::move(grey).value();
  watch.lap(result.times_ms.prepare);
  const bool has_face = find_face(result);
  watch.lap(result.times_ms.global);
  const bool has_reference = has_face && find_reference(result);
  watch.lap(result.times_ms.reference);
  if (has_reference) find_depth(result);
  watch.lap(result.times_ms.local);
  if (result.depth) find_regions(result);
  watch.lap(result.times_ms.contact);
  watch.total(result.times_ms.total);
  return result;
}

// Finds the edges and fits the face.
bool PaperMethod::find_face(FrameResult& result) const {
  if (plane_) {
    result.shape = plane_;
    return true;
  }
  const auto face = PaperFace::fit(paper_edges(result.grey), camera_, finger_.face);
  auto shape = face ? face->shape(camera_, finger_.face) : Result<FaceShape>(face.error());
  if (!shape) {
    result.problems.push_back(en::say("{}.", shape.error().message()));
    return false;
  }
  result.shape = std::move(shape).value();
  return true;
}

// Finds the markers and the recorded frame whose markers lie nearest.
bool PaperMethod::find_reference(FrameResult& result) {
  if (untouched_) {
    result.reference = untouched_->reference_for({}, *plane_, ReferenceMethod::kSingle);
    return true;
  }
  result.markers = paper_markers(
      result.grey, *result.shape, finger_.markers, last_ ? &*last_ : &reference_->frame(0).markers);
  if (!result.markers) {
    result.problems.push_back(
        en::say("fewer than two dots of a row are seen, from which the source paper's method could "
                "tell the others: uncover and light the dots on the side faces"));
    return false;
  }
  last_ = result.markers;
  const auto nearest = reference_->nearest(*result.markers);
  const PaperReference::Recorded& recorded = reference_->frame(nearest.index);
  cv::Mat grey;
  recorded.grey.convertTo(grey, CV_32F);
  result.reference.emplace();
  result.reference->image = ReferenceImage(grey);
  result.reference->frame = recorded.number;
  result.reference->distance_px = nearest.distance_px;
  return true;
}

void PaperMethod::find_depth(FrameResult& result) const {
  const DifferenceOptions options = paper_difference_options(image_noise_sd(result.grey));
  if (mapping_) {
    result.depth = depth_map(result.grey, *result.reference, *result.shape, options, *mapping_);
    return;
  }
  result.difference = difference(result.grey, *result.reference, *result.shape, options);
  result.touch = face_contact(*result.difference);
  result.problems.push_back(
      en::say("the finger is not calibrated: calibrate it with ball presses"));
}

void PaperMethod::find_regions(FrameResult& result) const {
  RegionOptions options;
  options.noise_mm = result.depth->noise_mm;
  DepthErrorModel error(*result.depth, *result.reference, *result.shape, *mapping_);
  options.untouched = [&](int u, int v) { return error.untouched(u, v); };
  options.pressed = [&](int u, int v, double mm) { return error.of_depth(u, v, mm); };
  result.regions = contact_regions(*result.depth, *result.shape, finger_.face, options);
  result.touch = face_contact(result.regions);
}

}  // namespace alltact
