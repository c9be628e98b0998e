// One bounce of light between the lit faces: at a point i
//   E_i = sum_j rho_j E_j exp(-mu r_ij) F_ij,   F_ij = integral of cos_i cos_j / (pi r^2) dA_j,
// over patches j of the view face and the side faces. E_j is the irradiance of the patch's centre
// directly from lamps and room, rho_j the mean reflectance of its face, mu the absorption of the
// clear body (C. Goral, K. Torrance, D. Greenberg and B. Battaile, "Modeling the interaction of
// light between diffuse surfaces", SIGGRAPH 1984). rho of a layer that does not absorb is
// S t / (1 + S t). `face` and `sides` are the mean reflectances, above 0 and up to 1. `depth_mm` is
// the depth of the side faces, as for the effect sides. The sum is evaluated on a lattice of each
// face, denser at its edges, and interpolated linearly. Occlusion is ignored. A press changes the
// light that a pixel reflects but not the light that its patch sends to others. A side face does
// not light itself.
#include "core/simulation/effect.h"
#include "core/simulation/illumination.h"

#include <numbers>

namespace alltact {

namespace {

constexpr int kPatchesAlong = 16, kStepsAlong = 32;
constexpr int kLitFaces = 3;
constexpr std::array<int, kLitFaces> kPatchesAcross{6, 4, 4}, kStepsAcross{10, 6, 6};

// Lattice steps from 0 to 1, denser towards both ends, and their inverse.
double lattice_part(double step) {
  return step < 0.5 ? 2 * step * step : 1 - 2 * (1 - step) * (1 - step);
}
inline float lattice_step(float part) {
  const float nearer = std::min(std::max(std::min(part, 1 - part), 0.0F), 0.5F);
  const float step = std::sqrt(nearer / 2);
  return part < 0.5F ? step : 1 - step;
}

constexpr double kFar = 4;        // diagonals of a patch: beyond, it counts as a point
constexpr double kInward = 1e-4;  // offset of lattice points from the edges, as a fraction

// The view face (0), and the side faces at -y (1) and at +y (2).
struct LitFaces {
  const FaceCurve& curve;
  double width_mm, side_depth_mm;

  // `along` and `across` run from 0 to 1: along from base to tip, across the view face from -y to
  // +y, across a side face from its edge with the view face.
  [[nodiscard]] Eigen::Vector3d point(int face, double along, double across) const {
    const FaceCurve::Node p = curve.at(along * curve.length_mm());
    const Eigen::Vector3d middle(p.x_mm, p.shift_mm, p.z_mm);
    if (face == 0) return middle + (across - 0.5) * width_mm * FaceCurve::across(p);
    return middle + side_of(face) * width_mm / 2 * FaceCurve::across(p) -
           across * side_depth_mm * FaceCurve::normal(p);
  }
  // Unit, into the finger's body.
  [[nodiscard]] Eigen::Vector3d normal(int face, double along) const {
    const FaceCurve::Node p = curve.at(along * curve.length_mm());
    if (face == 0) return -FaceCurve::normal(p);
    return -side_of(face) * FaceCurve::across(p);
  }
  [[nodiscard]] static double side_of(int face) { return face == 1 ? -1 : 1; }
};

struct LitPatch {
  int face;
  Quadrilateral corners;  // counter-clockwise as viewed from within the body
  Eigen::Vector3d middle, normal;
  double area_mm2, far2_mm2;  // beyond the root of this the patch counts as a point
};

struct LatticePoint {
  int face;
  Eigen::Vector3d at, normal;
};

LitPatch patch_of(const LitFaces& faces, int face, int i, int k) {
  const double n = kPatchesAcross[static_cast<std::size_t>(face)];
  const double a0 = double{1} * i / kPatchesAlong, a1 = double{1} * (i + 1) / kPatchesAlong;
  const double c0 = k / n, c1 = (k + 1) / n;
  LitPatch patch{face,
                 {faces.point(face, a0, c0), faces.point(face, a0, c1), faces.point(face, a1, c1),
                  faces.point(face, a1, c0)},
                 faces.point(face, (a0 + a1) / 2, (c0 + c1) / 2),
                 faces.normal(face, (a0 + a1) / 2),
                 0,
                 0};
  const Eigen::Vector3d turn =
      (patch.corners[2] - patch.corners[0]).cross(patch.corners[3] - patch.corners[1]);
  if (turn.dot(patch.normal) < 0) std::swap(patch.corners[1], patch.corners[3]);
  patch.area_mm2 = turn.norm() / 2;
  patch.far2_mm2 = kFar * kFar * (patch.corners[2] - patch.corners[0]).squaredNorm();
  return patch;
}

double factor_of(const LatticePoint& point, const LitPatch& patch) {
  const Eigen::Vector3d to_patch = patch.middle - point.at;
  const double r2 = to_patch.squaredNorm();
  if (r2 < patch.far2_mm2) return form_factor(point.at, point.normal, patch.corners);
  const double here = point.normal.dot(to_patch), there = -patch.normal.dot(to_patch);
  if (here <= 0 || there <= 0) return 0;
  return here * there * patch.area_mm2 / (std::numbers::pi * r2 * r2);
}

// Irradiance on one face's lattice.
struct LitLattice {
  int across;
  std::vector<float> value;  // row by row along

