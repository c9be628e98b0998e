#include "calibration/reference/recording_pass.h"

#include "calibration/presses/press.h"
#include "core/image/image_file.h"
#include "core/numerics/median.h"
#include "core/recording/video_file.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/marker_detector.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxCachedBytes = std::size_t{128} << 20;

// The reference video, created at its first frame.
class ReferenceVideo {
 public:
  ReferenceVideo(fs::path file, double frames_per_s)
      : file_(std::move(file)), frames_per_s_(frames_per_s) {}

  Status add(const Frame& frame) {
    if (!writer_) {
      auto made = VideoWriter::create(file_, frame, VideoCodec::kMagicYuv, frames_per_s_);
      if (!made) return made.error();
      writer_ = std::move(*made);
    }
    return writer_->add(frame);
  }
  Status finish() { return writer_ ? writer_->finish() : Status(); }

 private:
  fs::path file_;
  double frames_per_s_;
  std::optional<VideoWriter> writer_;
};

FrameDots analyse(const cv::Mat& grey, const Camera& camera, const Finger& finger) {
  FrameDots found;
  const auto edges = FaceEdgeFinder({.view = FaceView{camera, finger.face.width_mm}})(grey);
  if (!edges) {
    found.problem = edges.error().what;
    return found;
  }
  const auto shape = FaceShape::fit(*edges, camera, finger.face, kDefaultProfileDegree);
  if (!shape) {
    found.problem = shape.error().what;
    return found;
  }
  found.curves = edge_curves(*shape);
  if (finger.markers.per_row == 0) return found;
  for (const Polarity polarity : {Polarity::kBright, Polarity::kDark}) {
    if (finger.markers.polarity != Polarity::kAuto && finger.markers.polarity != polarity) continue;
    auto& dots = polarity == Polarity::kBright ? found.bright : found.dark;
    dots = MarkerDetector({finger.markers.per_row, polarity})(grey, *shape).dots;
  }
  return found;
}

}  // namespace

Result<RecordingPass> read_recording(Source& source, const Camera& camera, const Finger& finger,
                                     const Job& job, const fs::path& video) {
  RecordingPass pass;
  ReferenceVideo writer(video, source.frames_per_s());
  const auto total = source.count();
  std::size_t cached_bytes = 0;
  for (;;) {
    if (job.stop_requested())
      return Error{en::say("stopped before the recording was read"), video.parent_path().string(),
                   ""};
    const auto frame = source.next();
    if (frame && !*frame) break;
    const std::size_t number = pass.frames.size();
    if (total && *total > 0)
      job.report(static_cast<double>(number) / static_cast<double>(*total),
                 en::say("reading frame {} of {}", number + 1, *total));
    if (!frame) {
      pass.frames.push_back({{}, {}, {}, frame.error().what});
      pass.in_video.push_back(-1);
      // A source that fails permanently must not block.
      if (total && pass.frames.size() > *total) return frame.error();
      if (!total && pass.written == 0 && pass.frames.size() > 100) return frame.error();
      continue;
    }
    const auto grey = oriented_for(
        finger.camera, (*frame)->grey, en::say("the image"),
        (*frame)->origin.empty() ? (*frame)->name : (*frame)->origin,
        en::say("a recording from this finger's camera, or the right camera.size and orientation"));
    if (!grey) return grey.error();
    pass.settings.add(**frame);
    pass.frames.push_back(analyse(*grey, camera, finger));
    const Status written = writer.add(**frame);
    if (!written) return written.error();
    pass.in_video.push_back(pass.written++);
    const std::size_t bytes = grey->total();
    const bool has_room = cached_bytes + bytes <= kMaxCachedBytes;
    pass.greys.push_back(has_room ? *grey : cv::Mat());
    if (has_room) cached_bytes += bytes;
  }
  if (const Status finished = writer.finish(); !finished) return finished.error();
  return pass;
}

Status retain_frames(const fs::path& video, const std::vector<char>& keep, const Job& job) {
  fs::path full = video;
  full.replace_filename(video.stem().string() + ".whole" + video.extension().string());
  std::error_code problem;
  fs::rename(video, full, problem);
  if (problem)
    return Error{en::say("the recording cannot be renamed: {}", problem.message()), video.string(),
                 ""};
  struct Remove {
    const fs::path& file;
    ~Remove() {
      std::error_code ignored;
      fs::remove(file, ignored);
    }
  } remove{full};
  auto reader = VideoFile::open(full, job);
  if (!reader) return reader.error();
  ReferenceVideo writer(video, reader->frames_per_s());
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (job.stop_requested())
      return Error{en::say("stopped before the recording was written"), video.string(), ""};
    if (!keep[i]) continue;
    job.report(static_cast<double>(i) / static_cast<double>(keep.size()),
               en::say("writing the accepted frames"));
    const auto frame = reader->frame(i);
    if (!frame) return frame.error();
    if (const Status written = writer.add(**frame); !written) return written;
  }
  return writer.finish();
}

