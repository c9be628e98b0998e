#include "calibration/report/method_table.h"

#include <algorithm>

namespace alltact {
namespace {

MethodRow row_of(CalibrationMethod method, const Calibration& made, const Calibration& joint) {
  MethodRow row;
  row.method = method;
  row.presses = static_cast<int>(made.balls.size());
  row.residual_mm = made.residual_mm;
  for (const BallFit& ball : made.balls) row.press_depth_mm += ball.depth_mm / row.presses;
  const auto mapping = Mapping::create(made.mapping), reads = Mapping::create(joint.mapping);
  if (!mapping || !reads) {
    row.failed = en::say("no mapping came of it");
    return row;
  }
  const double x = std::min(mapping->x_max(), reads->x_max());
  row.at_depth_mm = mapping->depth_mm(x);
  row.joint_depth_mm = reads->depth_mm(x);
  return row;
}

}  // namespace

std::vector<MethodRow> compare_methods(const std::vector<Press>& presses,
                                       const Result<std::vector<Press>>& as_paper,
                                       const Camera& camera,
                                       const Face& face,
                                       const Calibration& joint,
                                       const Job& job) {
  std::vector<MethodRow> rows{row_of(CalibrationMethod::kJoint, joint, joint)};
  for (const CalibrationMethod method :
       {CalibrationMethod::kPaper, CalibrationMethod::kCircle, CalibrationMethod::kCone}) {
    CalibrationSettings settings;
    settings.method = method;
    const bool is_paper = method == CalibrationMethod::kPaper;
    const auto made = is_paper && !as_paper
                          ? Result<Calibration>(as_paper.error())
                          : calibrate(is_paper ? *as_paper : presses, camera, face, settings, job);
    if (job.stop_requested()) break;
    if (made) {
      rows.push_back(row_of(method, *made, joint));
    } else {
      rows.push_back({});
      rows.back().method = method;
      rows.back().failed = made.error().what;
    }
  }
  return rows;
}

}  // namespace alltact