  // Fractions of the face; positions beyond it count as its edge.
  [[nodiscard]] float at(float along_part, float across_part) const {
    const float along = std::min(kStepsAlong * lattice_step(along_part), kStepsAlong - 1e-3F);
    const float steps = static_cast<float>(across);
    const float side = std::min(steps * lattice_step(across_part), steps - 1e-3F);
    const auto i = static_cast<int>(along), k = static_cast<int>(side);
    const float to_i = along - static_cast<float>(i), to_k = side - static_cast<float>(k);
    const float* here = value.data() + std::ptrdiff_t{i} * (across + 1) + k;
    const float* next = here + across + 1;
    const float low = here[0] + to_k * (here[1] - here[0]);
    const float high = next[0] + to_k * (next[1] - next[0]);
    return low + to_i * (high - low);
  }
};

using LitLattices = std::array<LitLattice, kLitFaces>;

class OnceReflected {
 public:
  OnceReflected(const FrameGeometry& geometry, std::array<double, kLitFaces> albedo, double depth)
      : albedo_(albedo),
        absorb_per_mm_(geometry.illumination.absorb_per_mm),
        face_is_plane_(geometry.curve()->is_straight() && !geometry.curve()->is_twisted()),
        length_mm_(static_cast<float>(geometry.curve()->length_mm())),
        width_mm_(static_cast<float>(geometry.face().width_mm)),
        depth_mm_(static_cast<float>(depth)) {
    const LitFaces faces{*geometry.curve(), geometry.face().width_mm, depth};
    const auto inward = [](double part) { return kInward + (1 - 2 * kInward) * part; };
    for (int face = 0; face < kLitFaces; ++face) {
      for (int i = 0; i < kPatchesAlong; ++i)
        for (int k = 0; k < kPatchesAcross[static_cast<std::size_t>(face)]; ++k)
          patches_.push_back(patch_of(faces, face, i, k));
      const int steps = kStepsAcross[static_cast<std::size_t>(face)];
      for (int i = 0; i <= kStepsAlong; ++i)
        for (int k = 0; k <= steps; ++k) {
          const double along = inward(lattice_part(double{1} * i / kStepsAlong));
          points_.push_back({face,
                             faces.point(face, along, inward(lattice_part(double{1} * k / steps))),
                             faces.normal(face, along)});
        }
    }
  }

  // Irradiance on the faces' lattices, of which `direct` lights the patches.
  [[nodiscard]] LitLattices lit_by(const DirectLight& direct) const {
    const std::vector<double> radiosity = radiosities(direct);
    LitLattices lattices;
    for (std::size_t face = 0; face < kLitFaces; ++face) lattices[face].across = kStepsAcross[face];
    for (const LatticePoint& point : points_)
      lattices[static_cast<std::size_t>(point.face)].value.push_back(
          static_cast<float>(irradiance(point, radiosity)));
    return lattices;
  }

  void on_view_face(const LitLattice& lattice, const FaceRow& face, const Surface& s,
                    float* irradiance) const {
    const float along = 1 / length_mm_, across = 1 / width_mm_;
    for (int u = s.first; u < s.last; ++u)
      irradiance[u] =
          lattice.at(face.s_mm[u] * along, (s.y_mm[u] - face.shift_mm[u] + width_mm_ / 2) * across);
  }

