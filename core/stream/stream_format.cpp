#include "core/stream/stream_format.h"

#include "core/base/message.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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
      {"type", "u16", offsetof(StreamHeader, type),
       "1 finger, 2 frame, 3 problem, 4 end, 5 refused"},
      {"parts", "u32", offsetof(StreamHeader, parts), "entries of the table behind the header"},
      {"json_bytes", "u32", offsetof(StreamHeader, json_bytes),
       "bytes of the JSON behind the table, with the blanks at its end"},
      {"bytes", "u64", offsetof(StreamHeader, bytes), "bytes of all that follows the header"},
      {"sequence", "u64", offsetof(StreamHeader, sequence),
       "the source's own count; gaps are frames that were lost or too quick to be measured"},
      {"time_ns", "i64", offsetof(StreamHeader, time_ns),
       "when the frame was taken, ns, by the clock that the finger message names; 0: not known"},
      {"lost", "u64", offsetof(StreamHeader, lost),
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

StreamBytes stream_bytes(const StreamMessage& message, StreamPartSet requested,
                         std::uint64_t lost) {
  StreamBytes bytes;
  std::vector<StreamPartEntry> table;
  for (std::size_t k = 0; k < kStreamParts.size(); ++k) {
    const cv::Mat& part = message.parts[k];
    if (!requested[k] || part.empty()) continue;
    assert(part.channels() == kStreamParts[k].channels);
    bytes.parts.push_back(part.isContinuous() ? part : part.clone());
    table.push_back({padded<16>(kStreamParts[k].name), padded<4>(kStreamParts[k].dtype),
                     static_cast<std::uint32_t>(part.rows), static_cast<std::uint32_t>(part.cols),
                     static_cast<std::uint32_t>(part.channels()), 0,
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
    return bad_request(en::say("'{}' does not request {}", printable(line.substr(0, 60)),
                               std::string(kStreamFormat)));
  line.remove_prefix(kStreamFormat.size());
  StreamPartSet requested;
  while (!line.empty()) {
    const std::string_view word = line.substr(0, line.find(' '));
    line.remove_prefix(std::min(line.size(), word.size() + 1));
    if (word.empty()) continue;
    const auto* const kind =
        std::find_if(kStreamParts.begin(), kStreamParts.end(),
                     [&](const StreamPartKind& part) { return part.name == word; });
    if (kind == kStreamParts.end())
      return bad_request(en::say("there is no part '{}', only {}", printable(word.substr(0, 60)),
                                 one_of(part_names(), word)));
    requested.set(static_cast<std::size_t>(kind - kStreamParts.begin()));
  }
  return requested;
}

namespace {

constexpr std::size_t kWidth = 100;

/// Wraps words at kWidth letters; each line but the first has an indent.
std::string wrapped(std::string_view text, std::size_t indent) {
  std::string lines;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    const bool begins = lines.empty();
    if (!begins && column + 1 + word.size() > kWidth) {
      lines += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (!begins) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += word.size();
  }
  return lines;
}

}  // namespace

const std::vector<StreamKey>& stream_keys() {
  static const std::vector<StreamKey> keys = {
      {"finger", "format", "alltact-stream/1"},
      {"finger", "program", "name and version of what serves"},
      {"finger", "finger", "the finger's name"},
      {"finger", "finger_revision", "grows whenever the finger is calibrated anew meanwhile"},
      {"finger", "calibration_date", "UTC"},
      {"finger", "verdict",
       "what the calibration is worth: grade (good, usable, unproven, unfit), expected_error_mm, "
       "causes_mm, missing, rests_on, sentence"},
      {"finger", "source", "where the pictures come from"},
      {"finger", "clock",
       "monotonic: time_ns is CLOCK_MONOTONIC of this computer, as the kernel "
       "stamped the picture; source: a clock of the source's own"},
      {"finger", "frames_per_s", "about how often pictures come"},
      {"finger", "size_px", "columns and rows of every part"},
      {"finger", "reduced_by", "pixels a side of the camera's picture in one of the parts'"},
      {"finger", "camera",
       "model, size_px, fx_px, fy_px (mm_per_px), cx_px, cy_px, distortion, "
       "orientation (already applied), port: of the parts' pixels"},
      {"finger", "face", "kind, width_mm or plane_z_mm, layer_mm"},
      {"finger", "parts", "what may be asked for, with dtype and meaning"},
      {"frame", "frame", "name"},
      {"frame", "index", "counts the frames that were measured, from 0"},
      {"frame", "time_ns", "as in the header; absent where there is none"},
      {"frame", "finger_revision", "of the finger message that this frame belongs to"},
      {"frame", "reduced_by", "where it is not 1"},
      {"frame", "size_px", "columns and rows, where reduced"},
      {"frame", "face.u", "columns, px"},
      {"frame", "face.z_sd_mm", "how well the face's z is known there, one standard deviation"},
      {"frame", "markers[].u", "px"},
      {"frame", "markers[].v", "px"},
      {"frame", "markers[].seen", "else estimated from the others"},
      {"frame", "marker_method", "where it is not blobs"},
      {"frame", "reference.method", "single, nearest, local"},
      {"frame", "reference.frame", "number of the nearest recorded frame"},
      {"frame", "reference.distance_px", "of the markers to that frame's"},
      {"frame", "reference.known_pose", "false: never recorded"},
      {"frame", "reference.by_shape", "no marker was seen"},
      {"frame", "contact.touched", "by the markers' way from rest"},
      {"frame", "contact.offset_px", "u, v: sum over the markers"},
      {"frame", "contact.direction", "unit vector, camera frame"},
      {"frame", "contact.sd_deg", "standard deviation of the direction"},
      {"frame", "contact.face", "contact, back, upper, lower"},
      {"frame", "finger_contact.face", "contact, back, upper, lower"},
      {"frame", "finger_contact.direction",
       "unit vector, camera frame: the way the finger gives way"},
      {"frame", "finger_contact.direction_sd_deg", "standard deviation"},
      {"frame", "finger_contact.along_mm", "along the face from its base"},
      {"frame", "finger_contact.along_sd_mm", "standard deviation"},
      {"frame", "finger_contact.across_mm", "from the middle line towards +y"},
      {"frame", "finger_contact.across_sd_mm", "standard deviation"},
      {"frame", "finger_contact.depth_mm", "deepest, along z"},
      {"frame", "finger_contact.depth_sd_mm", "standard deviation"},
      {"frame", "finger_contact.limits", "as regions[].limits; absent: none"},
      {"frame", "finger_contact.no_place", "why there is no place"},
      {"frame", "finger_contact.new", "it began in this frame"},
      {"frame", "finger_contact.held_s", "since it began"},
      {"frame", "finger_contact.slipping", "the thing moves over the skin"},
      {"frame", "validity.measured", "part of the face"},
      {"frame", "validity.off_face", "part of the face"},
      {"frame", "validity.too_dark", "part of the face"},
      {"frame", "validity.saturated", "part of the face"},
      {"frame", "validity.extrapolated", "part of the face"},
      {"frame", "validity.beyond_layer", "part of the face"},
      {"frame", "validity.no_reference", "part of the face"},
      {"frame", "validity.hidden_end", "part of the face"},
      {"frame", "validity.bulge_limit", "part of the face"},
      {"frame", "regions[].place_mm", "x, y, z of the middle, camera frame"},
      {"frame", "regions[].place_on_face_mm", "along and across the face"},
      {"frame", "regions[].deepest_mm", "along z"},
      {"frame", "regions[].deepest_sd_mm", "standard deviation"},
      {"frame", "regions[].limits",
       "layer_limit: depths are least values; out_of_range, doubtful_light; absent: none"},
      {"frame", "regions[].area_mm2", "on the face"},
      {"frame", "regions[].volume_mm3", "displaced"},
      {"frame", "regions[].angle_deg", "principal axis, from the finger's length towards +y"},
      {"frame", "regions[].angle_sd_deg", "standard deviation"},
      {"frame", "regions[].axis", "the same as a unit vector, camera frame"},
      {"frame", "regions[].normal", "unit vector, camera frame"},
      {"frame", "regions[].place_covariance_mm2", "xx, xy, xz, yy, yz, zz of place_mm"},
      {"frame", "regions[].polygon_mm", "outline: along and across the face"},
      {"frame", "force.fx_n", "N, in the axes of the table that the model was trained with"},
      {"frame", "force.fy_n", "N"},
      {"frame", "force.fz_n", "N, where the model tells it"},
      {"frame", "force.sd_n", "standard deviations of these, N"},
      {"frame", "force.half_95_n", "95 % lie within +- these, N"},
      {"frame", "force.in_range", "false: the model was trained with nothing like this frame"},
      {"frame", "times_ms.prepare", "ms"},
      {"frame", "times_ms.edges", "ms"},
      {"frame", "times_ms.global", "ms"},
      {"frame", "times_ms.markers", "ms"},
      {"frame", "times_ms.reference", "ms"},
      {"frame", "times_ms.local", "ms"},
      {"frame", "times_ms.contact", "ms"},
      {"frame", "times_ms.force", "ms"},
      {"frame", "times_ms.total", "ms"},
      {"frame", "problems[]", "why something is absent, a sentence each"},
      {"problem", "problems[]", "why there is no frame now, or the finger is not followed"},
      {"end", "reason", "a sentence"},
      {"refused", "error", "a sentence"},
  };
  return keys;
}

std::string stream_schema_text() {
  std::string text = fmt::format(
      "{}: results and pictures over a Unix socket, for programs of one user on one computer.\n\n",
      kStreamFormat);
  text += wrapped(
      fmt::format(
          "The client sends one line, ended by a line break, of at most {} bytes: {}, then the "
          "parts that it wants, with blanks between. Then it reads messages. The first tells what "
          "the finger is, the others what each frame tells, as soon as it was measured. A part "
          "that was asked for is missing only where the frame has none. Whoever reads too slowly "
          "misses frames; its headers count them.",
          kLongestStreamRequest, kStreamFormat),
      0);
  text += "\n\n";
  text += wrapped(
      fmt::format(
          "A message: header, table of its parts, JSON, parts. Numbers are little-endian. The JSON "
          "ends at a multiple of {} bytes (with blanks), and so does each part (with zeros).",
          kStreamAlignment),
      0);
  text += "\n\n";
  const auto add_fields = [&](const char* title, std::size_t size,
                              const std::vector<StreamField>& fields) {
    text += fmt::format("{}, {} bytes\n", title, size);
    for (const StreamField& field : fields)
      text += fmt::format("  {:>2}  {:<10} {:<9} {}\n", field.offset, field.name, field.type,
                          wrapped(field.what, 27));
    text += "\n";
  };
  add_fields("header", sizeof(StreamHeader), stream_header_fields());
  add_fields("entry of the table", sizeof(StreamPartEntry), stream_part_fields());
  text += "parts: rows of pixels [v, u]\n";
  for (const StreamPartKind& kind : kStreamParts)
    text += fmt::format("  {:<8} {} x {}  {}\n", kind.name, kind.dtype, kind.channels,
                        wrapped(kind.what, 20));
  std::string_view message;
  for (const StreamKey& key : stream_keys()) {
    if (key.message != message) text += fmt::format("\nJSON of a {} message\n", key.message);
    message = key.message;
    text += fmt::format("  {:<32} {}\n", key.path, wrapped(key.what, 35));
  }
  return text;
}

std::string stream_schema_json() {
  using Json = nlohmann::ordered_json;
  const auto rows_of = [](const std::vector<StreamField>& fields) {
    Json rows = Json::array();
    for (const StreamField& field : fields)
      rows.push_back({{"name", field.name},
                      {"type", field.type},
                      {"offset", field.offset},
                      {"what", field.what}});
    return rows;
  };
  Json json;
  json["format"] = kStreamFormat;
  json["longest_request_bytes"] = kLongestStreamRequest;
  json["header"] = {{"bytes", sizeof(StreamHeader)}, {"fields", rows_of(stream_header_fields())}};
  json["table"] = {{"bytes", sizeof(StreamPartEntry)}, {"fields", rows_of(stream_part_fields())}};
  for (const StreamPartKind& kind : kStreamParts)
    json["parts"][std::string(kind.name)] = {
        {"dtype", kind.dtype}, {"channels", kind.channels}, {"what", kind.what}};
  for (const StreamKey& key : stream_keys())
    json["json"][std::string(key.message)][std::string(key.path)] = key.what;
  return json.dump(2);
}

}  // namespace alltact
