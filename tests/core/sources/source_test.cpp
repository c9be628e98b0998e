#include "core/open/open_source.h"
#include "tests/support/temporary_folder.h"

#include <cstring>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

cv::Mat noise(int width = 64, int height = 48) {
  cv::Mat image(height, width, CV_8UC1);
  cv::randu(image, 0, 256);
  return image;
}

std::vector<std::string> names_of(Source& source) {
  std::vector<std::string> names;
  while (true) {
    const auto frame = source.next();
    EXPECT_TRUE(frame.ok()) << (frame.ok() ? "" : frame.error().sentence());
    if (!frame.ok() || *frame == nullptr) return names;
    EXPECT_EQ((*frame)->sequence, names.size());
    names.push_back((*frame)->name);
  }
}

std::string refusal(const std::vector<fs::path>& inputs) {
  const auto source = open_source(inputs);
  return source.ok() ? "opened" : source.error().sentence();
}

std::vector<cv::Mat> write_video(const fs::path& file, int fourcc, int frames, bool is_smooth) {
  cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG, fourcc, 30, {64, 48}, false);
  EXPECT_TRUE(writer.isOpened());
  std::vector<cv::Mat> written;
  for (int i = 0; i < frames; ++i) {
    cv::Mat image = noise();
    if (is_smooth) cv::GaussianBlur(image, image, {0, 0}, 4);
    writer.write(image);
    written.push_back(image);
  }
  return written;
}

TEST(Source, FolderGivesItsPicturesInNameOrderAndNothingElse) {
  const TemporaryFolder folder;
  for (const char* name : {"b.png", "a10.png", "a2.bmp", "B.jpg", ".hidden.png"})
    cv::imwrite(folder / name, noise());
  std::ofstream(folder / "notes.txt") << "x";
  fs::create_directory(folder / "sub.png");
  auto source = open_source({folder.path()});
  ASSERT_TRUE(source.ok());
  EXPECT_EQ((*source)->count(), 4U);
  EXPECT_FALSE((*source)->is_continuous());
  EXPECT_THAT(names_of(**source), ElementsAre("B", "a2", "a10", "b"));
}

TEST(Source, PicturesComeInTheOrderGiven) {
  const TemporaryFolder folder;
  const cv::Mat z = noise(), a = noise();
  cv::imwrite(folder / "z.png", z);
  cv::imwrite(folder / "a.png", a);
  auto source = open_source({folder / "z.png", folder / "a.png"});
  ASSERT_TRUE(source.ok());
  const FramePtr first = *(*source)->next();
  EXPECT_EQ(first->name, "z");
  EXPECT_EQ(first->origin, (folder / "z.png").string());
  EXPECT_EQ(cv::norm(first->grey, z, cv::NORM_INF), 0);
  EXPECT_THAT(names_of(*open_source({folder / "z.png", folder / "a.png"}).value()),
              ElementsAre("z", "a"));
}

TEST(Source, NumberedPicturesFollowEachOtherInTime) {
  const auto is_continuous = [](const std::vector<std::string>& names) {
    const TemporaryFolder folder;
    for (const std::string& name : names) cv::imwrite(folder / name, noise());
    return (*open_source({folder.path()}))->is_continuous();
  };
  EXPECT_TRUE(is_continuous({"frame_00000.png", "frame_00001.png", "frame_00002.png"}));
  EXPECT_TRUE(is_continuous({"009.png", "010.png"}));
  EXPECT_TRUE(is_continuous({"9.png", "10.png"}));
  EXPECT_FALSE(is_continuous({"9.png", "010.png"}));
  EXPECT_FALSE(is_continuous({"frame_00000.png", "frame_00002.png"}));
  EXPECT_FALSE(is_continuous({"press_000.png", "other_001.png"}));
  EXPECT_FALSE(is_continuous({"frame_00000.png", "frame_00001.bmp"}));
  EXPECT_FALSE(is_continuous({"frame_00000.png"}));
  EXPECT_FALSE(is_continuous({"left.png", "right.png"}));
}

TEST(Source, GoesOnBehindAPictureThatCannotBeRead) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "a.png", noise());
  std::ofstream(folder / "b.png") << "no picture";
  cv::imwrite(folder / "c.png", noise());
  auto source = open_source({folder.path()});
  ASSERT_TRUE(source.ok());
  EXPECT_TRUE((*source)->next().ok());
  const auto broken = (*source)->next();
  ASSERT_FALSE(broken.ok());
  EXPECT_THAT(broken.error().where.english(), HasSubstr("b.png"));
  const auto last = (*source)->next();
  ASSERT_TRUE(last.ok());
  EXPECT_EQ((*last)->name, "c");
  EXPECT_EQ((*last)->sequence, 2U);  // a gap is a lost frame
  EXPECT_EQ(*(*source)->next(), nullptr);
  EXPECT_EQ(*(*source)->next(), nullptr);
}

