#include "core/sensing/reference/recorded_faces.h"

#include "core/numerics/farthest_points.h"
#include "core/numerics/parallel.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/profile_degree.h"

#include <array>
#include <functional>
#include <future>
#include <numeric>
#include <queue>

namespace alltact {
namespace {

constexpr double kBeyondRest = 0.15;    // of the rest frame's face: how much more others may show
constexpr std::size_t kMaxPoses = 160;  // from which the finger's twist is learnt
constexpr std::size_t kAtOnce = 16;     // frames that are loaded and analysed at a time

// Selects faces of a recording within a memory limit: above it, the frame that adds least coverage
// is dropped first.
class FaceSelection {
 public:
  FaceSelection(const MarkerTable& table, std::size_t limit)
      : table_(table), limit_(limit), faces_(table.frames.size()) {}

  void add(std::size_t row, FaceImage face) {
    bytes_ += face.bytes();
    faces_[row] = std::move(face);
    if (rank_.empty()) {
      retained_.push_back(row);
      if (bytes_ > limit_) rank_frames();
    } else {
      push(row);
    }
    while (bytes_ > limit_ && ranked_.size() > 2) drop_one();
  }

  [[nodiscard]] std::vector<std::size_t> rows() const {
    std::vector<std::size_t> retained;
    for (std::size_t row = 0; row < faces_.size(); ++row)
      if (faces_[row]) retained.push_back(row);
    return retained;
  }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  FaceImage take(std::size_t row) { return std::move(*faces_[row]); }

 private:
  /// Ranks the rows by the covering order. Ordering all rows takes the square of their number, days
  /// for a hundred thousand. So only twice as many as fit are ordered; all behind those follow the
  /// order of the recording, and the last is dropped first.
  void rank_frames() {
    const std::size_t count = std::min(faces_.size(), 2 * retained_.size());
    const std::vector<int> order = farthest_point_order(table_.layouts, static_cast<int>(count));
    rank_.resize(faces_.size());
    for (std::size_t row = 0; row < rank_.size(); ++row) rank_[row] = count + row;
    for (std::size_t i = 0; i < order.size(); ++i) rank_[static_cast<std::size_t>(order[i])] = i;
    for (const std::size_t row : retained_) push(row);
  }
  void push(std::size_t row) { ranked_.emplace(rank_[row], row); }
  /// Drops the last of the covering order among those already read.
  void drop_one() {
    auto& face = faces_[ranked_.top().second];
    ranked_.pop();
    bytes_ -= face->bytes();
    face.reset();
  }

  const MarkerTable& table_;
  std::size_t limit_, bytes_ = 0;
  std::vector<std::optional<FaceImage>> faces_;
  std::vector<std::size_t> retained_;  // rows, until they are ranked
  std::vector<std::size_t> rank_;      // of each row; empty: the limit was never exceeded
  std::priority_queue<std::pair<std::size_t, std::size_t>> ranked_;  // rank and row
};

struct AnalysedFace {
  FaceShape shape;
  FaceChart chart;
};

/// Analyses a recorded face from its edges, whether these were found now or cached.
class FaceAnalyser {
 public:
  FaceAnalyser(const MarkerTable& table, const Finger& finger, const Camera& camera)
      : table_(table), finger_(finger), camera_(camera) {}

