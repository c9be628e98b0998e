// An installed tree may be moved, finds what it brings, and lets other programs measure.
#include "tests/packaging/quoted.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Installed once for all tests of this file, and moved since.
class Installed : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const ProgramRun run = run_shell(std::string("cmake --install '") + ALLTACT_BUILD_DIR +
                                     "' --prefix " + quoted(*folder_ / "first"));
    ASSERT_EQ(run.status, 0) << run.errors;
    fs::rename(*folder_ / "first", tree());
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static fs::path tree() { return *folder_ / "another place"; }
  static ProgramRun run(const std::string& arguments) {
    return run_shell("cd / && " + quoted(tree() / "bin/alltact") + " " + arguments);
  }
  static inline TemporaryFolder* folder_ = nullptr;
};

TEST_F(Installed, FindsItsPartsLibrariesAndResources) {
  EXPECT_EQ(run("--version").status, 0);
  const ProgramRun effects = run("simulate --effects");
  EXPECT_EQ(effects.status, 0) << effects.errors;
  // A body that comes with the program, pressed into a finger by a scene that does too.
  const ProgramRun scene =
      run("simulate " + quoted(tree() / "share/alltact/scenes/experiment_thread_m8.yaml") +
          " --frames 1 -o " + quoted(*folder_ / "rendered"));
  EXPECT_EQ(scene.status, 0) << scene.errors;
  const ProgramRun drawing =
      run_shell("ldd " + quoted(tree() / "lib/alltact/liballtact-figures.so"));
  EXPECT_THAT(drawing.output, HasSubstr("another place"));
  EXPECT_THAT(drawing.output, Not(HasSubstr("not found")));
  const ProgramRun studio =
      run_shell("cd / && " + quoted(tree() / "bin/alltact-studio") + " --version");
  EXPECT_EQ(studio.status, 0) << studio.errors;
}

TEST_F(Installed, LoadsNothingFromWhereItWasBuilt) {
  const ProgramRun loaded = run_shell("LD_DEBUG=libs " + quoted(tree() / "bin/alltact") +
                                      " simulate --effects 2>&1 | grep 'calling init'");
  EXPECT_THAT(loaded.output, HasSubstr("another place"));
  EXPECT_THAT(loaded.output, HasSubstr("liballtact-sensing.so"));
  EXPECT_THAT(loaded.output, Not(HasSubstr(std::string(ALLTACT_BUILD_DIR))));
}

TEST_F(Installed, HoldsWhatADesktopAndAShellWant) {
  for (const char* file :
       {"share/applications/alltact-studio.desktop", "share/metainfo/alltact-studio.metainfo.xml",
        "share/mime/packages/alltact.xml", "share/thumbnailers/alltact.thumbnailer",
        "share/icons/hicolor/48x48/apps/alltact-studio.png",
        "share/icons/hicolor/scalable/apps/alltact-studio.svg",
        "share/man/man1/alltact-calibrate.1", "share/bash-completion/completions/alltact",
        "share/zsh/vendor-completions/_alltact-studio",
        "share/fish/vendor_completions.d/alltact.fish", "share/doc/alltact/README.md",
        "share/doc/alltact/resources/help/manual.md", "share/doc/alltact/core/finger/README.md",
        "share/doc/alltact/tests/bench/README.md", "lib/udev/rules.d/70-alltact.rules"})
    EXPECT_TRUE(fs::is_regular_file(tree() / file)) << file;
}

std::vector<fs::path> headers_below(const fs::path& folder) {
  std::vector<fs::path> headers;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".h") headers.push_back(fs::relative(entry.path(), folder));
  return headers;
}

