#include "calibration/reference/recording_pass.h"

#include "calibration/presses/press.h"
#include "core/image/image_file.h"
#include "core/numerics/median.h"
#include "core/numerics/parallel.h"
#include "core/recording/video_file.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/marker_detector.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <system_error>
#include <tuple>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxCachedBytes = std::size_t{256} << 20;

// The reference video, created at its first frame; none where the recording is copied later.
class ReferenceVideo {
 public:
  ReferenceVideo(const Source& source, const fs::path& file)
      : copied_(source.lossless_file()), file_(file), frames_per_s_(source.frames_per_s()) {}

  [[nodiscard]] bool is_copied() const { return copied_.has_value(); }
  [[nodiscard]] const fs::path& file() const { return copied_ ? *copied_ : file_; }
  Status add(const Frame& frame) {
    if (copied_) return {};
    if (!writer_) {
      auto made = VideoWriter::create(file_, frame, VideoCodec::kMagicYuv, frames_per_s_);
      if (!made) return made.error();
      writer_ = std::move(*made);
    }
    return writer_->add(frame);
  }
  Status finish() { return writer_ ? writer_->finish() : Status(); }

 private:
  std::optional<fs::path> copied_;
  fs::path file_;
  double frames_per_s_;
  std::optional<VideoWriter> writer_;
};

