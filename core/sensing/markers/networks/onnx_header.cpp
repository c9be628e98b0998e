#include "core/sensing/markers/networks/onnx_header.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

namespace alltact {
namespace {

/// One field of a protocol buffer's message.
struct Field {
  std::uint64_t number = 0;
  std::uint64_t value = 0;  // of an integer field
  std::string_view bytes;   // of a message or a string
  bool is_bytes = false;
};

/// Reads a message field by field. Every length is checked against the bytes left.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}

  /// False at the end, and where no valid field follows.
  bool next(Field& field) {
    if (rest_.empty() || is_broken_) return false;
    std::uint64_t key = 0;
    field = {};
    if (!read_varint(key)) return fail();
    field.number = key >> 3U;
    switch (key & 7U) {
      case 0:
        return read_varint(field.value) || fail();
      case 1:
        return skip(8) || fail();
      case 2: {
        std::uint64_t length = 0;
        if (!read_varint(length) || length > rest_.size()) return fail();
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
  /// The next integer of a packed field; nullopt at the end.
  std::optional<std::uint64_t> packed_number() {
    std::uint64_t value = 0;
    if (rest_.empty() || is_broken_) return std::nullopt;
    if (read_varint(value)) return value;
    is_broken_ = true;
    return std::nullopt;
  }

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
  bool read_varint(std::uint64_t& value) {
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

/// Calls visit for each field; false where the message is damaged.
template <class Visit>
bool each_field(std::string_view message, Visit visit) {
  Fields fields(message);
  Field field;
  while (fields.next(field)) visit(field);
  return !fields.is_broken();
}

/// ValueInfoProto: name 1, type 2 > tensor_type 1 > shape 2 > dim 1 > dim_value 1.
bool read_port(std::string_view message, OnnxPort& port) {
  bool is_complete = true;
  const auto dimension = [&](const Field& dim) {
    if (dim.number != 1 || !dim.is_bytes) return;
    std::int64_t size = 0;
    is_complete &= each_field(dim.bytes, [&](const Field& f) {
      constexpr auto kMaxSide =
          static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
      if (f.number == 1 && !f.is_bytes) size = f.value <= kMaxSide ? static_cast<int>(f.value) : 0;
    });
    port.shape.push_back(size);
  };
  const auto shape = [&](const Field& f) {
    if (f.number == 2 && f.is_bytes) is_complete &= each_field(f.bytes, dimension);
  };
  const auto type = [&](const Field& f) {
    if (f.number == 1 && f.is_bytes) is_complete &= each_field(f.bytes, shape);
  };
  is_complete &= each_field(message, [&](const Field& f) {
    if (f.number == 1 && f.is_bytes) port.name = f.bytes;
    if (f.number == 2 && f.is_bytes) is_complete &= each_field(f.bytes, type);
  });
  return is_complete;
}

constexpr std::uint64_t kMaxNumbers = std::uint64_t{1} << 28U;

/// Bytes of one number of a tensor, by TensorProto.DataType; 0 of unsupported types.
std::uint64_t bytes_of(std::uint64_t kind) {
  switch (kind) {
    case 1:  // float
    case 6:  // int32
      return 4;
    case 7:   // int64
    case 11:  // double
      return 8;
    case 2:  // uint8
    case 3:  // int8
    case 9:  // bool
      return 1;
    case 10:  // float16
      return 2;
    default:
      return 0;
  }
}

/// Integers of a repeated field, packed or one by one.
bool add_numbers(const Field& field, std::vector<std::uint64_t>& numbers) {
  if (!field.is_bytes) return numbers.push_back(field.value), true;
  Fields packed(field.bytes);
  while (auto value = packed.packed_number()) numbers.push_back(*value);
  return !packed.is_broken();
}

/// TensorProto: dims 1, data_type 2, float_data 4, int32_data 5, int64_data 7, name 8, raw_data 9,
/// double_data 10. True where the count of numbers matches the dimensions, which OpenCV trusts.
bool is_sound_tensor(std::string_view message, std::string* name) {
  std::vector<std::uint64_t> dims, numbers;
  std::uint64_t kind = 0, given = 0;
  bool is_complete = true;
  std::optional<std::uint64_t> raw;
  is_complete &= each_field(message, [&](const Field& field) {
    if (field.number == 1) is_complete &= add_numbers(field, dims);
    if (field.number == 2) kind = field.value;
    if (field.number == 4) given += field.is_bytes ? field.bytes.size() / 4 : 1;
    if (field.number == 10) given += field.is_bytes ? field.bytes.size() / 8 : 1;
    if (field.number == 5 || field.number == 7) is_complete &= add_numbers(field, numbers);
    if (field.number == 8 && field.is_bytes && name) *name = field.bytes;
    if (field.number == 9 && field.is_bytes) raw = field.bytes.size();
  });
  std::uint64_t count = 1;
  for (const std::uint64_t n : dims) {
    if (n > kMaxNumbers || (n > 0 && count > kMaxNumbers / n)) return false;
    count *= n;
  }
  const std::uint64_t size = bytes_of(kind);
  if (!is_complete || size == 0) return false;
  return raw ? *raw == count * size : given + numbers.size() == count;
}

/// AttributeProto: name 1, i 3, t 5, ints 8. Sizes, steps and groups are at least 1.
bool is_sound_attribute(std::string_view message) {
  std::string_view name;
  std::vector<std::uint64_t> numbers;
  bool is_complete = true;
  is_complete &= each_field(message, [&](const Field& field) {
    if (field.number == 1 && field.is_bytes) name = field.bytes;
    if (field.number == 3 || field.number == 8) is_complete &= add_numbers(field, numbers);
    if (field.number == 5 && field.is_bytes) is_complete &= is_sound_tensor(field.bytes, nullptr);
  });
  const bool is_size =
      name == "kernel_shape" || name == "strides" || name == "dilations" || name == "group";
  constexpr std::uint64_t kMaxSize = 1U << 16U;
  return is_complete &&
         (!is_size || std::all_of(numbers.begin(), numbers.end(), [](std::uint64_t n) {
           return n >= 1 && n <= kMaxSize;
         }));
}

/// A graph, parsed node by node.
struct Graph {
  OnnxHeader header;
  int nodes = 0;
  bool is_sound = true;
  std::set<std::string, std::less<>> known;  // weights, inputs and outputs of earlier nodes
  std::set<std::string, std::less<>> weights;

  /// GraphProto: node 1, initializer 5, input 11, output 12.
  void read(std::string_view message) {
    // Inputs of nodes may follow them in the file.
    is_sound &= each_field(message, [&](const Field& field) {
      if (field.is_bytes && field.number == 5) add_weights(field.bytes);
      if (!field.is_bytes || (field.number != 11 && field.number != 12)) return;
      OnnxPort port;
      is_sound &= read_port(field.bytes, port);
      if (field.number == 11) known.insert(port.name);
      (field.number == 11 ? header.inputs : header.outputs).push_back(std::move(port));
    });
    is_sound &= each_field(message, [&](const Field& field) {
      if (field.is_bytes && field.number == 1) add_node(field.bytes);
    });
    std::erase_if(header.inputs,
                  [this](const OnnxPort& port) { return weights.contains(port.name); });
    for (const OnnxPort& port : header.outputs) is_sound &= known.contains(port.name);
  }

 private:
  void add_weights(std::string_view message) {
    std::string name;
    is_sound &= is_sound_tensor(message, &name) && weights.insert(name).second;
    known.insert(std::move(name));
  }
  /// NodeProto: input 1, output 2, op_type 4, attribute 5. An optional input has an empty name.
  void add_node(std::string_view message) {
    std::vector<std::string> made;
    ++nodes;
    is_sound &= each_field(message, [&](const Field& field) {
      if (!field.is_bytes) return;
      if (field.number == 1) is_sound &= field.bytes.empty() || known.contains(field.bytes);
      if (field.number == 2) made.emplace_back(field.bytes);
      if (field.number == 5) is_sound &= is_sound_attribute(field.bytes);
    });
    is_sound &= !made.empty();
    for (std::string& name : made) is_sound &= name.empty() || known.insert(std::move(name)).second;
  }
};

}  // namespace

Result<OnnxHeader> read_onnx_header(std::string_view bytes, const Where& where) {
  Graph graph;
  bool is_complete = true;
  // ModelProto: graph 7, opset_import 8 (version 2).
  is_complete &= each_field(bytes, [&](const Field& field) {
    if (!field.is_bytes) return;
    if (field.number == 7) graph.read(field.bytes);
    if (field.number != 8) return;
    is_complete &= each_field(field.bytes, [&](const Field& f) {
      if (f.number == 2 && !f.is_bytes)
        graph.header.opset =
            std::max<std::int64_t>(graph.header.opset, static_cast<int>(f.value & 0xFFFFU));
    });
  });
  if (!is_complete || !graph.is_sound || graph.nodes == 0 || graph.header.inputs.empty() ||
      graph.header.outputs.empty())
    return Error{en::say("this is no network in the ONNX format, or only part of one, or damaged"),
                 where,
                 en::say("copying or exporting the file again")};
  return std::move(graph.header);
}

}  // namespace alltact
