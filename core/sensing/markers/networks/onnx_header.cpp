#include "core/sensing/markers/networks/onnx_header.h"

#include <algorithm>
#include <limits>
#include <set>

namespace alltact {
namespace {

/// One field of a protocol buffer's message.
struct Field {
  std::uint64_t number = 0;
  std::uint64_t value = 0;  // of a whole number
  std::string_view bytes;   // of a message or a text
  bool is_bytes = false;
};

/// Reads a message field by field. Every length is held against what there is.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}

  /// False at the end, and where what follows is no field.
  bool next(Field& field) {
    if (rest_.empty() || is_broken_) return false;
    std::uint64_t key = 0;
    field = {};
    if (!whole_number(key)) return fail();
    field.number = key >> 3U;
    switch (key & 7U) {
      case 0:
        return whole_number(field.value) || fail();
      case 1:
        return skip(8) || fail();
      case 2: {
        std::uint64_t length = 0;
        if (!whole_number(length) || length > rest_.size()) return fail();
        field.bytes = rest_.substr(0, static_cast<std::size_t>(length));
        field.is_bytes = true;
        return skip(static_cast<std::size_t>(length));
      }
      case 5:
        return skip(4) || fail();
      default:
        return fail();
    }
  }
  [[nodiscard]] bool is_broken() const { return is_broken_; }

 private:
  bool fail() {
    is_broken_ = true;
    return false;
  }
  bool skip(std::size_t count) {
    if (count > rest_.size()) return false;
    rest_.remove_prefix(count);
    return true;
  }
  bool whole_number(std::uint64_t& value) {
    value = 0;
    for (unsigned shift = 0; shift < 64 && !rest_.empty(); shift += 7) {
      const auto byte = static_cast<unsigned char>(rest_.front());
      rest_.remove_prefix(1);
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if ((byte & 0x80U) == 0) return true;
    }
    return false;
  }

  std::string_view rest_;
  bool is_broken_ = false;
};

/// Calls visit for each field; false where the message is broken.
template <class Visit>
bool each_field(std::string_view message, Visit visit) {
  Fields fields(message);
  Field field;
  while (fields.next(field)) visit(field);
  return !fields.is_broken();
}

/// ValueInfoProto: name 1, type 2 > tensor_type 1 > shape 2 > dim 1 > dim_value 1.
bool read_port(std::string_view message, OnnxPort& port) {
  bool is_whole = true;
  const auto dimension = [&](const Field& dim) {
    if (dim.number != 1 || !dim.is_bytes) return;
    std::int64_t size = 0;
    is_whole &= each_field(dim.bytes, [&](const Field& f) {
      constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
      if (f.number == 1 && !f.is_bytes) size = f.value <= kMost ? static_cast<int>(f.value) : 0;
    });
    port.shape.push_back(size);
  };
  const auto shape = [&](const Field& f) {
    if (f.number == 2 && f.is_bytes) is_whole &= each_field(f.bytes, dimension);
  };
  const auto type = [&](const Field& f) {
    if (f.number == 1 && f.is_bytes) is_whole &= each_field(f.bytes, shape);
  };
  is_whole &= each_field(message, [&](const Field& f) {
    if (f.number == 1 && f.is_bytes) port.name = f.bytes;
    if (f.number == 2 && f.is_bytes) is_whole &= each_field(f.bytes, type);
  });
  return is_whole;
}

/// GraphProto: node 1, initializer 5 (TensorProto: name 8), input 11, output 12.
bool read_graph(std::string_view message, OnnxHeader& header, int& nodes) {
  bool is_whole = true;
  std::set<std::string, std::less<>> weights;
  is_whole &= each_field(message, [&](const Field& field) {
    if (!field.is_bytes) return;
    if (field.number == 1) ++nodes;
    if (field.number == 5)
      is_whole &= each_field(field.bytes, [&](const Field& f) {
        if (f.number == 8 && f.is_bytes) weights.emplace(f.bytes);
      });
    if (field.number != 11 && field.number != 12) return;
    OnnxPort port;
    is_whole &= read_port(field.bytes, port);
    (field.number == 11 ? header.inputs : header.outputs).push_back(std::move(port));
  });
  std::erase_if(header.inputs, [&](const OnnxPort& port) { return weights.contains(port.name); });
  return is_whole;
}

}  // namespace

Result<OnnxHeader> read_onnx_header(std::string_view bytes, const Where& where) {
  OnnxHeader header;
  int nodes = 0;
  bool is_whole = true;
  // ModelProto: graph 7, opset_import 8 (version 2).
  is_whole &= each_field(bytes, [&](const Field& field) {
    if (field.number == 7 && field.is_bytes) is_whole &= read_graph(field.bytes, header, nodes);
    if (field.number == 8 && field.is_bytes)
      is_whole &= each_field(field.bytes, [&](const Field& f) {
        if (f.number == 2 && !f.is_bytes)
          header.opset = std::max<std::int64_t>(header.opset, static_cast<int>(f.value & 0xFFFF));
      });
  });
  if (!is_whole || nodes == 0 || header.inputs.empty() || header.outputs.empty())
    return Error{en::say("this is no network in the ONNX format, or only part of one"),
                 where,
                 en::say("copying or exporting the file again")};
  return header;
}

}  // namespace alltact
