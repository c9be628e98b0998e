#include "core/sensing/reference/face_cache.h"

#include "core/io/atomic_file.h"
#include "core/io/cache_folder.h"
#include "core/numerics/checksum.h"

#include <array>
#include <bit>
#include <fstream>
#include <string_view>
#include <type_traits>

namespace alltact {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "files hold little-endian numbers");

using Magic = std::array<char, 16>;
constexpr Magic kMagic{
    'a', 'l', 'l', 't', 'a', 'c', 't', '-', 'f', 'a', 'c', 'e', 's', '/', '1', '\n'};
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

std::optional<FaceCache> unpack_faces(std::istream& file,
                                      std::size_t bytes,
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
