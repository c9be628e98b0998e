#include "core/sensing/reference/recorded_faces.h"

#include "core/numerics/farthest_points.h"
#include "core/numerics/parts.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/profile_degree.h"

#include <array>
#include <functional>
#include <future>
#include <numeric>
#include <queue>

namespace alltact {
namespace {

constexpr double kBeyondRest = 0.15;     // of the rest frame's face: how much more others may show
constexpr std::size_t kMostPoses = 160;  // that the finger's twist is learnt from
constexpr std::size_t kAtOnce = 16;      // frames that are held and looked at side by side

// Faces of a recording within a limit: where it is passed, the frame that covers least goes first.
class Keeper {
 public:
  Keeper(const MarkerTable& table, std::size_t limit)
      : table_(table), limit_(limit), faces_(table.frames.size()) {}

  void add(std::size_t row, FacePicture face) {
    bytes_ += face.bytes();
    faces_[row] = std::move(face);
    if (rank_.empty()) {
      kept_.push_back(row);
      if (bytes_ > limit_) rank_frames();
    } else {
      push(row);
    }
    while (bytes_ > limit_ && last_first_.size() > 2) drop_one();
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
  /// Place of each row in the covering order. The order of all takes the square of their number,
  /// days for a hundred thousand; more than twice as many as fit by now will not be kept, and all
  /// behind those go in the order of the recording, the last first.
  void rank_frames() {
    const std::size_t count = std::min(faces_.size(), 2 * kept_.size());
    const std::vector<int> order = farthest_point_order(table_.layouts, static_cast<int>(count));
    rank_.resize(faces_.size());
    for (std::size_t row = 0; row < rank_.size(); ++row) rank_[row] = count + row;
    for (std::size_t i = 0; i < order.size(); ++i) rank_[static_cast<std::size_t>(order[i])] = i;
    for (const std::size_t row : kept_) push(row);
  }
  void push(std::size_t row) { last_first_.emplace(rank_[row], row); }
  /// The last of the covering order among those already read.
  void drop_one() {
    auto& face = faces_[last_first_.top().second];
    last_first_.pop();
    bytes_ -= face->bytes();
    face.reset();
  }

  const MarkerTable& table_;
  std::size_t limit_, bytes_ = 0;
  std::vector<std::optional<FacePicture>> faces_;
  std::vector<std::size_t> kept_;  // rows, until they are ranked
  std::vector<std::size_t> rank_;  // of each row; empty: the limit was never passed
  std::priority_queue<std::pair<std::size_t, std::size_t>> last_first_;  // rank and row
};

struct Looked {
  FaceShape shape;
  FaceChart chart;
};

/// What is made of a recorded face's edges, whether they were found now or kept.
class FaceLayer {
 public:
  FaceLayer(const MarkerTable& table, const Finger& finger, const Camera& camera)
      : table_(table), finger_(finger), camera_(camera) {}

  [[nodiscard]] std::optional<Looked> look_at(const FaceEdges& edges) const {
    auto shape = FaceShape::fit(edges, camera_, finger_.face, kUsualProfileDegree);
    if (!shape) return std::nullopt;
    auto chart = chart_of(*shape);
    if (!chart) return std::nullopt;
    return Looked{std::move(*shape), std::move(*chart)};
  }
  /// The grid of the first face in a row from the middle of all poses outwards: `face_of` gives a
  /// row's, nullopt where there is none. Whether one was found; errors: those of `face_of`.
  template <class FaceOf>
  Result<bool> find_rest(const FaceOf& face_of, RecordedFaces& read) const {
    constexpr std::size_t kTries = 16;
    std::vector<std::size_t> rows = from_the_middle();
    rows.resize(std::min(rows.size(), kTries));
    for (const std::size_t row : rows) {
      const Result<std::optional<Looked>> looked = face_of(row);
      if (!looked) return looked.error();
      if (!*looked) continue;
      read.grid = face_grid((*looked)->chart, kBeyondRest);
      read.places = skin_places((*looked)->chart, (*looked)->shape, markers(row));
      return true;
    }
    return false;
  }
  /// Lays a row's chart on the rest frame's. False: it shows the finger the other way round.
  bool lay(const RecordedFaces& read, std::size_t row, Looked& looked) const {
    if (looked.chart.base_at_low_u != read.grid.chart.base_at_low_u) return false;
    lay_on(read.places, looked.shape, markers(row), &looked.chart);
    return true;
  }
  void add(std::size_t row, Looked looked, RecordedFaces& read) const {
    read.seen.push_back(static_cast<Eigen::Index>(row));
    read.edges.push_back(edge_curves(looked.shape));
    read.charts.push_back(std::move(looked.chart));
    if (row % (table_.frames.size() / kMostPoses + 1) == 0)
      read.poses.push_back({markers(row), std::move(looked.shape)});
  }

