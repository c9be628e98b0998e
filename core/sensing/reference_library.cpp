#include "core/sensing/reference_library.h"

#include "core/io/picture.h"
#include "core/numerics/farthest_points.h"
#include "core/recording/video_file.h"
#include "core/sensing/face_edges.h"
#include "core/sensing/face_picture.h"
#include "core/sensing/layout_search.h"
#include "core/sensing/reference_error.h"
#include "core/sensing/reference_weights.h"

#include <limits>
#include <numeric>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kBeyondRest = 0.15;  // of the rest frame's face: how much more others may show
constexpr int kProfileDegree = 7;
constexpr std::size_t kMostPoses = 160;  // that the finger's twist is learnt from
constexpr double kMarkerSdPx = 0.1;      // of recorded markers, as measured
constexpr double kLeastWeight = 2e-3;    // below, a frame says nothing but narrows what is valid

constexpr const char* kAdvice = "make the reference anew from the recording";

Error wrong(std::string what, const std::filesystem::path& file) {
  return {std::move(what), file.string(), kAdvice};
}

}  // namespace

struct ReferenceLibrary::Content {
  /// The recorded frames nearest to a place in the modes, and their weights there.
  [[nodiscard]] Neighbours neighbours(const Eigen::VectorXd& place,
                                      const std::vector<char>& without) const;
  [[nodiscard]] FaceMix mix_of(const Neighbours& neighbours) const;
  /// Frames that do not show some of the skin that a frame (its warp) shows beyond the columns
  /// `shown` of the grid; empty where there is none such, or too few frames show it.
  [[nodiscard]] std::vector<char> hiding(const ChartWarp& warp,
                                         std::pair<int, int> shown,
                                         const std::vector<char>& without) const;

  cv::Size size;
  std::vector<int> frames;  // numbers in the video
  FaceGrid grid;
  SkinPlaces places;
  std::vector<FacePicture> faces;  // on the grid
  std::size_t bytes = 0;
  std::optional<MarkerModel> model;
  std::optional<TwistModel> twist;
  std::optional<ShapePoses> shape_poses;
  std::optional<LayoutSearch> search;
  Eigen::MatrixXd modes;  // of the frames, px, a row each
  Eigen::VectorXd mode_sd;
  ReferenceError error;
  double known_px = std::numeric_limits<double>::infinity();
  ReferencePicture single;  // empty for a recording
};

Neighbours ReferenceLibrary::Content::neighbours(const Eigen::VectorXd& place,
                                                 const std::vector<char>& without) const {
  const PoseNeighbours near = pose_neighbours(modes, place, model->marker_count(), without);
  const Eigen::VectorXd& w = near.weights;
  Neighbours found;
  found.reach_px2 = reach_px2(near.points, place, w);
  double kept = 0;
  for (Eigen::Index i = 0; i < w.size(); ++i)
    if (std::abs(w[i]) >= kLeastWeight) kept += w[i];
  std::vector<double> weights;
  for (Eigen::Index i = 0; i < w.size(); ++i) {
    if (std::abs(w[i]) < kLeastWeight) continue;
    found.rows.push_back(near.rows[static_cast<std::size_t>(i)]);
    weights.push_back(w[i] / kept);
  }
  found.weights =
      Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size()));
  return found;
}

FaceMix ReferenceLibrary::Content::mix_of(const Neighbours& neighbours) const {
  FaceMix mix;
  for (std::size_t i = 0; i < neighbours.rows.size(); ++i) {
    mix.faces.push_back(&faces[static_cast<std::size_t>(neighbours.rows[i])]);
    mix.weights.push_back(static_cast<float>(neighbours.weights[static_cast<Eigen::Index>(i)]));
  }
  return mix;
}

