#include "core/finger/finger.h"

#include "core/io/atomic_file.h"
#include "tests/support/temporary_folder.h"

#include <fstream>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

// One key on each line, so that lines can be removed and spoiled one by one.
constexpr const char* kFinRay = R"(format: alltact-finger/1
name: left-07
camera:
  model: brown
  size: [960, 540]
  fx: 523.9
  fy: 524.5
  cx: 479.5
  cy: 269.5
  distortion: [-0.05, 0.01, 0.0001, -0.0002, 0.001]
  orientation: flip_v
face:
  kind: fin_ray
  width_mm: 24.0
  layer_mm: 1.5
markers:
  per_row: 2
  polarity: bright
mapping:
  kind: polynomial
  along: normal
  domain: [0.0, 0.5]
  chebyshev: [2.0, 0.5]
  powers: [0.0, 1.5, 2.0]
  covariance: [[0.0001, 0.00001], [0.00001, 0.0002]]
  method: joint
  presses: [press_000, press_001]
  residual_mm: 0.012
  held_out_mm: 0.02
  spread_mm: 0.015
  degree_choice: "two coefficients: least error on presses left out"
reference:
  video: reference.mkv
  markers: reference.csv
contact:
  threshold_px: 12.0
  rest_markers: [[101.5, 40.0], [205.25, 41.0], [102.0, 500.0], [206.0, 499.5]]
force:
  model: force.yaml
gripper_from_camera:
  translation_mm: [40.5, 0.0, -12.0]
  rotation: [0.6, 0.0, -0.8, 0.0]
provenance:
  date: 2024-06-11
  ball_radius_mm: 3
  operator: "null"
)";

constexpr const char* kFlat = R"(format: alltact-finger/1
name: flat-01
camera:
  model: orthographic
  size: [460, 345]
  mm_per_px: 0.051015
  cx: 229.5
  cy: 172.0
face:
  kind: flat
  layer_mm: 3
  plane_z_mm: 0
mapping:
  kind: moebius
  domain: [0, 0.7]
  a_mm: 2.5
  b: 1.3
reference:
  image: ref.png
)";

/// Keys that may be left out: each has a default or belongs to a part that may be absent.
const std::set<std::string> kOptional{"camera.distortion",
                                      "camera.orientation",
                                      "markers.polarity",
                                      "mapping",
                                      "mapping.along",
                                      "mapping.powers",
                                      "mapping.covariance",
                                      "mapping.method",
                                      "mapping.presses",
                                      "mapping.residual_mm",
                                      "mapping.held_out_mm",
                                      "mapping.spread_mm",
                                      "mapping.degree_choice",
                                      "reference",
                                      "contact",
                                      "force",
                                      "gripper_from_camera",
                                      "provenance",
                                      "provenance.date",
                                      "provenance.ball_radius_mm",
                                      "provenance.operator",
                                      "face.plane_z_mm"};
/// Keys whose value is any text, so that a number or a strange word is one too.
const std::set<std::string> kTexts{"name",
                                   "mapping.method",
                                   "mapping.degree_choice",
                                   "reference.video",
                                   "reference.markers",
                                   "reference.image",
                                   "force.model",
                                   "provenance.date",
                                   "provenance.ball_radius_mm",
                                   "provenance.operator"};

struct Line {
  std::string key;           // full name
  std::string indent, word;  // as they stand in the file
  std::size_t number = 0;    // from 1
  std::size_t count = 1;     // of lines, with those that are indented below
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<Line> keys_of(const std::string& text) {
  const auto lines = lines_of(text);
  std::vector<Line> keys;
  std::string section;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Line line;
    line.indent = lines[i].substr(0, lines[i].find_first_not_of(' '));
    line.word = lines[i].substr(line.indent.size(), lines[i].find(':') - line.indent.size());
    line.number = i + 1;
    if (line.indent.empty()) section = line.word;
    line.key = line.indent.empty() ? line.word : section + "." + line.word;
    while (line.indent.empty() && i + line.count < lines.size() &&
           lines[i + line.count].starts_with(' '))
      ++line.count;
    keys.push_back(line);
  }
  return keys;
}

