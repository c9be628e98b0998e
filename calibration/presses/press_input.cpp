#include "calibration/presses/press_input.h"

#include "core/numerics/median.h"
#include "core/open/open_source.h"
#include "core/sources/file_source.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace alltact {

Result<std::unique_ptr<Source>> open_presses(const PressInput& input) {
  if (!input.frames.empty())
    return std::unique_ptr<Source>(std::make_unique<FrameSource>(input.frames));
  if (input.bursts)
    return std::unique_ptr<Source>(
        std::make_unique<BurstSource>(input.files, input.frames_per_press));
  auto source = open_source(input.files);
  if (source || std::none_of(input.files.begin(), input.files.end(), is_video)) return source;
  Error several = source.error();
  several.advice = en::list(
      {several.advice, en::say("or --bursts where each video shows one press held still")});
  return several;
}

bool is_one_video(const Source& presses) {
  const bool is_images = dynamic_cast<const ImageSource*>(&presses) != nullptr ||
                         dynamic_cast<const FrameSource*>(&presses) != nullptr;
  return presses.is_continuous() && !is_images;
}

namespace {

namespace fs = std::filesystem;

constexpr int kMinBlockPx = 8;
constexpr int kMaxBlocks = 120;       // along the image
constexpr double kMovedSd = 4.5;      // of a block's noise
constexpr double kMovedLevels = 1.0;  // and at least this much
constexpr double kMovedPart = 5e-4;   // of the blocks: allowed by chance
constexpr std::size_t kFewestHeld = 4;
constexpr std::size_t kMaxOfVideo = 64;

cv::Mat blocks_of(const cv::Mat& grey) {
  const int block = std::max(kMinBlockPx, grey.cols / kMaxBlocks);
  const cv::Size size(std::max(1, grey.cols / block), std::max(1, grey.rows / block));
  cv::Mat cropped, blocks;
  grey(cv::Rect(0, 0, std::min(grey.cols, size.width * block),
                std::min(grey.rows, size.height * block)))
      .convertTo(cropped, CV_32F);
  cv::resize(cropped, blocks, size, 0, 0, cv::INTER_AREA);
  return blocks;
}

bool show_the_same(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size()) return false;
  const cv::Mat difference = a - b;
  std::vector<float> values(difference.begin<float>(), difference.end<float>());
  const float light = upper_median(values);
  std::vector<float> off;
  off.reserve(values.size());
  for (const float value : values) off.push_back(std::abs(value - light));
  const double noise = 1.4826 * static_cast<double>(upper_median(off));
  const double far = std::max(kMovedSd * noise, kMovedLevels);
  const auto moved = std::count_if(off.begin(), off.end(),
                                   [&](float value) { return static_cast<double>(value) > far; });
  return static_cast<double>(moved) <= std::max(2.0, kMovedPart * static_cast<double>(off.size()));
}

}  // namespace

void HeldFrames::add(FramePtr frame) {
  cv::Mat blocks = blocks_of(frame->grey);
  seen_.push_back({std::move(frame), std::move(blocks)});
  if (seen_.size() > max_frames_) seen_.pop_front();
}

std::vector<FramePtr> HeldFrames::alike() const {
  if (seen_.empty()) return {};
  const Seen& newest = seen_.back();
  const auto moved = std::find_if(seen_.rbegin(), seen_.rend(), [&](const Seen& one) {
    return one.frame->grey.size() != newest.frame->grey.size() ||
           !show_the_same(one.blocks, newest.blocks);
  });
  std::vector<FramePtr> frames;
  for (auto one = moved.base(); one != seen_.end(); ++one) frames.push_back(one->frame);
  return frames;
}

FramePtr mean_frame(const std::vector<FramePtr>& frames) {
  assert(!frames.empty());
  if (frames.size() == 1) return frames.front();
  cv::Mat sum(frames.front()->grey.size(), CV_32SC1, cv::Scalar(0));
  for (const FramePtr& frame : frames) cv::add(sum, frame->grey, sum, cv::noArray(), CV_32S);
  auto mean = std::make_shared<Frame>(*frames.back());
  mean->jpeg.reset();
  cv::Mat grey;
  sum.convertTo(grey, CV_8U, 1.0 / static_cast<double>(frames.size()));
  mean->grey = grey;
  return mean;
}

BurstSource::BurstSource(std::vector<fs::path> bursts, std::size_t max_frames)
    : bursts_(std::move(bursts)),
      max_frames_(std::clamp<std::size_t>(max_frames, 1, kMaxOfVideo)) {}

Result<FramePtr> BurstSource::next() {
  if (position_ == bursts_.size()) return FramePtr();
  const fs::path& burst = bursts_[position_++];
  auto source = open_source({burst});
  if (!source) return source.error();
  HeldFrames held(kMaxOfVideo);
  std::vector<FramePtr> longest;
  std::size_t read = 0;
  const std::size_t enough = std::max(max_frames_, kFewestHeld);
  while (longest.size() < enough) {
    auto frame = (*source)->next();
    if (!frame) return frame.error();
    if (!*frame) break;
    ++read;
    held.add(std::move(frame).value());
    if (auto alike = held.alike(); alike.size() > longest.size()) longest = std::move(alike);
  }
  if (read > 1 && longest.size() < kFewestHeld)
    return Error{en::say("the finger moves: at most {} of {} frames in a row are the same",
                         longest.size(), read),
                 burst.string(),
                 en::say("holding ball and finger still for half a second, in steady light")};
  if (longest.size() > max_frames_)
    longest.erase(longest.begin(), longest.end() - static_cast<std::ptrdiff_t>(max_frames_));
  auto frame = std::make_shared<Frame>(*mean_frame(longest));
  frame->name = (burst.has_stem() ? burst : burst.parent_path()).stem().string();
  frame->origin = burst.string();
  for (Message& remark : (*source)->remarks()) remarks_.push_back(std::move(remark));
  remarks_.push_back(en::say(
      "{}.", en::at(Message::typed(frame->name),
                    en::say("the mean of {} still frames, of {} read", longest.size(), read))));
  return FramePtr(std::move(frame));
}

}  // namespace alltact
