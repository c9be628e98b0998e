// One description reads and writes a struct: what it writes stands below as text, and comes back.
#include "core/base/fields.h"

#include "core/base/json_fields.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

enum class Grip { kLoose = 1, kFirm };

struct Screw {
  double pitch_mm = 0.5, length_mm = 0;
  std::string note;
};
struct Plate {
  std::string name;
  Grip grip = Grip::kLoose;
  std::vector<int> holes;
  double width_mm = 0, height_mm = 0;
  bool is_flat = false;
  std::optional<Screw> lock;
  std::vector<Screw> screws;
  std::map<std::string, std::string> record;
};

void describe(Fields& fields, Screw& screw) {
  fields.number(may("pitch_mm"), screw.pitch_mm, {0, 10});
  fields.number("length_mm", screw.length_mm, en::say("a length in mm"));
  fields.text(may("note", !screw.note.empty()), screw.note);
}

void describe(Fields& fields, Plate& plate) {
  fields.format("alltact-plate/1", "");
  fields.text("name", plate.name);
  fields.choice("grip", plate.grip, {"loose", "firm"});
  fields.integers(may("holes", !plate.holes.empty()), plate.holes, 100, std::nullopt,
                  en::say("must be small"), "");
  fields.numbers("size_mm", {&plate.width_mm, &plate.height_mm}, en::say("must be two lengths"));
  fields.flag(may("flat").required_if(plate.grip == Grip::kFirm), plate.is_flat);
  fields.section(may("lock"), plate.lock);
  fields.sections(may("screws", !plate.screws.empty()), plate.screws, Fields::Layout::kLines);
  fields.texts_by_name("record", plate.record, Fields::Layout::kLines);
}

constexpr const char* kPlate = R"(format: alltact-plate/1
name: left plate
grip: firm
holes: [3, 7]
size_mm: [24.0, 1.5]
flat: true
lock: {pitch_mm: 0.5, length_mm: 8.0, colour: red}
screws:
  - pitch_mm: 0.25
    length_mm: 4.0
    note: "12"
  - pitch_mm: 0.5
    length_mm: 6.0
    head: {slot: 1}
record:
  date: 2026-01-31
later: [1, 2]
)";

TEST(Fields, WriteWhatTheyReadWithUnknownKeysInTheirPlaces) {
  YamlFile file("plate.yaml");
  const auto plate = read_fields<Plate>(file, kPlate);
  ASSERT_TRUE(plate.ok()) << plate.error().sentence();
  EXPECT_EQ(plate->grip, Grip::kFirm);
  EXPECT_EQ(plate->holes, (std::vector{3, 7}));
  EXPECT_EQ(plate->height_mm, 1.5);
  EXPECT_TRUE(plate->is_flat);
  EXPECT_EQ(plate->lock->length_mm, 8.0);
  EXPECT_EQ(plate->screws.at(0).note, "12");
  EXPECT_EQ(plate->screws.at(1).pitch_mm, 0.5);
  EXPECT_EQ(plate->record.at("date"), "2026-01-31");
  EXPECT_EQ(file.warnings().size(), 3U);
  EXPECT_EQ(fields_text(*plate, file.unknown()), kPlate);
}

TEST(Fields, LeaveOutWhatMayBeAbsent) {
  const std::string least =
      "format: alltact-plate/1\nname: a\ngrip: loose\nsize_mm: [1.0, 2.0]\nflat: false\n";
  YamlFile file("plate.yaml");
  const auto plate =
      read_fields<Plate>(file, least.substr(0, least.find("flat")) + "screws: [{length_mm: 4}]\n");
  ASSERT_TRUE(plate.ok()) << plate.error().sentence();
  EXPECT_FALSE(plate->lock.has_value());
  EXPECT_EQ(plate->screws.at(0).pitch_mm, 0.5);
  Plate bare = *plate;
  bare.screws.clear();
  EXPECT_EQ(fields_text(bare), least);
}