/// The text with the lines of a key replaced by others.
std::string replaced(const std::string& text, const Line& line, const std::string& by) {
  auto lines = lines_of(text);
  const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(line.number) - 1;
  const auto place = lines.erase(begin, begin + static_cast<std::ptrdiff_t>(line.count));
  if (!by.empty()) lines.insert(place, by);
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

class FingerFile : public testing::Test {
 protected:
  static Result<Finger> load(const std::string& text,
                             std::vector<std::string>* warnings = nullptr) {
    return Finger::parse(text, "left/finger.yaml", warnings);
  }
  static std::string saved(const Finger& finger) {
    const auto text = finger.to_yaml();
    EXPECT_TRUE(text.ok()) << (text.ok() ? "" : text.error().sentence());
    return text.ok() ? *text : "";
  }
  TemporaryFolder folder_;
};

TEST_F(FingerFile, EveryValueIsRead) {
  std::vector<std::string> warnings;
  const auto finger = load(kFinRay, &warnings);
  ASSERT_TRUE(finger.ok()) << finger.error().sentence();
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(finger->name, "left-07");
  EXPECT_EQ(finger->camera.model, CameraModel::kBrown);
  EXPECT_EQ(finger->camera.width_px, 960);
  EXPECT_EQ(finger->camera.height_px, 540);
  EXPECT_EQ(finger->camera.fx_px, 523.9);
  EXPECT_EQ(finger->camera.fy_px, 524.5);
  EXPECT_THAT(finger->camera.distortion, ElementsAre(-0.05, 0.01, 0.0001, -0.0002, 0.001));
  EXPECT_EQ(finger->camera.orientation, Orientation::kFlipV);
  EXPECT_EQ(finger->face.kind, FaceKind::kFinRay);
  EXPECT_EQ(finger->face.width_mm, 24);
  EXPECT_EQ(finger->face.layer_mm, 1.5);
  EXPECT_EQ(finger->marker_count(), 4);
  EXPECT_EQ(finger->markers.polarity, Polarity::kBright);
  ASSERT_TRUE(finger->mapping);
  EXPECT_EQ(finger->mapping->along, MappingAlong::kNormal);
  EXPECT_EQ(finger->mapping->x_max, 0.5);
  EXPECT_THAT(finger->mapping->chebyshev, ElementsAre(2.0, 0.5));
  EXPECT_EQ(finger->mapping->covariance(1, 1), 0.0002);
  ASSERT_TRUE(finger->mapping_record);
  EXPECT_EQ(finger->mapping_record->method, "joint");
  EXPECT_THAT(finger->mapping_record->presses, ElementsAre("press_000", "press_001"));
  EXPECT_EQ(finger->mapping_record->residual_mm, 0.012);
  EXPECT_EQ(finger->mapping_record->held_out_mm, 0.02);
  EXPECT_EQ(finger->mapping_record->spread_mm, 0.015);
  EXPECT_EQ(finger->reference->video, "reference.mkv");
  EXPECT_EQ(finger->reference->markers, "reference.csv");
  EXPECT_EQ(finger->contact->rest_markers[1], Eigen::Vector2d(205.25, 41));
  EXPECT_EQ(finger->force_model, "force.yaml");
  EXPECT_EQ(finger->gripper_from_camera->translation_mm, Eigen::Vector3d(40.5, 0, -12));
  EXPECT_EQ(finger->gripper_from_camera->rotation.coeffs(), Eigen::Vector4d(0, -0.8, 0, 0.6));
  EXPECT_EQ(finger->provenance.at("ball_radius_mm"), "3");
  EXPECT_EQ(finger->provenance.at("operator"), "null");
}

TEST_F(FingerFile, AMappingThatVariesOverTheFaceComesBack) {
  std::string text = kFinRay;
  const std::string plain = "  covariance: [[0.0001, 0.00001], [0.00001, 0.0002]]\n";
  const auto place = text.find(plain);
  ASSERT_NE(place, std::string::npos);
  text.replace(place,
               plain.size(),
               "  varies: {along: 0.05, across: -0.01, middle_mm: [52.0, 0.5], half_mm: [30.0, "
               "6.0]}\n  covariance: [[0.0001, 0.0, 0.0, 0.0], [0.0, 0.0002, 0.0, 0.0], [0.0, 0.0, "
               "0.0004, 0.0], [0.0, 0.0, 0.0, 0.0005]]\n");
  const auto finger = load(text);
  ASSERT_TRUE(finger.ok()) << finger.error().sentence();
  const FaceVariation& varies = finger->mapping->variation;
  EXPECT_EQ(varies.part, Eigen::Vector2d(0.05, -0.01));
  EXPECT_EQ(varies.middle_mm, Eigen::Vector2d(52.0, 0.5));
  EXPECT_EQ(varies.half_mm, Eigen::Vector2d(30.0, 6.0));
  const auto written = finger->to_yaml();
  ASSERT_TRUE(written.ok());
  const auto again = load(*written);
  ASSERT_TRUE(again.ok()) << again.error().sentence();
  EXPECT_EQ(again->mapping->variation.part, varies.part);
  EXPECT_EQ(*again->to_yaml(), *written);

  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string spoilt = text;
    spoilt.replace(spoilt.find(from), from.size(), to);
    const auto result = load(spoilt);
    return result.ok() ? std::string("accepted") : result.error().sentence();
  };
  EXPECT_THAT(refused("along: 0.05", "along: 0.6"), HasSubstr("mapping.varies"));
  EXPECT_THAT(refused("half_mm: [30.0, ", "half_mm: [0.0, "), HasSubstr("mapping.varies"));
  EXPECT_THAT(refused("middle_mm: [52.0, 0.5]", "middle_mm: [52.0]"), HasSubstr("middle_mm"));
}

