#include "app/commands/serve_messages.h"

#include "calibration/checks/finger_worth.h"
#include "calibration/export/description_json.h"
#include "calibration/verdict/verdict_json.h"
#include "core/io/depth_file.h"
#include "core/program.h"
#include "core/utc_time.h"

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

StreamMessage of_frame(const Frame& frame,
                       const std::string& line,
                       const FingerSnapshot& finger,
                       StreamPartSet requested) {
  assert(line.ends_with('}'));
  StreamMessage message;
  message.requested_parts = requested;
  message.sequence = frame.sequence;
  message.time_ns = frame.time_ns;
  message.json =
      line.substr(0, line.size() - 1) + fmt::format(",\"finger_revision\":{}}}", finger.revision);
  return message;
}

Json parts_json() {
  Json parts;
  for (const StreamPartKind& kind : kStreamParts)
    parts[std::string(kind.name)] = {
        {"dtype", kind.dtype}, {"channels", kind.channels}, {"what", kind.what}};
  Json& depth16 = parts[std::string(kStreamParts[kDepth16].name)];
  depth16["mm_per_step"] = kDepthStep_mm;
  depth16["zero_at"] = kDepthZero;
  depth16["none"] = 0;
  return parts;
}

}  // namespace

StreamMessage finger_message(const FingerSnapshot& finger,
                             const Pipeline& pipeline,
                             const ServedSource& source) {
  const CameraParameters& camera = pipeline.finger().camera;
  Json json;
  json["format"] = kStreamFormat;
  json["program"] = "alltact " + program_version();
  json["finger"] = finger.finger.name;
  json["finger_revision"] = finger.revision;
  if (const auto date = finger.finger.provenance.find("calibration_date");
      date != finger.finger.provenance.end())
    json["calibration_date"] = date->second;
  if (const auto worth = worth_of(finger, utc_now()).verdict)
    json["verdict"] = verdict_json(*worth);
  json["source"] = source.name;
  json["clock"] = source.is_camera ? "monotonic" : "source";
  json["frames_per_s"] = source.frames_per_s;
  json["size_px"] = {camera.width_px, camera.height_px};
  json["reduced_by"] = binning_factor(pipeline.settings().resolution);
  json["camera"] = camera_json(camera);
  json["face"] = face_json(finger.finger.face);
  json["parts"] = parts_json();
  StreamMessage message;
  message.type = StreamType::kFinger;
  message.json = text_of(json);
  return message;
}

StreamMessage frame_message(const FrameResult& result,
                            const std::string& line,
                            const FingerSnapshot& finger,
                            StreamPartSet requested) {
  StreamMessage message = of_frame(*result.frame, line, finger, requested);
  if (requested[kImage]) message.parts[kImage] = result.grey;
  if (!result.depth) return message;
  if (requested[kDepth16]) message.parts[kDepth16] = depth_steps(result.depth->depth_mm);
  if (requested[kDepth]) message.parts[kDepth] = result.depth->depth_mm;
  if (requested[kFlags]) message.parts[kFlags] = result.depth->flags;
  if (requested[kPoints])
    message.parts[kPoints] = contact_face_points_mm(result, finger.finger.face);
  return message;
}

StreamMessage unmeasured_message(const Frame& frame,
                                 const std::string& line,
                                 const FingerSnapshot& finger,
                                 StreamPartSet requested) {
  StreamMessage message = of_frame(frame, line, finger, requested);
  if (requested[kImage]) message.parts[kImage] = frame.grey;
  return message;
}

StreamMessage problem_message(const Error& problem) {
  StreamMessage message;
  message.type = StreamType::kProblem;
  message.json = text_of({{"problems", {problem.sentence()}}});
  return message;
}

std::string end_json(const Message& reason) {
  return text_of({{"reason", fmt::format("{}.", reason)}});
}

}  // namespace alltact
