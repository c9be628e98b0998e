#include "calibration/twin/twin_scene.h"

#include "core/base/yaml.h"
#include "core/simulation/plan.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

namespace alltact {
namespace {

std::string numbers(const Eigen::Vector3d& point) {
  return yaml_numbers({point.x(), point.y(), point.z()});
}

std::string camera_text(const CameraParameters& camera) {
  YamlBlock block("");
  block.add("model", std::string(to_string(camera.model)));
  block.add("size", fmt::format("[{}, {}]", camera.width_px, camera.height_px));
  if (camera.model == CameraModel::kOrthographic) {
    block.add("mm_per_px", yaml_number(camera.mm_per_px));
  } else {
    block.add("fx", yaml_number(camera.fx_px));
    block.add("fy", yaml_number(camera.fy_px));
  }
  block.add("cx", yaml_number(camera.cx_px));
  block.add("cy", yaml_number(camera.cy_px));
  return fmt::format("  camera: {}\n", block.in_braces());
}

std::string face_text(const Face& face) {
  YamlBlock block("");
  block.add("kind", face.kind == FaceKind::kFlat ? "flat" : "fin_ray");
  block.add("layer_mm", yaml_number(face.layer_mm));
  if (face.kind == FaceKind::kFlat)
    block.add("plane_z_mm", yaml_number(face.plane_z_mm));
  else
    block.add("width_mm", yaml_number(face.width_mm));
  return fmt::format("  face: {}\n", block.in_braces());
}

/// Effects as lines, each with its source.
class EffectLines {
 public:
  explicit EffectLines(const std::map<std::string, std::string>& comments) : comments_(comments) {}

