// Random calibration campaigns, each with a world of its own: a flat soft sensor, what a person
// does with it, and what goes wrong. All images come from the closed formulas below, none from the
// program's simulation, so that its verdict is judged by a stranger.
//
// MODEL (lengths in mm on the face, x to the right, y down, origin in the middle of the image)
//   depth     u(p) = max_q h(q) exp(-|p - q| / l): the skin follows an indenter h and leaves it
//             over the lift-off length l; incompressible skin rises around the contact by a share
//             of u, blurred over the layer's thickness.
//   light     x_local = 1 - R(T - d) / R(T), R the Kubelka-Munk reflectance of a layer (K, S) over
//             a coat of reflectance R_g (Kubelka 1948, eq. 18); S and T vary over the face.
//   scatter   x = (1 - f) x_local + f (k * x_local), k a sum of two Gaussians whose widths are of
//             the layer's thickness (close to the exponential tail of diffusion).
//   camera    I = gain A(p) texture(p) (1 - x), A of lamps that fall off along the face and of the
//             lens's vignetting; defocus, shot and read noise, 8 bits, JPEG.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact::test {

enum class IndenterKind { kBall = 1, kPunch, kPin, kEdge };
[[nodiscard]] const char* to_string(IndenterKind kind);

/// A rigid body in the face.
struct Indenter {
  IndenterKind kind = IndenterKind::kBall;
  double radius_mm = 4;     ///< of a ball, a punch or a pin; half the thickness of an edge
  cv::Point2d position_mm;  ///< of its middle
  double depth_mm = 0.5;    ///< of its deepest point below the untouched face
  double angle_rad = 0;     ///< of an edge
};

/// What goes wrong in a campaign, and what the person states wrongly. As constructed: nothing.
struct CampaignFaults {
  double radius_factor = 1;       ///< ball radius given / true
  double layer_factor = 1;        ///< layer thickness given / true
  double scale_factor = 1;        ///< mm per pixel given / true
  cv::Point2d camera_shift_px;    ///< between the reference and all that follows
  double exposure_sd = 0;         ///< of each frame's gain
  double lamp_drift = 0;          ///< light of all that follows the reference: 1 + drift
  double drift_slope = 0;         ///< the same, growing to this at the image's sides
  double reference_touch_mm = 0;  ///< something presses while the reference is taken
  bool is_defocused = false;
  int jpeg_quality = 0;          ///< 0: images are stored without loss
  bool has_few_presses = false;  ///< one to three
  bool is_at_one_position = false;
  bool is_all_shallow = false;
  bool is_all_deep = false;

  /// Words for a table, blank between them; empty: no fault.
  [[nodiscard]] std::string names() const;
  /// Ball radius, image scale or layer are not what they are given as.
  [[nodiscard]] bool is_typed_wrongly() const {
    return radius_factor != 1 || layer_factor != 1 || scale_factor != 1;
  }
};

/// A frame and the depth that it shows.
struct PaintedFrame {
  cv::Mat grey;        ///< CV_8UC1
  cv::Mat1f depth_mm;  ///< negative where the skin rises
  cv::Mat1b contact;   ///< where the indenter touches
};

class CampaignWorld {
 public:
  /// The same for the same seed, on any machine.
  explicit CampaignWorld(std::uint64_t seed);

  static constexpr int kWidthPx = 162, kHeightPx = 120;
  double mm_per_px = 0.1;  ///< true
  double layer_mm = 1.5;   ///< true
  CampaignFaults faults;
  std::vector<Indenter> presses;   ///< balls, true radii
  std::vector<Indenter> contacts;  ///< the next contacts, by which the verdict is judged

  /// Words for a table: layer, scatter and what else differs from world to world.
  [[nodiscard]] std::string traits() const;
  [[nodiscard]] double skirt_share() const { return skirt_share_; }

  /// The image that serves as reference.
  [[nodiscard]] cv::Mat reference() const;
  /// What the camera sees then, of noise drawn by `frame`.
  [[nodiscard]] PaintedFrame pressed(const Indenter& indenter, int frame) const;

 private:
  using Random = std::mt19937_64;
  void draw_finger(Random& random);
  void draw_faults(Random& random);
  void draw_presses(Random& random);
  void draw_contacts(Random& random);
  [[nodiscard]] cv::Point2d position(Random& random, double margin_mm) const;
  void press_in(const Indenter& indenter, PaintedFrame& frame) const;
  [[nodiscard]] cv::Mat1f darkening(const cv::Mat1f& depth_mm) const;
  [[nodiscard]] cv::Mat1f light(cv::Point2d shift_px, double drift, double slope) const;
  [[nodiscard]] cv::Mat seen(cv::Mat1f level, std::uint64_t noise_seed) const;
  /// -1 at the left (upper) side of the image, 1 at the other.
  [[nodiscard]] static double across(double u, int count) { return 2 * u / (count - 1) - 1; }

  std::uint64_t seed_;
  cv::Mat1f light_;  ///< of all that follows the reference
  double scatter_per_mm_ = 0.6, absorb_per_mm_ = 0.01, coat_ = 0.03;
  double scatter_slope_ = 0, scatter_bow_ = 0, layer_slope_ = 0;  ///< relative, at the sides
  double skirt_share_ = 0, skirt_mm_ = 1;
  double lift_off_mm_ = 0.15, bulge_ = 0;
  double level_ = 180, fall_ = 0.5, vignette_ = 0.2, side_ = 0;
  double texture_ = 0.01, blur_px_ = 0.5, shot_ = 0.02, read_sd_ = 0.7;
};

}  // namespace alltact::test