/// Fills `edges` where they are found.
FrameDots analyse(const cv::Mat& grey, const Camera& camera, const Finger& finger,
                  FaceEdges& edges) {
  FrameDots found;
  auto traced = FaceEdgeFinder({.view = FaceView{camera, finger.face.width_mm}})(grey);
  if (!traced) {
    found.problem = traced.error().what;
    return found;
  }
  edges = std::move(*traced);
  const auto shape = FaceShape::fit(edges, camera, finger.face, kDefaultProfileDegree);
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

constexpr std::size_t kAtOnce = 16;  // frames that are read and analysed at a time

/// Of a recording of that many frames.
std::size_t every_of(std::size_t count) {
  std::size_t every = 1;
  while ((count + every - 1) / every > kMaxExamined) every *= 2;
  return every;
}

struct ReadFrame {
  std::size_t number = 0;  // in the recording
  FramePtr frame;          // null: unreadable, for the reason in `dots.problem`
  cv::Mat grey;            // oriented as the camera
  FrameDots dots;
  FaceEdges edges;
};

/// Reads frames and writes them to the video, in order.
class RecordingCopy {
 public:
  RecordingCopy(Source& source, const CameraParameters& camera, const fs::path& video,
                const Job& job)
      : source_(source),
        camera_(camera),
        folder_(video.parent_path()),
        video_(source, video),
        job_(job) {}

  /// The next frames whose number is a multiple of `every`, up to kAtOnce; none after the last.
  /// Errors: a wrong size; a source that fails permanently; stopped.
  Result<std::vector<ReadFrame>> read(std::size_t every) {
    std::vector<ReadFrame> block;
    while (block.size() < kAtOnce) {
      if (job_.stop_requested())
        return Error{en::say("stopped before the recording was read"), folder_.string(), ""};
      const std::size_t unexamined = (every - position_ % every) % every;
      if (unexamined > 0 && source_.count()) {
        source_.skip(unexamined);
        position_ += unexamined;
      }
      auto frame = source_.next();
      if (frame && !*frame) break;
      const std::size_t number = position_++;
      if (frame && number % every != 0) continue;
      if (!frame) {
        if (fails_permanently()) return frame.error();
        block.push_back({number, {}, {}, {{}, {}, {}, frame.error().what}, {}});
        continue;
      }
      is_any_readable_ = true;
      const Frame& read = **frame;
      auto grey = oriented_for(camera_, read.grey, en::say("the image"),
                               read.origin.empty() ? read.name : read.origin,
                               en::say("a recording from this finger's camera, or the right "
                                       "camera.size and orientation"));
      if (!grey) return grey.error();
      block.push_back({number, std::move(*frame), std::move(*grey), {}, {}});
    }
    return block;
  }
  Status write(const std::vector<ReadFrame>& block) {
    for (const ReadFrame& read : block) {
      if (!read.frame) continue;
      if (const Status written = video_.add(*read.frame); !written) return written;
    }
    return {};
  }
  Status finish() { return video_.finish(); }
  [[nodiscard]] const ReferenceVideo& video() const { return video_; }
  /// Frames of the source, once it is read to its end.
  [[nodiscard]] std::size_t count() const { return source_.count().value_or(position_); }

 private:
  /// Such a source must not block.
  [[nodiscard]] bool fails_permanently() const {
    constexpr std::size_t kMaxUnreadable = 100;
    const auto total = source_.count();
    return total ? position_ > *total : !is_any_readable_ && position_ > kMaxUnreadable;
  }

  Source& source_;
  const CameraParameters& camera_;
  fs::path folder_;
  ReferenceVideo video_;
  const Job& job_;
  std::size_t position_ = 0;
  bool is_any_readable_ = false;
};

void report_read(const Source& source, std::size_t count, const Job& job) {
  if (const auto total = source.count(); total && *total > 0)
    job.report(static_cast<double>(count) / static_cast<double>(*total),
               en::say("reading frame {} of {}", count + 1, *total));
}

/// Collects the results of the first pass, and thins them as the recording grows.
class PassResults {
 public:
  explicit PassResults(const ReferenceVideo& video) : is_copied_(video.is_copied()) {
    pass_.video = video.file();
  }

  [[nodiscard]] std::size_t every() const { return pass_.every; }
  [[nodiscard]] std::size_t count() const { return pass_.frames.size(); }

  /// The recording has at least that many frames.
  void grow(std::size_t count) {
    const std::size_t every = std::max(pass_.every, every_of(count));
    if (every == pass_.every) return;
    pass_.every = every;
    for (std::size_t i = 0; i < pass_.frames.size(); ++i)
      if (!pass_.is_examined(i)) drop(i);
  }

  void add(ReadFrame& read) {
    resize(read.number + 1);
    if (!pass_.is_examined(read.number)) return;
    const std::size_t i = read.number;
    pass_.frames[i] = std::move(read.dots);
    if (read.frame) controls_[i] = read.frame->controls;
    if (!is_copied_) {
      if (!read.frame) return;
      pass_.in_video[i] = pass_.video_frames++;
      pass_.greys.emplace_back();
      pass_.edges.emplace_back();
    }
    const auto in_video = static_cast<std::size_t>(pass_.in_video[i]);
    pass_.edges[in_video] = std::move(read.edges);
    if (cached_bytes_ + read.grey.total() > kMaxCachedBytes) return;
    cached_bytes_ += read.grey.total();
    pass_.greys[in_video] = read.grey;
  }

  /// count: frames of the recording.
  RecordingPass finish(std::size_t count) {
    resize(count);
    for (auto& controls : controls_) {
      Frame frame;
      frame.controls = std::move(controls);
      pass_.settings.add(frame);
    }
    return std::move(pass_);
  }

 private:
  static FrameDots not_examined() {
    return {{}, {}, {}, en::say("neighbouring frames represent it: the recording is long")};
  }
  void resize(std::size_t count) {
    if (count <= pass_.frames.size()) return;
    for (std::size_t i = pass_.frames.size(); i < count; ++i)
      pass_.in_video.push_back(is_copied_ ? static_cast<int>(i) : -1);
    pass_.frames.resize(count, not_examined());
    controls_.resize(count);
    if (!is_copied_) return;
    pass_.video_frames = static_cast<int>(count);
    pass_.greys.resize(count);
    pass_.edges.resize(count);
  }
  void drop(std::size_t frame) {
    pass_.frames[frame] = not_examined();
    controls_[frame].reset();
    if (pass_.in_video[frame] < 0) return;
    const auto in_video = static_cast<std::size_t>(pass_.in_video[frame]);
    cached_bytes_ -= pass_.greys[in_video].total();
    pass_.greys[in_video].release();
    pass_.edges[in_video] = {};
  }

  bool is_copied_;
  RecordingPass pass_;
  std::vector<std::shared_ptr<const std::string>> controls_;  // by number in the recording
  std::size_t cached_bytes_ = 0;
};

}  // namespace

Result<RecordingPass> read_recording(Source& source, const Camera& camera, const Finger& finger,
                                     const Job& job, const fs::path& video) {
  RecordingCopy copy(source, finger.camera, video, job);
  PassResults results(copy.video());
  results.grow(source.count().value_or(0));
  auto block = copy.read(results.every());
  while (block && !block->empty()) {
    report_read(source, results.count(), job);
    results.grow(std::max(source.count().value_or(0), block->back().number + 1));
    const std::size_t every = results.every();
    std::erase_if(*block, [&](const ReadFrame& read) { return read.number % every != 0; });
    // While these are analysed, they are written and the next ones are read.
    auto next = std::async(std::launch::async, [&]() -> Result<std::vector<ReadFrame>> {
      if (const Status written = copy.write(*block); !written) return written.error();
      return copy.read(every);
    });
    std::vector<std::pair<FrameDots, FaceEdges>> found(block->size());
    parallel_for(static_cast<int>(block->size()), default_threads(), [&](int first, int end) {
      for (int k = first; k < end; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (const ReadFrame& read = (*block)[i]; read.frame)
          found[i].first = analyse(read.grey, camera, finger, found[i].second);
      }
    });
    auto following = next.get();
    for (std::size_t i = 0; i < block->size(); ++i) {
      if ((*block)[i].frame) std::tie((*block)[i].dots, (*block)[i].edges) = std::move(found[i]);
      results.add((*block)[i]);
    }
    block = std::move(following);
  }
  if (!block) return block.error();
  if (const Status finished = copy.finish(); !finished) return finished.error();
  return results.finish(copy.count());
}

