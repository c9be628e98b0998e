#include "core/stream/stream_format.h"

#include "core/either.h"
#include "core/printable.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

namespace alltact {
namespace {

static_assert(std::endian::native == std::endian::little);

std::size_t aligned(std::size_t bytes) {
  return (bytes + kStreamAlignment - 1) / kStreamAlignment * kStreamAlignment;
}

std::vector<std::string> part_names() {
  std::vector<std::string> names;
  for (const StreamPartKind& kind : kStreamParts) names.emplace_back(kind.name);
  return names;
}

template <std::size_t N>
std::array<char, N> padded(std::string_view text) {
  assert(text.size() <= N);
  std::array<char, N> letters{};
  std::copy(text.begin(), text.end(), letters.begin());
  return letters;
}

template <class T>
void put(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

Error bad_request(Message what) {
  return {std::move(what), "", en::say("one line such as alltact-stream/1 picture depth16")};
}

}  // namespace

const std::vector<StreamField>& stream_header_fields() {
  static const std::vector<StreamField> fields = {
      {"magic", "char[4]", offsetof(StreamHeader, magic), "ATCT"},
      {"version", "u16", offsetof(StreamHeader, version), "1"},
      {"type",
       "u16",
       offsetof(StreamHeader, type),
       "1 finger, 2 frame, 3 problem, 4 end, 5 refused"},
      {"parts", "u32", offsetof(StreamHeader, parts), "entries of the table behind the header"},
      {"json_bytes",
       "u32",
       offsetof(StreamHeader, json_bytes),
       "bytes of the JSON behind the table, with the blanks at its end"},
      {"bytes", "u64", offsetof(StreamHeader, bytes), "bytes of all that follows the header"},
      {"sequence",
       "u64",
       offsetof(StreamHeader, sequence),
       "the source's own count; gaps are frames that were lost or too quick to be measured"},
      {"time_ns",
       "i64",
       offsetof(StreamHeader, time_ns),
       "when the frame was taken, ns, by the clock that the finger message names; 0: not known"},
      {"lost",
       "u64",
       offsetof(StreamHeader, lost),
       "measured frames that this client was too slow for, so far"},
  };
  return fields;
}

const std::vector<StreamField>& stream_part_fields() {
  static const std::vector<StreamField> fields = {
      {"name", "char[16]", offsetof(StreamPartEntry, name), "zeros behind it"},
      {"dtype", "char[4]", offsetof(StreamPartEntry, dtype), "as NumPy writes it, zeros behind it"},
      {"rows", "u32", offsetof(StreamPartEntry, rows), "v"},
      {"cols", "u32", offsetof(StreamPartEntry, cols), "u"},
      {"channels", "u32", offsetof(StreamPartEntry, channels), "values of a pixel, side by side"},
      {"offset", "u64", offsetof(StreamPartEntry, offset), "from the header's end"},
      {"bytes", "u64", offsetof(StreamPartEntry, bytes), "rows x cols x channels x value"},
  };
  return fields;
}

std::string_view to_string(StreamType type) {
  constexpr std::array<std::string_view, 5> kWords{"finger", "frame", "problem", "end", "refused"};
  return kWords.at(static_cast<std::size_t>(type) - 1);
}

StreamBytes stream_bytes(const StreamMessage& message,
                         StreamPartSet requested,
                         std::uint64_t lost) {
  StreamBytes bytes;
  std::vector<StreamPartEntry> table;
  for (std::size_t k = 0; k < kStreamParts.size(); ++k) {
    const cv::Mat& part = message.parts[k];
    if (!requested[k] || part.empty()) continue;
    assert(part.channels() == kStreamParts[k].channels);
    bytes.parts.push_back(part.isContinuous() ? part : part.clone());
    table.push_back({padded<16>(kStreamParts[k].name),
                     padded<4>(kStreamParts[k].dtype),
                     static_cast<std::uint32_t>(part.rows),
                     static_cast<std::uint32_t>(part.cols),
                     static_cast<std::uint32_t>(part.channels()),
                     0,
                     part.total() * part.elemSize()});
  }
  StreamHeader header;
  header.type = static_cast<std::uint16_t>(message.type);
  header.parts = static_cast<std::uint32_t>(table.size());
  header.json_bytes = static_cast<std::uint32_t>(aligned(message.json.size()));
  header.sequence = message.sequence;
  header.time_ns = message.time_ns;
  header.lost = lost;
  header.bytes = table.size() * sizeof(StreamPartEntry) + header.json_bytes;
  for (StreamPartEntry& entry : table) {
    entry.offset = header.bytes;
    header.bytes += aligned(entry.bytes);
  }
  put(bytes.head, header);
  for (const StreamPartEntry& entry : table) put(bytes.head, entry);
  bytes.head += message.json;
  bytes.head.resize(bytes.head.size() + header.json_bytes - message.json.size(), ' ');
  return bytes;
}

Result<StreamPartSet> stream_request(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (!line.starts_with(kStreamFormat) ||
      (line.size() > kStreamFormat.size() && line[kStreamFormat.size()] != ' '))
    return bad_request(en::say(
        "'{}' does not ask for {}", printable(line.substr(0, 60)), std::string(kStreamFormat)));
  line.remove_prefix(kStreamFormat.size());
  StreamPartSet requested;
  while (!line.empty()) {
    const std::string_view word = line.substr(0, line.find(' '));
    line.remove_prefix(std::min(line.size(), word.size() + 1));
    if (word.empty()) continue;
    const auto* const kind =
        std::find_if(kStreamParts.begin(), kStreamParts.end(), [&](const StreamPartKind& part) {
          return part.name == word;
        });
    if (kind == kStreamParts.end())
      return bad_request(en::say("there is no part '{}', but {}",
                                 printable(word.substr(0, 60)),
                                 one_of(part_names(), word)));
    requested.set(static_cast<std::size_t>(kind - kStreamParts.begin()));
  }
  return requested;
}

}  // namespace alltact
