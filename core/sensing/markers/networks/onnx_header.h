// What an ONNX file says of itself, read without running it: OpenCV tells neither the size of a
// picture that a network takes nor why it cannot read one.
#pragma once

#include "core/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// One input or output of a network. shape: 0 where the size is left open.
struct OnnxPort {
  std::string name;
  std::vector<std::int64_t> shape;
};

struct OnnxHeader {
  std::vector<OnnxPort> inputs, outputs;  ///< inputs without the weights
  std::int64_t opset = 0;
};

/// Walks the protocol buffer of a model (onnx.proto3: ModelProto, GraphProto, ValueInfoProto).
/// OpenCV believes a damaged file and then reads where nothing is, so every length is held against
/// what there is, every weight's dimensions against its bytes, and every name that a node takes
/// against those that are made before it. `where` is the file, for errors. Error: not an ONNX
/// model, cut off, or damaged.
[[nodiscard]] Result<OnnxHeader> read_onnx_header(std::string_view bytes, const Where& where);

}  // namespace alltact
