#include "core/sensing/frame_result.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(PictureFault, NamesABlackASaturatedAndABlankPictureAndNoOther) {
  cv::Mat image(300, 480, CV_8UC1, cv::Scalar(3));
  EXPECT_NE(image_fault(image).value().english().find("black"), std::string::npos);
  image(cv::Rect(100, 100, 120, 80)).setTo(120);  // a face with nothing around it
  EXPECT_FALSE(image_fault(image));
  image(cv::Rect(0, 0, 480, 90)).setTo(255);  // a third but for a little
  EXPECT_FALSE(image_fault(image));
  image(cv::Rect(0, 0, 480, 120)).setTo(255);
  EXPECT_NE(image_fault(image).value().english().find("% of it is saturated"), std::string::npos);
  image.setTo(120);
  EXPECT_NE(image_fault(image).value().english().find("blank"), std::string::npos);
  cv::randn(image, 120, 1.0);  // an even field, with the noise of a quiet camera
  EXPECT_FALSE(image_fault(image));
}

TEST(IsSameFrame, IsTheOneReadAgainAndNotTheCamerasNext) {
  Frame first;
  first.grey = cv::Mat(40, 60, CV_8UC1, cv::Scalar(7));
  Frame again = first;
  EXPECT_TRUE(is_same_frame(first, again));
  again.grey = first.grey.clone();
  EXPECT_FALSE(is_same_frame(first, again)) << "they do not say where they come from";
  first.origin = again.origin = "reference.mkv";
  first.name = again.name = "frame_00007";
  first.sequence = again.sequence = 7;
  EXPECT_TRUE(is_same_frame(first, again));
  again.sequence = 8;
  EXPECT_FALSE(is_same_frame(first, again));
}

TEST(IsSamePicture, SeesOneGreyLevelOfOnePixel) {
  cv::Mat image(40, 60, CV_8UC1);
  cv::randu(image, 0, 256);
  cv::Mat other = image.clone();
  EXPECT_TRUE(is_same_image(image, other));
  other.at<std::uint8_t>(39, 59) ^= 1;
  EXPECT_FALSE(is_same_image(image, other));
  EXPECT_FALSE(is_same_image(image, image.rowRange(0, 39)));
  EXPECT_FALSE(is_same_image({}, {}));
}

TEST(FlagFractions, AreOfTheFaceAlone) {
  cv::Mat flags(10, 10, CV_8UC1, cv::Scalar(kOffFace));
  flags.rowRange(0, 4).setTo(kMeasured);
  flags.row(4).setTo(kSaturated);
  const FlagFractions shares = flag_fractions(flags);
  EXPECT_DOUBLE_EQ(shares.of[kMeasured], 0.8);
  EXPECT_DOUBLE_EQ(shares.of[kSaturated], 0.2);
  EXPECT_EQ(shares.of[kOffFace], 0.0);
  EXPECT_EQ(flag_fractions(cv::Mat(3, 3, CV_8UC1, cv::Scalar(kOffFace))).of[kMeasured], 0.0);
}

TEST(FaceFaults, TellsEachFaultByItsName) {
  FlagFractions good{};
  good.of[kMeasured] = 0.99;
  good.of[kSaturated] = 0.01;
  const cv::Rect face(0, 0, 100, 100);
  const auto told = [&](const FlagFractions& shares, double q, double brighter) {
    std::string all;
    for (const Message& fault :
         face_faults(shares, LightGain(face, {q - 1.0, 0, 0, 0, 0, 0}, 0.9, brighter)))
      all += fault.english() + "\n";
    return all;
  };
  EXPECT_EQ(told(good, 1.0, 0.05), "");
  EXPECT_EQ(told(good, 1.0 / 1.3, 0.0), "");
  EXPECT_NE(told(good, 1.0 / 1.6, 0.0).find("60 % brighter"), std::string::npos);
  EXPECT_NE(told(good, 1.0 / 0.4, 0.0).find("60 % darker"), std::string::npos);
  EXPECT_NE(told(good, 1.0, 0.3).find("another finger"), std::string::npos);
  FlagFractions bright{};
  bright.of[kSaturated] = 0.64;
  EXPECT_NE(told(bright, 1.0, 0.0).find("64 % of the face is too bright"), std::string::npos);
  FlagFractions unknown{};
  unknown.of[kNoReference] = 0.1;
  EXPECT_NE(told(unknown, 1.0, 0.0).find("10 % of the face was never"), std::string::npos);
  FlagFractions hidden{};
  hidden.of[kHiddenEnd] = 0.004;  // however little: nothing can be said of it
  EXPECT_NE(told(hidden, 1.0, 0.0).find("0.4 % of the face, at its end, is hidden"),
            std::string::npos);
}

}  // namespace
}  // namespace alltact
