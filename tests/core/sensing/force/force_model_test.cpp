// A force model measures, and its file is read strictly.
#include "core/sensing/force/force_meter.h"
#include "tests/support/two_marker_force.h"

#include <limits>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using ModelJson = nlohmann::ordered_json;

using test::two_marker_force;

Markers moved(double u0, double v0, double u1, double v1) {
  return {{100 + u0, 50 + v0, true, 0.1}, {100 + u1, 450 + v1, true, 0.1}};
}

TEST(ForceModel, MeasuresWithSdAndIntervals) {
  const ForceModel model = two_marker_force();
  const auto force = model(force_input(model, moved(6, 0, 0, 3), std::nullopt));
  ASSERT_TRUE(force);
  EXPECT_EQ(force->axes, 2);
  EXPECT_NEAR(force->force_N[0], 0.6, 1e-12);
  EXPECT_NEAR(force->force_N[1], 0.6, 1e-12);
  EXPECT_EQ(force->force_N[2], 0);
  // The members differ by 0.005 in Fx, in Fy not at all.
  EXPECT_NEAR(force->sd_N[0], std::hypot(0.03, 0.005), 1e-12);
  EXPECT_NEAR(force->half_95_N[0], 2 * std::hypot(0.03, 0.005), 1e-12);
  EXPECT_NEAR(force->half_90_N[1], 1.7 * 0.04, 1e-12);
  EXPECT_TRUE(force->in_range);
  EXPECT_FALSE(model(force_input(model, moved(30, 0, 0, 0), std::nullopt))->in_range);
}

TEST(ForceModel, NothingIsToldOfWhatCannotBeMeasured) {
  const ForceModel model = two_marker_force();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity, 1e300})
    EXPECT_FALSE(model(force_input(model, moved(bad, 0, 0, 0), std::nullopt))) << bad;
  Markers hidden = moved(1, 0, 0, 0);
  for (Marker& marker : hidden) marker.seen = false;
  EXPECT_FALSE(model(force_input(model, hidden, std::nullopt)));
  EXPECT_FALSE(model(force_input(model, {hidden[0]}, std::nullopt)));
  EXPECT_FALSE(model(force_input(model, {}, std::nullopt)));
  // Where a marker is hidden, what was guessed of it is of no account.
  hidden[0].seen = true, hidden[1] = {nan, nan, false, 0};
  const auto force = model(force_input(model, hidden, Eigen::Vector2d(nan, 0)));
  ASSERT_TRUE(force);
  EXPECT_TRUE(force->force_N.allFinite() && force->half_95_N.allFinite());
}

TEST(ForceModel, HiddenMarkersAreFilledInFromTheOthers) {
  ForceModel model = two_marker_force();
  // Both markers move as one along u.
  model.range.components = Eigen::MatrixXd::Zero(4, 1);
  model.range.components(0, 0) = model.range.components(2, 0) = std::sqrt(0.5);
  model.range.component_sd_px = Eigen::VectorXd::Constant(1, 20);
  Markers markers = moved(0, 0, 4, 0);
  markers[0].seen = false;
  const auto force = model(force_input(model, markers, std::nullopt));
  ASSERT_TRUE(force);
  EXPECT_NEAR(force->force_N[0], 0.4, 1e-4);
}

