#include "core/sensing/reference/recorded_faces.h"

#include "core/base/atomic_file.h"
#include "core/base/cache.h"
#include "core/numerics/checksum.h"
#include "core/numerics/linear_algebra.h"
#include "core/numerics/parallel.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"

#include <algorithm>
#include <array>
#include <bit>
#include <fstream>
#include <functional>
#include <future>
#include <numeric>
#include <queue>
#include <string_view>
#include <type_traits>

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
    if (row % (table_.frames.size() / kMaxPoses + 1) != 0) return;
    read.poses.push_back({markers(row), std::move(analysed.shape)});
    read.posed.push_back(static_cast<Eigen::Index>(row));
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
      if (const FaceEdges* known = known_edges(row)) return analyser_.analyse(*known);
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
          return Error{en::say("stopped before the reference was read"), frames_.video.string(),
                       ""};
        auto grey = image(first + i);
        if (!grey) return grey.error();
        rows[i].number = first + i;
        rows[i].grey = std::move(*grey);
      }
      return rows;
    });
  }
  [[nodiscard]] Error wrong(Message what) const {
    return {std::move(what), frames_.video.string(),
            en::say("create the reference again from the recording")};
  }
  [[nodiscard]] Error too_few(std::size_t found) const {
    return wrong(en::say("the face was found in {} of {} recorded images; 2 are needed", found,
                         frames_.table.frames.size()));
  }
  [[nodiscard]] Result<cv::Mat> image(std::size_t row) const {
    const auto number = static_cast<std::size_t>(frames_.table.frames[row]);
    if (number >= frames_.count)
      return wrong(en::say("the marker table lists frame {} but the recording ends after {} frames",
                           number, frames_.count));
    auto grey = frames_.frame(number);
    if (!grey) return wrong(grey.error().what);
    return grey;
  }
  [[nodiscard]] const FaceEdges* known_edges(std::size_t row) const {
    return frames_.known_edges(static_cast<std::size_t>(frames_.table.frames[row]));
  }
  /// Warps a row's face to the grid; no `analysed` face where none is found.
  void analyse(const RecordedFaces& read, Row& row) const {
    if (const FaceEdges* known = known_edges(row.number)) {
      row.edges = *known;
    } else {
      auto edges = finder_(row.grey);
      if (!edges) return;
      row.edges = std::move(*edges);
    }
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

std::optional<RecordedFaces> restore_faces(FaceCache cache, const MarkerTable& table,
                                           const Finger& finger, const Camera& camera) {
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

Result<RecordedFaces> read_recorded_faces(const RecordingInput& frames, const Finger& finger,
                                          const Camera& camera, std::size_t limit_bytes,
                                          const Job& job) {
  try {
    return Reader(frames, finger, camera)(limit_bytes, job);
  } catch (const std::exception& problem) {
    return Error{en::say("the recording cannot be read ({})", std::string(problem.what())),
                 frames.video.string(), en::say("create the reference again from the recording")};
  }
}

RecordedFaces faces_of_rows(RecordedFaces faces, const std::vector<std::size_t>& rows,
                            const MarkerTable& table, std::size_t limit_bytes) {
  // The new number of a row; nullopt: it is left out.
  const auto number_of = [&](std::size_t row) -> std::optional<std::size_t> {
    const auto found = std::lower_bound(rows.begin(), rows.end(), row);
    if (found == rows.end() || *found != row) return std::nullopt;
    return static_cast<std::size_t>(found - rows.begin());
  };
  RecordedFaces some;
  some.grid = std::move(faces.grid);
  some.positions = std::move(faces.positions);
  FaceSelection selection(table, limit_bytes);
  for (std::size_t i = 0; i < faces.retained.size(); ++i)
    if (const auto number = number_of(faces.retained[i]))
      selection.add(*number, std::move(faces.faces[i]));
  some.retained = selection.rows();
  some.bytes = selection.bytes();
  for (const std::size_t row : some.retained) some.faces.push_back(selection.take(row));
  for (std::size_t i = 0; i < faces.seen.size(); ++i)
    if (const auto number = number_of(static_cast<std::size_t>(faces.seen[i]))) {
      some.seen.push_back(static_cast<Eigen::Index>(*number));
      some.edges.push_back(std::move(faces.edges[i]));
      some.charts.push_back(std::move(faces.charts[i]));
    }
  for (std::size_t i = 0; i < faces.posed.size(); ++i)
    if (const auto number = number_of(static_cast<std::size_t>(faces.posed[i]))) {
      some.posed.push_back(static_cast<Eigen::Index>(*number));
      some.poses.push_back(std::move(faces.poses[i]));
    }
  return some;
}

std::optional<RecordedFaces> recorded_faces_from_cache(FaceCache cache, const MarkerTable& table,
                                                       const Finger& finger, const Camera& camera) {
  try {
    return restore_faces(std::move(cache), table, finger, camera);
  } catch (const std::exception&) {
    return std::nullopt;  // problems of the recording are reported when it is read itself
  }
}

namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "files hold little-endian numbers");

using Magic = std::array<char, 16>;
constexpr Magic kMagic{'a', 'l', 'l', 't', 'a', 'c', 't', '-',
                       'f', 'a', 'c', 'e', 's', '/', '1', '\n'};
constexpr std::size_t kMinFoundBytes = 150,
                      kMinImageBytes = 24;  // bytes of an entry without its lists
constexpr std::size_t kMaxFiles = 8;
constexpr std::size_t kMaxFaceBytes = std::size_t{128} << 20;

class Packer {
 public:
  explicit Packer(std::size_t bytes) { bytes_.reserve(bytes); }

  template <class T>
  void one(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(&value, sizeof value);
  }
  template <class T>
  void many(const T* values, std::size_t count) {
    one<std::uint64_t>(count);
    put(values, count * sizeof(T));
  }
  template <class T>
  void many(const std::vector<T>& values) {
    many(values.data(), values.size());
  }
  /// Returns all bytes, followed by the checksum.
  std::string finished() {
    one(std::uint64_t{sum_.value()});
    return std::move(bytes_);
  }

 private:
  void put(const void* values, std::size_t bytes) {
    sum_.add(values, bytes);
    bytes_.append(static_cast<const char*>(values), bytes);
  }

  std::string bytes_;
  Checksum sum_;
};

/// Returns zeros from where bytes are missing, and never allocates more than the file holds.
class Unpacker {
 public:
  Unpacker(std::istream& from, std::size_t bytes) : from_(from), rest_(bytes) {}

  template <class T>
  T one() {
    T value{};
    get(&value, sizeof value);
    return value;
  }
  template <class T>
  std::vector<T> many() {
    std::vector<T> values(count(sizeof(T)));
    get(values.data(), values.size() * sizeof(T));
    return values;
  }
  /// Number of entries that follow, each of at least `min_bytes`.
  std::size_t count(std::size_t min_bytes) {
    const auto count = one<std::uint64_t>();
    require(count <= rest_ / min_bytes);
    return good_ ? count : 0;
  }
  void require(bool good) { good_ = good_ && good; }
  [[nodiscard]] bool is_good() const { return good_; }
  /// True when nothing was refused and only the checksum of all before it follows.
  bool is_complete() {
    const std::uint64_t sum = sum_.value();
    return one<std::uint64_t>() == sum && good_ && rest_ == 0;
  }

 private:
  void get(void* values, std::size_t bytes) {
    require(bytes <= rest_);
    if (!good_) return;
    require(static_cast<bool>(
        from_.read(static_cast<char*>(values), static_cast<std::streamsize>(bytes))));
    sum_.add(values, bytes);
    rest_ -= bytes;
  }

  std::istream& from_;
  std::size_t rest_;
  Checksum sum_;
  bool good_ = true;
};

void pack(Packer& to, const Edge& edge) {
  to.many(edge.v);
  to.many(edge.sd);
  to.many(edge.valid);
}

Edge unpack_edge(Unpacker& from, std::size_t count) {
  Edge edge{from.many<double>(), from.many<double>(), from.many<char>()};
  from.require(edge.v.size() == count && edge.sd.size() == count && edge.valid.size() == count);
  return edge;
}

void pack(Packer& to, const std::optional<FaceEnd>& end) {
  to.one<std::uint8_t>(end ? 1 : 0);
  to.one(end.value_or(FaceEnd{}));
}

std::optional<FaceEnd> unpack_end(Unpacker& from) {
  const bool is_there = from.one<std::uint8_t>() != 0;
  const auto end = from.one<FaceEnd>();
  return is_there ? std::optional(end) : std::nullopt;
}

void pack(Packer& to, const FaceEdges& edges) {
  to.many(edges.u);
  pack(to, edges.upper);
  pack(to, edges.lower);
  pack(to, edges.ends.first);
  pack(to, edges.ends.last);
  to.one(edges.noise_sd);
  to.one<std::uint8_t>(edges.bright_inside ? 1 : 0);
}

FaceEdges unpack_edges(Unpacker& from) {
  FaceEdges edges;
  edges.u = from.many<double>();
  edges.upper = unpack_edge(from, edges.u.size());
  edges.lower = unpack_edge(from, edges.u.size());
  edges.ends.first = unpack_end(from);
  edges.ends.last = unpack_end(from);
  edges.noise_sd = from.one<double>();
  edges.bright_inside = from.one<std::uint8_t>() != 0;
  return edges;
}

void pack(Packer& to, const ReferenceError& error) {
  const cv::Mat sd =
      error.relative_sd.isContinuous() ? error.relative_sd : error.relative_sd.clone();
  to.one(std::int32_t{sd.cols});
  to.many(sd.ptr<float>(), sd.total());
  to.one(error.typical_reach_px2);
}

ReferenceError unpack_error(Unpacker& from) {
  ReferenceError error;
  const auto columns = static_cast<std::size_t>(std::max(0, from.one<std::int32_t>()));
  auto sd = from.many<float>();
  error.typical_reach_px2 = from.one<double>();
  from.require(columns > 0 && !sd.empty() && sd.size() % columns == 0);
  if (!from.is_good()) return error;
  error.relative_sd = cv::Mat(sd, true).reshape(1, static_cast<int>(sd.size() / columns));
  return error;
}

std::size_t bytes_of(const FaceCache& faces) {
  std::size_t bytes = 0;
  for (const FaceImage& face : faces.faces) bytes += face.bytes();
  return bytes;
}

fs::path file_for(const fs::path& folder, const std::string& made_from) {
  Checksum sum;
  sum.add(made_from.data(), made_from.size());
  return folder / (sum.text() + ".faces");
}

}  // namespace