MarkerTable table_of(const NumberedRecording& numbered, const std::vector<std::size_t>& selected) {
  MarkerTable table;
  const auto count = numbered.typical.size();
  table.typical = numbered.typical;
  table.layouts.resize(static_cast<Eigen::Index>(selected.size()),
                       static_cast<Eigen::Index>(2 * count));
  for (std::size_t i = 0; i < selected.size(); ++i) {
    const Markers& markers = *numbered.markers[selected[i]];
    table.frames.push_back(static_cast<int>(i));
    table.seen.emplace_back(count, 0);
    for (std::size_t m = 0; m < count; ++m) {
      table.layouts.row(static_cast<Eigen::Index>(i)).segment<2>(static_cast<Eigen::Index>(2 * m))
          << markers[m].u,
          markers[m].v;
      table.seen.back()[m] = static_cast<char>(markers[m].seen);
    }
  }
  return table;
}

MarkerTable table_in_video(const RecordingPass& pass, const NumberedRecording& numbered,
                           const std::vector<std::size_t>& selected) {
  MarkerTable table = table_of(numbered, selected);
  for (std::size_t i = 0; i < selected.size(); ++i) table.frames[i] = pass.in_video[selected[i]];
  return table;
}

Result<cv::Mat> oriented_frame(VideoFile& video, std::size_t number,
                               const CameraParameters& camera) {
  const auto read = video.frame(number);
  if (!read) return read.error();
  return oriented_for(camera, (*read)->grey, en::say("the recording's image"), "", "");
}

Result<cv::Mat> RecordedVideo::frame(std::size_t number) {
  if (!pass.greys[number].empty()) return pass.greys[number];
  return oriented_frame(reader, number, finger.camera);
}

namespace {

constexpr int kStudyDegree = 7;
constexpr double kPatchMm = 1.5;  // a side
constexpr double kMaxSeconds = 2.0;
constexpr double kMaxFraction = 0.125;
constexpr double kRimPx = 4.0;  // next to the face's edges a shift of a tenth of a pixel is visible

struct AnalysedFrame {
  cv::Mat grey;
  FaceShape shape;
  double noise_sd;
};

std::optional<AnalysedFrame> analyse_frame(const cv::Mat& grey, const Camera& camera,
                                           const Finger& finger) {
  const auto edges = FaceEdgeFinder({.view = FaceView{camera, finger.face.width_mm}})(grey);
  if (!edges) return std::nullopt;
  auto shape = FaceShape::fit(*edges, camera, finger.face, kStudyDegree);
  if (!shape) return std::nullopt;
  return AnalysedFrame{grey, std::move(shape).value(), edges->noise_sd};
}

/// Means of the valid part of an image over squares.
class Means {
 public:
  explicit Means(const cv::Mat& x) : known_(measured_pixels(x)) {
    known_.convertTo(weight_, CV_32FC1, 1.0 / 255.0);
    filled_ = x.clone();
    filled_.setTo(0.0F, ~known_);
  }
  /// NaN where less than half of the square is known, or the middle is not.
  [[nodiscard]] cv::Mat over(int side) const {
    cv::Mat sum, weight;
    cv::boxFilter(filled_, sum, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_CONSTANT);
    cv::boxFilter(weight_, weight, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_CONSTANT);
    cv::Mat mean = sum / weight;
    mean.setTo(std::numeric_limits<float>::quiet_NaN(), (weight < 0.25F) | ~known_);
    return mean;
  }

 private:
  cv::Mat known_, weight_, filled_;
};

/// Difference of the face from the reference in patches around every pixel.
struct Patches {
  cv::Mat mean;
  double noise;  ///< sd of a patch's mean by noise alone
};

Patches patches_of(const Difference& difference, const FaceShape& shape, double grey_level) {
  std::vector<double> z;
  for (const FaceColumn& column : shape.columns())
    if (column.valid) z.push_back(column.z_mm);
  const int side =
      std::max(3, static_cast<int>(kPatchMm / shape.camera().mm_per_px_at(upper_median(z))));
  const Means means(difference.x);
  Patches patches;
  patches.mean = means.over(side);
  // Smoothing has already averaged over neighbours; a patch is wider than that.
  patches.noise = difference.grey_sd * 2.0 * std::sqrt(M_PI) / (side * grey_level);
  return patches;
}

class Study {
 public:
  Study(const ReferenceLibrary& library, const std::vector<Markers>& numbered, double frames_per_s)
      : library_(library), numbered_(numbered) {
    const double most = kMaxFraction * static_cast<double>(library.frame_count());
    gap_ = static_cast<std::size_t>(std::max(1.0, std::min(most, kMaxSeconds * frames_per_s)));
  }