TEST(ForceModel, ANetworkIsEvaluatedLayerByLayer) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 1);
  const auto drawn = [&](Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXd m(rows, columns);
    for (double& value : m.reshaped()) value = normal(random);
    return m;
  };
  const ForceRegressor network{
      {drawn(3, 4), drawn(3, 1)}, {drawn(2, 3), drawn(2, 1)}, {drawn(2, 2), drawn(2, 1)}};
  for (int round = 0; round < 20; ++round) {
    const Eigen::VectorXd z = drawn(4, 1);
    std::vector<long double> values(z.begin(), z.end());
    for (std::size_t layer = 0; layer < 3; ++layer) {
      std::vector<long double> next;
      for (Eigen::Index row = 0; row < network[layer].bias.size(); ++row) {
        long double sum = network[layer].bias[row];
        for (std::size_t i = 0; i < values.size(); ++i)
          sum += network[layer].weights(row, static_cast<Eigen::Index>(i)) * values[i];
        next.push_back(layer < 2 ? std::max(sum, 0.0L) : sum);
      }
      values = next;
    }
    const Eigen::VectorXd told = force_of(network, z);
    for (Eigen::Index i = 0; i < 2; ++i)
      EXPECT_NEAR(told[i], static_cast<double>(values[static_cast<std::size_t>(i)]), 1e-12);
  }
}

TEST(CreepMean, FollowsWithItsTimeAndBeginsAnewAfterAGap) {
  CreepMean creep(2.0);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(2), one = Eigen::VectorXd::Ones(2);
  EXPECT_EQ(creep(none, 10.0).norm(), 0);
  for (int i = 1; i <= 10; ++i)
    EXPECT_NEAR(creep(one, 10.0 + 0.1 * i)[0], std::exp(-0.1 * i / 2.0), 1e-12) << i;
  EXPECT_EQ(creep(one, 30.0).norm(), 0) << "after a gap nothing is known";
  EXPECT_EQ(creep(none, 29.0).norm(), 0) << "nor where time goes back";
}

TEST(ForceModelFile, ReadsBackWhatItWrote) {
  ForceModel model = two_marker_force();
  model.range.position_mm = {Eigen::Vector2d(10, -5), Eigen::Vector2d(70, 5)};
  model.missing = {1};
  model.creep_s = 1.5;
  const std::string json = model.to_json();
  const auto again = ForceModel::parse(json, "model.json");
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(again->to_json(), json);
  const ForceInput input = force_input(model, moved(1, 2, 3, 4), Eigen::Vector2d(30, 0));
  EXPECT_EQ((*again)(input)->force_N, model(input)->force_N);
}

TEST(ForceModelFile, EveryPartOfAFileIsRefused) {
  const std::string json = two_marker_force().to_json();
  for (std::size_t length = 0; length < json.size(); ++length) {
    const auto model = ForceModel::parse(json.substr(0, length), "model.json");
    ASSERT_FALSE(model) << length;
    EXPECT_NE(model.error().sentence().find("damaged or truncated"), std::string::npos);
  }
}

/// The sentence that a model is refused with after a change.
template <class Change>
std::string refusal_of(const Change& change) {
  ModelJson json = ModelJson::parse(two_marker_force().to_json());
  change(json);
  const auto model = ForceModel::parse(json.dump(), "model.json");
  EXPECT_FALSE(model);
  return model ? "" : model.error().sentence();
}

TEST(ForceModelFile, EveryKeyIsNeededAndOfItsKind) {
  const ModelJson whole = ModelJson::parse(two_marker_force().to_json());
  for (const auto& [key, value] : whole.items()) {
    const std::string name = key;
    EXPECT_NE(refusal_of([&](ModelJson& json) { json.erase(name); }).find("is missing"),
              std::string::npos)
        << name;
    EXPECT_NE(refusal_of([&](ModelJson& json) { json[name] = nullptr; }), "") << name;
  }
  for (const char* part : {"range", "scores"})
    for (const auto& [key, value] : whole.at(part).items()) {
      const std::string name = key;
      EXPECT_NE(refusal_of([&](ModelJson& json) { json[part].erase(name); }), "") << name;
      EXPECT_NE(refusal_of([&](ModelJson& json) { json[part][name] = "x"; }), "") << name;
    }
  for (const auto& [key, value] : whole.at("members").at(0).items()) {
    const std::string name = key;
    EXPECT_NE(refusal_of([&](ModelJson& json) { json["members"][1].erase(name); }), "") << name;
    EXPECT_NE(refusal_of([&](ModelJson& json) { json["members"][1][name] = "x"; }), "") << name;
  }
}

