// Every kind of bad input is refused with a sentence that names it, and changes nothing.
#include "tests/support/flat_finger.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Pictures that no command may take, made from a good one.
class Ladder {
 public:
  explicit Ladder(const FlatFinger& flat) : flat_(flat) {
    const cv::Mat good = cv::imread(flat.presses[0].string(), cv::IMREAD_GRAYSCALE);
    write_text(path("empty"), "");
    const std::string bytes = text_of(flat.presses[0]);
    write_text(path("truncated"), bytes.substr(0, bytes.size() / 2));
    write_text(path("text"), "this is not a picture\n");
    write("small", good(cv::Rect(0, 0, 100, 80)).clone());
    cv::Mat colour(good.size(), CV_8UC3, cv::Scalar(20, 60, 220));
    write("colour", colour);
    write("black", cv::Mat::zeros(good.size(), CV_8UC1));
  }

  [[nodiscard]] static std::vector<std::string> names() {
    return {"missing", "empty", "truncated", "text", "small", "colour", "black"};
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return flat_.file(name + ".png");
  }

 private:
  void write(const std::string& name, const cv::Mat& image) {
    ASSERT_TRUE(cv::imwrite(path(name), image));
  }
  const FlatFinger& flat_;
};

/// One sentence about one file: no trace of a crash, no second line from a decoder.
void expect_sentence_naming(const ProgramRun& run, const std::string& name) {
  EXPECT_EQ(run.status, 1) << name << run.errors;
  EXPECT_THAT(run.errors, HasSubstr(name + ".png"));
  EXPECT_THAT(run.errors, Not(HasSubstr("unexpected"))) << name;
  EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
}

TEST(BadInput, APressIsRefusedBeforeAnythingIsWritten) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  const Ladder ladder(flat);
  const auto before = contents_of(flat.finger());
  for (const std::string& name : Ladder::names()) {
    expect_sentence_naming(
        flat.calibrate({flat.presses[0].string(), ladder.path(name), flat.presses[1].string()}),
        name);
    EXPECT_EQ(contents_of(flat.finger()), before) << name;
  }
}

TEST(BadInput, AReferencePictureIsRefusedBeforeAnythingIsWritten) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  const Ladder ladder(flat);
  const auto before = contents_of(flat.finger());
  for (const std::string& name : Ladder::names()) {
    expect_sentence_naming(flat.calibrate({}, name + ".png"), name);
    EXPECT_EQ(contents_of(flat.finger()), before) << name;
  }
}

TEST(BadInput, OneBadPictureDoesNotSpoilTheBatch) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  ASSERT_EQ(flat.calibrate().status, 0);
  const Ladder ladder(flat);
  for (const std::string& name : Ladder::names()) {
    if (name == "missing") continue;  // refused before the batch begins, below
    const std::string output = "out_" + name;
    const ProgramRun run = flat.reconstruct(
        {flat.presses[0].string(), ladder.path(name), flat.presses[1].string()}, output);
    EXPECT_EQ(run.status, 1) << name;
    EXPECT_THAT(run.errors, HasSubstr(name + ".png"));
    std::istringstream lines(text_of(flat.folder.path() / output / "results.jsonl"));
    std::vector<nlohmann::json> results;
    for (std::string line; std::getline(lines, line);)
      results.push_back(nlohmann::json::parse(line));
    ASSERT_EQ(results.size(), 3U) << name;
    EXPECT_EQ(results[1].at("frame"), name);
    EXPECT_EQ(results[1].at("index"), 1);
    EXPECT_FALSE(results[1].at("problems").empty());
    EXPECT_FALSE(results[1].contains("regions")) << "absent, never zero";
    for (const int good : {0, 2}) {
      EXPECT_EQ(results[static_cast<std::size_t>(good)].at("regions").size(), 1U) << name;
      EXPECT_FALSE(results[static_cast<std::size_t>(good)].contains("problems")) << name;
    }
    EXPECT_FALSE(fs::exists(flat.folder.path() / output / (name + ".depth.tiff")));
    EXPECT_TRUE(fs::exists(flat.folder.path() / output / "press_1.depth.tiff"));
  }
}

