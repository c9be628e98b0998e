#include "app/commands/recorded_depth.h"

#include "app/commands/result_files.h"
#include "core/io/depth_file.h"

#include <fmt/format.h>

namespace alltact {

Result<std::unique_ptr<RecordedDepth>> RecordedDepth::create(const ReconstructOptions& options,
                                                             cv::Size size,
                                                             double frames_per_s) {
  const std::string name = options.part ? part_video(*options.part) : std::string(kDepthVideoFile);
  auto video = DepthVideoWriter::create(options.folder / name, size, frames_per_s);
  if (!video) return video.error();
  return std::unique_ptr<RecordedDepth>(new RecordedDepth(size, std::move(*video)));
}

Status RecordedDepth::compress(const BatchFrame& frame, FrameLine& line) {
  std::optional<DepthPackets> packets;
  {
    const std::lock_guard lock(lock_);
    if (!idle_.empty()) {
      packets = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (!packets) {
    auto made = DepthPackets::create(size_);
    if (!made) return made.error();
    packets = std::move(*made);
  }
  const bool has_depth = frame.result && frame.result->depth;
  auto packet = packets->packet(has_depth ? depth_steps(frame.result->depth->depth_mm)
                                          : cv::Mat(size_, CV_16UC1, cv::Scalar(0)));
  if (!packet) return packet.error();
  line.depth_packet = std::move(*packet);
  if (has_depth)
    add_depth_steps(line.line,
                    "depth_video",
                    fmt::format("\"file\":\"{}\",\"picture\":{}", kDepthVideoFile, frame.index));
  const std::lock_guard lock(lock_);
  idle_.push_back(std::move(*packets));
  return {};
}

}  // namespace alltact
