#include "core/sensing/reference/recorded_faces.h"

#include "core/numerics/farthest_points.h"
#include "core/numerics/parts.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/profile_degree.h"

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

/// A recorded frame, and what is kept of it where its face was found.
struct Row {
  std::size_t number = 0;
  cv::Mat grey;
  std::optional<Looked> looked;
  FacePicture face;
};

class Reader {
 public:
  Reader(const RecordingToRead& frames, const Finger& finger, const Camera& camera)
      : frames_(frames), finger_(finger), camera_(camera) {}

  Result<RecordedFaces> operator()(std::size_t limit_bytes, const Job& job) const {
    RecordedFaces read;
    if (const Status status = find_rest(read); !status) return status.error();
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
      for (Row& row : *rows)
        if (row.looked) add(std::move(row), keeper, read);
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
  [[nodiscard]] std::optional<Looked> look_at(const cv::Mat& grey) const {
    const auto edges = finder_(grey);
    if (!edges) return std::nullopt;
    const auto shape = FaceShape::fit(*edges, camera_, finger_.face, kUsualProfileDegree);
    if (!shape) return std::nullopt;
    auto chart = chart_of(*shape);
    if (!chart) return std::nullopt;
    return Looked{*shape, std::move(*chart)};
  }
  [[nodiscard]] Markers markers(std::size_t row) const {
    return markers_of(
        frames_.table.layouts, static_cast<Eigen::Index>(row), frames_.table.seen[row]);
  }

  /// Rows from the middle of all poses outwards.
  [[nodiscard]] std::vector<std::size_t> from_the_middle() const {
    const Eigen::MatrixXd& layouts = frames_.table.layouts;
    const Eigen::VectorXd off =
        (layouts.rowwise() - layouts.colwise().mean()).rowwise().squaredNorm();
    std::vector<std::size_t> rows(static_cast<std::size_t>(layouts.rows()));
    std::iota(rows.begin(), rows.end(), 0);
    std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
      return off[static_cast<Eigen::Index>(a)] < off[static_cast<Eigen::Index>(b)];
    });
    return rows;
  }
  Status find_rest(RecordedFaces& read) const {
    constexpr std::size_t kTries = 16;
    std::vector<std::size_t> rows = from_the_middle();
    rows.resize(std::min(rows.size(), kTries));
    for (const std::size_t row : rows) {
      const auto grey = picture(row);
      if (!grey) return grey.error();
      const auto looked = look_at(*grey);
      if (!looked) continue;
      read.grid = face_grid(looked->chart, kBeyondRest);
      read.places = skin_places(looked->chart, looked->shape, markers(row));
      return {};
    }
    return too_few(0);
  }

  /// A row's face laid on the grid; without `looked` where none is found.
  void look_at(const RecordedFaces& read, Row& row) const {
    row.looked = look_at(row.grey);
    if (row.looked && row.looked->chart.base_at_low_u != read.grid.chart.base_at_low_u)
      row.looked.reset();
    if (!row.looked) return;
    lay_on(read.places, row.looked->shape, markers(row.number), &row.looked->chart);
    row.face = keep_face(row.grey, row.looked->chart, read.grid);
  }
  void add(Row row, Keeper& keeper, RecordedFaces& read) const {
    keeper.add(row.number, std::move(row.face));
    read.seen.push_back(static_cast<Eigen::Index>(row.number));
    read.edges.push_back(edge_curves(row.looked->shape));
    read.charts.push_back(std::move(row.looked->chart));
    if (row.number % (frames_.table.frames.size() / kMostPoses + 1) == 0)
      read.poses.push_back({markers(row.number), std::move(row.looked->shape)});
  }

  const RecordingToRead& frames_;
  const Finger& finger_;
  const Camera& camera_;
  FaceEdgeFinder finder_{{.view = FaceView{camera_, finger_.face.width_mm}}};
};

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

}  // namespace alltact
