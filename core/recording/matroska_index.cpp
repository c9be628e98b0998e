#include "core/recording/matroska_index.h"

#include "core/io/system_error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <span>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

extern "C" {
#include <libavutil/crc.h>
}

namespace alltact {
namespace {

// Element numbers, as in the file with their length marker.
constexpr std::uint32_t kEbmlHead = 0x1A45DFA3, kSegment = 0x18538067, kCluster = 0x1F43B675;
constexpr std::uint32_t kTimestamp = 0xE7, kSimpleBlock = 0xA3, kBlockGroup = 0xA0, kBlock = 0xA1;
constexpr std::uint32_t kCheckSum = 0xBF;
constexpr std::uint32_t kReference = 0xFB;  // to the block from which one in a group is predicted

constexpr std::int64_t kUnknown = -1;

struct Element {
  std::uint32_t id = 0;
  std::int64_t content_at = 0;
  std::int64_t bytes = 0;  // of the content, or kUnknown
};

class File {
 public:
  explicit File(const std::filesystem::path& path)
      : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    struct stat status {};
    if (number_ >= 0 && ::fstat(number_, &status) == 0) bytes_ = status.st_size;
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  [[nodiscard]] std::int64_t bytes() const { return bytes_; }
  /// Reads from `at` on, up to the size of `room`.
  [[nodiscard]] std::span<const std::uint8_t> read(std::int64_t at,
                                                   std::span<std::uint8_t> room) const {
    const ssize_t got = ::pread(number_, room.data(), room.size(), at);
    return room.first(got > 0 ? static_cast<std::size_t>(got) : 0);
  }

 private:
  int number_;
  std::int64_t bytes_ = 0;
};

/// The element that begins at `at`; empty where there is none, or only a part of its head.
std::optional<Element> element_at(const File& file, std::int64_t at) {
  std::array<std::uint8_t, 12> room{};
  const auto head = file.read(at, room);
  if (head.empty()) return std::nullopt;
  const auto id_length = static_cast<std::size_t>(std::countl_zero(head[0])) + 1;
  if (id_length > 4 || head.size() <= id_length) return std::nullopt;
  Element element;
  for (std::size_t i = 0; i < id_length; ++i) element.id = element.id << 8U | head[i];
  const auto length = static_cast<std::size_t>(std::countl_zero(head[id_length])) + 1;
  if (length > 8 || head.size() < id_length + length) return std::nullopt;
  std::uint64_t value = head[id_length] & (0xFFU >> length);
  for (std::size_t i = 1; i < length; ++i) value = value << 8U | head[id_length + i];
  element.content_at = at + static_cast<std::int64_t>(id_length + length);
  const bool is_unknown = value == (std::uint64_t{1} << (7 * length)) - 1;
  element.bytes = is_unknown ? kUnknown : static_cast<std::int64_t>(value);
  return element;
}

std::int64_t number_in(const File& file, const Element& element) {
  std::array<std::uint8_t, 8> room{};
  const auto requested = static_cast<std::size_t>(std::clamp<std::int64_t>(element.bytes, 0, 8));
  std::int64_t value = 0;
  for (const std::uint8_t byte : file.read(element.content_at, std::span(room).first(requested)))
    value = value << 8U | byte;
  return value;
}

bool holds_others(std::uint32_t id) {
  return id == kSegment || id == kCluster || id == kBlockGroup;
}

/// Walks through a file from its first element to its last. It enters container elements instead of
/// skipping them, because after a crash their lengths are unknown.
class Walk {
 public:
  explicit Walk(const File& file) : file_(file) {}

  MatroskaIndex run() {
    std::int64_t at = 0;
    while (const auto element = element_at(file_, at)) {
      if (element->id == kSegment) index_.has_length = element->bytes != kUnknown;
      if (element->id == kCluster) {
        block_ = {};
        block_.cluster_at = at;
        cluster_end_ = element->bytes == kUnknown ? 0 : element->content_at + element->bytes;
      }
      if (holds_others(element->id)) {
        at = element->content_at;
      } else {
        if (element->bytes == kUnknown || element->bytes > file_.bytes() - element->content_at)
          break;
        take(*element);
        at = element->content_at + element->bytes;
      }
    }
    index_.is_walkable = at == file_.bytes();
    return std::move(index_);
  }

 private:
  void take(const Element& element) {
    if (element.id == kCheckSum && element.bytes == 4 && cluster_end_ > element.content_at) {
      block_.checked_from = element.content_at + 4;
      block_.checked_bytes = cluster_end_ - block_.checked_from;
      std::array<std::uint8_t, 4> sum{};
      for (const std::uint8_t byte : file_.read(element.content_at, sum))
        block_.check_sum = block_.check_sum >> 8U | std::uint32_t{byte} << 24U;
    }
    if (element.id == kTimestamp) cluster_time_ = number_in(file_, element);
    if (element.id == kReference && !index_.blocks.empty()) index_.blocks.back().is_key = false;
    if (element.id != kSimpleBlock && element.id != kBlock) return;
    // The track's number (1 to 8 bytes, in recordings of this program 1), the time after the
    // cluster's (2), flags (1).
    std::array<std::uint8_t, 11> room{};
    const auto head = file_.read(element.content_at, room);
    const auto track = head.empty() ? 9 : static_cast<std::size_t>(std::countl_zero(head[0])) + 1;
    if (track > 8 || head.size() < track + 3) return;
    const auto relative = static_cast<std::int16_t>(head[track] << 8U | head[track + 1]);
    block_.time = cluster_time_ + relative;
    block_.data_bytes_at = element.content_at;
    block_.is_key = element.id == kBlock || (head[track + 2] & 0x80U) != 0;
    index_.blocks.push_back(block_);
  }

  const File& file_;
  MatroskaIndex index_;
  MatroskaIndex::Block block_{};  // the next block, with the values of its cluster
  std::int64_t cluster_time_ = 0, cluster_end_ = 0;
};

}  // namespace

Result<MatroskaIndex> index_matroska(const std::filesystem::path& path) {
  const File file(path);
  if (!file.is_open()) return system_error(en::say("the video cannot be opened"), path, errno);
  const auto head = element_at(file, 0);
  if (!head || head->id != kEbmlHead)
    return Error{en::say("this is no Matroska file"),
                 path.string(),
                 en::say("check that it is the right file")};
  return Walk(file).run();
}

bool is_undamaged(int descriptor, const MatroskaIndex::Block& block) {
  if (block.checked_bytes <= 0) return true;
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 ||
      block.checked_bytes > status.st_size - block.checked_from)
    return false;
  const AVCRC* table = av_crc_get_table(AV_CRC_32_IEEE_LE);
  std::uint32_t sum = 0xFFFFFFFFU;
  // In chunks: a damaged length may be nearly that of the file.
  std::array<std::uint8_t, std::size_t{1} << 16> room{};
  std::int64_t left = block.checked_bytes;
  for (std::int64_t at = block.checked_from; left > 0;) {
    const auto requested = std::min<std::int64_t>(left, std::ssize(room));
    const ssize_t got = ::pread(descriptor, room.data(), static_cast<std::size_t>(requested), at);
    if (got <= 0) return false;
    sum = av_crc(table, sum, room.data(), static_cast<std::size_t>(got));
    at += got;
    left -= got;
  }
  return (sum ^ 0xFFFFFFFFU) == block.check_sum;
}

}  // namespace alltact
