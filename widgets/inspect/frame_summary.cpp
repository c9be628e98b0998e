#include "widgets/inspect/frame_summary.h"

#include <algorithm>

namespace alltact {

FrameSummary summary_of(const MeasuredFrame& frame) {
  const FrameResult& result = frame.result;
  FrameSummary summary;
  summary.number = frame.number;
  if (result.depth) {
    summary.deepest_mm = summary.area_mm2 = 0.0;
    for (const ContactRegion& region : result.regions) {
      *summary.deepest_mm = std::max(*summary.deepest_mm, region.deepest_mm);
      *summary.area_mm2 += region.area_mm2;
    }
  }
  if (result.force) summary.force_N = result.force->force_N.norm();
  summary.has_contact = result.contact.has_value() || !result.regions.empty();
  if (!result.problems.empty()) summary.problem = result.problems.front();
  return summary;
}

}  // namespace alltact
