#include "core/finger/camera_yaml.h"

#include "core/camera/camera_range.h"
#include "core/io/atomic_file.h"
#include "core/numerics/checksum.h"

namespace alltact {
namespace {

/// The enumerator of a word; the words are those of to_string().
template <class E, std::size_t N>
E read_word(YamlSection& section, const std::string& key, const std::array<E, N>& meanings) {
  std::vector<std::string_view> words;
  for (E meaning : meanings) words.push_back(to_string(meaning));
  return meanings[section.choice(key, words)];
}

constexpr std::array kModels{
    CameraModel::kPinhole, CameraModel::kBrown, CameraModel::kFisheye, CameraModel::kOrthographic};
constexpr std::array kOrientations{Orientation::kNone,
                                   Orientation::kFlipU,
                                   Orientation::kFlipV,
                                   Orientation::kRotate180,
                                   Orientation::kRotate90,
                                   Orientation::kRotate270};

void read_size(YamlSection& section, CameraParameters& parameters) {
  const std::vector<double> size = section.numbers("size");
  const auto is_integer = [](double x) { return std::abs(x) < 1e9 && x == std::floor(x); };
  if (size.size() != 2 || !is_integer(size[0]) || !is_integer(size[1]))
    section.refuse(
        "size", en::say("must be two whole numbers"), en::say("[width, height] in pixels"));
  parameters.width_px = static_cast<int>(size[0]);
  parameters.height_px = static_cast<int>(size[1]);
}

FlatPort read_port(YamlSection& camera) {
  YamlSection section = camera.section("port");
  FlatPort port;
  port.gap_mm = section.number("gap_mm", en::say("the air between lens and window in mm"));
  port.plate_mm = section.number("plate_mm", en::say("the window's thickness in mm"));
  port.plate_index = section.number("plate_index", en::say("the window's index of refraction"));
  port.medium_index = section.number("medium_index", en::say("the index of what lies behind it"));
  return port;
}

std::string in_braces(const FlatPort& port, const UnknownKeys& unknown) {
  YamlBlock block("camera.port");
  block.add("gap_mm", yaml_number(port.gap_mm));
  block.add("plate_mm", yaml_number(port.plate_mm));
  block.add("plate_index", yaml_number(port.plate_index));
  block.add("medium_index", yaml_number(port.medium_index));
  block.add_unknown(unknown);
  return block.in_braces();
}

}  // namespace

CameraParameters read_camera(YamlSection& section, LensRecord& record) {
  CameraParameters parameters;
  parameters.model = read_word(section, "model", kModels);
  read_size(section, parameters);
  if (parameters.model == CameraModel::kOrthographic) {
    parameters.mm_per_px = section.number("mm_per_px", en::say("the size of a pixel in mm"));
  } else {
    parameters.fx_px = section.number("fx", en::say("the focal length in pixels"));
    parameters.fy_px = section.number("fy", en::say("the focal length in pixels"));
  }
  parameters.cx_px = section.number("cx", en::say("the principal point in pixels"));
  parameters.cy_px = section.number("cy", en::say("the principal point in pixels"));
  if (section.has("distortion")) parameters.distortion = section.numbers("distortion");
  if (section.has("orientation"))
    parameters.orientation = read_word(section, "orientation", kOrientations);
  if (section.has("port")) parameters.port = read_port(section);
  if (section.has("lens")) record = section.section("lens").all_texts();
  return parameters;
}

void add_camera(const CameraParameters& parameters,
                const LensRecord& record,
                const UnknownKeys& unknown,
                YamlBlock& block) {
  block.add("model", std::string(to_string(parameters.model)));
  block.add("size", fmt::format("[{}, {}]", parameters.width_px, parameters.height_px));
  if (parameters.model == CameraModel::kOrthographic) {
    block.add("mm_per_px", yaml_number(parameters.mm_per_px));
  } else {
    block.add("fx", yaml_number(parameters.fx_px));
    block.add("fy", yaml_number(parameters.fy_px));
  }
  block.add("cx", yaml_number(parameters.cx_px));
  block.add("cy", yaml_number(parameters.cy_px));
  block.add("distortion", yaml_numbers(parameters.distortion));
  block.add("orientation", std::string(to_string(parameters.orientation)));
  if (parameters.port) block.add("port", in_braces(*parameters.port, unknown));
  YamlBlock lens("camera.lens");
  for (const auto& [key, value] : record) lens.add(key, yaml_text_or_number(value));
  lens.add_unknown(unknown);
  if (!lens.is_empty()) block.add("lens", lens.in_braces());
}

Result<CameraParameters> load_camera(const std::filesystem::path& path, LensRecord* record) {
  YamlFile file(path);
  CameraParameters parameters;
  LensRecord lens;
  bool is_wrapped = false;
  const Status read = file.load([&](YamlSection& top) {
    is_wrapped = top.has("camera");
    YamlSection section = is_wrapped ? top.section("camera") : top;
    parameters = read_camera(section, lens);
  });
  if (!read) return read.error();
  if (record != nullptr) *record = std::move(lens);
  const Status status = check_camera_range(parameters);
  if (status) return parameters;
  Error error = status.error();
  if (!is_wrapped) {
    const std::string key = error.where.english();
    error.where = key.substr(key.find('.') + 1);
  }
  return file.located(error);
}

std::string camera_fingerprint(const CameraParameters& parameters) {
  YamlBlock block("");
  add_camera(parameters, {}, {}, block);
  const std::string text = block.on_many_lines();
  Checksum checksum;
  checksum.add(text.data(), text.size());
  return checksum.text();
}

Status save_camera(const std::filesystem::path& path,
                   const CameraParameters& parameters,
                   const LensRecord& record) {
  if (const Status status = check_camera_range(parameters); !status) return status.error();
  YamlBlock block("");
  add_camera(parameters, record, {}, block);
  return write_file_atomically(path, block.on_many_lines());
}

}  // namespace alltact