 private:
  [[nodiscard]] Markers markers(std::size_t row) const {
    return markers_of(table_.layouts, static_cast<Eigen::Index>(row), table_.seen[row]);
  }
  /// Rows from the middle of all poses outwards.
  [[nodiscard]] std::vector<std::size_t> from_the_middle() const {
    const Eigen::MatrixXd& layouts = table_.layouts;
    const Eigen::VectorXd off =
        (layouts.rowwise() - layouts.colwise().mean()).rowwise().squaredNorm();
    std::vector<std::size_t> rows(static_cast<std::size_t>(layouts.rows()));
    std::iota(rows.begin(), rows.end(), 0);
    std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
      return off[static_cast<Eigen::Index>(a)] < off[static_cast<Eigen::Index>(b)];
    });
    return rows;
  }

  const MarkerTable& table_;
  const Finger& finger_;
  const Camera& camera_;
};

/// A recorded frame, and what is kept of it where its face was found.
struct Row {
  std::size_t number = 0;
  cv::Mat grey;
  FaceEdges edges;
  std::optional<Looked> looked;
  FacePicture face;
};

class Reader {
 public:
  Reader(const RecordingToRead& frames, const Finger& finger, const Camera& camera)
      : frames_(frames),
        layer_(frames.table, finger, camera),
        finder_({.view = FaceView{camera, finger.face.width_mm}}) {}

  Result<RecordedFaces> operator()(std::size_t limit_bytes, const Job& job) const {
    RecordedFaces read;
    const auto face_of = [&](std::size_t row) -> Result<std::optional<Looked>> {
      const auto grey = picture(row);
      if (!grey) return grey.error();
      const auto edges = finder_(*grey);
      return edges ? layer_.look_at(*edges) : std::nullopt;
    };
    const auto has_rest = layer_.find_rest(face_of, read);
    if (!has_rest) return has_rest.error();
    if (!*has_rest) return too_few(0);
    Keeper keeper(frames_.table, limit_bytes);
    const std::size_t count = frames_.table.frames.size();
    auto next = begin_reading(0, job);
    for (std::size_t first = 0; first < count; first += kAtOnce) {
      job.report(static_cast<double>(first) / static_cast<double>(count),
                 en::say("reading reference frame {} of {}", first + 1, count));
      auto rows = next.get();
      if (!rows) return rows.error();
      next = begin_reading(first + kAtOnce, job);  // while these are looked at
      over_parts(static_cast<int>(rows->size()), all_cores(), [&](int from, int to) {
        for (int i = from; i < to; ++i) look_at(read, (*rows)[static_cast<std::size_t>(i)]);
      });
      for (Row& row : *rows) {
        if (!row.looked) continue;
        keeper.add(row.number, std::move(row.face));
        layer_.add(row.number, std::move(*row.looked), read);
        if (count <= kMostFramesKept) read.found.push_back({row.number, std::move(row.edges)});
      }
    }
    read.bytes = keeper.bytes();
    read.kept = keeper.rows();
    for (const std::size_t row : read.kept) read.faces.push_back(keeper.take(row));
    if (read.kept.size() < 2) return too_few(read.kept.size());
    return read;
  }

 private:
  /// Up to kAtOnce pictures from `first` on, on a thread of their own where one can be had.
  [[nodiscard]] std::future<Result<std::vector<Row>>> begin_reading(std::size_t first,
                                                                    const Job& job) const {
    return std::async([this, first, &job]() -> Result<std::vector<Row>> {
      const std::size_t count = frames_.table.frames.size();
      std::vector<Row> rows(first < count ? std::min(kAtOnce, count - first) : 0);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (job.stop_requested())
          return Error{
              en::say("stopped before the reference was read"), frames_.video.string(), ""};
        auto grey = picture(first + i);
        if (!grey) return grey.error();
        rows[i].number = first + i;
        rows[i].grey = std::move(*grey);
      }
      return rows;
    });
  }
  [[nodiscard]] Error wrong(Message what) const {
    return {std::move(what),
            frames_.video.string(),
            en::say("make the reference anew from the recording")};
  }
  [[nodiscard]] Error too_few(std::size_t found) const {
    return wrong(en::say("the face was found in {} of {} recorded pictures; 2 are needed",
                         found,
                         frames_.table.frames.size()));
  }
  [[nodiscard]] Result<cv::Mat> picture(std::size_t row) const {
    const auto number = static_cast<std::size_t>(frames_.table.frames[row]);
    if (number >= frames_.count)
      return wrong(en::say("the marker table names frame {} but the recording ends after {} frames",
                           number,
                           frames_.count));
    auto grey = frames_.frame(number);
    if (!grey) return wrong(grey.error().what);
    return grey;
  }
  /// A row's face laid on the grid; without `looked` where none is found.
  void look_at(const RecordedFaces& read, Row& row) const {
    auto edges = finder_(row.grey);
    if (!edges) return;
    row.edges = std::move(*edges);
    row.looked = layer_.look_at(row.edges);
    if (row.looked && !layer_.lay(read, row.number, *row.looked)) row.looked.reset();
    if (row.looked) row.face = keep_face(row.grey, row.looked->chart, read.grid);
  }