TEST(ForceModelFile, WrongShapesAndNumbersAreRefusedWithTheirPlace) {
  const auto told = [](const std::string& sentence, const char* words) {
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("model.json"), std::string::npos) << sentence;
  };
  told(refusal_of([](ModelJson& json) { json["format"] = "alltact-force/9"; }),
       "cannot be read by this");
  told(refusal_of([](ModelJson& json) { json["kind"] = "oracle"; }), "mean, ridge, quadratic");
  told(refusal_of([](ModelJson& json) { json["kind"] = "network"; }), "does not have the shape");
  told(refusal_of([](ModelJson& json) { json["axes"] = 3; }), "does not have the shape");
  told(refusal_of([](ModelJson& json) { json["axes"] = 1; }), "must be 2 or 3");
  told(refusal_of([](ModelJson& json) { json["marker_count"] = 3; }), "does not have the shape");
  told(refusal_of([](ModelJson& json) { json["marker_count"] = 1e9; }), "marker_count");
  told(refusal_of([](ModelJson& json) { json["members"] = ModelJson::array(); }), "members");
  told(refusal_of([](ModelJson& json) { json["members"][0]["regressors"] = ModelJson::array(); }),
       "are missing");
  told(refusal_of([](ModelJson& json) {
         json["members"][1]["regressors"][0][0]["weights"]["columns"] = 5;
       }),
       "members[1].regressors");
  told(refusal_of(
           [](ModelJson& json) { json["members"][1]["regressors"][0][0]["bias"].push_back(1.0); }),
       "does not have the shape");
  told(refusal_of([](ModelJson& json) { json["members"][0]["flags"] = {7}; }), "flags");
  told(refusal_of([](ModelJson& json) { json["members"][0]["squared"] = 5; }), "squared");
  told(refusal_of([](ModelJson& json) { json["scores"]["floor_N"][0] = 0; }), "above 0");
  told(refusal_of([](ModelJson& json) { json["scores"]["rms"] = {1}; }), "scores");
  told(refusal_of([](ModelJson& json) { json["range"]["noise_px"] = -1; }), "above 0");
  told(refusal_of([](ModelJson& json) { json["range"]["mean_px"][0] = 1e20; }),
       "not a valid number");
  told(refusal_of([](ModelJson& json) { json["creep_s"] = -1; }), "creep_s");
}

TEST(ForceModelFile, AnyByteChangedGivesAModelOrASentence) {
  const std::string json = two_marker_force().to_json();
  std::mt19937 random(6);
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = json;
    for (int i = 0; i < 1 + round % 3; ++i)
      bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    const auto model = ForceModel::parse(bytes, "model.json");
    if (!model) {
      EXPECT_FALSE(model.error().sentence().empty());
    } else if (const auto force = (*model)(force_input(*model, moved(1, 2, 3, 4), std::nullopt))) {
      EXPECT_TRUE(force->force_N.allFinite() && force->half_95_N.allFinite());
    }
  }
}

TEST(ForceModel, BelongsToItsMarkersAlone) {
  ForceModel model = two_marker_force();
  Finger finger;
  finger.markers.per_row = 1;
  finger.contact = ContactSettings{5.0, model.rest_px};
  EXPECT_TRUE(model.belongs_to(finger));
  finger.contact->rest_markers[1].x() += 7;
  EXPECT_NE(model.belongs_to(finger).error().sentence().find("rested up to 7.0 px"),
            std::string::npos);
  finger.contact->rest_markers = model.rest_px;
  finger.markers.missing = {0};
  EXPECT_FALSE(model.belongs_to(finger));
  finger.markers = {6, Polarity::kBright, {}};
  EXPECT_NE(model.belongs_to(finger).error().sentence().find("2 markers, the finger has 12"),
            std::string::npos);
}

}  // namespace
}  // namespace alltact
