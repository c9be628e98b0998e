// Header of an ONNX file, read without running it: OpenCV reports neither the input size of a
// network nor why it cannot read one.
#pragma once

#include "core/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// One input or output of a network. shape: 0 for a dynamic size.
struct OnnxPort {
  std::string name;
  std::vector<std::int64_t> shape;
};

struct OnnxHeader {
  std::vector<OnnxPort> inputs, outputs;  ///< inputs exclude the weights
  std::int64_t opset = 0;
};

/// Parses the protocol buffer of a model (onnx.proto3: ModelProto, GraphProto, ValueInfoProto).
/// OpenCV trusts a damaged file and then reads out of bounds. So every length is checked against
/// the bytes left, every weight's dimensions against its bytes, and every input of a node against
/// the names defined before it. `where`: the file, for errors. Error: not an ONNX model, truncated,
/// or damaged.
[[nodiscard]] Result<OnnxHeader> read_onnx_header(std::string_view bytes, const Where& where);

}  // namespace alltact
