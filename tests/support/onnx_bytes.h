// Small networks in the ONNX format, written byte by byte as onnx.proto3 says, without any of its
// libraries.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace alltact::test {

namespace protobuf {

inline std::string number(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7U) bytes += static_cast<char>(0x80U | (value & 0x7FU));
  return bytes + static_cast<char>(value);
}
inline std::string whole(int field, std::int64_t value) {
  return number(static_cast<std::uint64_t>(field) << 3U) +
         number(static_cast<std::uint64_t>(value));
}
inline std::string block(int field, const std::string& bytes) {
  return number((static_cast<std::uint64_t>(field) << 3U) | 2U) + number(bytes.size()) + bytes;
}

}  // namespace protobuf

using Shape = std::vector<std::int64_t>;

/// A network as a list of nodes; each adds to the graph's bytes.
class OnnxBytes {
 public:
  /// 0 in a shape: left open, by the name "n".
  OnnxBytes& input(const std::string& name, const Shape& shape) { return port(11, name, shape); }
  OnnxBytes& output(const std::string& name, const Shape& shape) { return port(12, name, shape); }

  OnnxBytes& weights(const std::string& name, const Shape& shape,
                     const std::vector<float>& values) {
    std::string raw(values.size() * sizeof(float), '\0');
    std::memcpy(raw.data(), values.data(), raw.size());
    return tensor(name, shape, 1, raw);  // FLOAT
  }
  OnnxBytes& sizes(const std::string& name, const Shape& values) {
    std::string raw(values.size() * sizeof(std::int64_t), '\0');
    std::memcpy(raw.data(), values.data(), raw.size());
    return tensor(name, {static_cast<std::int64_t>(values.size())}, 7, raw);  // INT64
  }
  struct Attribute {
    std::string name;
    Shape values;
  };
  OnnxBytes& node(const std::string& kind, const std::vector<std::string>& from,
                  const std::string& to, const std::vector<Attribute>& attributes = {}) {
    using namespace protobuf;
    std::string bytes;
    for (const std::string& name : from) bytes += block(1, name);
    bytes += block(2, to) + block(3, "node_" + to) + block(4, kind);
    for (const Attribute& attribute : attributes) {
      std::string inner = block(1, attribute.name) + whole(20, 7);  // INTS
      for (const std::int64_t value : attribute.values) inner += whole(8, value);
      bytes += block(5, inner);
    }
    graph_ += block(1, bytes);
    return *this;
  }
  [[nodiscard]] std::string bytes(std::int64_t opset = 11) const {
    using namespace protobuf;
    return whole(1, 6) + block(2, "by hand") + block(7, graph_ + block(2, "graph")) +
           block(8, block(1, "") + whole(2, opset));
  }

 private:
  OnnxBytes& tensor(const std::string& name, const Shape& shape, int type, const std::string& raw) {
    using namespace protobuf;
    std::string bytes;
    for (const std::int64_t n : shape) bytes += whole(1, n);
    graph_ += block(5, bytes + whole(2, type) + block(8, name) + block(9, raw));
    return *this;
  }
  OnnxBytes& port(int field, const std::string& name, const Shape& shape) {
    using namespace protobuf;
    std::string dims;
    for (const std::int64_t n : shape) dims += block(1, n > 0 ? whole(1, n) : block(2, "n"));
    graph_ += block(field, block(1, name) + block(2, block(1, whole(1, 1) + block(2, dims))));
    return *this;
  }
  std::string graph_;
};

}  // namespace alltact::test