  // The position on the side follows from the view face's point in the same column, to first
  // order in the twist.
  void on_sides(const LitLattices& lattices, const FaceRow& face, const Surface& s,
                float* irradiance) const {
    const float along = 1 / length_mm_, across = 1 / depth_mm_;
    for (int u = s.first; u < s.last; ++u) {
      const float dx = face.x_mm[u] - s.x_mm[u], dz = face.z_mm[u] - s.z_mm[u];
      const float behind = dz * face.cos_incline[u] - dx * face.sin_incline[u];
      const float at = face.s_mm[u] - dz * face.sin_incline[u] - dx * face.cos_incline[u];
      const LitLattice& lattice = lattices[s.normal_y[u] > 0 ? 1 : 2];
      irradiance[u] = lattice.at(at * along, behind * across);
    }
  }

 private:
  // For every patch: rho_j E_j.
  [[nodiscard]] std::vector<double> radiosities(const DirectLight& direct) const {
    const std::size_t n = patches_.size();
    std::array<std::vector<float>, 6> columns;
    for (auto& column : columns) column.resize(n);
    std::vector<float> irradiance(n);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        columns[axis][j] = static_cast<float>(patches_[j].middle[i]);
        columns[axis + 3][j] = static_cast<float>(patches_[j].normal[i]);
      }
    Surface all;
    all.last = static_cast<int>(n);
    all.x_mm = columns[0].data(), all.y_mm = columns[1].data(), all.z_mm = columns[2].data();
    all.normal_x = columns[3].data(), all.normal_y = columns[4].data();
    all.normal_z = columns[5].data();
    direct(all, irradiance.data());
    std::vector<double> radiosity(n);
    for (std::size_t j = 0; j < n; ++j)
      radiosity[j] =
          albedo_[static_cast<std::size_t>(patches_[j].face)] * static_cast<double>(irradiance[j]);
    return radiosity;
  }

  [[nodiscard]] double irradiance(const LatticePoint& point,
                                  const std::vector<double>& radiosity) const {
    double sum = 0;
    for (std::size_t j = 0; j < patches_.size(); ++j) {
      const LitPatch& patch = patches_[j];
      const bool is_plane = point.face > 0 || face_is_plane_;
      if (is_plane && patch.face == point.face) continue;
      double light = radiosity[j] * factor_of(point, patch);
      if (absorb_per_mm_ > 0) light *= std::exp(-absorb_per_mm_ * (patch.middle - point.at).norm());
      sum += light;
    }
    return sum;
  }

  std::array<double, kLitFaces> albedo_;
  double absorb_per_mm_;
  bool face_is_plane_;
  float length_mm_, width_mm_, depth_mm_;
  std::vector<LitPatch> patches_;
  std::vector<LatticePoint> points_;
};

class Interreflection final : public GeometryEffect {
 public:
  explicit Interreflection(YamlSection& p)
      : face_(p.number("face", strength_up_to(1))),
        sides_(p.number("sides", strength_up_to(1))),
        depth_mm_(p.number("depth_mm", strength_up_to(1000))) {}

  Status validate(const SceneFacts& scene) const override {
    if (scene.has_effect("sides") && scene.has_effect("leds")) return {};
    return Error{en::say("only the lit view face and side faces light each other"), "",
                 en::say("name the effects sides and leds too")};
  }

  void apply(const FrameContext&, FrameGeometry& geometry) const override {
    const auto reflected = std::make_shared<const OnceReflected>(
        geometry, std::array{face_, sides_, sides_}, depth_mm_);
    geometry.illumination.indirect = [reflected](const DirectLight& direct) -> IndirectRows {
      return [reflected, lattices = reflected->lit_by(direct)](
                 const RowView& row, const Surface& surface, float* irradiance) {
        if (&surface == row.surfaces.data())
          reflected->on_view_face(lattices[0], row.face, surface, irradiance);
        else
          reflected->on_sides(lattices, row.face, surface, irradiance);
      };
    };
  }

 private:
  double face_, sides_, depth_mm_;
};

}  // namespace

EffectKind effect_interreflection() {
  return effect_kind<Interreflection>("interreflection", 76,
                                      en::say("The finger's faces light each other"),
                                      "face: 0.47, sides: 0.12, depth_mm: 14", {"sides", "leds"});
}

}  // namespace alltact
