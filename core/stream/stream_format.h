// Binary format of a message to other programs on this computer.
//
// Numbers are little-endian. A message is
//   header   48 bytes (StreamHeader)
//   table    48 bytes for each part (StreamPartEntry)
//   JSON     one object, UTF-8, padded with blanks to the next multiple of 16 bytes
//   parts    rows of pixels, each part at a multiple of 16 bytes
// Offsets count from the header's end. A client sends one line (stream_request()).
#pragma once

#include "core/base/result.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

inline constexpr std::string_view kStreamFormat = "alltact-stream/1";
inline constexpr std::size_t kStreamAlignment = 16;  ///< bytes

enum class StreamType : std::uint16_t {
  kFinger = 1,  ///< description of the finger: the first message, and again after each change
  kFrame,       ///< results of one frame
  kProblem,     ///< why there is no frame now; others may follow
  kEnd,         ///< the last message, with the reason
  kRefused,     ///< the client's error; the connection ends
};

struct StreamHeader {
  std::array<char, 4> magic{'A', 'T', 'C', 'T'};
  std::uint16_t version = 1;
  std::uint16_t type = 0;        ///< StreamType
  std::uint32_t parts = 0;       ///< entries of the table
  std::uint32_t json_bytes = 0;  ///< with the blanks behind it
  std::uint64_t bytes = 0;       ///< of all that follows the header
  std::uint64_t sequence = 0;    ///< Frame::sequence
  std::int64_t time_ns = 0;      ///< Frame::time_ns
  std::uint64_t lost = 0;        ///< number of frames for which this client was too slow
};
static_assert(sizeof(StreamHeader) == 48);

struct StreamPartEntry {
  std::array<char, 16> name{};  ///< of kStreamParts, zeros behind it
  std::array<char, 4> dtype{};  ///< as NumPy writes it: "|u1", "<u2", "<f4"
  std::uint32_t rows = 0, cols = 0, channels = 0;
  std::uint64_t offset = 0, bytes = 0;
};
static_assert(sizeof(StreamPartEntry) == 48);

/// A part that a client can request. A message has them in the order of this table.
struct StreamPartKind {
  std::string_view name, dtype;
  int channels;
  std::string_view what;
};
inline constexpr std::array kStreamParts = {
    StreamPartKind{"picture", "|u1", 1, "grey levels of the picture that was measured"},
    StreamPartKind{"depth16", "<u2", 1,
                   "whole micrometres: depth_mm = 0.001 (value - 10000); 0: none"},
    StreamPartKind{"depth", "<f4", 1, "press depth along z, mm; NaN: none"},
    StreamPartKind{"flags", "|u1", 1,
                   "0 measured, 1 off the face, 2 too dark, 3 saturated, 4 darker than calibrated, "
                   "5 beyond the layer, 6 not in the recording, 7 end hidden"},
    StreamPartKind{"points", "<f4", 3, "x, y, z of the pressed face, mm, camera frame; NaN: none"},
};
enum StreamPart : std::size_t { kImage = 0, kDepth16, kDepth, kFlags, kPoints };
using StreamPartSet = std::bitset<kStreamParts.size()>;

/// A field of the header or table, for the description of the format.
struct StreamField {
  std::string_view name, type;
  std::size_t offset;
  std::string_view what;
};
[[nodiscard]] const std::vector<StreamField>& stream_header_fields();
[[nodiscard]] const std::vector<StreamField>& stream_part_fields();
[[nodiscard]] std::string_view to_string(StreamType type);

/// A message for all clients.
struct StreamMessage {
  StreamType type = StreamType::kFrame;
  std::uint64_t sequence = 0;
  std::int64_t time_ns = 0;
  std::string json;  ///< one object
  /// By StreamPart; empty: there is none. Read-only from now on.
  std::array<cv::Mat, kStreamParts.size()> parts;
  /// The parts that were requested; the others were not made.
  StreamPartSet requested_parts = StreamPartSet().set();
};

/// A message for one client: `head` (header, table, JSON), then each part, padded with zeros to the
/// next multiple of 16 bytes.
struct StreamBytes {
  std::string head;
  std::vector<cv::Mat> parts;  ///< continuous
};
[[nodiscard]] StreamBytes stream_bytes(const StreamMessage& message, StreamPartSet requested,
                                       std::uint64_t lost);

/// Parses a client's line, without its end: "alltact-stream/1 depth16 flags". Without parts the
/// client gets the JSON only. Errors: another beginning; no such part.
[[nodiscard]] Result<StreamPartSet> stream_request(std::string_view line);
inline constexpr std::size_t kLongestStreamRequest = 256;

// Documentation of the format for other programs, printed by `alltact serve --schema`.

/// A key of a message's JSON: "regions[].deepest_mm".
struct StreamKey {
  std::string_view message;  ///< as to_string(StreamType) names it
  std::string_view path;
  std::string_view what;  ///< with its unit
};
/// All keys, in the order in which they are sent. Unknown values are absent, never zero.
[[nodiscard]] const std::vector<StreamKey>& stream_keys();

/// For people: request, layout, parts and keys.
[[nodiscard]] std::string stream_schema_text();
/// The same as one JSON object.
[[nodiscard]] std::string stream_schema_json();

}  // namespace alltact
