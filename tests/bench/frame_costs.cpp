// What the steps of a frame cost on a finger's own pictures, each beside a copy of the bytes that
// it cannot do without:
//   frame_costs FINGER FRAMES [REPEATS]
// FRAMES: a folder of grey pictures, of neighbouring frames or not. Prints JSON: processor's
// milliseconds of a frame by step on one thread, the least of some runs, their median over the
// frames.
#include "core/finger/finger_store.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

namespace alltact {
namespace {

struct Step {
  const char* name;
  double StepTimes::*ms;
};
constexpr std::array<Step, 7> kSteps{{{"prepare", &StepTimes::prepare},
                                      {"edges", &StepTimes::edges},
                                      {"shape", &StepTimes::global},
                                      {"markers", &StepTimes::markers},
                                      {"reference", &StepTimes::reference},
                                      {"depth", &StepTimes::local},
                                      {"contact", &StepTimes::contact}}};
using Costs = std::array<double, kSteps.size() + 1>;  // and all of them together

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Bytes that a step must read and write at the least.
Costs bytes_of(const FrameResult& result, int neighbours) {
  const auto image = static_cast<double>(result.grey.total());
  double face = 0, pressed = 0, dots = 0;
  const cv::Mat& flags = result.depth->flags;
  for (int v = 0; v < flags.rows; ++v)
    face += static_cast<double>(std::count_if(flags.ptr<std::uint8_t>(v),
                                              flags.ptr<std::uint8_t>(v) + flags.cols,
                                              [](std::uint8_t flag) { return flag != kOffFace; }));
  for (const ContactRegion& region : result.regions) pressed += region.pixels;
  constexpr double kDotPx = 20 * 20;
  if (result.markers) dots = kDotPx * static_cast<double>(result.markers->size());
  const double columns = static_cast<double>(result.grey.cols) * sizeof(FaceColumn);
  Costs bytes{2.0 * image,  // and the last one, which it is compared with
              image,
              columns,
              dots,
              face * (neighbours + 2.0),       // recorded faces in, 16-bit levels out
              face * (1.0 + 2.0 + 4.0 + 1.0),  // picture and reference in, depth and flags out
              image / 16.0 * 4.0 + pressed * 4.0,
              0.0};
  for (std::size_t k = 0; k + 1 < bytes.size(); ++k) bytes.back() += bytes[k];
  return bytes;
}

/// The least of some copies that move as many bytes, half of them read and half written.
double copy_ms(double bytes) {
  constexpr int kTimes = 30;
  std::vector<std::uint8_t> from(static_cast<std::size_t>(std::max(64.0, 0.5 * bytes)), 7),
      to(from.size());
  double least = std::numeric_limits<double>::max();
  for (int k = 0; k < kTimes; ++k) {
    timespec begin{}, end{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &begin);
    std::memcpy(to.data(), from.data(), from.size());
    asm volatile("" : : "r"(to.data()) : "memory");  // it is not left out
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &end);
    least = std::min(least, 1e3 * static_cast<double>(end.tv_sec - begin.tv_sec) +
                                1e-6 * static_cast<double>(end.tv_nsec - begin.tv_nsec));
  }
  return least;
}

int run(const std::filesystem::path& folder, const std::filesystem::path& images, int repeats) {
  const auto fail = [](const std::string& why) {
    std::fprintf(stderr, "%s\n", why.c_str());
    return 1;
  };
  cv::setNumThreads(1);
  const auto finger = open_finger(folder);
  if (!finger) return fail(finger.error().sentence());
  const PipelineSettings settings;
  auto pipeline = Pipeline::create(**finger, settings, Job());
  if (!pipeline) return fail(pipeline.error().sentence());
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(images))
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<FramePtr> frames;
  for (const auto& file : files) {
    auto frame = std::make_shared<Frame>();
    frame->grey = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    frame->name = file.stem().string();
    frame->origin = file.string();
    frames.push_back(frame);
  }
  std::array<std::vector<double>, std::tuple_size_v<Costs>> all_ms, all_bytes;
  for (const FramePtr& frame : frames) {
    Costs least;
    least.fill(std::numeric_limits<double>::max());
    Costs bytes{};
    // Twice the same first: then the markers are followed, as those of a camera's frames are.
    for (int k = 0; k < repeats + 1; ++k) {
      const double begin = processor_ms();
      const auto result = (*pipeline)(frame);
      const double all = processor_ms() - begin;
      if (!result || !result->depth) return fail(frame->name + " shows no depth");
      bytes = bytes_of(*result, settings.reference_neighbours);
      if (k == 0) continue;
      for (std::size_t s = 0; s < kSteps.size(); ++s)
        least[s] = std::min(least[s], result->times_ms.*kSteps[s].ms);
      least.back() = std::min(least.back(), all);
    }
    for (std::size_t s = 0; s < least.size(); ++s)
      all_ms[s].push_back(least[s]), all_bytes[s].push_back(bytes[s]);
  }
  if (frames.empty()) return fail("no picture in " + images.string());
  nlohmann::ordered_json told;
  told["frames"] = frames.size();
  told["size"] = {frames.front()->grey.cols, frames.front()->grey.rows};
  for (std::size_t s = 0; s < all_ms.size(); ++s) {
    const double bytes = median(all_bytes[s]);
    told["steps"][s < kSteps.size() ? kSteps[s].name : "total"] = {
        {"ms", median(all_ms[s])}, {"bytes", bytes}, {"copy_ms", copy_ms(bytes)}};
  }
  std::printf("%s\n", told.dump(1).c_str());
  return 0;
}

}  // namespace
}  // namespace alltact

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: frame_costs FINGER FRAMES [REPEATS]\n");
    return 2;
  }
  return alltact::run(argv[1], argv[2], argc > 3 ? std::max(1, std::atoi(argv[3])) : 10);
}
