#include "core/sensing/result_json.h"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::json;

FrameResult empty_result() {
  FrameResult result;
  auto frame = std::make_shared<Frame>();
  frame->name = "press_003";
  result.frame = frame;
  return result;
}

ContactRegion region_at_origin() {
  ContactRegion region;
  region.position_mm.setZero();
  region.position_px.setZero();
  region.deepest_point_mm.setZero();
  return region;
}

TEST(ResultLine, WhatCouldNotBeHadIsAbsent) {
  FrameResult result = empty_result();
  result.problems = {en::say("no {} was found", std::string("\"face\""))};
  const std::string line = result_line(result, 3, ReferenceMethod::kLocal);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const Json json = Json::parse(line);
  EXPECT_EQ(json.at("frame"), "press_003");
  EXPECT_EQ(json.at("index"), 3);
  EXPECT_EQ(json.at("problems"), Json({"no \"face\" was found"}));
  for (const char* key : {"markers", "reference", "contact", "regions", "force"})
    EXPECT_FALSE(json.contains(key)) << key;
  for (const char* step : {"edges", "global", "markers", "reference", "local", "contact"})
    EXPECT_FALSE(json.at("times_ms").contains(step)) << step;
}

TEST(ResultLine, ForcesStandWithTheirErrors) {
  FrameResult result = empty_result();
  result.force.emplace();
  result.force->axes = 3;
  result.force->force_N = {3.1, 0.12345, -0.5};
  result.force->sd_N = {0.1, 0.05, 0.2};
  result.force->half_95_N = {0.2, 0.1, 0.4};
  result.force->in_range = true;
  const Json json = Json::parse(result_line(result, 3, ReferenceMethod::kLocal));
  EXPECT_EQ(json.at("force"),
            Json::parse(R"({"fx_n": 3.1, "fy_n": 0.1235, "fz_n": -0.5, "sd_n": [0.1, 0.05, 0.2],
                            "half_95_n": [0.2, 0.1, 0.4], "in_range": true})"));
}

TEST(ResultLine, ContactsStandWithTheirPlaceOrWhyThereIsNone) {
  FrameResult result = empty_result();
  FingerContact& contact = result.contact.emplace();
  contact.direction = Eigen::Vector3d(0.6, 0, -0.8);
  contact.position = PositionOnFinger{52.3, -1.5, 0.4, 0.05, 0.06, 0.01};
  contact.is_new = true;
  contact.held_s = 0.0;
  const auto line = [&] {
    return Json::parse(result_line(result, 3, ReferenceMethod::kLocal)).at("finger_contact");
  };
  EXPECT_EQ(line(),
            Json::parse(R"({"face": "contact", "direction": [0.6, 0.0, -0.8], "along_mm": 52.3,
                "along_sd_mm": 0.05, "across_mm": -1.5, "across_sd_mm": 0.06, "depth_mm": 0.4,
                "depth_sd_mm": 0.01, "new": true, "held_s": 0.0})"));
  contact = {};
  contact.face = PushedFace::kUpper;
  contact.direction_sd_deg = 1.25;
  contact.no_position = en::say("nobody knows");
  contact.is_slipping = true;
  EXPECT_EQ(line(),
            Json::parse(R"({"face": "upper", "direction_sd_deg": 1.25, "no_place": "nobody knows",
                "new": false, "slipping": true})"));
}

