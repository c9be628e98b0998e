// Any body, as triangles: `file` (STL or OBJ, beside the scene, or one of those in
// resources/bodies), `scale` mm of a unit of the file.
// Its z axis points away from the finger, its x axis along it, until it is turned; its middle lies
// over the place.
#include "core/program.h"
#include "core/simulation/bodies/mesh_body.h"
#include "core/simulation/rigid_press.h"

#include <filesystem>

namespace alltact {

namespace {

constexpr double kLargest_mm = 1000, kSmallest_mm = 0.1;

std::filesystem::path find_mesh(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path beside = folder / name;
  std::error_code failed;
  if (std::filesystem::exists(beside, failed)) return beside;
  const auto shipped = find_resource(std::filesystem::path("bodies") / name);
  return shipped ? *shipped : beside;
}

class Mesh final : public RigidPress {
 public:
  explicit Mesh(YamlSection& p) : RigidPress(p) {
    const double scale = p.number_or("scale", 1, strength_up_to(1e6));
    auto mesh = read_mesh(find_mesh(p.file().path().parent_path(), p.text("file")));
    if (!mesh) p.refuse("file", mesh.error().what, mesh.error().advice);
    if (const Status closed = check_closed(*mesh); !closed)
      p.refuse("file", closed.error().what, closed.error().advice);
    auto body = std::make_shared<MeshBody>(std::move(*mesh), scale);
    const double size = 2 * body->half_size_mm().maxCoeff();
    if (size > kLargest_mm || size < kSmallest_mm)
      p.refuse(p.has("scale") ? "scale" : "file",
               en::say("the body would be {:g} mm large", size),
               en::say("'scale' says how many mm a unit of the file is"));
    set_body(std::move(body));
  }
  Message sentence() const override { return en::say("A body is pressed into the face"); }
};

}  // namespace

const EffectKind& effect_mesh() {
  static const EffectKind kKind{
      "mesh",
      Stage::kGeometry,
      35,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Mesh>(p); },
      "file: nut_m6.stl, s_mm: 50, y_mm: 0, depth_mm: 0.8"};
  return kKind;
}

}  // namespace alltact
