// Finger files that are spoilt, cut short, hostile or that no finger fits.
#include "core/finger/finger.h"
#include "tests/core/finger/finger_files.h"

#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::kFinRay;
using test::kFlat;
using testing::HasSubstr;

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

using RefusedFingerFile = test::FingerFiles;

TEST_F(RefusedFingerFile, EveryKeyRemovedIsNamedOrOptional) {
  for (const std::string text : {kFinRay, kFlat})
    for (const Line& line : keys_of(text)) {
      const auto finger = load(replaced(text, line, ""));
      EXPECT_EQ(finger.ok(), kOptional.contains(line.key)) << line.key;
      if (finger.ok()) continue;
      EXPECT_THAT(finger.error().where.english(),
                  testing::MatchesRegex(".*finger.yaml:[0-9]+: .*"));
      EXPECT_TRUE(finger.error().where.english().ends_with(": " + line.key))
          << line.key << " but " << finger.error().sentence();
    }
}

TEST_F(RefusedFingerFile, EveryKeySpoiledIsRefusedByItsNameAndLine) {
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
        EXPECT_THAT(finger.error().where.english(), HasSubstr("finger.yaml:")) << shown;
        if (!is_yaml) continue;
        EXPECT_THAT(finger.error().where.english(), HasSubstr(line.key)) << shown;
        EXPECT_THAT(finger.error().where.english(), HasSubstr(fmt::format(":{}: ", line.number)))
            << shown;
      }
}

TEST_F(RefusedFingerFile, EveryTruncationIsAnErrorOrAFinger) {
  for (const std::string text : {kFinRay, kFlat})
    for (std::size_t size = 0; size < text.size(); ++size) {
      const auto finger = load(text.substr(0, size));
      if (finger.ok()) {
        EXPECT_TRUE(finger->validate().ok()) << size;
      } else {
        EXPECT_THAT(finger.error().where.english(), HasSubstr("finger.yaml")) << size;
        EXPECT_FALSE(finger.error().what.english().empty());
      }
    }
}

TEST_F(RefusedFingerFile, DamagedBytesNeverCrash) {
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

TEST_F(RefusedFingerFile, HostileFilesAreRefused) {
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

TEST_F(RefusedFingerFile, CombinationsThatCannotBeAreRefused) {
  const auto where = [](const Finger& finger) {
    const Status status = finger.validate();
    return status.ok() ? std::string("accepted") : status.error().where.english();
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

}  // namespace
}  // namespace alltact
