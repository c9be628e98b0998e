// The folder tree is the architecture: who includes whom, and what the programs load.
#include "tests/support/program.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

struct Include {
  std::string file;    // relative to the top
  std::string header;  // as written between the quotes or brackets
};

std::vector<Include> includes_below(const std::string& folder) {
  static const std::regex line_form(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])");
  std::vector<Include> includes;
  const fs::path top = ALLTACT_SOURCE_DIR;
  if (!fs::exists(top / folder)) return includes;
  for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".h" && ending != ".cpp") continue;
    std::istringstream stream(text_of(entry.path()));
    std::smatch found;
    for (std::string line; std::getline(stream, line);) {
      if (std::regex_search(line, found, line_form))
        includes.push_back({fs::relative(entry.path(), top).string(), found[1].str()});
    }
  }
  return includes;
}

std::vector<std::string> offences(const std::string& folder, const std::string& forbidden) {
  const std::regex form(forbidden);
  std::vector<std::string> found;
  for (const Include& include : includes_below(folder))
    if (std::regex_search(include.header, form))
      found.push_back(include.file + " includes " + include.header);
  return found;
}

constexpr const char* kQtOrVtk = "^(Q[A-Z]|Qt|vtk)";

TEST(Layers, TheScanSeesWhatIsThere) {
  const auto includes = includes_below("core");
  const auto by_pipeline = [](const Include& include) {
    return include.file == "core/sensing/pipeline.h" && include.header == "core/finger/finger.h";
  };
  EXPECT_TRUE(std::any_of(includes.begin(), includes.end(), by_pipeline));
  EXPECT_FALSE(offences("calibration", "^core/").empty());
}

TEST(Layers, CoreKnowsNothingAbove) {
  EXPECT_THAT(offences("core", "^(calibration|widgets|app|tests)/"), testing::IsEmpty());
  EXPECT_THAT(offences("core", kQtOrVtk), testing::IsEmpty());
  EXPECT_THAT(offences("core", "^ceres"), testing::IsEmpty());
}

TEST(Layers, CalibrationKnowsOnlyCore) {
  EXPECT_THAT(offences("calibration", "^(widgets|app|tests)/"), testing::IsEmpty());
  EXPECT_THAT(offences("calibration", kQtOrVtk), testing::IsEmpty());
}

TEST(Layers, WidgetsDoNotKnowTheProgram) {
  EXPECT_THAT(offences("widgets", "^(app|tests)/"), testing::IsEmpty());
}

TEST(Layers, TheProgramDoesNotKnowTheTests) {
  EXPECT_THAT(offences("app", "^tests/"), testing::IsEmpty());
}

TEST(Layers, NobodyOpensOpenCvWindows) {
  for (const char* folder : {"core", "calibration", "widgets", "app", "tests"})
    EXPECT_THAT(offences(folder, "opencv2/(highgui|opencv)"), testing::IsEmpty()) << folder;
}

TEST(Layers, TheTopHoldsOnlyWhatTheDesignNames) {
  const std::set<std::string> allowed = {"core",
                                         "calibration",
                                         "widgets",
                                         "app",
                                         "resources",
                                         "translations",
                                         "tests",
                                         "packaging",
                                         "README.md",
                                         "LICENSE",
                                         "CMakeLists.txt",
                                         "CMakePresets.json"};
  for (const auto& entry : fs::directory_iterator(ALLTACT_SOURCE_DIR)) {
    const std::string name = entry.path().filename().string();
    // build/ and demo/ are made by the two commands and known to .gitignore.
    if (name.front() == '.' || name == "build" || name == "demo" || name == "compile_commands.json")
      continue;
    EXPECT_TRUE(allowed.contains(name)) << name;
  }
}

TEST(Layers, NoProgramLoadsQt5) {
  const fs::path build = fs::path(ALLTACT_PROGRAM).parent_path().parent_path();
  for (const fs::path& program : {fs::path(ALLTACT_PROGRAM),
                                  build / "tests/core_tests",
                                  build / "tests/app_tests",
                                  build / "app/studio/alltact-studio",
                                  build / "tests/widgets_tests",
                                  build / "tests/studio_tests",
                                  build / "tests/calibration_tests"}) {
    if (!fs::exists(program)) continue;  // a build of one part alone
    const ProgramRun libraries = run_shell("ldd '" + program.string() + "'");
    ASSERT_EQ(libraries.status, 0) << libraries.errors;
    ASSERT_THAT(libraries.output, testing::HasSubstr("libopencv_core")) << program;
    EXPECT_THAT(libraries.output, testing::Not(testing::HasSubstr("libQt5"))) << program;
    EXPECT_THAT(libraries.output, testing::Not(testing::HasSubstr("libopencv_highgui"))) << program;
  }
}

}  // namespace
}  // namespace alltact::test
