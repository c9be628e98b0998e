#include "core/sensing/reference/reference_library.h"

#include "core/base/cache.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "core/recording/video_file.h"
#include "core/sensing/reference/recorded_faces.h"
#include "core/sensing/reference/recorded_poses.h"
#include "core/sensing/reference/reference_image.h"

#include <limits>

#include <fmt/format.h>
#include <sys/stat.h>

namespace alltact {
namespace {

// below, a frame contributes nothing but narrows the valid columns
constexpr double kMinWeight = 2e-3;

Error wrong(Message what, const std::filesystem::path& file) {
  return {std::move(what), file.string(), en::say("create the reference again from the recording")};
}

/// Cache folder of a recording's faces, and the key of all their inputs.
struct CacheKey {
  std::filesystem::path folder;
  std::string made_from;
};

}  // namespace

struct ReferenceLibrary::Content {
  Content() = default;  // without faces: of a single image
  /// For faces whose drift and error are known or still to be estimated.
  Content(MarkerModel learnt, RecordedFaces&& read, const MarkerTable& table, const Finger& finger,
          const Camera& camera);
  /// Loads the faces that an earlier run saved; null: there are none.
  static std::shared_ptr<Content> from_cache(const CacheKey& key, MarkerModel learnt,
                                             const MarkerTable& table,
                                             const FingerSnapshot& snapshot);
  /// Reads the faces from the frames of a recording, and saves them where there is a `key`.
  static Result<std::shared_ptr<const Content>> from_frames(
      const RecordingInput& frames, MarkerModel learnt, const Finger& finger, const Camera& camera,
      const Job& job, std::size_t memory_limit_bytes, const std::optional<CacheKey>& key);
  /// From the cache, else from the video.
  static Result<std::shared_ptr<const Content>> read(const std::filesystem::path& video_file,
                                                     const MarkerTable& table,
                                                     const FingerSnapshot& snapshot,
                                                     const std::optional<CacheKey>& key,
                                                     const Job& job,
                                                     std::size_t memory_limit_bytes);
  /// Removes the drift of the light from the faces, and estimates the error of references.
  void analyse_faces();
  /// Saves the analysed faces for the next run; on failure that run reads the recording again.
  void save_cache(const CacheKey& key, std::vector<FoundFace> found,
                  const std::vector<std::size_t>& retained);
  /// The recorded frames nearest to a pose in the modes, and their weights there.
  [[nodiscard]] PoseNeighbours neighbours(const Eigen::VectorXd& pose,
                                          const std::vector<char>& without,
                                          int count = kPoseNeighbours) const;
  [[nodiscard]] FaceMix mix_of(const PoseNeighbours& neighbours) const;
  /// The frame in the middle of all poses, and the distance of the markers from it.
  [[nodiscard]] NearestFrame rest(const Markers& markers) const;
  /// Marks frames that do not show all of the skin which a frame (its warp) shows outside of the
  /// columns `shown` of the grid. Empty where there is no such skin, or too few frames show it.
  [[nodiscard]] std::vector<char> incomplete_frames(const ChartWarp& warp,
                                                    std::pair<int, int> shown,
                                                    const std::vector<char>& without,
                                                    int neighbours) const;

