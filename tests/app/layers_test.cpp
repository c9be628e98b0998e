// The folder tree is the architecture: who includes whom, and what the programs load.
#include "tests/support/program.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
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

constexpr std::array kFloors{"core", "calibration", "widgets", "app"};
constexpr const char* kQtOrVtk = "^(Q[A-Z]|Qt|vtk)";

TEST(Layers, TheScanSeesWhatIsThere) {
  const auto includes = includes_below("core");
  const auto by_pipeline = [](const Include& include) {
    return include.file == "core/sensing/pipeline.h" &&
           include.header == "core/finger/finger_store.h";
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

/// Which folders include headers of which others, and one file that does.
using FolderArrows = std::map<std::string, std::map<std::string, std::string>>;

FolderArrows arrows_between_folders() {
  FolderArrows arrows;
  for (const char* floor : kFloors)
    for (const Include& include : includes_below(floor)) {
      const std::string from = fs::path(include.file).parent_path().string();
      const std::string to = fs::path(include.header).parent_path().string();
      if (from != to && fs::exists(fs::path(ALLTACT_SOURCE_DIR) / include.header))
        arrows[from].emplace(to, include.file + " includes " + include.header);
    }
  return arrows;
}

/// Arrows that lie on a way back to where they begin, by the folders that can be reached.
std::vector<std::string> circles(const FolderArrows& arrows) {
  const auto reached_from = [&](const std::string& start) {
    std::set<std::string> reached;
    std::vector<std::string> next{start};
    while (!next.empty()) {
      const auto from = arrows.find(next.back());
      next.pop_back();
      if (from == arrows.end()) continue;
      for (const auto& arrow : from->second)
        if (reached.insert(arrow.first).second) next.push_back(arrow.first);
    }
    return reached;
  };
  std::vector<std::string> found;
  for (const auto& [from, to_and_why] : arrows)
    for (const auto& [to, why] : to_and_why)
      if (reached_from(to).contains(from)) found.push_back(why);
  return found;
}

TEST(Layers, NoFolderLeadsBackToItself) {
  const FolderArrows arrows = arrows_between_folders();
  EXPECT_GT(arrows.size(), 30U);
  EXPECT_THAT(circles(arrows), testing::IsEmpty());
  EXPECT_THAT(circles({{"a", {{"b", "1"}}}, {"b", {{"c", "2"}, {"d", "3"}}}, {"c", {{"a", "4"}}}}),
              testing::UnorderedElementsAre("1", "2", "4"));
}

/// Types that a file's text defines where they could clash with those of other files.
std::vector<std::string> types_defined_in(const std::string& text) {
  static const std::regex form(
      R"(^(class|struct|enum class|enum)( \[\[nodiscard\]\])? (\w+)( final)?( : [^;]*)? \{)");
  std::vector<std::string> names;
  std::istringstream stream(text);
  std::smatch found;
  bool is_own = false;  // in a namespace without a name
  for (std::string line; std::getline(stream, line);) {
    if (line == "namespace {") is_own = true;
    if (line == "}  // namespace") is_own = false;
    if (!is_own && std::regex_search(line, found, form)) names.push_back(found[3]);
  }
  return names;
}

TEST(Layers, NoNameStandsForTwoTypes) {
  std::map<std::string, std::vector<std::string>> places;
  std::vector<std::string> folders(std::begin(kFloors), std::end(kFloors));
  folders.emplace_back("tests");
  for (const std::string& folder : folders)
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(ALLTACT_SOURCE_DIR) / folder)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".h" && ending != ".cpp") continue;
      for (const std::string& name : types_defined_in(text_of(entry.path())))
        places[name].push_back(entry.path().string());
    }
  EXPECT_GT(places.size(), 300U);
  for (const auto& [name, files] : places) EXPECT_THAT(files, testing::SizeIs(1)) << name;
  EXPECT_THAT(types_defined_in("struct A {\nclass B;\nnamespace {\nstruct C {\n}  // namespace\n"
                               "enum class D : int { kOne };\nstruct A::E {\n"),
              testing::ElementsAre("A", "D"));
}

TEST(Layers, NobodyOpensOpenCvWindows) {
  for (const char* folder : {"core", "calibration", "widgets", "app", "tests"})
    EXPECT_THAT(offences(folder, "opencv2/(highgui|opencv)"), testing::IsEmpty()) << folder;
}

TEST(Layers, TheTopHoldsOnlyWhatTheDesignNames) {
  const std::set<std::string> allowed = {
      "core",           "calibration",      "widgets",      "app",
      "resources",      "translations",     "tests",        "packaging",
      "README.md",      "CONTRIBUTING.md",  "CHANGELOG.md", "LICENSE",
      "CMakeLists.txt", "CMakePresets.json"};
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
  for (const fs::path& program :
       {build / "app/liballtact-commands.so", build / "app/liballtact-figures.so",
        build / "tests/core_tests", build / "tests/app_tests", build / "app/studio/alltact-studio",
        build / "tests/widgets_tests", build / "tests/studio_tests",
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
