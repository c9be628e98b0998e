// What a process holds while it runs, and whether that grows.
#pragma once

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <malloc.h>
#include <unistd.h>

namespace alltact::test {

struct ProcessFigures {
  double time_s = 0;
  double resident_mb = 0, descriptors = 0, threads = 0;
  double files = 0;  ///< in the folder for temporary files, at any depth of what is this test's
};

inline double entries_in(const std::filesystem::path& folder) {
  std::error_code gone;
  double count = 0;
  for (std::filesystem::directory_iterator entry(folder, gone), end; !gone && entry != end;
       entry.increment(gone))
    ++count;
  return count;
}

/// Of this process now. `folder`: whose files are counted, at any depth.
inline ProcessFigures process_figures(const std::filesystem::path& folder) {
  ProcessFigures figures;
  figures.time_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  malloc_trim(0);
  std::ifstream statm("/proc/self/statm");
  double pages = 0, resident = 0;
  statm >> pages >> resident;
  figures.resident_mb = resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
  figures.descriptors = entries_in("/proc/self/fd");
  figures.threads = entries_in("/proc/self/task");
  std::error_code gone;
  for (std::filesystem::recursive_directory_iterator entry(folder, gone), end;
       !gone && entry != end; entry.increment(gone))
    ++figures.files;
  return figures;
}

/// How much a figure rose over the whole time: the median slope between any two samples (Theil
/// 1950, Sen, Journal of the American Statistical Association 1968), which single peaks do not
/// move, times the time. 0 for fewer than two samples.
inline double rise_of(const std::vector<ProcessFigures>& samples, double ProcessFigures::*figure) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = i + 1; j < samples.size(); ++j)
      slopes.push_back((samples[j].*figure - samples[i].*figure) /
                       (samples[j].time_s - samples[i].time_s));
  if (slopes.empty()) return 0;
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::nth_element(slopes.begin(), middle, slopes.end());
  return *middle * (samples.back().time_s - samples.front().time_s);
}

}  // namespace alltact::test