TEST(Source, LosslessGreyVideoComesBackExactly) {
  const TemporaryFolder folder;
  const auto written =
      write_video(folder / "v.mkv", cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 7, false);
  auto source = open_source({folder / "v.mkv"});
  ASSERT_TRUE(source.ok());
  EXPECT_TRUE((*source)->is_continuous());
  for (std::size_t i = 0; i < written.size(); ++i) {
    const FramePtr frame = *(*source)->next();
    ASSERT_NE(frame, nullptr);
    EXPECT_EQ(frame->name, fmt::format("frame_{:05}", i));
    EXPECT_EQ(frame->sequence, i);
    EXPECT_EQ(frame->grey.type(), CV_8UC1);
    EXPECT_EQ(cv::norm(frame->grey, written[i], cv::NORM_INF), 0) << i;
  }
  EXPECT_EQ(*(*source)->next(), nullptr);
}

TEST(Source, FramesStayAsTheyWereWhenLaterOnesAreRead) {
  const TemporaryFolder folder;
  const auto written =
      write_video(folder / "v.mkv", cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 5, false);
  auto source = open_source({folder / "v.mkv"});
  std::vector<FramePtr> frames;
  while (const FramePtr frame = *(*source)->next()) frames.push_back(frame);
  ASSERT_EQ(frames.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(cv::norm(frames[i]->grey, written[i], cv::NORM_INF), 0);
}

TEST(Source, CamerasMotionJpegComesBackAsGrey) {
  const TemporaryFolder folder;
  const auto written =
      write_video(folder / "v.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 4, true);
  auto source = open_source({folder / "v.avi"});
  ASSERT_TRUE(source.ok());
  for (const cv::Mat& image : written) {
    const FramePtr frame = *(*source)->next();
    ASSERT_NE(frame, nullptr);
    // A lossy format: close in the mean, and neither darker nor brighter.
    EXPECT_LT(cv::norm(frame->grey, image, cv::NORM_L1) / static_cast<double>(image.total()), 3);
    EXPECT_NEAR(cv::mean(frame->grey)[0], cv::mean(image)[0], 1);
  }
}

TEST(Source, TruncatedVideoGivesWhatIsThere) {
  const TemporaryFolder folder;
  write_video(folder / "v.mkv", cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 20, false);
  const auto size = fs::file_size(folder / "v.mkv");
  int frames_before = 21;
  for (double part : {0.9, 0.5, 0.2, 0.02, 0.0}) {
    fs::resize_file(folder / "v.mkv",
                    static_cast<std::uintmax_t>(part * static_cast<double>(size)));
    auto source = open_source({folder / "v.mkv"});
    int frames = 0;
    if (source.ok()) {
      while (true) {
        const auto frame = (*source)->next();
        if (!frame.ok() || *frame == nullptr) break;
        ++frames;
      }
    } else {
      EXPECT_THAT(source.error().sentence(), HasSubstr("v.mkv"));
    }
    EXPECT_LT(frames, frames_before);
    if (part > 0.1) {
      EXPECT_GE(frames, part * 20 - 3);
    }
    frames_before = frames + 1;
  }
}

TEST(Source, SaysWhatIsWrongWithAnInput) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "a.png", noise());
  fs::create_directory(folder / "empty");
  std::ofstream(folder / "bad.mkv") << "no video at all";
  std::ofstream(folder / "empty.mkv") << "";
  std::ofstream(folder / "notes.txt") << "x";
  write_video(folder / "v.mkv", cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 1, false);
  EXPECT_THAT(refusal({}), HasSubstr("no input"));
  EXPECT_THAT(refusal({folder / "none.png"}), HasSubstr("none.png: there is no such file"));
  EXPECT_THAT(refusal({folder / "empty"}), HasSubstr("contains no images"));
  EXPECT_THAT(refusal({folder / "bad.mkv"}), HasSubstr("bad.mkv: the video cannot be opened"));
  EXPECT_THAT(refusal({folder / "empty.mkv"}), HasSubstr("the video cannot be opened"));
  EXPECT_THAT(refusal({folder / "notes.txt"}), HasSubstr("neither an image"));
  EXPECT_THAT(refusal({folder / "a.png", folder / "v.mkv"}), HasSubstr("cannot be mixed"));
  EXPECT_EQ(refusal({folder / "v.mkv"}), "opened");
}

}  // namespace
}  // namespace alltact