TEST_F(FingerFile, APlaceInTheGripperComesBackToTheLastDigit) {
  const Finger plain = *load(kFlat);
  EXPECT_FALSE(plain.gripper_from_camera) << "files from before it was known are read";
  const bool holds = rc::check("places in the gripper", [&] {
    const auto number = [](double scale) {
      return scale * static_cast<double>(*rc::gen::inRange<long>(-(1L << 52), 1L << 52)) /
             static_cast<double>(1L << 52);
    };
    Finger finger = plain;
    RigidTransform& pose = finger.gripper_from_camera.emplace();
    pose.translation_mm = {number(1e4), number(100), number(1e-9)};
    pose.rotation = rotation_of_degrees({number(180), number(90), number(180)});
    const auto once = finger.to_yaml();
    RC_ASSERT(once.ok());
    const auto again = load(*once);
    RC_ASSERT(again.ok());
    RC_ASSERT(again->gripper_from_camera == finger.gripper_from_camera);
    RC_ASSERT(*again->to_yaml() == *once);
  });
  EXPECT_TRUE(holds);
}

TEST_F(FingerFile, APlaceInTheGripperThatIsNoneIsRefused) {
  const auto said = [&](const std::string& pose) {
    const auto finger = load(std::string(kFlat) + "gripper_from_camera: {" + pose + "}\n");
    return finger.ok() ? std::string("accepted") : finger.error().sentence();
  };
  EXPECT_EQ(said("translation_mm: [1, 2, 3], rotation: [0.7071, 0, 0.7071, 0]"), "accepted");
  EXPECT_THAT(said("translation_mm: [1, 2, 3], rotation: [1, 1, 0, 0]"), HasSubstr("length 1"));
  EXPECT_THAT(said("translation_mm: [1, 2, 3], rotation: [0, 0, 0, 0]"), HasSubstr("length 1"));
  EXPECT_THAT(said("translation_mm: [1, 2, 3], rotation: [1, 0, 0]"), HasSubstr("four numbers"));
  EXPECT_THAT(said("translation_mm: [1, 2], rotation: [1, 0, 0, 0]"), HasSubstr("three numbers"));
  EXPECT_THAT(said("translation_mm: [1, 2, 20000], rotation: [1, 0, 0, 0]"),
              HasSubstr("gripper_from_camera.translation_mm"));
  EXPECT_NE(said("translation_mm: [1, 2, .nan], rotation: [1, 0, 0, 0]"), "accepted");
  EXPECT_NE(said("translation_mm: [1, 2, 3]"), "accepted");
}