Status retain_frames(const RecordingPass& pass, const std::vector<std::size_t>& selected,
                     const fs::path& video, const Job& job) {
  const bool is_written = pass.video == video;
  if (is_written && static_cast<int>(selected.size()) == pass.video_frames) return {};
  std::vector<char> keep(static_cast<std::size_t>(pass.video_frames), 0);
  for (const std::size_t i : selected) keep[static_cast<std::size_t>(pass.in_video[i])] = 1;
  if (!is_written) return copy_frames(pass.video, video, keep, job);
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
  return copy_frames(full, video, keep, job);
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

std::optional<FaceEdges> RecordedVideo::edges(std::size_t number, const cv::Mat& grey) const {
  if (!pass.edges[number].u.empty()) return pass.edges[number];
  auto traced = FaceEdgeFinder({.view = FaceView{camera, finger.face.width_mm}})(grey);
  return traced ? std::optional(std::move(*traced)) : std::nullopt;
}

namespace {

constexpr double kPatchMm = 1.5;  // a side
constexpr double kMaxSeconds = 2.0;
constexpr double kMaxFraction = 0.125;
constexpr std::size_t kMaxCompared = 120;  // frames: six are above the 95th percentile
constexpr double kRimPx = 4.0;  // next to the face's edges a shift of a tenth of a pixel is visible

/// Difference of the face from the reference in patches around every kPatchStepPx-th pixel.
struct Patches {
  cv::Mat mean;
  double noise;  ///< sd of a patch's mean by noise alone
};

constexpr int kPatchStepPx = 4;

/// Means of the valid part of an image over squares of `side` steps; NaN where less than half of
/// the square is known, or less than half of the step in its middle.
cv::Mat patch_means(const cv::Mat& x, int side) {
  const cv::Mat known = measured_pixels(x);
  cv::Mat weight, filled = x.clone();
  known.convertTo(weight, CV_32FC1, 1.0 / 255.0);
  filled.setTo(0.0F, ~known);
  constexpr double kStep = 1.0 / kPatchStepPx;
  cv::resize(filled, filled, {}, kStep, kStep, cv::INTER_AREA);
  cv::resize(weight, weight, {}, kStep, kStep, cv::INTER_AREA);
  const cv::Mat is_off = weight < 0.5F;
  cv::boxFilter(filled, filled, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_CONSTANT);
  cv::boxFilter(weight, weight, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_CONSTANT);
  cv::Mat mean = filled / weight;
  mean.setTo(std::numeric_limits<float>::quiet_NaN(), (weight < 0.5F) | is_off);
  return mean;
}

Patches patches_of(const Difference& difference, const FaceShape& shape, double grey_level) {
  std::vector<double> z;
  for (const FaceColumn& column : shape.columns())
    if (column.valid) z.push_back(column.z_mm);
  const double side_px = kPatchMm / shape.camera().mm_per_px_at(upper_median(z));
  const int side = std::max(1, static_cast<int>(std::lround(side_px / kPatchStepPx)));
  // Smoothing has already averaged over neighbours; a patch is wider than that.
  return {patch_means(difference.x, side),
          difference.grey_sd * 2.0 * std::sqrt(M_PI) / (kPatchStepPx * side * grey_level)};
}

class Study {
 public:
  Study(const ReferenceLibrary& library, const std::vector<StudyInput>& recorded,
        double frames_per_s)
      : library_(library), recorded_(recorded) {
    const double most =
        kMaxFraction * static_cast<double>(recorded.back().number - recorded.front().number + 1);
    gap_ = static_cast<std::size_t>(std::max(1.0, std::min(most, kMaxSeconds * frames_per_s)));
    apart_ = (library.frame_count() + kMaxCompared - 1) / kMaxCompared;
  }

  [[nodiscard]] bool is_compared(std::size_t index) const { return index % apart_ == 0; }

  /// grey: of a frame that is compared.
  [[nodiscard]] StudiedFrame frame(std::size_t index, const FaceShape& shape, const cv::Mat& grey,
                                   double noise_sd) const {
    StudiedFrame studied;
    studied.number = library_.frame_numbers()[index];
    const auto& [recorded, markers] = recorded_[index];
    for (std::size_t pair = 0; pair < markers.size() / 2; ++pair)
      studied.pairs.push_back(tip_pose(markers, pair, shape));
    if (!is_compared(index)) return studied;
    std::vector<char> without(library_.frame_count(), 0);
    for (std::size_t i = 0; i < without.size(); ++i) {
      const std::size_t other = recorded_[i].number;
      without[i] = static_cast<char>(other <= recorded + gap_ && recorded <= other + gap_);
    }
    if (std::count(without.begin(), without.end(), 0) < 2) return studied;
    const auto patches = compare(index, shape, grey, noise_sd, without);
    if (!patches) return studied;
    studied.compared = true;
    studied.error = mean_error(*patches);
    return studied;
  }

 private:
  [[nodiscard]] std::optional<Patches> compare(std::size_t index, const FaceShape& shape,
                                               const cv::Mat& grey, double noise_sd,
                                               const std::vector<char>& without) const {
    const Reference reference =
        library_.reference_for(recorded_[index].markers, shape, ReferenceMethod::kLocal, without);
    // Outside the others' poses the reference is extrapolated and does not count.
    if (!reference.known_pose || reference.noise_gain > 1.0) return std::nullopt;
    DifferenceOptions options;
    options.edge_margin_px = kRimPx;
    options.noise_sd = noise_sd;
    options.correct_light = true;
    const Difference compared = difference(grey, reference, shape, options);
    if (compared.face.runs.empty()) return std::nullopt;
    return patches_of(compared, shape, mean_brightness(grey, compared.face));
  }

  static double mean_error(const Patches& patches) {
    double square = 0, count = 0;
    for (int v = 0; v < patches.mean.rows; ++v)
      for (int u = 0; u < patches.mean.cols; ++u)
        if (const float x = patches.mean.at<float>(v, u); std::isfinite(x))
          square += static_cast<double>(x) * x, ++count;
    if (count == 0) return 0;
    // Of a normal distribution the mean magnitude is 0.8 of the standard deviation.
    return 0.8 * std::sqrt(std::max(0.0, square / count - patches.noise * patches.noise));
  }

  const ReferenceLibrary& library_;
  const std::vector<StudyInput>& recorded_;
  std::size_t gap_, apart_;
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
                                       const std::vector<StudyInput>& recorded,
                                       RecordedVideo& video, const Job& job) {
  const std::size_t count = library.frame_count();
  const Study study(library, recorded, video.reader.frames_per_s());
  RecordingStudy result;
  std::vector<cv::Mat> greys;
  for (std::size_t first = 0; first < count; first += kAtOnce) {
    if (job.stop_requested())
      return Error{en::say("stopped before the recording was compared"), "", ""};
    job.report(static_cast<double>(first) / static_cast<double>(count),
               en::say("comparing frame {} of {}", first + 1, count));
    greys.assign(std::min(kAtOnce, count - first), cv::Mat());
    for (std::size_t k = 0; k < greys.size(); ++k) {
      const auto number = static_cast<std::size_t>(library.frame_numbers()[first + k]);
      if (!study.is_compared(first + k) && !video.pass.edges[number].u.empty()) continue;
      auto grey = video.frame(number);
      if (!grey) return grey.error();
      greys[k] = std::move(*grey);
    }
    result.frames.resize(first + greys.size());
    parallel_for(static_cast<int>(greys.size()), default_threads(), [&](int from, int to) {
      for (int k = from; k < to; ++k) {
        const std::size_t i = first + static_cast<std::size_t>(k);
        StudiedFrame& studied = result.frames[i];
        studied.number = library.frame_numbers()[i];
        const cv::Mat& grey = greys[static_cast<std::size_t>(k)];
        const auto edges = video.edges(static_cast<std::size_t>(studied.number), grey);
        if (!edges) continue;
        const auto shape =
            FaceShape::fit(*edges, video.camera, video.finger.face, kDefaultProfileDegree);
        if (shape) studied = study.frame(i, *shape, grey, edges->noise_sd);
      }
    });
  }
  std::vector<double> errors;
  for (const StudiedFrame& studied : result.frames)
    if (studied.compared) errors.push_back(studied.error);
  result.error_median = quantile_of(errors, 0.5);
  result.error_p95 = quantile_of(errors, 0.95);
  return result;
}

}  // namespace alltact
