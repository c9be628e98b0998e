#include "calibration/study/painted_press.h"
#include "calibration/study/study_world.h"
#include "core/finger/reduced_finger.h"
#include "core/numerics/image_noise.h"
#include "core/recording/video_file.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/flat_reference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kDefaultBallRadiusMm = 3.0;
constexpr std::size_t kMaxGap = 5;        // frames on either side of a painted one, left out too
constexpr std::size_t kMinFrames = 3;     // painted
constexpr std::size_t kFramesPerBar = 4;  // one of so many shows a bar as well

// 95 % bound of the mapping's own error, from the calibration. Images painted with the mapping that
// reads them cannot show that error.
double mapping_p95_mm(const FingerSnapshot& finger) {
  constexpr int kDepths = 12;
  constexpr double kP95OfSd = 1.96, kSdOfMean = 1.2533;  // of a Gaussian
  const Mapping& mapping = *finger.mapping;
  double square = 0;
  for (int i = 1; i <= kDepths; ++i)
    square += std::pow(mapping.depth_sd_mm(mapping.x_max() * i / kDepths), 2) / kDepths;
  double sd_mm = std::sqrt(square);
  if (finger.finger.mapping_record)
    sd_mm = std::max(sd_mm, kSdOfMean * finger.finger.mapping_record->spread_mm);
  return kP95OfSd * sd_mm;
}

FaceZone zone_of_frame(std::size_t number) {
  return static_cast<FaceZone>(number % kFaceZones);
}

// Rows of the table that are painted, evenly over its time, and rows that stay in the reference.
struct Split {
  std::vector<std::size_t> painted, retained;
};

Split split_of(std::size_t rows, std::size_t painted) {
  Split split;
  painted = std::min(painted, rows / 6);
  if (painted == 0) return split;
  const std::size_t gap = std::min(kMaxGap, (rows / (3 * painted) - 1) / 2);
  std::vector<char> left_out(rows, 0);
  for (std::size_t i = 0; i < painted; ++i) {
    const std::size_t row = (2 * i + 1) * rows / (2 * painted);
    split.painted.push_back(row);
    for (std::size_t k = row - std::min(row, gap); k <= std::min(row + gap, rows - 1); ++k)
      left_out[k] = 1;
  }
  for (std::size_t row = 0; row < rows; ++row)
    if (!left_out[row]) split.retained.push_back(row);
  return split;
}

Error too_few(const FingerSnapshot& finger) {
  return {en::say("too few pictures of the reference recording show the face"),
          finger.folder.string(),
          en::say("record the finger bending through all its poses")};
}

Error stopped_painting() {
  return {en::say("stopped before the study was over"), "", ""};
}

/// A recording's frames, decoded once for libraries of several image sizes, up to a memory limit.
class DecodedFrames {
 public:
  explicit DecodedFrames(VideoFile video) : video_(std::move(video)) {}
  [[nodiscard]] std::size_t count() const { return video_.frame_count(); }
  Result<cv::Mat> operator()(std::size_t number) {
    if (const auto known = greys_.find(number); known != greys_.end()) return known->second;
    const auto frame = video_.frame(number);
    if (!frame) return frame.error();
    const cv::Mat& grey = (*frame)->grey;
    if (bytes_ + grey.total() <= kMostBytes) {
      bytes_ += grey.total();
      greys_.emplace(number, grey);
    }
    return grey;
  }

 private:
  static constexpr std::size_t kMostBytes = 256U << 20U;
  VideoFile video_;
  std::map<std::size_t, cv::Mat> greys_;
  std::size_t bytes_ = 0;
};

Result<UntouchedImages> untouched_of_recording(const FingerSnapshot& snapshot,
                                               const StudyWorldOptions& options,
                                               const Job& job) {
  const Finger& finger = snapshot.finger;
  if (!finger.reference || finger.reference->video.empty() || finger.reference->markers.empty())
    return Error{en::say("the finger has no reference recording"),
                 (snapshot.folder / Finger::kFileName).string(),
                 en::say("record the bending, untouched finger and make its reference")};
  const auto table =
      MarkerTable::load(snapshot.folder / finger.reference->markers, finger.marker_count());
  if (!table) return table.error();
  const auto file = snapshot.folder / finger.reference->video;
  const Split split = split_of(table->frames.size(), static_cast<std::size_t>(options.frames));
  if (split.painted.size() < kMinFrames) return too_few(snapshot);
  auto video = VideoFile::open(file, job);
  if (!video) return video.error();
  const auto frames = std::make_shared<DecodedFrames>(std::move(video).value());
  const auto library_of = [file, frames, retained = rows_of(*table, split.retained), snapshot](
                              const PipelineSettings& settings, const Job& doing) {
    const FingerSnapshot measuring = finger_as_measured(snapshot, settings);
    const auto image = [&](std::size_t number) -> Result<cv::Mat> {
      const auto grey = (*frames)(number);
      if (!grey) return grey.error();
      return image_for(measuring, *grey, en::say("the recording's picture"), "", "");
    };
    return ReferenceLibrary::from_frames(image,
                                         frames->count(),
                                         file,
                                         reduced_table(retained, measuring.reduced_by),
                                         measuring.finger,
                                         measuring.camera,
                                         doing);
  };
  auto library = library_of({}, job);
  if (!library) return library.error();
  UntouchedImages untouched{nullptr, std::move(library).value(), {}, library_of};
  for (const std::size_t row : split.painted) {
    if (job.stop_requested()) return stopped_painting();
    const auto raw = (*frames)(static_cast<std::size_t>(table->frames[row]));
    if (!raw) return raw.error();
    auto grey =
        oriented_for(finger.camera, *raw, en::say("the recording's picture"), file.string(), "");
    if (!grey) return grey.error();
    untouched.images.push_back(grey->clone());
  }
  return untouched;
}