std::vector<char> ReferenceLibrary::Content::hiding(const ChartWarp& warp,
                                                    std::pair<int, int> shown,
                                                    const std::vector<char>& without) const {
  if (warp.first() >= warp.end()) return {};
  const auto column = [&](float u) { return static_cast<int>(u) - grid.origin.x; };
  int first = std::max(0, column(warp.reach(warp.first()).first));
  int end = std::min(grid.size.width, column(warp.reach(warp.end() - 1).second) + 2);
  if (first >= shown.first && end <= shown.second) return {};
  // As much of that as enough frames show.
  std::vector<int> firsts, ends;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!without.empty() && without[i]) continue;
    firsts.push_back(faces[i].first);
    ends.push_back(faces[i].end);
  }
  constexpr std::size_t kEnough = 2 * kPoseNeighbours;
  if (firsts.size() < kEnough) return {};
  std::nth_element(firsts.begin(), firsts.begin() + kEnough - 1, firsts.end());
  std::nth_element(ends.begin(), ends.end() - kEnough, ends.end());
  first = std::max(first, firsts[kEnough - 1]);
  end = std::min(end, *(ends.end() - kEnough));
  std::vector<char> hidden(faces.size(), 0);
  std::size_t left = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    hidden[i] = faces[i].first > first || faces[i].end < end || (!without.empty() && without[i]);
    left += !hidden[i];
  }
  return left >= kPoseNeighbours ? hidden : std::vector<char>();
}

namespace {

// Faces of a recording within a limit: where it is passed, the frame that covers least goes first.
class Keeper {
 public:
  Keeper(const MarkerTable& table, std::size_t limit)
      : table_(table), limit_(limit), faces_(table.frames.size()) {}

  void add(std::size_t row, FacePicture face) {
    bytes_ += face.bytes();
    faces_[row] = std::move(face);
    if (bytes_ > limit_ && rank_.empty()) rank_frames();
    while (bytes_ > limit_ && kept() > 2) drop_one();
  }

  [[nodiscard]] std::vector<std::size_t> rows() const {
    std::vector<std::size_t> kept;
    for (std::size_t row = 0; row < faces_.size(); ++row)
      if (faces_[row]) kept.push_back(row);
    return kept;
  }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  FacePicture take(std::size_t row) { return std::move(*faces_[row]); }

 private:
  [[nodiscard]] std::size_t kept() const { return rows().size(); }
  void rank_frames() {
    rank_ = farthest_point_order(table_.layouts, static_cast<int>(faces_.size()));
  }
  void drop_one() {
    while (!rank_.empty()) {
      // The last of the covering order among those already read.
      const auto last = std::find_if(rank_.rbegin(), rank_.rend(), [&](int row) {
        return faces_[static_cast<std::size_t>(row)].has_value();
      });
      if (last == rank_.rend()) return;
      auto& face = faces_[static_cast<std::size_t>(*last)];
      bytes_ -= face->bytes();
      face.reset();
      return;
    }
  }

  const MarkerTable& table_;
  std::size_t limit_, bytes_ = 0;
  std::vector<std::optional<FacePicture>> faces_;
  std::vector<int> rank_;
};

Markers as_markers(const Eigen::MatrixXd& layouts,
                   Eigen::Index row,
                   const std::vector<char>& seen) {
  Markers markers(static_cast<std::size_t>(layouts.cols() / 2));
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const auto k = static_cast<Eigen::Index>(2 * m);
    markers[m] = {layouts(row, k), layouts(row, k + 1), seen[m] != 0, kMarkerSdPx};
  }
  return markers;
}

/// The frames of a recording as they are read for the library.
struct Reading {
  const FrameOfRecording& frame;
  std::size_t frame_count;
  const std::filesystem::path& video;
  const MarkerTable& table;
  const Finger& finger;
  const Camera& camera;
  FaceEdgeFinder finder{{.view = FaceView{camera, finger.face.width_mm}}};

  [[nodiscard]] Result<cv::Mat> picture(std::size_t row) const {
    const auto number = static_cast<std::size_t>(table.frames[row]);
    if (number >= frame_count)
      return wrong(
          fmt::format("the marker table names frame {} but the recording ends after {} frames",
                      number,
                      frame_count),
          video);
    auto grey = frame(number);
    if (!grey) return wrong(grey.error().what, video);
    return grey;
  }
  struct Looked {
    FaceShape shape;
    FaceChart chart;
  };
  [[nodiscard]] std::optional<Looked> look_at(const cv::Mat& grey) const {
    const auto edges = finder(grey);
    if (!edges) return std::nullopt;
    const auto shape = FaceShape::fit(*edges, camera, finger.face, kProfileDegree);
    if (!shape) return std::nullopt;
    auto chart = chart_of(*shape);
    if (!chart) return std::nullopt;
    return Looked{*shape, std::move(*chart)};
  }
  [[nodiscard]] Markers markers(std::size_t row) const {
    return as_markers(table.layouts, static_cast<Eigen::Index>(row), table.seen[row]);
  }
};

