// A body given by triangles: `file` (STL or OBJ, next to the scene, or one in resources/bodies),
// `scale` in mm per unit of the file. Unless rotated, its z axis points away from the finger and
// its x axis along it. Its centre lies over the press position.
#include "core/program.h"
#include "core/simulation/bodies/mesh_body.h"
#include "core/simulation/rigid_press.h"

#include <filesystem>

namespace alltact {

namespace {

constexpr double kMaxSize_mm = 1000, kMinSize_mm = 0.1;

std::filesystem::path find_mesh(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path local_file = folder / name;
  std::error_code failed;
  if (std::filesystem::exists(local_file, failed)) return local_file;
  const auto shipped = find_resource(std::filesystem::path("bodies") / name);
  return shipped ? *shipped : local_file;
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
    if (size > kMaxSize_mm || size < kMinSize_mm)
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