  [[nodiscard]] StudiedFrame frame(std::size_t index, const AnalysedFrame& analysed) const {
    StudiedFrame studied;
    studied.number = library_.frame_numbers()[index];
    const Markers& markers = numbered_[index];
    for (std::size_t pair = 0; pair < markers.size() / 2; ++pair)
      studied.pairs.push_back(tip_pose(markers, pair, analysed.shape));
    std::vector<char> without(library_.frame_count(), 0);
    const std::size_t first = index > gap_ ? index - gap_ : 0;
    for (std::size_t i = first; i <= index + gap_ && i < without.size(); ++i) without[i] = 1;
    if (std::count(without.begin(), without.end(), 0) < 2) return studied;
    const auto local = compare(index, analysed, ReferenceMethod::kLocal, without);
    if (!local) return studied;
    studied.compared = true;
    studied.error = mean_error(*local);
    if (const auto nearest = compare(index, analysed, ReferenceMethod::kNearest, without))
      studied.nearest_error = mean_error(*nearest);
    return studied;
  }

 private:
  [[nodiscard]] std::optional<Patches> compare(std::size_t index, const AnalysedFrame& analysed,
                                               ReferenceMethod method,
                                               const std::vector<char>& without) const {
    const Reference reference =
        library_.reference_for(numbered_[index], analysed.shape, method, without);
    // Outside the others' poses the reference is extrapolated and does not count.
    if (!reference.known_pose || reference.noise_gain > 1.0) return std::nullopt;
    DifferenceOptions options;
    options.edge_margin_px = kRimPx;
    options.noise_sd = analysed.noise_sd;
    options.correct_light = true;
    const Difference compared = difference(analysed.grey, reference, analysed.shape, options);
    if (compared.face.runs.empty()) return std::nullopt;
    return patches_of(compared, analysed.shape, mean_brightness(analysed.grey, compared.face));
  }

  static double mean_error(const Patches& patches) {
    double square = 0, count = 0;
    for (int v = 0; v < patches.mean.rows; v += 4)
      for (int u = 0; u < patches.mean.cols; u += 4)
        if (const float x = patches.mean.at<float>(v, u); std::isfinite(x))
          square += static_cast<double>(x) * x, ++count;
    if (count == 0) return 0;
    // Of a normal distribution the mean magnitude is 0.8 of the standard deviation.
    return 0.8 * std::sqrt(std::max(0.0, square / count - patches.noise * patches.noise));
  }

  const ReferenceLibrary& library_;
  const std::vector<Markers>& numbered_;
  std::size_t gap_;
};

double quantile_of(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(part * (static_cast<double>(values.size()) - 1.0));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

Result<RecordingStudy> study_recording(const ReferenceLibrary& library,
                                       const std::vector<Markers>& numbered,
                                       const RecordingFrameReader& frame, double frames_per_s,
                                       const Finger& finger, const Camera& camera, const Job& job) {
  const std::size_t count = library.frame_count();
  const Study study(library, numbered, frames_per_s);
  RecordingStudy result;
  const auto analysed_at = [&](std::size_t index) -> Result<std::optional<AnalysedFrame>> {
    const auto grey = frame(static_cast<std::size_t>(library.frame_numbers()[index]));
    if (!grey) return grey.error();
    return analyse_frame(*grey, camera, finger);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (job.stop_requested())
      return Error{en::say("stopped before the recording was compared"), "", ""};
    job.report(static_cast<double>(i) / static_cast<double>(count),
               en::say("comparing frame {} of {}", i + 1, count));
    const auto analysed = analysed_at(i);
    if (!analysed) return analysed.error();
    StudiedFrame studied;
    studied.number = library.frame_numbers()[i];
    if (*analysed) studied = study.frame(i, **analysed);
    result.frames.push_back(std::move(studied));
  }
  std::vector<double> errors, nearest;
  for (std::size_t i = 0; i < count; ++i) {
    if (!result.frames[i].compared) continue;
    errors.push_back(result.frames[i].error);
    nearest.push_back(result.frames[i].nearest_error);
  }
  result.error_median = quantile_of(errors, 0.5);
  result.error_p95 = quantile_of(errors, 0.95);
  result.nearest_error_median = quantile_of(nearest, 0.5);
  return result;
}

}  // namespace alltact