std::string pack_faces(const FaceCache& faces, const std::string& made_from) {
  constexpr std::size_t kOfAFace = 16384;  // approximate size of its edges
  Packer to(bytes_of(faces) + kOfAFace * faces.found.size());
  to.one(kMagic);
  to.many(made_from.data(), made_from.size());
  to.one<std::uint64_t>(faces.found.size());
  for (const FoundFace& face : faces.found) {
    to.one<std::uint64_t>(face.row);
    pack(to, face.edges);
  }
  to.one<std::uint64_t>(faces.retained.size());
  for (std::size_t i = 0; i < faces.retained.size(); ++i) {
    to.one<std::uint64_t>(faces.retained[i]);
    to.one<std::int32_t>(faces.faces[i].first);
    to.one<std::int32_t>(faces.faces[i].end);
    to.many(faces.faces[i].grey);
  }
  pack(to, faces.error);
  return to.finished();
}

std::optional<FaceCache> unpack_faces(std::istream& file, std::size_t bytes,
                                      const std::string& made_from) {
  Unpacker from(file, bytes);
  if (from.one<Magic>() != kMagic) return std::nullopt;
  const std::vector<char> name = from.many<char>();
  if (std::string_view(name.data(), name.size()) != made_from) return std::nullopt;
  FaceCache faces;
  faces.found.resize(from.count(kMinFoundBytes));
  for (FoundFace& face : faces.found) {
    face.row = from.one<std::uint64_t>();
    face.edges = unpack_edges(from);
    if (!from.is_good()) return std::nullopt;
  }
  const std::size_t retained = from.count(kMinImageBytes);
  for (std::size_t i = 0; i < retained && from.is_good(); ++i) {
    faces.retained.push_back(from.one<std::uint64_t>());
    FaceImage& face = faces.faces.emplace_back();
    face.first = from.one<std::int32_t>();
    face.end = from.one<std::int32_t>();
    face.grey = from.many<std::uint8_t>();
  }
  faces.error = unpack_error(from);
  return from.is_complete() ? std::optional(std::move(faces)) : std::nullopt;
}

Status save_faces(const fs::path& folder, const std::string& made_from, const FaceCache& faces) {
  if (bytes_of(faces) > kMaxFaceBytes || faces.found.size() > kMaxCachedFrames) return {};
  if (const Status made = make_folder(folder); !made) return made.error();
  const Status retained =
      write_file_unsynced(file_for(folder, made_from), pack_faces(faces, made_from));
  if (!retained) return retained.error();
  remove_oldest(folder, kMaxFiles);
  return {};
}

std::optional<FaceCache> load_faces(const fs::path& folder, const std::string& made_from) {
  const fs::path path = file_for(folder, made_from);
  std::error_code failed;
  const auto bytes = fs::file_size(path, failed);
  if (failed || bytes > 2 * kMaxFaceBytes) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  auto faces = unpack_faces(file, bytes, made_from);
  // Marks the file as used, so that others are removed first.
  if (faces) fs::last_write_time(path, fs::file_time_type::clock::now(), failed);
  return faces;
}

}  // namespace alltact