  void add(const std::string& name, const std::string& parameters, const std::string& from = "") {
    add_comment(from.empty() ? name : from);
    text_ += fmt::format("  - {{use: {}{}{}}}\n", name, parameters.empty() ? "" : ", ", parameters);
  }
  /// In frames [first, end); -1: from the beginning, to the end.
  void add_lamps(const TwinScene& scene, double share, int first, int end) {
    if (first <= 0) add_comment("leds");
    text_ += "  - use: leds\n";
    if (first >= 0) text_ += fmt::format("    from: {}\n    until: {}\n", first, end);
    text_ += "    lamps:\n";
    for (const TwinLamp& lamp : scene.lamps) {
      text_ += fmt::format("      - {{at_mm: {}, power: {}", numbers(lamp.at_mm),
                           yaml_number(share * lamp.power));
      if (lamp.aim_mm)
        text_ += fmt::format(", aim_mm: {}, lobe: {}", numbers(*lamp.aim_mm), lamp.lobe);
      text_ += "}\n";
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void add_comment(const std::string& key) {
    const auto comment = comments_.find(key);
    if (comment != comments_.end()) text_ += "  # " + comment->second + "\n";
  }

  const std::map<std::string, std::string>& comments_;
  std::string text_;
};

void add_pose(const TwinScene& scene, EffectLines& lines) {
  if (scene.face.kind != FaceKind::kFinRay) return;
  double bend = 1, sway = 1;  // the ranges that the poses lie in
  std::vector<TwinPose> poses{scene.rest};
  for (const TwinBall& ball : scene.balls) poses.push_back(ball.pose);
  for (const TwinPose& pose : poses) {
    bend = std::max({bend, std::ceil(std::abs(pose.q1_mm)), std::ceil(std::abs(pose.q2_mm))});
    sway = std::max(sway, std::ceil(std::abs(pose.sway_mm)));
  }
  lines.add("bend", fmt::format("q1_mm: {{from: {0}, to: {1}}}, q2_mm: {{from: {0}, to: {1}}}",
                                yaml_number(-bend), yaml_number(bend)));
  lines.add("sway",
            fmt::format("sway_mm: {{from: {}, to: {}}}", yaml_number(-sway), yaml_number(sway)));
}

std::string pose_text(const TwinPose& pose) {
  return fmt::format("{{q1_mm: {}, q2_mm: {}, sway_mm: {}}}", yaml_number(pose.q1_mm),
                     yaml_number(pose.q2_mm), yaml_number(pose.sway_mm));
}

std::string motion_text(const TwinScene& scene) {
  if (scene.face.kind != FaceKind::kFinRay) return "";
  std::string text = fmt::format(
      "untouched: {{x_mm: {}, y_mm: {}, z_mm: {}, incline_deg: {}, "
      "length_mm: {}}}\nmotion:\n  kind: poses\n  poses:\n    - {}\n",
      yaml_number(scene.base_mm.x()), yaml_number(scene.base_mm.y()),
      yaml_number(scene.base_mm.z()), yaml_number(scene.incline_rad * 180 / std::numbers::pi),
      yaml_number(scene.length_mm), pose_text(scene.rest));
  for (const TwinBall& ball : scene.balls) text += "    - " + pose_text(ball.pose) + "\n";
  return text;
}

void add_contact(const TwinScene& scene, EffectLines& lines) {
  if (scene.balls.empty()) return;
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    const TwinBall& ball = scene.balls[i];
    lines.add("ball",
              fmt::format("from: {}, until: {}, radius_mm: {}, s_mm: {}, y_mm: {}, depth_mm: {}",
                          i + 1, i + 2, yaml_number(ball.radius_mm), yaml_number(ball.s_mm),
                          yaml_number(ball.y_mm), yaml_number(ball.depth_mm)),
              "ball " + ball.press);
  }
  lines.add("rolloff", fmt::format("from: 1, kind: {}, length_mm: {}",
                                   scene.rolloff == TwinRolloff::kHertz ? "hertz" : "smooth",
                                   yaml_number(scene.rolloff_mm)));
  if (scene.halo == TwinHalo::kNone) return;
  std::string bulge = fmt::format("from: 1, share: {}, width_mm: {}", yaml_number(scene.halo_share),
                                  yaml_number(scene.halo_width_mm));
  if (scene.halo == TwinHalo::kExponential)
    bulge += fmt::format(", tail: exponential, steepness: {}", yaml_number(scene.halo_steepness));
  lines.add("bulge", bulge);
}

void add_light(const TwinScene& scene, EffectLines& lines) {
  std::string layer = fmt::format("scatter_per_mm: {}", yaml_number(scene.layer.scatter_per_mm));
  if (scene.layer.absorb_per_mm > 0)
    layer += fmt::format(", absorb_per_mm: {}", yaml_number(scene.layer.absorb_per_mm));
  if (scene.layer.coat > 0) layer += fmt::format(", coat: {}", yaml_number(scene.layer.coat));
  lines.add("layer", layer + ", along: normal");
  if (scene.room_level > 0)
    lines.add("ambient", fmt::format("level: {}", yaml_number(scene.room_level)));
  const bool is_even = std::all_of(scene.balls.begin(), scene.balls.end(),
                                   [](const TwinBall& b) { return b.light == 1; });
  if (is_even) return lines.add_lamps(scene, 1, -1, -1);
  lines.add_lamps(scene, 1, 0, 1);
  for (std::size_t i = 0; i < scene.balls.size(); ++i)
    lines.add_lamps(scene, scene.balls[i].light, static_cast<int>(i) + 1, static_cast<int>(i) + 2);
}

void add_sensor(const TwinScene& scene, bool with_noise, EffectLines& lines) {
  if (scene.blur_px > 0) lines.add("defocus", fmt::format("sd_px: {}", yaml_number(scene.blur_px)));
  if (!with_noise) return;
  if (scene.prnu > 0) lines.add("fixed-pattern", fmt::format("prnu: {}", yaml_number(scene.prnu)));
  if (scene.shot_gain > 0) lines.add("shot", fmt::format("gain: {}", yaml_number(scene.shot_gain)));
  if (scene.read_sd > 0) lines.add("read", fmt::format("sd: {}", yaml_number(scene.read_sd)));
  lines.add("quantisation", "");
}

void add_lens(const CameraParameters& camera, EffectLines& lines) {
  const auto& k = camera.distortion;
  if (std::any_of(k.begin(), k.end(), [](double value) { return value != 0; }))
    lines.add("distortion", fmt::format("coefficients: {}", yaml_numbers(k)));
  if (!camera.port) return;
  lines.add(
      "port",
      fmt::format("gap_mm: {}, plate_mm: {}, plate_index: {}, medium_index: {}",
                  yaml_number(camera.port->gap_mm), yaml_number(camera.port->plate_mm),
                  yaml_number(camera.port->plate_index), yaml_number(camera.port->medium_index)));
}

}  // namespace

std::string TwinScene::to_yaml(bool with_noise) const {
  EffectLines lines(comments);
  add_lens(camera, lines);
  add_pose(*this, lines);
  add_contact(*this, lines);
  add_light(*this, lines);
  add_sensor(*this, with_noise, lines);
  return fmt::format("name: {}\nwhy: {}\nframes: {}\nfinger:\n{}{}{}effects:\n{}", yaml_text(name),
                     yaml_text(why), balls.size() + 1, camera_text(camera), face_text(face),
                     motion_text(*this), lines.text());
}

TwinScene TwinScene::with_ball(const TwinBall& ball) const {
  TwinScene one = *this;
  one.balls = {ball};
  return one;
}

TwinScene TwinScene::untouched(const TwinPose& pose) const {
  TwinScene one = *this;
  one.balls.clear();
  one.rest = pose;
  return one;
}

Result<cv::Mat> twin_image(const TwinScene& scene, int frame) {
  const auto parsed = Scene::parse(scene.to_yaml(false), "the twin's scene");
  if (!parsed) return parsed.error();
  const auto plan = Plan::compile(*parsed, 1);
  if (!plan) return plan.error();
  return plan->render(frame);
}

CameraParameters cropped_camera(const CameraParameters& camera, const cv::Rect& part) {
  CameraParameters cropped = camera;
  cropped.width_px = part.width;
  cropped.height_px = part.height;
  cropped.cx_px = camera.cx_px - part.x;
  cropped.cy_px = camera.cy_px - part.y;
  return cropped;
}

CameraParameters downsampled_camera(const CameraParameters& camera, int side) {
  CameraParameters thin = camera;
  thin.width_px = camera.width_px / side;
  thin.height_px = camera.height_px / side;
  thin.fx_px = camera.fx_px / side;
  thin.fy_px = camera.fy_px / side;
  thin.cx_px = (camera.cx_px - 0.5 * (side - 1)) / side;
  thin.cy_px = (camera.cy_px - 0.5 * (side - 1)) / side;
  thin.mm_per_px = camera.mm_per_px * side;
  return thin;
}

cv::Mat downsampled_image(const cv::Mat& grey, int side) {
  cv::Mat_<float> thin(grey.rows / side, grey.cols / side);
  for (int v = 0; v < thin.rows; ++v)
    for (int u = 0; u < thin.cols; ++u) {
      double sum = 0;
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) sum += grey.at<float>(v * side + i, u * side + j);
      thin(v, u) = static_cast<float>(sum / (side * side));
    }
  return thin;
}

}  // namespace alltact
