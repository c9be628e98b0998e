#include "core/finger/camera_yaml.h"

#include "core/camera/camera_range.h"
#include "core/io/atomic_file.h"

#include <yaml-cpp/exceptions.h>

namespace alltact {
namespace {

/// The word's meaning; the words are those of to_string().
template <class E, std::size_t N>
E read_word(YamlSection& section, const std::string& key, const std::array<E, N>& meanings) {
  std::vector<std::string_view> words;
  for (E meaning : meanings) words.push_back(to_string(meaning));
  return meanings[section.word(key, words)];
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
  const auto is_whole = [](double x) { return std::abs(x) < 1e9 && x == std::floor(x); };
  if (size.size() != 2 || !is_whole(size[0]) || !is_whole(size[1]))
    section.refuse("size", "must be two whole numbers", "[width, height] in pixels");
  parameters.width_px = static_cast<int>(size[0]);
  parameters.height_px = static_cast<int>(size[1]);
}

FlatPort read_port(YamlSection& camera) {
  YamlSection section = camera.section("port");
  FlatPort port;
  port.gap_mm = section.number("gap_mm", "the air between lens and window in mm");
  port.plate_mm = section.number("plate_mm", "the window's thickness in mm");
  port.plate_index = section.number("plate_index", "the window's index of refraction");
  port.medium_index = section.number("medium_index", "the index of what lies behind it");
  return port;
}

std::string in_braces(const FlatPort& port) {
  YamlBlock block("camera.port");
  block.add("gap_mm", yaml_number(port.gap_mm));
  block.add("plate_mm", yaml_number(port.plate_mm));
  block.add("plate_index", yaml_number(port.plate_index));
  block.add("medium_index", yaml_number(port.medium_index));
  return block.in_braces();
}

}  // namespace

CameraParameters read_camera(YamlSection& section, LensRecord& record) {
  CameraParameters parameters;
  parameters.model = read_word(section, "model", kModels);
  read_size(section, parameters);
  if (parameters.model == CameraModel::kOrthographic) {
    parameters.mm_per_px = section.number("mm_per_px", "the size of a pixel in mm");
  } else {
    parameters.fx_px = section.number("fx", "the focal length in pixels");
    parameters.fy_px = section.number("fy", "the focal length in pixels");
  }
  parameters.cx_px = section.number("cx", "the principal point in pixels");
  parameters.cy_px = section.number("cy", "the principal point in pixels");
  if (section.has("distortion")) parameters.distortion = section.numbers("distortion");
  if (section.has("orientation"))
    parameters.orientation = read_word(section, "orientation", kOrientations);
  if (section.has("port")) parameters.port = read_port(section);
  if (section.has("lens")) {
    YamlSection lens = section.section("lens");
    record = lens.all_texts();
    lens.keep_the_rest();
  }
  section.keep_the_rest();
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
  if (parameters.port) block.add("port", in_braces(*parameters.port));
  YamlBlock lens("camera.lens");
  for (const auto& [key, value] : record) lens.add(key, yaml_text_or_number(value));
  lens.add_unknown(unknown);
  if (!lens.is_empty()) block.add("lens", lens.in_braces());
}

Error located(const YamlFile& file, const Error& error) {
  // A key that is absent where another one asks for it: the nearest block above it.
  std::string key = error.where;
  while (!key.empty() && !file.lines.contains(key)) {
    const std::size_t dot = key.rfind('.');
    key.resize(dot == std::string::npos ? 0 : dot);
  }
  return file.error(error.what, key.empty() ? 1 : file.lines.at(key), error.where, error.advice);
}

Result<CameraParameters> load_camera(const std::filesystem::path& path, LensRecord* record) {
  const auto content = read_file(path, kMaxYamlBytes);
  if (!content) return content.error();
  YamlFile file{path, {}, {}, {}};
  try {
    YamlSection top = YamlSection::top(file, *content);
    const bool is_wrapped = top.has("camera");
    CameraParameters parameters;
    LensRecord lens;
    if (is_wrapped) {
      YamlSection section = top.section("camera");
      parameters = read_camera(section, lens);
    } else {
      parameters = read_camera(top, lens);
    }
    if (record != nullptr) *record = std::move(lens);
    const Status status = check_camera_range(parameters);
    if (status) return parameters;
    Error error = status.error();
    if (!is_wrapped) error.where = error.where.substr(error.where.find('.') + 1);
    return located(file, error);
  } catch (const Refused& refused) {
    return refused.error;
  } catch (const YAML::Exception& problem) {
    return Error{"this is not YAML: " + problem.msg, path.string(), "look at its brackets"};
  }
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
