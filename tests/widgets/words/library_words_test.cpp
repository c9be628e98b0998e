// Everything that the libraries say is in the catalogue, and is recognised in the window.
#include "widgets/words/library_words.h"

#include "core/result.h"
#include "tests/support/source_texts.h"
#include "tests/support/ts_file.h"
#include "widgets/words/catalogue.h"

#include <QRegularExpression>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path kTop = ALLTACT_SOURCE_DIR;
constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// What is no sentence for people, with the reason.
struct Exempt {
  const char* text;
  const char* reason;
};
constexpr Exempt kExempt[] = {
    {"x \x01 px", "figures"},
    {"id=\x01 bytes=\x01 at=\x01 range=", "a dimmer as it is written down"},
    {"feature", "a dimmer as it is written down"},
    {"output", "a dimmer as it is written down"},
    {"mcp2221a gp2", "a dimmer as it is written down"},
    {"mcp2221a gp3", "a dimmer as it is written down"},
    {"alltact calibrate", "a command"},
    {"--board", "an option"},
    {"numbers are written as they lie", "an assertion"},
    {"millimetres; x along image u, y along image v, z away from the camera", "in mesh files"},
    {"connectivity", "in mesh files"},
    {"offsets", "in mesh files"},
    {"camera_info.yaml, parameters.yaml", "files"},
    {"alltact export \x01 --to \x01 -o", "a command"},
    {"equidistant", "a key"},
    {"press advice", "names a row of random numbers"},
    {"integer menu", "a kind of control, for the command line"},
    {"extraneous bytes before marker 0xd9", "a message of libjpeg that is looked for"},
};

/// Folders and files whose texts never come to a window.
bool is_said_nowhere(const SourceText& text) {
  const std::string file = fs::relative(text.file, kTop).generic_string();
  return file.starts_with("calibration/hard_cases/") ||        // a table of the command line
         file == "calibration/export/calibration_json.cpp" ||  // formulas and keys of files...
         file == "calibration/export/ros_parameters.cpp" ||    // ...for other programs
         file == "calibration/report/typical_faults.cpp" ||  // scenes, made and read by the program
         text.text.find_first_of("\n\x04") != std::string::npos;  // the body of a file
}

bool is_exempt(const std::string& bare) {
  return std::any_of(std::begin(kExempt), std::end(kExempt), [&](const Exempt& exempt) {
    return bare == exempt.text;
  });
}

std::vector<SourceText> library_texts() {
  std::vector<SourceText> all = texts_below(kTop / "core");
  for (const SourceText& text : texts_below(kTop / "calibration")) all.push_back(text);
  return all;
}

/// What the Studio's own work and the command line that it runs say where no window is.
std::vector<SourceText> program_texts() {
  std::vector<SourceText> all = texts_below(kTop / "widgets");
  for (const SourceText& text : texts_below(kTop / "app" / "studio")) all.push_back(text);
  for (const char* file : {"app/console/finger_work.cpp",
                           "app/console/console.cpp",
                           "app/main.cpp",
                           "app/commands/calibrate.cpp"})
    for (const SourceText& text : texts_of(kTop / file)) all.push_back(text);
  std::erase_if(all, [](const SourceText& text) {
    return text.file.parent_path() == kTop / "widgets" / "words";
  });
  return all;
}

std::set<std::string> catalogue() {
  std::set<std::string> all;
  for (const char* pattern : library_patterns()) all.insert(bare_pattern(pattern));
  return all;
}

TEST(LibraryWords, HoldEverySentenceOfTheSources) {
  const std::set<std::string> known = catalogue();
  int count = 0;
  for (const SourceText& text : library_texts()) {
    if (is_said_nowhere(text)) continue;
    for (const std::string& bare : bare_sentences(text.text)) {
      if (!is_for_people(bare, text.is_told) || is_exempt(bare)) continue;
      ++count;
      EXPECT_TRUE(known.contains(bare)) << text.file << ":" << text.line << ": " << bare;
    }
  }
  EXPECT_GT(count, 700);
}

TEST(LibraryWords, HoldWhatTheStudiosOwnWorkSaysWithoutAWindow) {
  const std::set<std::string> known = catalogue();
  int count = 0;
  for (const SourceText& text : program_texts()) {
    const std::string file = fs::relative(text.file, kTop).generic_string();
    const bool is_window = file.starts_with("widgets/") || file.starts_with("app/studio/");
    if (!is_window || text.is_qt || is_said_nowhere(text)) continue;
    if (file.starts_with("widgets/report/") ||  // reports are English
        file == "app/studio/main.cpp")          // on the terminal, before there is a window
      continue;
    for (const std::string& bare : bare_sentences(text.text)) {
      if (!is_for_people(bare, text.is_told) || is_exempt(bare)) continue;
      ++count;
      EXPECT_TRUE(known.contains(bare)) << text.file << ":" << text.line << ": " << bare;
    }
  }
  EXPECT_GT(count, 10);
}

