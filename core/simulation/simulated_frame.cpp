#include "core/simulation/simulated_frame.h"

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

nlohmann::ordered_json json_of(const Truth::Ball& ball) {
  return {{"centre_mm", {ball.centre_mm.x(), ball.centre_mm.y(), ball.centre_mm.z()}},
          {"radius_mm", ball.radius_mm},
          {"depth_mm", ball.depth_mm}};
}

nlohmann::ordered_json json_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::ordered_json json_of(const ContactTruth& contact) {
  nlohmann::ordered_json json{{"name", contact.name},
                              {"face", to_string(contact.face)},
                              {"along_mm", contact.along_mm},
                              {"across_mm", contact.across_mm},
                              {"depth_mm", contact.depth_mm},
                              {"point_mm", json_of(contact.point_mm)},
                              {"direction", json_of(contact.direction)}};
  if (contact.angle_deg) json["angle_deg"] = *contact.angle_deg;
  if (contact.force_N) json["force_N"] = json_of(*contact.force_N);
  if (contact.camera_from_object) {
    const Eigen::Matrix4d matrix = contact.camera_from_object->matrix();
    for (int row = 0; row < 4; ++row) {
      auto numbers = nlohmann::ordered_json::array();
      for (int column = 0; column < 4; ++column) numbers.push_back(matrix(row, column));
      json["camera_from_object"].push_back(std::move(numbers));
    }
  }
  return json;
}

}  // namespace

std::string Truth::to_json() const {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!pose.empty()) json["pose"] = pose;
  if (!markers.empty()) {
    auto list = nlohmann::ordered_json::array();
    for (const Dot& dot : markers)
      list.push_back(nlohmann::ordered_json{{"u", dot.u}, {"v", dot.v}, {"visible", dot.visible}});
    json["markers"] = std::move(list);
  }
  if (ball) json["ball"] = json_of(*ball);
  if (balls.size() > 1)
    for (const Ball& one : balls) json["balls"].push_back(json_of(one));
  for (const ContactTruth& contact : contacts) json["contacts"].push_back(json_of(contact));
  return json.dump();
}

}  // namespace alltact