  [[nodiscard]] std::optional<AnalysedFace> analyse(const FaceEdges& edges) const {
    auto shape = FaceShape::fit(edges, camera_, finger_.face, kDefaultProfileDegree);
    if (!shape) return std::nullopt;
    auto chart = chart_of(*shape);
    if (!chart) return std::nullopt;
    return AnalysedFace{std::move(*shape), std::move(*chart)};
  }
  /// Sets the grid from the first face, in the order of rows from the middle of all poses outwards.
  /// `face_of` returns a row's face, nullopt where there is none. Returns whether one was found;
  /// errors: those of `face_of`.
  template <class FaceOf>
  Result<bool> find_rest(const FaceOf& face_of, RecordedFaces& read) const {
    constexpr std::size_t kTries = 16;
    std::vector<std::size_t> rows = from_the_middle();
    rows.resize(std::min(rows.size(), kTries));
    for (const std::size_t row : rows) {
      const Result<std::optional<AnalysedFace>> analysed = face_of(row);
      if (!analysed) return analysed.error();
      if (!*analysed) continue;
      read.grid = face_grid((*analysed)->chart, kBeyondRest);
      read.positions = skin_positions((*analysed)->chart, (*analysed)->shape, markers(row));
      return true;
    }
    return false;
  }
  /// Registers a row's chart to the rest frame's. False: it shows the finger in the opposite
  /// direction.
  bool register_face(const RecordedFaces& read, std::size_t row, AnalysedFace& analysed) const {
    if (analysed.chart.base_at_low_u != read.grid.chart.base_at_low_u) return false;
    register_chart(read.positions, analysed.shape, markers(row), &analysed.chart);
    return true;
  }
  void add(std::size_t row, AnalysedFace analysed, RecordedFaces& read) const {
    read.seen.push_back(static_cast<Eigen::Index>(row));
    read.edges.push_back(edge_curves(analysed.shape));
    read.charts.push_back(std::move(analysed.chart));
    if (row % (table_.frames.size() / kMaxPoses + 1) == 0)
      read.poses.push_back({markers(row), std::move(analysed.shape)});
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

/// A recorded frame, and what is retained of it where its face was found.
struct Row {
  std::size_t number = 0;
  cv::Mat grey;
  FaceEdges edges;
  std::optional<AnalysedFace> analysed;
  FaceImage face;
};

class Reader {
 public:
  Reader(const RecordingInput& frames, const Finger& finger, const Camera& camera)
      : frames_(frames),
        analyser_(frames.table, finger, camera),
        finder_({.view = FaceView{camera, finger.face.width_mm}}) {}

  Result<RecordedFaces> operator()(std::size_t limit_bytes, const Job& job) const {
    RecordedFaces read;
    const auto face_of = [&](std::size_t row) -> Result<std::optional<AnalysedFace>> {
      const auto grey = image(row);
      if (!grey) return grey.error();
      const auto edges = finder_(*grey);
      return edges ? analyser_.analyse(*edges) : std::nullopt;
    };
    const auto has_rest = analyser_.find_rest(face_of, read);
    if (!has_rest) return has_rest.error();
    if (!*has_rest) return too_few(0);
    FaceSelection selection(frames_.table, limit_bytes);
    const std::size_t count = frames_.table.frames.size();
    auto next = begin_reading(0, job);
    for (std::size_t first = 0; first < count; first += kAtOnce) {
      job.report(static_cast<double>(first) / static_cast<double>(count),
                 en::say("reading reference frame {} of {}", first + 1, count));
      auto rows = next.get();
      if (!rows) return rows.error();
      next = begin_reading(first + kAtOnce, job);  // while these are analysed
      parallel_for(static_cast<int>(rows->size()), default_threads(), [&](int from, int to) {
        for (int i = from; i < to; ++i) analyse(read, (*rows)[static_cast<std::size_t>(i)]);
      });
      for (Row& row : *rows) {
        if (!row.analysed) continue;
        selection.add(row.number, std::move(row.face));
        analyser_.add(row.number, std::move(*row.analysed), read);
        if (count <= kMaxCachedFrames) read.found.push_back({row.number, std::move(row.edges)});
      }
    }
    read.bytes = selection.bytes();
    read.retained = selection.rows();
    for (const std::size_t row : read.retained) read.faces.push_back(selection.take(row));
    if (read.retained.size() < 2) return too_few(read.retained.size());
    return read;
  }

 private:
  /// Reads up to kAtOnce images from `first` on, on a thread of their own where one is available.
  [[nodiscard]] std::future<Result<std::vector<Row>>> begin_reading(std::size_t first,
                                                                    const Job& job) const {
    return std::async([this, first, &job]() -> Result<std::vector<Row>> {
      const std::size_t count = frames_.table.frames.size();
      std::vector<Row> rows(first < count ? std::min(kAtOnce, count - first) : 0);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (job.stop_requested())
          return Error{
              en::say("stopped before the reference was read"), frames_.video.string(), ""};
        auto grey = image(first + i);
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
  [[nodiscard]] Result<cv::Mat> image(std::size_t row) const {
    const auto number = static_cast<std::size_t>(frames_.table.frames[row]);
    if (number >= frames_.count)
      return wrong(en::say("the marker table names frame {} but the recording ends after {} frames",
                           number,
                           frames_.count));
    auto grey = frames_.frame(number);
    if (!grey) return wrong(grey.error().what);
    return grey;
  }
  /// Warps a row's face to the grid; no `analysed` face where none is found.
  void analyse(const RecordedFaces& read, Row& row) const {
    auto edges = finder_(row.grey);
    if (!edges) return;
    row.edges = std::move(*edges);
    row.analysed = analyser_.analyse(row.edges);
    if (row.analysed && !analyser_.register_face(read, row.number, *row.analysed))
      row.analysed.reset();
    if (row.analysed) row.face = warp_face(row.grey, row.analysed->chart, read.grid);
  }

  const RecordingInput& frames_;
  FaceAnalyser analyser_;
  FaceEdgeFinder finder_;
};

/// True for rows of a table, each once and in ascending order.
template <class Rows, class RowOf>
bool are_ascending(const Rows& rows, const RowOf& row_of, std::size_t count) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (row_of(rows[i]) >= count || (i > 0 && row_of(rows[i - 1]) >= row_of(rows[i]))) return false;
  return true;
}

bool are_on_grid(const FaceGrid& grid, const FaceCache& cache) {
  return cache.error.relative_sd.size() ==
             cv::Size(grid.size.width / kErrorCellPx, grid.size.height / kErrorCellPx) &&
         std::all_of(cache.faces.begin(), cache.faces.end(), [&](const FaceImage& face) {
           return 0 <= face.first && face.end <= grid.size.width &&
                  face.grey.size() == grid.runs.pixels();
         });
}

std::optional<RecordedFaces> restore_faces(FaceCache cache,
                                           const MarkerTable& table,
                                           const Finger& finger,
                                           const Camera& camera) {
  const std::size_t count = table.frames.size();
  const auto row_of_found = [](const FoundFace& face) { return face.row; };
  if (!are_ascending(cache.found, row_of_found, count) ||
      !are_ascending(cache.retained, std::identity(), count) ||
      cache.retained.size() != cache.faces.size() || cache.retained.size() < 2)
    return std::nullopt;
  const FaceAnalyser analyser(table, finger, camera);
  const auto face_of = [&](std::size_t row) -> Result<std::optional<AnalysedFace>> {
    const auto face = std::ranges::lower_bound(cache.found, row, {}, row_of_found);
    if (face == cache.found.end() || face->row != row) return std::optional<AnalysedFace>();
    return analyser.analyse(face->edges);
  };
  RecordedFaces read;
  if (const auto has_rest = analyser.find_rest(face_of, read); !has_rest || !*has_rest)
    return std::nullopt;
  if (!are_on_grid(read.grid, cache)) return std::nullopt;
  for (std::size_t first = 0; first < cache.found.size(); first += kAtOnce) {
    std::array<std::optional<AnalysedFace>, kAtOnce> analysed;
    const std::size_t block = std::min(kAtOnce, cache.found.size() - first);
    parallel_for(static_cast<int>(block), default_threads(), [&](int from, int to) {
      for (int i = from; i < to; ++i) {
        const FoundFace& face = cache.found[first + static_cast<std::size_t>(i)];
        auto& one = analysed[static_cast<std::size_t>(i)];
        one = analyser.analyse(face.edges);
        if (one && !analyser.register_face(read, face.row, *one)) one.reset();
      }
    });
    for (std::size_t i = 0; i < block; ++i) {
      if (!analysed[i]) return std::nullopt;
      analyser.add(cache.found[first + i].row, std::move(*analysed[i]), read);
    }
  }
  read.retained = std::move(cache.retained);
  read.faces = std::move(cache.faces);
  for (const FaceImage& face : read.faces) read.bytes += face.bytes();
  return read;
}

}  // namespace

Result<RecordedFaces> read_recorded_faces(const RecordingInput& frames,
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

std::optional<RecordedFaces> recorded_faces_from_cache(FaceCache cache,
                                                       const MarkerTable& table,
                                                       const Finger& finger,
                                                       const Camera& camera) {
  try {
    return restore_faces(std::move(cache), table, finger, camera);
  } catch (const std::exception&) {
    return std::nullopt;  // problems of the recording are reported when it is read itself
  }
}

}  // namespace alltact