/// The frame nearest to the middle of all poses in which the face is found, and its chart.
struct Rest {
  FaceChart chart;
  SkinPlaces places;
};
Result<Rest> find_rest(const Reading& reading) {
  constexpr std::size_t kTries = 16;
  const Eigen::MatrixXd& layouts = reading.table.layouts;
  const Eigen::VectorXd off =
      (layouts.rowwise() - layouts.colwise().mean()).rowwise().squaredNorm();
  std::vector<std::size_t> rows(static_cast<std::size_t>(layouts.rows()));
  std::iota(rows.begin(), rows.end(), 0);
  std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return off[static_cast<Eigen::Index>(a)] < off[static_cast<Eigen::Index>(b)];
  });
  rows.resize(std::min(rows.size(), kTries));
  for (const std::size_t row : rows) {
    const auto grey = reading.picture(row);
    if (!grey) return grey.error();
    if (const auto looked = reading.look_at(*grey))
      return Rest{looked->chart, skin_places(looked->chart, looked->shape, reading.markers(row))};
  }
  return wrong(fmt::format("the face was found in {} of {} recorded pictures; 2 are needed",
                           0,
                           reading.table.frames.size()),
               reading.video);
}

/// The edges of every recorded face, and the row of the marker table that is of the same frame.
struct RecordedShapes {
  std::vector<EdgeCurves> curves;
  std::vector<Eigen::Index> rows;
};

Status read_faces(const Reading& reading,
                  const FaceGrid& grid,
                  const SkinPlaces& places,
                  const Job& job,
                  Keeper& keeper,
                  std::vector<TwistModel::Pose>& poses,
                  RecordedShapes& shapes) {
  const std::size_t count = reading.table.frames.size();
  const std::size_t every = count / kMostPoses + 1;
  for (std::size_t row = 0; row < count; ++row) {
    if (job.stop_requested())
      return Error{"stopped before the reference was read", reading.video.string(), ""};
    if (row % 16 == 0)
      job.report(static_cast<double>(row) / static_cast<double>(count),
                 fmt::format("reading reference frame {} of {}", row + 1, count));
    const auto grey = reading.picture(row);
    if (!grey) return grey.error();
    auto looked = reading.look_at(*grey);
    if (!looked || looked->chart.base_at_low_u != grid.chart.base_at_low_u) continue;
    lay_on(places, looked->shape, reading.markers(row), &looked->chart);
    keeper.add(row, keep_face(*grey, looked->chart, grid));
    shapes.rows.push_back(static_cast<Eigen::Index>(row));
    shapes.curves.push_back(edge_curves(looked->shape));
    if (row % every == 0) poses.push_back({reading.markers(row), std::move(looked->shape)});
  }
  return {};
}

/// How far off a pose may be, in squares, that is told by estimates of the markers, px^2.
double squares_of_sds(const Markers& markers) {
  double square = 0;
  for (const Marker& marker : markers) square += 2.0 * marker.sd_px * marker.sd_px;
  return square;
}

Eigen::MatrixXd seen_layouts(const MarkerTable& table, const std::vector<int>& missing) {
  Eigen::MatrixXd layouts = table.layouts;
  const auto is_missing = [&](std::size_t m) {
    return std::binary_search(missing.begin(), missing.end(), static_cast<int>(m));
  };
  for (std::size_t i = 0; i < table.seen.size(); ++i)
    for (std::size_t m = 0; m < table.seen[i].size(); ++m)
      if (!table.seen[i][m] && !is_missing(m))
        layouts.block<1, 2>(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(2 * m))
            .setConstant(std::numeric_limits<double>::quiet_NaN());
  return layouts;
}

/// The untouched picture that a flat sensor's finger names.
Result<cv::Mat> flat_picture(const std::filesystem::path& finger_folder, const Finger& finger) {
  if (!finger.reference || finger.reference->image.empty())
    return Error{"the sensor has no untouched picture",
                 (finger_folder / Finger::kFileName).string(),
                 "give one with the calibration"};
  const auto file = finger_folder / finger.reference->image;
  const auto raw = read_grey_picture(file);
  if (!raw) return raw.error();
  return oriented_for(finger.camera,
                      *raw,
                      "the untouched picture",
                      file.string(),
                      "give the untouched picture anew");
}

}  // namespace