// The single image with added noise, as much as two images differ by.
Result<UntouchedImages> untouched_of_flat(const FingerSnapshot& snapshot,
                                          const StudyWorldOptions& options,
                                          const Job& job) {
  auto library = ReferenceLibrary::load(snapshot, job);
  if (!library) return library.error();
  const auto turned = flat_reference(snapshot);
  if (!turned) return turned.error();
  const cv::Mat& grey = *turned;
  const double sd = std::sqrt(2.0) * image_noise_sd(grey);
  const auto library_of = [snapshot](const PipelineSettings& settings, const Job& doing) {
    return ReferenceLibrary::load(finger_as_measured(snapshot, settings), doing);
  };
  UntouchedImages untouched{nullptr, std::move(library).value(), {}, library_of};
  for (int number = 0; number < options.frames; ++number) {
    if (job.stop_requested()) return stopped_painting();
    StudyDraws draws(~options.seed, static_cast<std::uint32_t>(number));
    cv::Mat noisy = grey.clone();
    for (int v = 0; v < noisy.rows; ++v)
      for (int u = 0; u < noisy.cols; ++u) {
        auto& level = noisy.at<std::uint8_t>(v, u);
        level = cv::saturate_cast<std::uint8_t>(level + sd * draws.normal());
      }
    untouched.images.push_back(noisy);
  }
  return untouched;
}

// The finger with a camera whose images are already oriented.
Result<FingerPtr> upright(const FingerSnapshot& finger) {
  auto turned = std::make_shared<FingerSnapshot>(finger);
  turned->finger.camera.orientation = Orientation::kNone;
  auto camera = Camera::create(turned->finger.camera);
  if (!camera) return camera.error();
  turned->camera = std::move(camera).value();
  return FingerPtr(std::move(turned));
}

}  // namespace

double painted_radius_mm(const FingerSnapshot& finger) {
  return finger.presses.ball_radius_mm > 0 ? finger.presses.ball_radius_mm : kDefaultBallRadiusMm;
}

Result<UntouchedImages> untouched_images(const FingerPtr& finger,
                                         const StudyWorldOptions& options,
                                         const Job& job) {
  if (!finger->mapping)
    return Error{en::say("the finger is not calibrated yet"),
                 (finger->folder / Finger::kFileName).string(),
                 en::say("alltact calibrate with ball presses")};
  const bool is_flat = finger->finger.face.kind == FaceKind::kFlat;
  auto untouched = is_flat ? untouched_of_flat(*finger, options, job)
                           : untouched_of_recording(*finger, options, job);
  if (!untouched) return untouched.error();
  auto turned = upright(*finger);
  if (!turned) return turned.error();
  untouched->finger = std::move(turned).value();
  return untouched;
}

Result<StudyWorld> painted_world(const FingerPtr& finger,
                                 const StudyWorldOptions& options,
                                 const Job& job) {
  const auto untouched = untouched_images(finger, options, job);
  if (!untouched) return untouched.error();
  StudyWorld world{en::say("balls painted into untouched pictures of {}", finger->finger.name),
                   false,
                   untouched->finger,
                   untouched->library,
                   {},
                   0};
  Pipeline pipeline = Pipeline::with_library(world.library, *world.finger, PipelineSettings{});
  const PressPainter painter(*finger, painted_radius_mm(*finger));
  for (std::size_t i = 0; i < untouched->images.size(); ++i) {
    if (job.stop_requested()) return stopped_painting();
    auto frame = std::make_shared<Frame>();
    frame->grey = untouched->images[i];
    pipeline.forget();
    const auto seen = pipeline(frame);
    if (!seen || !seen->shape) continue;
    StudyDraws draws(options.seed, static_cast<std::uint32_t>(i));
    if (auto painted = painter.ball(seen->grey, *seen->shape, draws, zone_of_frame(i)))
      world.frames.push_back(std::move(*painted));
    if (i % kFramesPerBar != 0) continue;
    if (auto painted = painter.bar(seen->grey, *seen->shape, draws, zone_of_frame(i)))
      world.bars.push_back(std::move(*painted));
  }
  if (world.frames.size() < kMinFrames) return too_few(*finger);
  world.mapping_p95_mm = mapping_p95_mm(*finger);
  world.library_for = untouched->library_for;
  world.checksum = checksum_of(world.frames);
  return world;
}

}  // namespace alltact