TEST(LibraryWords, HoldNoSentenceThatNoSourceHas) {
  std::set<std::string> said;
  for (const auto& texts : {library_texts(), program_texts()})
    for (const SourceText& text : texts) said.merge(bare_sentences(text.text));
  for (const char* pattern : library_patterns()) {
    const std::string bare = bare_pattern(pattern);
    if (bare.find_first_of(kLetters) == std::string::npos) continue;  // joins others
    EXPECT_TRUE(said.contains(bare)) << "nothing says \"" << pattern << '"';
  }
}

TEST(LibraryWords, AreThereOnceWithTheirHolesInOrder) {
  std::set<std::string> seen;
  for (const std::string pattern : library_patterns()) {
    EXPECT_TRUE(seen.insert(pattern).second) << "twice: " << pattern;
    char next = '1';
    std::size_t after = 0;
    for (std::size_t at = pattern.find('%'); at != std::string::npos;
         at = pattern.find('%', at + 1)) {
      if (at + 1 == pattern.size() || std::isdigit(pattern[at + 1]) == 0) continue;
      EXPECT_EQ(pattern[at + 1], next++) << pattern;
      EXPECT_FALSE(after > 0 && at == after) << "two holes side by side: " << pattern;
      after = at + 2;
    }
    EXPECT_NE(pattern, "%1");
  }
}

TEST(LibraryWords, AreSaidAsTheyAreInEnglish) {
  for (const char* text :
       {"good: 0.021 mm of depth error to be expected (0.019 mm in shape, on presses it had not "
        "seen; 0.009 mm as a whole)",
        "a/finger.yaml:12: camera.fx: must be a number from 1 to 1000000. Try: the focal length in "
        "pixels, as 'alltact lens' finds it.",
        "Not yet seen: twist it further one way: 3.0 of 9.0 degrees reached.",
        "press_1: no face was found. press_2: 12.5. press_3: . press_4: no face was found.",
        "one line\nand the next\n"})
    EXPECT_EQ(in_window_language(text).toStdString(), text);
  EXPECT_EQ(window_sentence("the disk is full").toStdString(), "The disk is full.");
  EXPECT_EQ(window_sentence("The disk is full.").toStdString(), "The disk is full.");
  EXPECT_EQ(window_sentence("").toStdString(), "");
}

class InLanguage : public testing::TestWithParam<const char*> {
 protected:
  static QString filled(QString pattern, const std::vector<std::string>& arguments) {
    for (std::size_t i = arguments.size(); i-- > 0;)
      pattern.replace(QStringLiteral("%%1").arg(i + 1), QString::fromStdString(arguments[i]));
    return pattern;
  }
  TsTranslator spoken_{GetParam(), QString::fromLatin1(kLibraryContext)};
};
INSTANTIATE_TEST_SUITE_P(Ts, InLanguage, testing::Values("de", "zh_CN"));

rc::Gen<std::string> arguments() {
  const auto number = rc::gen::map(rc::gen::inRange(0, 100000), [](int value) {
    return std::to_string(value % 1000) +
           (value % 2 == 0 ? "" : "." + std::to_string(value / 1000));
  });
  const auto path = rc::gen::map(rc::gen::inRange(0, 1000), [](int value) {
    return "/data/finger_" + std::to_string(value) + "/press_" + std::to_string(value % 7) + ".png";
  });
  const auto word =
      rc::gen::map(rc::gen::container<std::string>(7, rc::gen::inRange('a', char('z' + 1))),
                   [](const std::string& letters) { return "Q" + letters; });
  return rc::gen::oneOf(number, path, word);
}

TEST_P(InLanguage, IsRecognisedWhateverItIsFilledInWith) {
  constexpr std::size_t kMostHoles = 9;
  EXPECT_TRUE(rc::check([&] {
    const auto words = *rc::gen::container<std::vector<std::string>>(kMostHoles, arguments());
    for (const char* pattern : library_patterns()) {
      if (bare_pattern(pattern).find_first_of(kLetters) == std::string::npos) continue;
      const std::string said = filled(QString::fromUtf8(pattern), words).toStdString();
      const QString expected = spoken_.translate(kLibraryContext, pattern, nullptr, -1);
      RC_ASSERT(in_window_language(said).toStdString() == filled(expected, words).toStdString());
    }
  }));
}