Result<ReferenceLibrary> ReferenceLibrary::load(const std::filesystem::path& finger_folder,
                                                const Finger& finger,
                                                const Camera& camera,
                                                const Job& job,
                                                std::size_t memory_limit_bytes) {
  if (finger.face.kind == FaceKind::kFlat) {
    const auto grey = flat_picture(finger_folder, finger);
    if (!grey) return grey.error();
    return single(*grey);
  }
  if (!finger.reference || finger.reference->video.empty() || finger.reference->markers.empty())
    return Error{"the finger has no reference recording",
                 (finger_folder / Finger::kFileName).string(),
                 "record the bending, untouched finger and make its reference"};
  const auto table_file = finger_folder / finger.reference->markers;
  const auto table = MarkerTable::load(table_file, finger.marker_count());
  if (!table) return table.error();
  return from_recording(
      finger_folder / finger.reference->video, *table, finger, camera, job, memory_limit_bytes);
}

Result<ReferenceLibrary> ReferenceLibrary::from_recording(const std::filesystem::path& video_file,
                                                          const MarkerTable& table,
                                                          const Finger& finger,
                                                          const Camera& camera,
                                                          const Job& job,
                                                          std::size_t memory_limit_bytes) {
  auto video = VideoFile::open(video_file, job);
  if (!video) return wrong("the reference recording is missing or no video", video_file);
  const auto frame = [&](std::size_t number) -> Result<cv::Mat> {
    const auto read = video->frame(number);
    if (!read) return read.error();
    return oriented_for(finger.camera, (*read)->grey, "the recording's picture", "", "");
  };
  return from_frames(
      frame, video->frame_count(), video_file, table, finger, camera, job, memory_limit_bytes);
}

Result<ReferenceLibrary> ReferenceLibrary::from_frames(const FrameOfRecording& frame,
                                                       std::size_t frame_count,
                                                       const std::filesystem::path& video_file,
                                                       const MarkerTable& table,
                                                       const Finger& finger,
                                                       const Camera& camera,
                                                       const Job& job,
                                                       std::size_t memory_limit_bytes) {
  std::vector<int> missing;
  if (!finger.reference || !finger.reference->places) missing = finger.markers.missing;
  auto model = MarkerModel::learn(seen_layouts(table, missing), table.typical, missing);
  if (!model) return Error{model.error().what, video_file.string(), model.error().advice};
  auto content = std::make_shared<Content>();
  Keeper keeper(table, memory_limit_bytes);
  std::vector<TwistModel::Pose> poses;
  RecordedShapes shapes;
  try {
    const Reading reading{frame, frame_count, video_file, table, finger, camera};
    const auto rest = find_rest(reading);
    if (!rest) return rest.error();
    content->grid = face_grid(rest->chart, kBeyondRest);
    content->places = rest->places;
    const Status read =
        read_faces(reading, content->grid, content->places, job, keeper, poses, shapes);
    if (!read) return read.error();
  } catch (const std::exception& problem) {
    return wrong(fmt::format("the recording cannot be read ({})", problem.what()), video_file);
  }
  const auto rows = keeper.rows();
  if (rows.size() < 2)
    return wrong(fmt::format("the face was found in {} of {} recorded pictures; 2 are needed",
                             rows.size(),
                             table.frames.size()),
                 video_file);
  content->size = camera.size();
  content->bytes = keeper.bytes();
  Eigen::MatrixXd layouts(static_cast<Eigen::Index>(rows.size()), table.layouts.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    layouts.row(static_cast<Eigen::Index>(i)) =
        table.layouts.row(static_cast<Eigen::Index>(rows[i]));
    content->frames.push_back(table.frames[rows[i]]);
    content->faces.push_back(keeper.take(rows[i]));
  }
  const bool has_dots = !finger.reference || !finger.reference->places;
  if (has_dots) {
    content->twist = TwistModel::learn(poses);
    content->shape_poses = ShapePoses::learn(shapes.curves, table.layouts(shapes.rows, Eigen::all));
  }
  content->model = std::move(*model);
  content->mode_sd = content->model->mode_sd_px();
  content->modes.resize(layouts.rows(), content->mode_sd.size());
  const std::vector<char> all_seen(static_cast<std::size_t>(layouts.cols() / 2), 1);
  for (Eigen::Index i = 0; i < layouts.rows(); ++i)
    content->modes.row(i) = content->model->modes(as_markers(layouts, i, all_seen))
                                .cwiseProduct(content->mode_sd)
                                .transpose();
  content->search.emplace(layouts);
  take_out_drift(content->grid, content->modes, content->faces);
  content->error = reference_error(content->grid, content->faces, [&](int i) {
    std::vector<char> without(content->faces.size(), 0);
    without[static_cast<std::size_t>(i)] = 1;
    return content->neighbours(content->modes.row(i).transpose(), without);
  });
  content->known_px = known_distance_px(*content->search);
  ReferenceLibrary library;
  library.content_ = std::move(content);
  return library;
}