TEST(BadInput, AMissingPictureIsNamed) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  ASSERT_EQ(flat.calibrate().status, 0);
  expect_sentence_naming(flat.reconstruct({flat.file("missing.png")}, "out"), "missing");
}

TEST(BadInput, TwoPicturesOfOneNameAreTold) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  fs::create_directory(flat.folder / "twin");
  fs::copy(flat.presses[0], flat.folder.path() / "twin" / "press_0.png");
  const std::string twin = flat.file("twin/press_0.png");
  const auto before = contents_of(flat.finger());
  const ProgramRun calibration = flat.calibrate({flat.presses[0].string(), twin});
  EXPECT_EQ(calibration.status, 1);
  EXPECT_THAT(calibration.errors, HasSubstr("press_0"));
  EXPECT_EQ(contents_of(flat.finger()), before);

  ASSERT_EQ(flat.calibrate().status, 0);
  const ProgramRun run = flat.reconstruct({flat.presses[0].string(), twin}, "out");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("twin"));
}

TEST(BadInput, APressWithoutABallIsLeftOutWithItsReason) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  cv::imwrite(flat.file("nothing.png"), untouched_picture(77));
  const auto before = contents_of(flat.finger());
  const ProgramRun alone = flat.calibrate({flat.file("nothing.png")});
  EXPECT_EQ(alone.status, 1);
  EXPECT_THAT(alone.errors, HasSubstr("nothing"));
  const std::string image = flat.finger() + "/calibration.problem.png";
  EXPECT_THAT(alone.errors, HasSubstr(image));
  auto after = contents_of(flat.finger());
  EXPECT_EQ(std::erase_if(after,
                          [](const auto& file) { return file.first == "calibration.problem.png"; }),
            1U);
  EXPECT_EQ(after, before);

  const ProgramRun among = flat.calibrate({flat.presses[0].string(), flat.presses[1].string(),
                                           flat.file("nothing.png"), flat.presses[2].string()});
  EXPECT_EQ(among.status, 0) << among.errors;
  EXPECT_THAT(among.errors, HasSubstr("Left out: nothing"));
  const auto report = nlohmann::json::parse(text_of(flat.finger() + "/calibration_report.json"));
  EXPECT_EQ(report.at("presses").size(), 3U);
  EXPECT_EQ(report.at("left_out").size(), 1U);
  EXPECT_THAT(among.errors, HasSubstr(image));
  const cv::Mat shown = cv::imread(image), one = untouched_picture(77);
  ASSERT_FALSE(shown.empty());
  EXPECT_EQ(shown.cols % one.cols, 0);
  EXPECT_LT(shown.rows * one.cols, 2 * shown.cols * one.rows) << "only the one that was left out";

  // Whoever leaves it out by himself needs no picture of why.
  const ProgramRun again =
      run_alltact({"calibrate", flat.finger(), "--again", "--exclude", "nothing"});
  EXPECT_EQ(again.status, 0) << again.errors;
  EXPECT_FALSE(std::filesystem::exists(image));
}

TEST(BadInput, ARecordingOfNoneOrOneFrameIsRefused) {
  const TemporaryFolder folder;
  write_text(folder / "camera.yaml",
             "model: pinhole\nsize: [320, 240]\nfx: 200\nfy: 200\ncx: 159.5\ncy: 119.5\n"
             "distortion: []\norientation: none\n");
  const std::string finger = (folder / "finger").string();
  ASSERT_EQ(make_fin_ray(finger, folder / "camera.yaml").status, 0);
  fs::create_directory(folder / "none");
  fs::create_directory(folder / "one");
  cv::imwrite((folder / "one").string() + "/frame_00000.png", untouched_picture(3));
  write_text(folder / "broken.mkv", "not a video");
  const auto before = contents_of(finger);
  for (const char* recording : {"none", "one", "broken.mkv", "nowhere"}) {
    const ProgramRun run = run_alltact({"reference", finger, (folder / recording).string()});
    EXPECT_EQ(run.status, 1) << recording;
    EXPECT_NE(run.errors, "") << recording;
    EXPECT_THAT(run.errors, Not(HasSubstr("unexpected"))) << recording;
    EXPECT_EQ(contents_of(finger), before) << recording;
  }
}