TEST_P(InLanguage, KeepsWhatIsNoSentenceOfOurs) {
  for (const char* text : {"",
                           "/dev/video0",
                           "No such device or address",
                           "Exposure (Absolute): 120; 130, 140.",
                           "Die Katze: sie schl\xc3\xa4"
                           "ft. \xe4\xbd\xa0\xe5\xa5\xbd",
                           "100 %1 %2 %n"})
    EXPECT_EQ(in_window_language(text).toStdString(), text);
}

/// A text in the window's language has no English word left, but for names.
void expect_no_english(const std::string& text, const std::set<std::string>& names = {}) {
  const std::string said = in_window_language(text).toStdString();
  static const std::regex word("[A-Za-z]{2,}");
  for (std::sregex_iterator one(text.begin(), text.end(), word), none; one != none; ++one) {
    static const std::set<std::string> kEverywhere{
        "mm", "px", "in", "was", "so", "finger", "YAML", "USB"};
    if (names.contains(one->str()) || kEverywhere.contains(one->str())) continue;
    EXPECT_FALSE(std::regex_search(said, std::regex("\\b" + one->str() + "\\b")))
        << text << "\n"
        << said << "\nleaves: " << one->str();
  }
}

TEST_P(InLanguage, SaysWhatIsPutTogether) {
  expect_no_english(Error{"could not read the file: it does not exist",
                          "/data/finger/finger.yaml",
                          "check the path for typing errors"}
                        .sentence(),
                    {"data", "yaml"});
  expect_no_english(
      "good: 0.021 mm of depth error to be expected (0.019 mm in shape, on presses it had not "
      "seen; 0.009 mm as a whole)");
  expect_no_english(
      "not fit to measure with: 0.321 mm of depth error on the very presses it was made from; "
      "press again with a clean ball of the radius given, whole on the face");
  expect_no_english(
      "press next: 12 mm from the base, 3 mm from the middle on the upper side, 0.8 mm deep; that "
      "would take the standard deviation of depth from 0.0123 mm to 0.0101 mm");
  expect_no_english(
      "unproven: the focal length is known to 0.5 %, 0.3 mm at 60 mm; with so few views none could "
      "be left out to show what it is worth; take two more, tilted to the left and up, near the "
      "top "
      "left corner and bottom edge");
  expect_no_english(
      "recalibrate: 0.102 mm of depth error on 3 presses (passes up to 0.040 mm), light +1.2 %; "
      "the "
      "mapping reads 12 % too shallow: layer, ball or camera are not what they were; the face is "
      "3.1 % brighter than it was: look at lamps, exposure and layer; calibrate again before "
      "measuring with it");
  expect_no_english("no press can be used: press_1: no face was found. press_2: no face was found.",
                    {"press_1", "press_2", "press"});
  expect_no_english(
      "base 0.012 mm (3 presses), middle 0.010 mm (1 press), tip unknown: no press there, upper "
      "half 0.011 mm (4 presses), lower half unknown: no press there");
  expect_no_english(
      "polynomial of degree 4 that varies over the face: 0.0123 mm on presses left out, not "
      "distinguishable from the best (Moebius curve, 0.0120 mm) and simpler");
  expect_no_english(
      "'Gain' cannot be set to 12: an automatic mode has it in hand. Try: switch that mode off "
      "first.",
      {"Gain"});
  expect_no_english("'Gain' was changed from 12 to 14 by something else; it was put back.",
                    {"Gain"});
  expect_no_english(
      "the camera has no such format that can be read; it offers 640x480 MJPG at 30 frames per "
      "second, 320x240 YUYV at 15 frames per second and more",
      {"x480", "x240", "MJPG", "YUYV"});
  expect_no_english(
      "Not yet seen: bend it further away from the camera: 1.2 of 3.0 mm reached; twist it further "
      "one way: 3.0 of 9.0 degrees reached.");
  expect_no_english(
      "a/finger.yaml:12: camera.fx: must be a number from 1 to 1000000. Try: the focal length in "
      "pixels, as 'alltact lens' finds it.",
      {"yaml", "camera", "fx", "alltact", "lens"});
  expect_no_english(
      "The reference was not taken with one setting of camera and light: Gain was 3 and is 5. Lock "
      "them, and record it again.",
      {"Gain"});
}

TEST_P(InLanguage, SaysManySentencesInARow) {
  std::string all;
  for (int i = 0; i < 40; ++i)
    all += "press_" + std::to_string(i) +
           ": the contact covers too few pixels. Try: pressing deeper, or a larger picture. ";
  const std::string said = in_window_language(all).toStdString();
  EXPECT_THAT(said, Not(HasSubstr("pixels")));
  EXPECT_THAT(said, Not(HasSubstr("deeper")));
  EXPECT_THAT(said, HasSubstr("press_39"));
}

}  // namespace
}  // namespace alltact::test