TEST_F(FingerFile, FlatSensorsHaveNoMarkersAndDefaults) {
  const auto finger = load(kFlat);
  ASSERT_TRUE(finger.ok()) << finger.error().sentence();
  EXPECT_EQ(finger->face.kind, FaceKind::kFlat);
  EXPECT_EQ(finger->marker_count(), 0);
  EXPECT_EQ(finger->camera.orientation, Orientation::kNone);
  EXPECT_EQ(finger->mapping->a_mm, 2.5);
  EXPECT_FALSE(finger->mapping_record);
  EXPECT_EQ(finger->reference->image, "ref.png");
}

TEST_F(FingerFile, SavedTwiceIsTheSameBytesAndTheSameFinger) {
  for (const std::string text : {kFinRay, kFlat}) {
    const auto first = load(text);
    ASSERT_TRUE(first.ok());
    const std::string once = saved(*first);
    ASSERT_TRUE(first->save(folder_.path()).ok());
    EXPECT_EQ(*read_file(folder_ / Finger::kFileName), once);
    const auto second = Finger::load(folder_.path());
    ASSERT_TRUE(second.ok()) << second.error().sentence();
    EXPECT_EQ(saved(*second), once);
    EXPECT_EQ(second->camera, first->camera);
    EXPECT_EQ(second->provenance, first->provenance);
    EXPECT_EQ(second->mapping->chebyshev, first->mapping->chebyshev);
    EXPECT_EQ(second->mapping->covariance, first->mapping->covariance);
    EXPECT_EQ(second->contact.has_value(), first->contact.has_value());
    EXPECT_EQ(second->gripper_from_camera, first->gripper_from_camera);
  }
}

TEST_F(FingerFile, UnknownKeysAreKeptAtEveryLevelAndWarnedOf) {
  std::string text = kFinRay;
  for (const char* section :
       {"camera", "face", "markers", "mapping", "reference", "contact", "force"}) {
    const std::size_t at = text.find("\n" + std::string(section) + ":\n");
    ASSERT_NE(at, std::string::npos);
    text.insert(at + std::string(section).size() + 3,
                fmt::format("  new_in_{}: {{a: [1, two, \"3\", ~], b: !colour red}}\n", section));
  }
  text +=
      "  nested: {x: 1}\nlater:\n  - 1.50\n  - {deep: [yes, 'no: maybe']}\n'odd key: x': |\n"
      "  several\n  lines\n";
  std::vector<std::string> warnings;
  const auto finger = load(text, &warnings);
  ASSERT_TRUE(finger.ok()) << finger.error().sentence();
  EXPECT_EQ(warnings.size(), 10U);
  EXPECT_THAT(warnings[0], HasSubstr("finger.yaml:4: camera.new_in_camera: is not known"));
  const std::string once = saved(*finger);
  for (const char* section :
       {"camera", "face", "markers", "mapping", "reference", "contact", "force"})
    EXPECT_THAT(
        once,
        HasSubstr(fmt::format("new_in_{}: {{a: [1, two, \"3\", ~], b: !<!colour> red}}", section)));
  EXPECT_THAT(once, HasSubstr("later: [1.50, {deep: [yes, \"no: maybe\"]}]"));
  EXPECT_THAT(once, HasSubstr("\"odd key: x\": \"several\\nlines\\n\""));
  EXPECT_THAT(once, HasSubstr("  nested: {x: 1}"));
  const auto again = load(once, &warnings);
  ASSERT_TRUE(again.ok()) << again.error().sentence();
  EXPECT_EQ(warnings.size(), 10U);
  EXPECT_EQ(saved(*again), once);
}

