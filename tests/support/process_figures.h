// What a process holds while it runs, and whether that grows.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

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

/// Main memory that this process uses now.
inline double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  double pages = 0, resident = 0;
  statm >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Of this process now. `folder`: whose files are counted, at any depth.
inline ProcessFigures process_figures(const std::filesystem::path& folder) {
  ProcessFigures figures;
  figures.time_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  figures.resident_mb = resident_mb();
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

/// Samples of the process as a table, for people, in the file that ALLTACT_SOAK_FILE names.
inline void keep_figures(const std::vector<ProcessFigures>& samples) {
  const char* file = std::getenv("ALLTACT_SOAK_FILE");
  if (file == nullptr) return;
  std::ofstream table(file);
  table << "t_s,resident_mb,descriptors,threads,files\n";
  for (const ProcessFigures& one : samples)
    table << one.time_s - samples.front().time_s << ',' << one.resident_mb << ',' << one.descriptors
          << ',' << one.threads << ',' << one.files << '\n';
}

}  // namespace alltact::test