  cv::Size size;
  std::vector<int> frames;  // numbers in the video
  FaceGrid grid;
  SkinPositions positions;
  std::vector<FaceImage> faces;  // on the grid
  std::size_t bytes = 0;
  std::optional<MarkerModel> model;
  std::optional<TwistModel> twist;
  std::optional<ShapePoses> shape_poses;
  std::optional<LayoutSearch> search;
  Eigen::MatrixXd modes;  // of the frames, px, a row each
  Eigen::VectorXd mode_sd;
  EndLengths ends;
  ReferenceError error;
  double max_known_px = std::numeric_limits<double>::infinity();
  ReferenceImage single;  // empty for a recording
};

PoseNeighbours ReferenceLibrary::Content::neighbours(const Eigen::VectorXd& pose,
                                                     const std::vector<char>& without,
                                                     int count) const {
  PoseNeighbours near = pose_neighbours(modes, pose, model->marker_count(), without, count);
  std::vector<double> weights;
  std::vector<int> rows;
  double weight_sum = 0;
  for (std::size_t i = 0; i < near.rows.size(); ++i) {
    const double weight = near.weights[static_cast<Eigen::Index>(i)];
    if (std::abs(weight) < kMinWeight) continue;
    rows.push_back(near.rows[i]);
    weights.push_back(weight);
    weight_sum += weight;
  }
  near.rows = std::move(rows);
  near.weights =
      Eigen::Map<const Eigen::ArrayXd>(weights.data(), static_cast<Eigen::Index>(weights.size())) /
      weight_sum;
  return near;
}

FaceMix ReferenceLibrary::Content::mix_of(const PoseNeighbours& neighbours) const {
  FaceMix mix;
  for (std::size_t i = 0; i < neighbours.rows.size(); ++i) {
    mix.faces.push_back(&faces[static_cast<std::size_t>(neighbours.rows[i])]);
    mix.weights.push_back(static_cast<float>(neighbours.weights[static_cast<Eigen::Index>(i)]));
  }
  return mix;
}

NearestFrame ReferenceLibrary::Content::rest(const Markers& markers) const {
  Eigen::Index index = 0;
  modes.rowwise().squaredNorm().minCoeff(&index);
  std::vector<char> without(faces.size(), 1);
  without[static_cast<std::size_t>(index)] = 0;
  if (static_cast<int>(markers.size()) != model->marker_count())
    return {static_cast<int>(index), 0.0};
  return {static_cast<int>(index), search->nearest(markers, without).distance_px};
}

std::vector<char> ReferenceLibrary::Content::incomplete_frames(const ChartWarp& warp,
                                                               std::pair<int, int> shown,
                                                               const std::vector<char>& without,
                                                               int neighbours) const {
  if (warp.first() >= warp.end()) return {};
  const auto column = [&](float u) { return static_cast<int>(u) - grid.origin.x; };
  int first = std::max(0, column(warp.reach(warp.first()).first));
  int end = std::min(grid.size.width, column(warp.reach(warp.end() - 1).second) + 2);
  if (first >= shown.first && end <= shown.second) return {};
  // Limited to the columns that enough frames show.
  std::vector<int> firsts, face_ends;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!without.empty() && without[i]) continue;
    firsts.push_back(faces[i].first);
    face_ends.push_back(faces[i].end);
  }
  const auto required = static_cast<std::size_t>(neighbours);
  const std::size_t enough = 2 * required;
  if (firsts.size() < enough) return {};
  const auto nth = static_cast<std::ptrdiff_t>(enough);
  std::nth_element(firsts.begin(), firsts.begin() + nth - 1, firsts.end());
  std::nth_element(face_ends.begin(), face_ends.end() - nth, face_ends.end());
  first = std::max(first, firsts[enough - 1]);
  end = std::min(end, *(face_ends.end() - nth));
  std::vector<char> hidden(faces.size(), 0);
  std::size_t left = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    hidden[i] = static_cast<char>(faces[i].first > first || faces[i].end < end ||
                                  (!without.empty() && without[i]));
    left += !hidden[i];
  }
  return left >= required ? hidden : std::vector<char>();
}