TEST_F(FingerFile, EveryKeyRemovedIsNamedOrOptional) {
  for (const std::string text : {kFinRay, kFlat})
    for (const Line& line : keys_of(text)) {
      const auto finger = load(replaced(text, line, ""));
      EXPECT_EQ(finger.ok(), kOptional.contains(line.key)) << line.key;
      if (finger.ok()) continue;
      EXPECT_THAT(finger.error().where, testing::MatchesRegex(".*finger.yaml:[0-9]+: .*"));
      EXPECT_TRUE(finger.error().where.ends_with(": " + line.key))
          << line.key << " but " << finger.error().sentence();
    }
}

TEST_F(FingerFile, EveryKeySpoiledIsRefusedByItsNameAndLine) {
  for (const std::string text : {kFinRay, kFlat})
    for (const Line& line : keys_of(text))
      for (const std::string value :
           {"purple",   "-3",   ".nan",           "nan",     ".inf",     "-.inf",
            "",         "~",    "1e300",          "-1e300",  "1e999",    "99999999999999999999",
            "[1, [2]]", "[]",   "[-1e300, .nan]", "[x, y]",  "{a: 1}",   "\"\"",
            "\"5\"",    "0x10", "1 mm",           "!!float", "*nowhere", "[",
            "'"}) {
        const std::string spoiled =
            replaced(text, line, fmt::format("{}{}: {}", line.indent, line.word, value));
        const auto finger = load(spoiled);
        const std::string shown = line.key + ": " + value;
        if (finger.ok()) {
          // Whatever was accepted is fit to be used and to be kept.
          EXPECT_TRUE(finger->validate().ok()) << shown;
          const bool is_text = kTexts.contains(line.key) || line.key == "provenance.operator";
          const bool is_list_of_texts = line.key == "mapping.presses";
          const bool is_plausible = (line.key == "camera.distortion" && value == "[]") ||
                                    (line.key == "mapping.covariance" && value == "[]") ||
                                    line.key == "provenance" ||
                                    ((line.key == "camera.cx" || line.key == "camera.cy" ||
                                      line.key == "mapping.b" || line.key == "face.plane_z_mm") &&
                                     value == "-3") ||
                                    line.key.starts_with("provenance.");
          EXPECT_TRUE(is_text || is_list_of_texts || is_plausible) << shown;
          continue;
        }
        // Where the text is no YAML any more, only the line is known.
        const bool is_yaml = value != "*nowhere" && value != "[" && value != "'";
        EXPECT_THAT(finger.error().where, HasSubstr("finger.yaml:")) << shown;
        if (!is_yaml) continue;
        EXPECT_THAT(finger.error().where, HasSubstr(line.key)) << shown;
        EXPECT_THAT(finger.error().where, HasSubstr(fmt::format(":{}: ", line.number))) << shown;
      }
}

TEST_F(FingerFile, EveryTruncationIsAnErrorOrAFinger) {
  for (const std::string text : {kFinRay, kFlat})
    for (std::size_t size = 0; size < text.size(); ++size) {
      const auto finger = load(text.substr(0, size));
      if (finger.ok()) {
        EXPECT_TRUE(finger->validate().ok()) << size;
      } else {
        EXPECT_THAT(finger.error().where, HasSubstr("finger.yaml")) << size;
        EXPECT_FALSE(finger.error().what.empty());
      }
    }
}