TEST(ResultLine, CarriesEverythingUnderTheDesignsNames) {
  FrameResult result = empty_result();
  result.markers = Markers{{101.2, 48.9, true, 0.02}, {1.0, 2.0, false, 0.5}};
  result.reference.emplace();
  result.reference->frame = 117;
  result.reference->distance_px = 1.8;
  result.push.emplace();
  result.push->offset_px = {12.1, 0.4};
  result.push->direction = Eigen::Vector3d(0.999, 0.03, 0.0);
  result.push->sd_deg = 1.2;
  result.push->face = PushedFace::kContact;
  result.depth.emplace();
  result.depth->flags = (cv::Mat_<std::uint8_t>(1, 4) << kMeasured, kSaturated, kOffFace, kOffFace);
  ContactRegion region = region_at_origin();
  region.position_mm = {3.1, -0.2, 48.0};
  region.deepest_mm = 0.83;
  region.position_on_face_mm = {31.5, -0.2};
  region.area_mm2 = 11.9;
  region.volume_mm3 = 4.1;
  result.regions = {region};
  const Json json = Json::parse(result_line(result, 3, ReferenceMethod::kNearest));
  EXPECT_EQ(json.at("markers"),
            Json::parse(
                R"([{"u": 101.2, "v": 48.9, "seen": true}, {"u": 1.0, "v": 2.0, "seen": false}])"));
  EXPECT_EQ(json.at("reference"),
            Json::parse(
                R"({"method": "nearest", "frame": 117, "distance_px": 1.8, "known_pose": true})"));
  EXPECT_EQ(json.at("contact"), Json::parse(R"({"touched": true, "offset_px": [12.1, 0.4],
      "direction": [0.999, 0.03, 0.0], "sd_deg": 1.2, "face": "contact"})"));
  EXPECT_EQ(json.at("validity"), Json::parse(R"({"measured": 0.5, "saturated": 0.5})"));
  EXPECT_EQ(json.at("regions"), Json::parse(R"([{"place_mm": [3.1, -0.2, 48.0],
      "place_on_face_mm": [31.5, -0.2], "deepest_mm": 0.83, "area_mm2": 11.9,
      "volume_mm3": 4.1}])"))
      << "a round contact has no angle";
  EXPECT_FALSE(json.contains("problems"));
  result.reference->by_shape = true;
  EXPECT_EQ(
      Json::parse(result_line(result, 3, ReferenceMethod::kNearest)).at("reference").at("by_shape"),
      true);
}

TEST(ResultLine, NumbersThatAreNoneAreLeftOut) {
  FrameResult result = empty_result();
  result.depth.emplace();
  result.depth->flags = (cv::Mat_<std::uint8_t>(1, 4) << kMeasured, kSaturated, kOffFace, kOffFace);
  ContactRegion region = region_at_origin();
  region.position_mm = {0, 0, std::numeric_limits<double>::quiet_NaN()};
  region.deepest_mm = std::numeric_limits<double>::infinity();
  region.area_mm2 = 1;
  result.regions = {region};
  const std::string line = result_line(result, 0, ReferenceMethod::kLocal);
  EXPECT_EQ(line.find("null"), std::string::npos);
  const Json json = Json::parse(line);
  EXPECT_FALSE(json.at("regions")[0].contains("place_mm"));
  EXPECT_FALSE(json.at("regions")[0].contains("deepest_mm"));
  EXPECT_TRUE(json.at("regions")[0].contains("area_mm2"));
}

TEST(FailureLine, IsOneObjectWithItsReason) {
  const Json json = Json::parse(failure_line("a \"b\" \xff", 7, {Message::typed("broken\nfile")}));
  EXPECT_EQ(json.at("index"), 7);
  EXPECT_EQ(json.at("problems")[0], "broken\nfile");
}

TEST(ResultJson, TheWayMarkersWereFoundIsSaidUnlessItIsTheUsualOne) {
  FrameResult result;
  auto frame = std::make_shared<Frame>();
  frame->name = "one";
  result.frame = frame;
  result.markers = Markers{{1.5, 2.5, true, 0.1}};
  EXPECT_EQ(result_line(result, 0, ReferenceMethod::kLocal).find("marker_method"),
            std::string::npos);
  result.marker_method = MarkerMethod::kNetwork;
  EXPECT_NE(result_line(result, 0, ReferenceMethod::kLocal).find(R"("marker_method":"network")"),
            std::string::npos);
  result.markers.reset();
  EXPECT_EQ(result_line(result, 0, ReferenceMethod::kLocal).find("marker_method"),
            std::string::npos);
}

}  // namespace
}  // namespace alltact