TEST_F(Installed, PublicHeadersStandApartAndIncludeNothingThatIsNotInstalled) {
  const fs::path include = tree() / "include";
  std::set<std::string> wanted, found;
  std::istringstream list(text_of(kTop / "packaging/public-headers"));
  for (std::string line; std::getline(list, line);)
    if (line.ends_with(".h")) wanted.insert(line);
  static const std::regex line_form("#include [<\"]([^>\"]+)[>\"]");
  for (const fs::path& header : headers_below(include / "alltact")) {
    if (header.begin()->string() != "detail") found.insert(header.string());
    const std::string text = text_of(include / "alltact" / header);
    for (std::sregex_iterator at(text.begin(), text.end(), line_form), end; at != end; ++at) {
      const std::string name = (*at)[1];
      const std::string first = name.substr(0, name.find('/'));
      if (first == "alltact") {
        EXPECT_TRUE(fs::exists(include / name)) << header << " includes " << name;
      } else if (first != name) {
        EXPECT_THAT(first, testing::AnyOf("opencv2", "Eigen", "fmt")) << header;
      }
    }
  }
  EXPECT_EQ(found, wanted);
}

/// As another program's build would compile it.
std::string compiler(const fs::path& include) {
  return "c++ -std=c++20 -fsyntax-only -Wall -Wextra -Werror -I " + quoted(include) +
         " -isystem /usr/include/opencv4 -isystem /usr/include/eigen3 -x c++ ";
}

TEST_F(Installed, AllPublicHeadersCompileTogether) {
  std::string all;
  for (const fs::path& header : headers_below(tree() / "include/alltact"))
    if (header.begin()->string() != "detail") all += "#include <alltact/" + header.string() + ">\n";
  write_text(*folder_ / "all.cpp", all);
  const ProgramRun run = run_shell(compiler(tree() / "include") + quoted(*folder_ / "all.cpp"));
  EXPECT_EQ(run.status, 0) << run.errors;
}

TEST_F(Installed, EachPublicHeaderCompilesAlone) {
  if (std::getenv("ALLTACT_SLOW") == nullptr) GTEST_SKIP() << "minutes; packaging/test --slow";
  for (const fs::path& header : headers_below(tree() / "include/alltact")) {
    if (header.begin()->string() == "detail") continue;
    write_text(*folder_ / "one.cpp", "#include <alltact/" + header.string() + ">\n");
    const ProgramRun run = run_shell(compiler(tree() / "include") + quoted(*folder_ / "one.cpp"));
    EXPECT_EQ(run.status, 0) << header << "\n" << run.errors;
  }
}

TEST_F(Installed, TheExampleMeasuresLive) {
  if (kIsSanitized) GTEST_SKIP() << "sanitizers want to be in a program that has their libraries";
  const std::string example = (kTop / "packaging/example").string();
  std::istringstream source(text_of(kTop / "packaging/example/measure_live.cpp"));
  int lines = 0;
  bool is_main = false;
  for (std::string line; std::getline(source, line);) {
    is_main = is_main || line.starts_with("int main");
    lines += is_main ? 1 : 0;
  }
  EXPECT_LE(lines, 20);
  const ProgramRun built =
      run_shell("cmake -S '" + example + "' -B " + quoted(*folder_ / "example") +
                " -DCMAKE_PREFIX_PATH=" + quoted(tree()) + " && cmake --build " +
                quoted(*folder_ / "example"));
  ASSERT_EQ(built.status, 0) << built.output << built.errors;
  const std::string program = quoted(*folder_ / "example/measure_live");
  EXPECT_EQ(run_shell(program).status, 2);
  const ProgramRun none = run_shell(program + " /no/finger /no/source");
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.errors, HasSubstr("/no/finger"));
}

TEST_F(Installed, AnotherMinorVersionIsNotTaken) {
  const auto found = [&](const std::string& version) {
    fs::create_directories(*folder_ / "asks");
    write_text(*folder_ / "asks/CMakeLists.txt",
               "cmake_minimum_required(VERSION 3.25)\nproject(asks LANGUAGES CXX)\n"
               "find_package(alltact " +
                   version +
                   " REQUIRED)\n"
                   "if(NOT TARGET alltact::calibration)\n  message(FATAL_ERROR none)\nendif()\n");
    fs::remove_all(*folder_ / "asked");
    return run_shell("cmake -S " + quoted(*folder_ / "asks") + " -B " + quoted(*folder_ / "asked") +
                     " -DCMAKE_PREFIX_PATH=" + quoted(tree()))
               .status == 0;
  };
  EXPECT_TRUE(found("0.1"));
  EXPECT_FALSE(found("0.2"));
  EXPECT_FALSE(found("1.0"));
}

}  // namespace
}  // namespace alltact::test