TEST_F(FingerFile, DamagedBytesNeverCrash) {
  std::srand(1);
  for (int i = 0; i < 1500; ++i) {
    std::string text = kFinRay;
    for (int k = 0; k < 3; ++k)
      text[static_cast<std::size_t>(std::rand()) % text.size()] =
          i % 2 == 0 ? static_cast<char>(std::rand())
                     : "[]{}:,-#&*!|>'\"%@`\n\t 0x"[std::rand() % 24];
    const auto finger = load(text);
    if (finger.ok()) {
      EXPECT_TRUE(finger->validate().ok());
    }
  }
}

TEST_F(FingerFile, HostileFilesAreRefused) {
  const auto what = [&](const std::string& text) {
    const auto finger = load(text);
    return finger.ok() ? std::string("accepted") : finger.error().sentence();
  };
  const std::string text = kFinRay;
  EXPECT_THAT(what(text + "name: again\n"), HasSubstr("given twice"));
  EXPECT_THAT(what("format: alltact-finger/2\n"), HasSubstr("newer version"));
  EXPECT_THAT(what(text + "---\nname: other\n"), HasSubstr("more than one document"));
  EXPECT_NE(what(text + "deep: " + std::string(3000, '[') + std::string(3000, ']') + "\n"),
            "accepted");
  EXPECT_NE(what(text + "self: &x [*x]\n"), "accepted");
  std::string bomb = text + "b0: &b0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 9; ++i)
    bomb +=
        fmt::format("b{0}: &b{0} [*b{1}, *b{1}, *b{1}, *b{1}, *b{1}, *b{1}, *b{1}]\n", i, i - 1);
  EXPECT_THAT(what(bomb), HasSubstr("too large"));
  const auto keys = keys_of(text);
  const Line force =
      *std::find_if(keys.begin(), keys.end(), [](const Line& line) { return line.key == "force"; });
  for (const char* path : {"/etc/passwd", "../other/force.yaml", "a/../../b", "sub/", ".."})
    EXPECT_THAT(what(replaced(text, force, fmt::format("force: {{model: {}}}", path))),
                HasSubstr("force.model"))
        << path;
  EXPECT_FALSE(Finger::load(folder_ / "none").ok());
}

TEST_F(FingerFile, CombinationsThatCannotBeAreRefused) {
  const auto where = [](const Finger& finger) {
    const Status status = finger.validate();
    return status.ok() ? std::string("accepted") : status.error().where;
  };
  const Finger fin_ray = *load(kFinRay), flat = *load(kFlat);
  Finger f = fin_ray;
  f.camera = flat.camera;
  EXPECT_EQ(where(f), "camera.model");
  EXPECT_FALSE(f.save(folder_.path()).ok());
  f = flat;
  f.markers.per_row = 3;
  EXPECT_EQ(where(f), "markers.per_row");
  f = flat;
  f.camera = fin_ray.camera;
  EXPECT_EQ(where(f), "face.plane_z_mm");
  f.face.plane_z_mm = 20;
  EXPECT_EQ(where(f), "accepted");
  f = fin_ray;
  f.markers.per_row = 3;
  EXPECT_EQ(where(f), "contact.rest_markers");
  f = fin_ray;
  f.reference->image = "ref.png";
  EXPECT_EQ(where(f), "reference.image");
  f = fin_ray;
  f.mapping.reset();
  EXPECT_EQ(where(f), "mapping");
  f = fin_ray;
  f.contact->threshold_px = std::nan("");
  EXPECT_EQ(where(f), "contact.threshold_px");
}