  const RecordingToRead& frames_;
  FaceLayer layer_;
  FaceEdgeFinder finder_;
};

/// Rows of a table, each once and in their order.
template <class Rows, class RowOf>
bool are_rows(const Rows& rows, const RowOf& row_of, std::size_t count) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (row_of(rows[i]) >= count || (i > 0 && row_of(rows[i - 1]) >= row_of(rows[i]))) return false;
  return true;
}

bool are_on(const FaceGrid& grid, const KeptFaces& kept) {
  return kept.error.relative_sd.size() ==
             cv::Size(grid.size.width / kErrorCellPx, grid.size.height / kErrorCellPx) &&
         std::all_of(kept.faces.begin(), kept.faces.end(), [&](const FacePicture& face) {
           return 0 <= face.first && face.end <= grid.size.width &&
                  face.grey.size() == grid.runs.pixels();
         });
}

std::optional<RecordedFaces> lay_again(KeptFaces kept,
                                       const MarkerTable& table,
                                       const Finger& finger,
                                       const Camera& camera) {
  const std::size_t count = table.frames.size();
  const auto row_of_found = [](const FoundFace& face) { return face.row; };
  if (!are_rows(kept.found, row_of_found, count) || !are_rows(kept.kept, std::identity(), count) ||
      kept.kept.size() != kept.faces.size() || kept.kept.size() < 2)
    return std::nullopt;
  const FaceLayer layer(table, finger, camera);
  const auto face_of = [&](std::size_t row) -> Result<std::optional<Looked>> {
    const auto face = std::ranges::lower_bound(kept.found, row, {}, row_of_found);
    if (face == kept.found.end() || face->row != row) return std::optional<Looked>();
    return layer.look_at(face->edges);
  };
  RecordedFaces read;
  if (const auto has_rest = layer.find_rest(face_of, read); !has_rest || !*has_rest)
    return std::nullopt;
  if (!are_on(read.grid, kept)) return std::nullopt;
  for (std::size_t first = 0; first < kept.found.size(); first += kAtOnce) {
    std::array<std::optional<Looked>, kAtOnce> looked;
    const std::size_t block = std::min(kAtOnce, kept.found.size() - first);
    over_parts(static_cast<int>(block), all_cores(), [&](int from, int to) {
      for (int i = from; i < to; ++i) {
        const FoundFace& face = kept.found[first + static_cast<std::size_t>(i)];
        auto& one = looked[static_cast<std::size_t>(i)];
        one = layer.look_at(face.edges);
        if (one && !layer.lay(read, face.row, *one)) one.reset();
      }
    });
    for (std::size_t i = 0; i < block; ++i) {
      if (!looked[i]) return std::nullopt;
      layer.add(kept.found[first + i].row, std::move(*looked[i]), read);
    }
  }
  read.kept = std::move(kept.kept);
  read.faces = std::move(kept.faces);
  for (const FacePicture& face : read.faces) read.bytes += face.bytes();
  return read;
}

}  // namespace

Result<RecordedFaces> read_recorded_faces(const RecordingToRead& frames,
                                          const Finger& finger,
                                          const Camera& camera,
                                          std::size_t limit_bytes,
                                          const Job& job) {
  try {
    return Reader(frames, finger, camera)(limit_bytes, job);
  } catch (const std::exception& problem) {
    return Error{en::say("the recording cannot be read ({})", std::string(problem.what())),
                 frames.video.string(),
                 en::say("make the reference anew from the recording")};
  }
}

std::optional<RecordedFaces> recorded_faces_again(KeptFaces kept,
                                                  const MarkerTable& table,
                                                  const Finger& finger,
                                                  const Camera& camera) {
  try {
    return lay_again(std::move(kept), table, finger, camera);
  } catch (const std::exception&) {
    return std::nullopt;  // what is wrong with the recording is said when it is read itself
  }
}

}  // namespace alltact
