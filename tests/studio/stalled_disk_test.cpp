// A folder whose disk stops answering: the window says so, and goes on when it answers.
#include "core/base/atomic_file.h"
#include "core/base/slow_disk.h"
#include "core/finger/finger.h"
#include "tests/studio/studio_rig.h"

#include <QElapsedTimer>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

TEST(StalledDisk, IsSaidInOneSentenceUntilItAnswers) {
  const TemporaryFolder folder;
  const fs::path finger = folder / "finger";
  fs::copy(MadeFingers::get().described(), finger, fs::copy_options::recursive);
  const fs::path file = finger / Finger::kFileName;
  const std::string text = text_of(file);
  // Opening a pipe waits until somebody writes to it, as a stalled file waits for its disk.
  fs::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);

  const DiskWatch disks(std::chrono::milliseconds(300), [](const fs::path&) {});
  StudioOptions options;
  options.finger = finger;
  options.slow_files = [&disks] { return disks.slow(); };
  Studio studio(options);
  const std::string sentence = "its disk responds slowly";
  ASSERT_TRUE(
      wait_until([&] { return studio.problems().find(sentence) != std::string::npos; }, 5000));
  const std::string reported = studio.problems();
  EXPECT_THAT(reported, HasSubstr(finger.string()));
  EXPECT_EQ(reported.find(sentence), reported.rfind(sentence)) << "once: " << reported;

  // It answers: what waited is read, and the sentence goes.
  QElapsedTimer timer;
  timer.start();
  while (studio.session().status().finger.state == FingerState::kLoading &&
         timer.elapsed() < 10000) {
    if (const int pipe = ::open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC); pipe >= 0) {
      EXPECT_EQ(::write(pipe, text.data(), text.size()), static_cast<ssize_t>(text.size()));
      ::close(pipe);
    }
    QTest::qWait(20);
  }
  // Whoever still waits for the pipe goes on: its other end is open, then closed.
  const int other_end = ::open(file.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(other_end, 0);
  fs::remove(file);
  ASSERT_TRUE(write_file_atomically(file, text).ok());
  QTest::qWait(100);
  ::close(other_end);
  EXPECT_TRUE(
      wait_until([&] { return studio.problems().find(sentence) == std::string::npos; }, 10000))
      << studio.problems();
}

}  // namespace
}  // namespace alltact::test