TEST_F(FingerFile, AnyTextsAndNumbersSurvive) {
  const auto any_text = [] {
    return *rc::gen::container<std::string>(
        rc::gen::oneOf(rc::gen::inRange<char>(1, 127),
                       rc::gen::elementOf(std::string("\"'\\:#\n\t-?,[]{}&*!|>%@`~ "))));
  };
  const bool holds = rc::check("texts and numbers survive", [&] {
    Finger finger = *load(kFinRay);
    finger.name = "n" + any_text();
    RC_PRE(finger.name.size() <= 200);
    finger.mapping_record->degree_choice = any_text();
    finger.mapping_record->presses = {any_text(), any_text()};
    finger.provenance = {{"k" + any_text().substr(0, 50), any_text()}, {"plain", "0.50"}};
    finger.face.width_mm = *rc::gen::inRange(1, 1 << 30) / 7e7;
    finger.contact->rest_markers[2].x() = *rc::gen::inRange(-1000, 1000) * 1e-9;
    const std::string once = saved(finger);
    const auto loaded = load(once);
    RC_ASSERT(loaded.ok());
    RC_ASSERT(loaded->name == finger.name);
    RC_ASSERT(loaded->mapping_record->degree_choice == finger.mapping_record->degree_choice);
    RC_ASSERT(loaded->mapping_record->presses == finger.mapping_record->presses);
    RC_ASSERT(loaded->provenance == finger.provenance);
    RC_ASSERT(loaded->face.width_mm == finger.face.width_mm);
    RC_ASSERT(loaded->contact->rest_markers[2] == finger.contact->rest_markers[2]);
    RC_ASSERT(saved(*loaded) == once);
  });
  EXPECT_TRUE(holds);
}

TEST_F(FingerFile, CamerasHaveFilesOfTheirOwn) {
  const CameraParameters camera = load(kFinRay)->camera;
  const fs::path file = folder_ / "camera.yaml";
  ASSERT_TRUE(save_camera(file, camera).ok());
  EXPECT_EQ(*load_camera(file), camera);
  std::ofstream(file) << "camera:\n  model: pinhole\n  size: [64, 48]\n  fx: 50\n  fy: 0\n"
                         "  cx: 31.5\n  cy: 23.5\n";
  EXPECT_TRUE(load_camera(file).error().where.ends_with("camera.yaml:5: camera.fy"));
  std::ofstream(file) << "model: pinhole\nsize: [64, 48]\nfx: 50\nfy: 0\ncx: 31.5\ncy: 23.5\n";
  EXPECT_TRUE(load_camera(file).error().where.ends_with("camera.yaml:4: fy"));
  EXPECT_FALSE(save_camera(file, CameraParameters{}).ok());
  EXPECT_FALSE(load_camera(folder_ / "none.yaml").ok());
}

TEST_F(FingerFile, HowTheLensWasCalibratedStaysWithTheCamera) {
  const TemporaryFolder folder;
  const LensRecord record{{"fx_sd_px", "0.12"}, {"verdict", "good: 0.02 mm, at 60 mm"}};
  CameraParameters camera;
  camera.width_px = 960, camera.height_px = 540;
  camera.fx_px = camera.fy_px = 523.9;
  ASSERT_TRUE(save_camera(folder / "camera.yaml", camera, record));
  LensRecord loaded;
  const auto again = load_camera(folder / "camera.yaml", &loaded);
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(*again, camera);
  EXPECT_EQ(loaded, record);

  std::string text = kFinRay;
  text.insert(text.find("face:"), "  lens: {fx_sd_px: 0.12, halves: [1, 2], verdict: good}\n");
  const auto finger = Finger::parse(text, "finger.yaml");
  ASSERT_TRUE(finger) << finger.error().sentence();
  EXPECT_EQ(finger->lens_record, (LensRecord{{"fx_sd_px", "0.12"}, {"verdict", "good"}}));
  const auto written = finger->to_yaml();
  ASSERT_TRUE(written);
  EXPECT_THAT(*written, HasSubstr("  lens: {fx_sd_px: 0.12, verdict: good, halves: [1, 2]}\n"));
}

}  // namespace
}  // namespace alltact