TEST(BadInput, ASpoiledFingerIsNamedByKeyAndLine) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  ASSERT_EQ(flat.calibrate().status, 0);
  const fs::path file = fs::path(flat.finger()) / "finger.yaml";
  const std::string good = text_of(file);
  const std::vector<std::pair<std::string, std::string>> spoils = {
      {"format: alltact-finger/1", "format: alltact-finger/99"},
      {"layer_mm: 3", "layer_mm: thick"},
      {"layer_mm: 3", "layer_mm: -3"},
      {"kind: flat", "kind: round"},
      {"mm_per_px: 0.06", "mm_per_px: .nan"},
      {"model: orthographic", "modle: orthographic"},
  };
  for (const auto& [from, to] : spoils) {
    std::string spoiled = good;
    const auto place = spoiled.find(from);
    ASSERT_NE(place, std::string::npos) << from << "\n" << good;
    write_text(file, spoiled.replace(place, from.size(), to));
    for (const char* command : {"check", "reconstruct"}) {
      const ProgramRun run = std::string(command) == "check"
                                 ? run_alltact({"check", flat.finger()})
                                 : flat.reconstruct({flat.presses[0].string()}, "out");
      EXPECT_EQ(run.status, 1) << to;
      EXPECT_THAT(run.errors, HasSubstr("finger.yaml")) << to;
    }
    EXPECT_FALSE(fs::exists(flat.folder / "out"));
  }
  write_text(file, good);
  EXPECT_EQ(run_alltact({"check", flat.finger()}).status, 0);
}

TEST(BadInput, ASceneCutBeforeItsCameraCountsGreyLevelsIsToldBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  const fs::path scene =
      fs::path(ALLTACT_SOURCE_DIR) / "resources" / "scenes" / "demo_presses.yaml";
  std::string text = text_of(scene);
  const std::size_t end = text.find("  - {use: quantisation}");
  ASSERT_NE(end, std::string::npos);
  write_text(folder / "cut.yaml", text.substr(0, end));
  const ProgramRun run =
      run_alltact({"simulate", (folder / "cut.yaml").string(), "-o", (folder / "out").string()});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("integer grey levels"));
  EXPECT_THAT(run.errors, HasSubstr("quantisation"));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(BadInput, NothingInAFileWritesOnTheTerminal) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  const std::string file = flat.file("finger/finger.yaml"), good = text_of(file);
  std::string spoiled = good;
  const std::size_t at = spoiled.find("orthographic");
  ASSERT_NE(at, std::string::npos);
  spoiled.replace(at, 12, "\"\\e[2J\\a" + std::string(4000, 'x') + "\"");
  write_text(file, spoiled);
  const ProgramRun run = run_alltact({"check", flat.finger()});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.errors.find_first_of("\x1b\a"), std::string::npos);
  EXPECT_LT(run.errors.size(), 500U);
}

TEST(BadInput, AFolderWithoutAFingerIsTold) {
  const TemporaryFolder folder;
  const ProgramRun run = run_alltact({"check", folder.path().string()});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("finger.yaml"));
}

TEST(BadInput, AnUncalibratedFingerSaysSo) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  const ProgramRun run = flat.reconstruct({flat.presses[0].string()}, "out");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("not calibrated"));
  EXPECT_FALSE(fs::exists(flat.folder / "out"));
  EXPECT_EQ(run_alltact({"check", flat.finger()}).status, 1);
}

}  // namespace
}  // namespace alltact::test