TEST(Fields, RefuseByLineAndKey) {
  const auto refusal = [](const std::string& from, const std::string& to) {
    std::string text = kPlate;
    text.replace(text.find(from), from.size(), to);
    YamlFile file("plate.yaml");
    const auto plate = read_fields<Plate>(file, text);
    return plate ? "read" : plate.error().sentence();
  };
  EXPECT_THAT(refusal("plate/1", "plate/2"), HasSubstr("plate.yaml:1: format: 'alltact-plate/2'"));
  EXPECT_THAT(refusal("firm", "tight"), HasSubstr("plate.yaml:3: grip: 'tight' is not known here"));
  EXPECT_THAT(refusal("[3, 7]", "[3, 101]"), HasSubstr("plate.yaml:4: holes: must be small"));
  EXPECT_THAT(refusal("[3, 7]", "[3, 7.5]"), HasSubstr("plate.yaml:4: holes: must be small"));
  EXPECT_THAT(refusal("[24.0, 1.5]", "[24.0]"),
              HasSubstr("plate.yaml:5: size_mm: must be two lengths"));
  EXPECT_THAT(refusal("flat: true\n", ""), HasSubstr("flat: is missing"));
  EXPECT_THAT(refusal("length_mm: 8.0, ", ""), HasSubstr("plate.yaml:7: lock.length_mm: is miss"));
  EXPECT_THAT(refusal("0.25", "11"), HasSubstr("plate.yaml:9: screws[0].pitch_mm: must be"));
}

struct Gauge {
  int count = 0;
  double sd_N = 0;
  std::optional<Eigen::Vector2d> position_mm;
  std::vector<Screw> screws;
};

void describe(JsonFields& fields, Screw& screw) { fields.field("pitch_mm", screw.pitch_mm); }

void describe(JsonFields& fields, Gauge& gauge) {
  fields.field("count", gauge.count);
  fields.field("sd_N", gauge.sd_N);
  fields.field("position_mm", gauge.position_mm);
  fields.field("screws", gauge.screws);
}

/// What is refused of a gauge, or the gauge written again.
std::string read_again(const std::string& text, const JsonFields::Rules& rules = {}) {
  const auto json = JsonFields::Json::parse(text);
  Gauge gauge;
  try {
    JsonFields fields(json, rules);
    describe(fields, gauge);
  } catch (const RefusedJson& refused) {
    return refused.path + " " + refused.what_is_wrong.english();
  }
  return written_json(gauge).dump();
}

TEST(JsonFields, WriteWhatTheyRead) {
  for (const char* text :
       {R"({"count":3,"sd_N":0.5,"position_mm":[1.5,-2.0],"screws":[{"pitch_mm":0.25}]})",
        R"({"count":0,"sd_N":1e-09,"screws":[]})"})
    EXPECT_EQ(read_again(text), text);
  const char* unknown = R"({"count":3,"sd_N":null,"screws":[]})";
  EXPECT_EQ(read_again(unknown, {.null_is_nan = true}), unknown);
}

TEST(JsonFields, RefuseByPath) {
  const JsonFields::Rules rules{.root = "gauge", .largest = 1e6};
  EXPECT_EQ(read_again("[1]", rules), "gauge is not an object");
  EXPECT_EQ(read_again(R"({"sd_N":1})", rules), "gauge.count is missing");
  EXPECT_EQ(read_again(R"({"count":1.5})", rules), "count is not an integer");
  EXPECT_EQ(read_again(R"({"count":1,"sd_N":null})", rules), "sd_N is not a number");
  EXPECT_EQ(read_again(R"({"count":1,"sd_N":1e6})", rules), "sd_N is not a valid number");
  EXPECT_EQ(read_again(R"({"count":1,"sd_N":1,"screws":{}})", rules), "screws is not a list");
  EXPECT_EQ(read_again(R"({"count":1,"sd_N":1,"screws":[{"pitch_mm":1},{}]})", rules),
            "screws[1].pitch_mm is missing");
}

}  // namespace
}  // namespace alltact