namespace {

/// Variance of a pose from estimates of the markers, px^2.
double marker_variance(const Markers& markers) {
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

/// Key of all inputs of a library, as text; nullopt where a file's state is unavailable.
std::optional<std::string> made_from(const std::filesystem::path& video,
                                     const std::filesystem::path& table,
                                     const FingerSnapshot& snapshot,
                                     std::size_t memory_limit_bytes) {
  const Finger& finger = snapshot.finger;
  Finger key_finger;  // without the results of the library
  key_finger.name = "-";
  key_finger.camera = finger.camera;
  key_finger.face = finger.face;
  key_finger.markers = finger.markers;
  key_finger.reference = finger.reference;
  const auto yaml = key_finger.to_yaml();
  if (!yaml) return std::nullopt;
  std::string key = fmt::format("{} {} {}", memory_limit_bytes, snapshot.reduced_by, *yaml);
  for (const std::filesystem::path& file : {video, table}) {
    struct stat of {};
    if (stat(file.c_str(), &of) != 0) return std::nullopt;
    key += fmt::format(" {} {} {} {}.{}", of.st_dev, of.st_ino, of.st_size, of.st_mtim.tv_sec,
                       of.st_mtim.tv_nsec);
  }
  return key;
}

/// nullopt: the inputs have no key, or there is no cache.
std::optional<CacheKey> cache_key(const std::optional<std::string>& made_from) {
  static const std::string code =
      checksum_of_code(reinterpret_cast<const void*>(&read_recorded_faces));
  auto folder = cache_folder("faces");
  if (!made_from || !folder) return std::nullopt;
  return CacheKey{std::move(*folder), code + " " + *made_from};
}

Result<MarkerModel> learn_model(const MarkerTable& table, const Finger& finger,
                                const std::filesystem::path& video_file) {
  std::vector<int> missing;
  if (!finger.reference || !finger.reference->positions) missing = finger.markers.missing;
  auto model = MarkerModel::learn(seen_layouts(table, missing), table.typical, missing);
  if (!model) return Error{model.error().what, video_file.string(), model.error().advice};
  return model;
}

}  // namespace

Result<ReferenceLibrary> ReferenceLibrary::load(const FingerSnapshot& snapshot, const Job& job,
                                                std::size_t memory_limit_bytes) {
  const std::filesystem::path& finger_folder = snapshot.folder;
  const Finger& finger = snapshot.finger;
  if (finger.face.kind == FaceKind::kFlat) {
    const auto grey = flat_reference(snapshot);
    if (!grey) return grey.error();
    return single(*grey);
  }
  if (!finger.reference || finger.reference->video.empty() || finger.reference->markers.empty())
    return Error{en::say("the finger has no reference recording"),
                 (finger_folder / Finger::kFileName).string(),
                 en::say("record the untouched finger bending and create its reference")};
  const auto video_file = finger_folder / finger.reference->video;
  const auto table_file = finger_folder / finger.reference->markers;
  const auto key = made_from(video_file, table_file, snapshot, memory_limit_bytes);
  const auto read_content = [&]() -> Result<std::shared_ptr<const Content>> {
    const auto table = MarkerTable::load(table_file, finger.marker_count());
    if (!table) return table.error();
    return Content::read(video_file, reduced_table(*table, snapshot.reduced_by), snapshot,
                         cache_key(key), job, memory_limit_bytes);
  };
  static SharedValues<Content> shared;
  const Error stopped{en::say("stopped before the reference was read"), video_file, ""};
  auto content = key ? shared.get(*key, job, stopped, read_content) : read_content();
  if (!content) return content.error();
  return ReferenceLibrary(std::move(*content));
}

ReferenceLibrary::Content::Content(MarkerModel learnt, RecordedFaces&& read,
                                   const MarkerTable& table, const Finger& finger,
                                   const Camera& camera)
    : size(camera.size()),
      grid(std::move(read.grid)),
      positions(std::move(read.positions)),
      faces(std::move(read.faces)),
      bytes(read.bytes),
      model(std::move(learnt)),
      mode_sd(model->mode_sd_px()),
      ends(read.charts, camera.size().width) {
  const Eigen::MatrixXd layouts = table.layouts(read.retained, Eigen::all);
  for (const std::size_t row : read.retained) frames.push_back(table.frames[row]);
  const bool has_dots = !finger.reference || !finger.reference->positions;
  if (has_dots) {
    twist = TwistModel::learn(read.poses);
    shape_poses = ShapePoses::learn(read.edges, table.layouts(read.seen, Eigen::all));
  }
  modes.resize(layouts.rows(), mode_sd.size());
  const std::vector<char> all_seen(static_cast<std::size_t>(layouts.cols() / 2), 1);
  for (Eigen::Index i = 0; i < layouts.rows(); ++i)
    modes.row(i) = model->modes(markers_of(layouts, i, all_seen)).cwiseProduct(mode_sd).transpose();
  search.emplace(layouts);
  max_known_px = known_distance_px(*search);
  if (positions.tip)
    positions.tip->max_missing_mm = ends.tip_tolerance_mm(grid.chart.base_at_low_u);
}

void ReferenceLibrary::Content::analyse_faces() {
  remove_drift(grid, modes, faces);
  error = reference_error(grid, faces, [&](int i) {
    std::vector<char> without(faces.size(), 0);
    without[static_cast<std::size_t>(i)] = 1;
    return neighbours(modes.row(i).transpose(), without);
  });
}

std::shared_ptr<ReferenceLibrary::Content> ReferenceLibrary::Content::from_cache(
    const CacheKey& key, MarkerModel learnt, const MarkerTable& table,
    const FingerSnapshot& snapshot) {
  auto cached = load_faces(key.folder, key.made_from);
  if (!cached) return nullptr;
  ReferenceError error = cached->error;
  auto faces =
      recorded_faces_from_cache(std::move(*cached), table, snapshot.finger, snapshot.camera);
  if (!faces) return nullptr;
  auto content = std::make_shared<Content>(std::move(learnt), std::move(*faces), table,
                                           snapshot.finger, snapshot.camera);
  content->error = std::move(error);
  return content;
}

void ReferenceLibrary::Content::save_cache(const CacheKey& key, std::vector<FoundFace> found,
                                           const std::vector<std::size_t>& retained) {
  if (found.empty()) return;
  FaceCache cache{std::move(found), retained, std::move(faces), error};
  static_cast<void>(save_faces(key.folder, key.made_from, cache));
  faces = std::move(cache.faces);
}

Result<std::shared_ptr<const ReferenceLibrary::Content>> ReferenceLibrary::Content::from_frames(
    const RecordingInput& frames, MarkerModel learnt, const Finger& finger, const Camera& camera,
    const Job& job, std::size_t memory_limit_bytes, const std::optional<CacheKey>& key) {
  auto faces = read_recorded_faces(frames, finger, camera, memory_limit_bytes, job);
  if (!faces) return faces.error();
  auto found = std::move(faces->found);
  const auto retained = faces->retained;
  auto content =
      std::make_shared<Content>(std::move(learnt), std::move(*faces), frames.table, finger, camera);
  content->analyse_faces();
  if (key) content->save_cache(*key, std::move(found), retained);
  return std::shared_ptr<const Content>(std::move(content));
}

Result<std::shared_ptr<const ReferenceLibrary::Content>> ReferenceLibrary::Content::read(
    const std::filesystem::path& video_file, const MarkerTable& table,
    const FingerSnapshot& snapshot, const std::optional<CacheKey>& key, const Job& job,
    std::size_t memory_limit_bytes) {
  auto model = learn_model(table, snapshot.finger, video_file);
  if (!model) return model.error();
  if (key)
    if (auto content = from_cache(*key, *model, table, snapshot))
      return std::shared_ptr<const Content>(std::move(content));
  auto video = VideoFile::open(video_file, job);
  if (!video)
    return wrong(en::say("the reference recording is missing or not a video"), video_file);
  const auto frame = [&](std::size_t number) -> Result<cv::Mat> {
    const auto read = video->frame(number);
    if (!read) return read.error();
    return image_for(snapshot, (*read)->grey, en::say("the recording's image"), "", "");
  };
  return from_frames({frame, video->frame_count(), video_file, table}, std::move(*model),
                     snapshot.finger, snapshot.camera, job, memory_limit_bytes, key);
}

Result<ReferenceLibrary> ReferenceLibrary::from_frames(const RecordingInput& frames,
                                                       const Finger& finger, const Camera& camera,
                                                       const Job& job,
                                                       std::size_t memory_limit_bytes) {
  auto model = learn_model(frames.table, finger, frames.video);
  if (!model) return model.error();
  auto content = Content::from_frames(frames, std::move(*model), finger, camera, job,
                                      memory_limit_bytes, std::nullopt);
  if (!content) return content.error();
  return ReferenceLibrary(std::move(*content));
}

Result<ReferenceLibrary> ReferenceLibrary::from_faces(RecordedFaces faces, const MarkerTable& table,
                                                      const Finger& finger, const Camera& camera,
                                                      const std::filesystem::path& video) {
  auto model = learn_model(table, finger, video);
  if (!model) return model.error();
  auto content =
      std::make_shared<Content>(std::move(*model), std::move(faces), table, finger, camera);
  content->analyse_faces();
  return ReferenceLibrary(std::move(content));
}

Result<ReferenceLibrary> ReferenceLibrary::single(const cv::Mat& grey) {
  if (grey.empty() || grey.type() != CV_8UC1)
    return Error{en::say("the reference image is not an 8-bit grey image"), en::say("reference"),
                 en::say("save it in this format")};
  auto content = std::make_shared<Content>();
  content->size = grey.size();
  cv::Mat levels;
  grey.convertTo(levels, CV_32F);
  content->single = ReferenceImage(levels);
  content->bytes = content->single.memory_bytes();
  return ReferenceLibrary(std::move(content));
}

std::size_t ReferenceLibrary::frame_count() const {
  return content_->search ? content_->frames.size() : 1;
}

std::size_t ReferenceLibrary::memory_bytes() const { return content_->bytes; }

const MarkerModel* ReferenceLibrary::marker_model() const {
  return content_->model ? &*content_->model : nullptr;
}

const TwistModel* ReferenceLibrary::twist_model() const {
  return content_->twist ? &*content_->twist : nullptr;
}

const ShapePoses* ReferenceLibrary::shape_poses() const {
  return content_->shape_poses ? &*content_->shape_poses : nullptr;
}

const std::vector<int>& ReferenceLibrary::frame_numbers() const { return content_->frames; }

NearestFrame ReferenceLibrary::nearest(const Markers& markers,
                                       const std::vector<char>& without) const {
  if (!content_->search || static_cast<int>(markers.size()) != content_->model->marker_count())
    return {};
  return content_->search->nearest(markers, without);
}

double ReferenceLibrary::combined_distance_px(const Markers& markers,
                                              const std::vector<char>& without) const {
  const Content& content = *content_;
  if (!content.search || static_cast<int>(markers.size()) != content.model->marker_count())
    return nearest(markers, without).distance_px;
  const PoseNeighbours near =
      content.neighbours(content.model->modes(markers).cwiseProduct(content.mode_sd), without);
  return content.search->distance_px(markers, near.rows, near.weights);
}

Reference ReferenceLibrary::reference_for(const Markers& markers, const FaceShape& shape,
                                          ReferenceMethod method, const std::vector<char>& without,
                                          int neighbours) const {
  Reference reference;
  const Content& content = *content_;
  if (!content.search) {
    reference.image = content.single;
    reference.frame = 0;
    return reference;
  }
  reference.relative_sd = content.error.relative_sd;
  const bool is_single = method == ReferenceMethod::kSingle;
  const NearestFrame found = is_single ? content.rest(markers) : nearest(markers, without);
  reference.frame = content.frames[static_cast<std::size_t>(found.row)];
  reference.distance_px = found.distance_px;
  reference.known_pose = found.distance_px <= content.max_known_px;
  reference.by_shape = seen_count(markers) == 0;
  auto now = chart_of(shape);
  if (now && now->base_at_low_u == content.grid.chart.base_at_low_u)
    register_chart(content.positions, shape, markers, &*now);
  else
    now = FaceChart{};
  if (is_single) now = content.grid.chart;
  if (!now->along_mm.empty())
    reference.hidden = content.ends.hidden_columns(*now, content.size.width);
  reference.registration_sd_px = registration_sd_px(*now, content.size.width);
  ChartWarp warp(*now, content.grid.chart);
  std::vector<FaceMix> mixes{{{&content.faces[static_cast<std::size_t>(found.row)]}, {1.0F}}};
  if (method == ReferenceMethod::kLocal) {
    const Eigen::VectorXd pose = content.model->modes(markers).cwiseProduct(content.mode_sd);
    const PoseNeighbours near = content.neighbours(pose, without, neighbours);
    const double marker_variance_px2 = reference.by_shape ? marker_variance(markers) : 0.0;
    mixes = {content.mix_of(near)};
    reference.error_factor = reference.outer_error_factor =
        content.error.factor(near.reach_px2 + marker_variance_px2);
    const auto incomplete_frames =
        content.incomplete_frames(warp, mixes.front().shown(content.grid), without, neighbours);
    if (!incomplete_frames.empty()) {
      const PoseNeighbours further = content.neighbours(pose, incomplete_frames, neighbours);
      mixes.push_back(content.mix_of(further));
      reference.outer_error_factor = content.error.factor(further.reach_px2 + marker_variance_px2);
    }
  }
  double square = 0;
  for (const float w : mixes.front().weights) square += static_cast<double>(w) * w;
  reference.noise_gain = std::sqrt(square);
  reference.image = ReferenceImage(content.grid, mixes, std::move(warp), content.size);
  return reference;
}

Result<cv::Mat> flat_reference(const FingerSnapshot& snapshot) {
  const Finger& finger = snapshot.finger;
  if (!finger.reference || finger.reference->image.empty())
    return Error{en::say("the sensor has no untouched image"),
                 (snapshot.folder / Finger::kFileName).string(),
                 en::say("specify one for the calibration")};
  const auto file = snapshot.folder / finger.reference->image;
  const auto raw = read_grey_image(file);
  if (!raw) return raw.error();
  return image_for(snapshot, *raw, en::say("the untouched image"), file.string(),
                   en::say("specify the untouched image again"));
}

}  // namespace alltact