Result<ReferenceLibrary> ReferenceLibrary::single(const cv::Mat& grey) {
  if (grey.empty() || grey.type() != CV_8UC1)
    return Error{
        "the reference picture is not an 8-bit grey picture", "reference", "save it as such"};
  auto content = std::make_shared<Content>();
  content->size = grey.size();
  cv::Mat levels;
  grey.convertTo(levels, CV_32F);
  content->single = ReferencePicture(levels);
  content->bytes = content->single.memory_bytes();
  ReferenceLibrary library;
  library.content_ = std::move(content);
  return library;
}

std::size_t ReferenceLibrary::frame_count() const {
  return content_->search ? content_->frames.size() : 1;
}

std::size_t ReferenceLibrary::memory_bytes() const {
  return content_->bytes;
}

const MarkerModel* ReferenceLibrary::marker_model() const {
  return content_->model ? &*content_->model : nullptr;
}

const TwistModel* ReferenceLibrary::twist_model() const {
  return content_->twist ? &*content_->twist : nullptr;
}

const ShapePoses* ReferenceLibrary::shape_poses() const {
  return content_->shape_poses ? &*content_->shape_poses : nullptr;
}

const std::vector<int>& ReferenceLibrary::frame_numbers() const {
  return content_->frames;
}

ReferenceLibrary::Nearest ReferenceLibrary::nearest(const Markers& markers,
                                                    const std::vector<char>& without) const {
  if (!content_->search || static_cast<int>(markers.size()) != content_->model->marker_count())
    return {0, 0.0};
  const auto found = content_->search->nearest(markers, without);
  return {found.row, found.distance_px};
}

Reference ReferenceLibrary::reference_for(const Markers& markers,
                                          const FaceShape& shape,
                                          ReferenceMethod method,
                                          const std::vector<char>& without) const {
  Reference reference;
  const Content& content = *content_;
  if (!content.search) {
    reference.picture = content.single;
    reference.frame = 0;
    return reference;
  }
  reference.relative_sd = content.error.relative_sd;
  const Nearest found = nearest(markers, without);
  reference.frame = content.frames[static_cast<std::size_t>(found.index)];
  reference.distance_px = found.distance_px;
  reference.known_pose = found.distance_px <= content.known_px;
  reference.by_shape =
      std::none_of(markers.begin(), markers.end(), [](const Marker& m) { return m.seen; });
  auto now = chart_of(shape);
  if (now && now->base_at_low_u == content.grid.chart.base_at_low_u)
    lay_on(content.places, shape, markers, &*now);
  else
    now = FaceChart{};
  ChartWarp warp(*now, content.grid.chart);
  std::vector<FaceMix> mixes{{{&content.faces[static_cast<std::size_t>(found.index)]}, {1.0F}}};
  if (method == ReferenceMethod::kLocal) {
    const Eigen::VectorXd place = content.model->modes(markers).cwiseProduct(content.mode_sd);
    const Neighbours near = content.neighbours(place, without);
    const double unsure_px2 = reference.by_shape ? squares_of_sds(markers) : 0.0;
    mixes = {content.mix_of(near)};
    reference.error_factor = reference.outer_error_factor =
        content.error.factor(near.reach_px2 + unsure_px2);
    const auto hiding = content.hiding(warp, mixes.front().shown(content.grid), without);
    if (!hiding.empty()) {
      const Neighbours further = content.neighbours(place, hiding);
      mixes.push_back(content.mix_of(further));
      reference.outer_error_factor = content.error.factor(further.reach_px2 + unsure_px2);
    }
  }
  double square = 0;
  for (const float w : mixes.front().weights) square += static_cast<double>(w) * w;
  reference.noise_gain = std::sqrt(square);
  reference.picture = ReferencePicture(content.grid, mixes, std::move(warp), content.size);
  return reference;
}

}  // namespace alltact
