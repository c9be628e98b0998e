#include "core/simulation/truth.h"

#include <nlohmann/json.hpp>

namespace alltact {

namespace {

nlohmann::ordered_json json_of(const Truth::Ball& ball) {
  return {{"centre_mm", {ball.centre_mm.x(), ball.centre_mm.y(), ball.centre_mm.z()}},
          {"radius_mm", ball.radius_mm},
          {"depth_mm", ball.depth_mm}};
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
  return json.dump();
}

}  // namespace alltact
