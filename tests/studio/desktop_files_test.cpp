// Files that the window hands to the desktop, with and without a program that shows them.
#include "core/base/atomic_file.h"
#include "tests/studio/studio_rig.h"

#include <QDesktopServices>
#include <QUrl>

#include <gmock/gmock.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

/// Puts an opener of this script into the path.
class FakeOpener {
 public:
  explicit FakeOpener(const std::string& script) : path_before_(qgetenv("PATH")) {
    must(write_file_atomically(folder_ / "xdg-open", "#!/bin/sh\n" + script + "\n"));
    std::filesystem::permissions(folder_ / "xdg-open", std::filesystem::perms::owner_all);
    qputenv("PATH", QByteArray::fromStdString(folder_.path().string()) + ":" + path_before_);
  }
  ~FakeOpener() { qputenv("PATH", path_before_); }
  FakeOpener(const FakeOpener&) = delete;
  FakeOpener& operator=(const FakeOpener&) = delete;
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
  QByteArray path_before_;
};

const QUrl kReport = QUrl::fromLocalFile(QStringLiteral("/the/finger/calibration report.html"));

TEST(DesktopFiles, NamesAFileThatNoProgramShows) {
  const FakeOpener opener("exit 3");
  Studio studio;
  QDesktopServices::openUrl(kReport);
  ASSERT_TRUE(wait_until([&] { return !studio.problems().empty(); }));
  EXPECT_THAT(studio.problems(), HasSubstr("/the/finger/calibration report.html"));
  EXPECT_THAT(studio.problems(), HasSubstr("no program on this computer opens this file"));
}

TEST(DesktopFiles, OpensAFileInTheDesktopsProgram) {
  const FakeOpener opener(R"(printf '%s' "$1" > "$(dirname "$0")/next"
mv "$(dirname "$0")/next" "$(dirname "$0")/opened")");
  Studio studio;
  QDesktopServices::openUrl(kReport);
  const auto opened = opener.folder() / "opened";
  ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(opened); }));
  EXPECT_EQ(text_of(opened), "/the/finger/calibration report.html");
  EXPECT_EQ(studio.problems(), "");
}

}  // namespace
}  // namespace alltact::test
