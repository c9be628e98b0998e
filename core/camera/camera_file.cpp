#include "core/camera/camera_file.h"

#include "core/base/atomic_file.h"
#include "core/base/letters.h"
#include "core/numerics/checksum.h"

#include <algorithm>
#include <array>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// PhotonVision's files may hold images.
constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

/// A key with which another program describes a lens.
bool is_foreign_lens_key(const std::string& key) {
  const std::string word = plain_word(key);
  static constexpr std::array<std::string_view, 17> kWords{"k",  "d",  "k1", "k2", "k3", "k4",
                                                           "k5", "k6", "p1", "p2", "s1", "s2",
                                                           "s3", "s4", "xi", "kc", "mtx"};
  if (std::find(kWords.begin(), kWords.end(), word) != kWords.end()) return true;
  if (word.starts_with("dist") && word != "distortion" && !word.starts_with("distance"))
    return true;
  for (const char* part : {"coef", "matrix", "intrinsic", "lensmodel", "radial"})
    if (word.find(part) != std::string::npos) return true;
  return false;
}

/// Unknown keys of the camera's section, as one warning.
void warn_of_unknown(YamlFile& file, const std::string& section, CameraFile& camera) {
  std::vector<Message> names;
  for (const auto& [name, keys] : file.unknown()) {
    if (name != section && name != (section.empty() ? "port" : section + ".port")) continue;
    for (const auto& [key, value] : keys)
      names.push_back(Message::typed(printable(name == section ? key : "port." + key)));
  }
  if (names.empty()) return;
  const Message what = en::say("keys that are not known here were not read: {}", en::list(names));
  camera.warnings.push_back(en::say("{}.", en::at(Where(file.path()), what)));
}

Result<CameraFile> parse_own_camera(const std::string& content, const fs::path& origin) {
  YamlFile file(origin);
  CameraFile camera;
  bool is_wrapped = false;
  const Status read = file.read(content, [&](YamlSection& top) {
    is_wrapped = top.has("camera");
    Fields fields(is_wrapped ? top.section("camera") : top);
    describe(fields, camera);
  });
  if (!read) return read.error();
  if (const Status status = check_camera_range(camera.parameters); !status) {
    Error error = status.error();
    if (!is_wrapped) {
      const std::string key = error.where.english();
      error.where = key.substr(key.find('.') + 1);
    }
    return file.located(error);
  }
  warn_of_unknown(file, is_wrapped ? "camera" : "", camera);
  const CameraParameters& p = camera.parameters;
  const bool has_lens = p.model == CameraModel::kBrown || p.model == CameraModel::kFisheye;
  camera.understood =
      understood_camera(p, en::say("a camera file of this program"),
                        has_lens ? std::string(to_string(p.model)) : "", p.distortion.size());
  return camera;
}

}  // namespace

static void describe(Fields& fields, FlatPort& port) {
  fields.number("gap_mm", port.gap_mm, en::say("the lens-to-window air gap in mm"));
  fields.number("plate_mm", port.plate_mm, en::say("the window's thickness in mm"));
  fields.number("plate_index", port.plate_index, en::say("the window's index of refraction"));
  fields.number("medium_index", port.medium_index, en::say("the index of refraction behind it"));
}

void describe(Fields& fields, CameraFile& file) {
  if (fields.is_reading())
    for (const std::string& key : fields.section().keys())
      if (is_foreign_lens_key(key))
        fields.section().refuse(
            key, en::say("is a key of other programs, whose numbers would be lost here"),
            en::say("the other program's file unchanged, or 'distortion: [...]' instead of it"));
  CameraParameters& camera = file.parameters;
  fields.choice("model", camera.model, words_up_to(CameraModel::kOrthographic));
  std::vector<int> size{camera.width_px, camera.height_px};
  fields.integers("size", size, 999'999'999, 2, en::say("must be two integers"),
                  en::say("[width, height] in pixels"));
  camera.width_px = size[0], camera.height_px = size[1];
  if (camera.model == CameraModel::kOrthographic) {
    fields.number("mm_per_px", camera.mm_per_px, en::say("the size of a pixel in mm"));
  } else {
    fields.number("fx", camera.fx_px, en::say("the focal length in pixels"));
    fields.number("fy", camera.fy_px, en::say("the focal length in pixels"));
  }
  fields.number("cx", camera.cx_px, en::say("the principal point in pixels"));
  fields.number("cy", camera.cy_px, en::say("the principal point in pixels"));
  fields.numbers(may("sd_px", !camera.sd_px.empty()), camera.sd_px);
  fields.numbers(may("distortion"), camera.distortion);
  fields.choice(may("orientation"), camera.orientation, words_up_to(Orientation::kRotate270));
  fields.section(may("port"), camera.port);
  fields.texts_by_name("lens", file.lens);
}

Result<CameraFile> load_camera(const fs::path& file) {
  fs::path path = file;
  std::string name;
  const std::string text = file.string();
  std::error_code ignored;
  if (const std::size_t mark = text.rfind('#');
      mark != std::string::npos && !fs::exists(file, ignored)) {
    path = text.substr(0, mark);
    name = text.substr(mark + 1);
  }
  const auto content = read_file(path, kMaxBytes);
  if (!content) return content.error();
  return parse_camera(*content, path, name);
}

Result<CameraFile> parse_camera(const std::string& content, const fs::path& origin,
                                const std::string& name) {
  auto foreign = parse_foreign_camera(content, origin, name);
  if (!foreign) return foreign.error();
  if (*foreign) return std::move(**foreign);
  return parse_own_camera(content, origin);
}

Message understood_camera(const CameraParameters& camera, const Message& what,
                          const std::string& model, std::size_t count) {
  Message lens = en::say("no distortion");
  if (!model.empty() && count > 0)
    lens =
        en::count("{1} with {0} coefficients", "{1} with {0} coefficient", count, printable(model));
  if (camera.model == CameraModel::kOrthographic)
    return en::say("read as {}: {} x {} px, {:g} mm per px", what, camera.width_px,
                   camera.height_px, camera.mm_per_px);
  return en::say("read as {}: {} x {} px, fx {:.1f}, {}", what, camera.width_px, camera.height_px,
                 camera.fx_px, lens);
}

std::string camera_fingerprint(const CameraParameters& parameters) {
  const std::string text = fields_text(CameraFile{parameters, {}, {}, {}});
  Checksum checksum;
  checksum.add(text.data(), text.size());
  return checksum.text();
}

Status save_camera(const fs::path& path, const CameraParameters& parameters,
                   const LensRecord& record) {
  if (const Status status = check_camera_range(parameters); !status) return status.error();
  return write_file_atomically(path, fields_text(CameraFile{parameters, record, {}, {}}));
}

}  // namespace alltact
