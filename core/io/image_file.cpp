#include "core/io/image_file.h"

#include "core/io/atomic_file.h"
#include "core/io/image_format.h"
#include "core/io/image_note.h"

#include <opencv2/imgcodecs.hpp>

namespace alltact {
namespace {

constexpr std::int64_t kMaxSidePx = 16384;
constexpr double kMaxColour = 0.12;  // mean distance of the channels from grey, relative to the
                                     // mean grey
constexpr double kBlack = 4;         // grey level

Error at(const std::filesystem::path& file, Error error) {
  error.where = file.string();
  return error;
}

struct Encoded {
  std::string content;
  ImageHeader header;
};

/// The file's bytes, after its header was checked for completeness and size.
Result<Encoded> read_encoded(const std::filesystem::path& file) {
  auto content = read_file(file);
  if (!content) return content.error();
  auto header = image_header(*content);
  if (!header) return at(file, header.error());
  const auto [width, height] = std::pair(header->width_px, header->height_px);
  if (width < 1 || height < 1 || width > kMaxSidePx || height > kMaxSidePx)
    return Error{en::say("the picture says it is {} x {} px; a side must have 1 to {}",
                         width,
                         height,
                         kMaxSidePx),
                 file.string(),
                 en::say("a smaller picture, or copy it again if that size is wrong")};
  return Encoded{std::move(*content), *header};
}

/// Empty where the decoder gives up.
cv::Mat decode(const Encoded& encoded) {
  try {
    // Unchanged: the camera's pixels, also where a tag requests a rotation.
    return cv::imdecode(cv::Mat(1,
                                static_cast<int>(encoded.content.size()),
                                CV_8UC1,
                                const_cast<char*>(encoded.content.data())),
                        cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
}

Error not_decodable(const std::filesystem::path& file) {
  return {en::say("the picture is damaged or cut short"),
          file.string(),
          en::say("copy or record it again")};
}

std::optional<Error> unfit_for_grey(const ImageHeader& header) {
  if (header.is_float || header.bits > 8)
    return Error{header.is_float
                     ? en::say("the picture has {} bits per channel (floating point); 8 are needed",
                               header.bits)
                     : en::say("the picture has {} bits per channel; 8 are needed", header.bits),
                 "",
                 en::say("the camera's 8-bit pictures")};
  if (header.has_transparency)
    return Error{en::say("the picture has transparent parts; a camera takes none"),
                 "",
                 en::say("the picture as the camera took it, without an alpha channel")};
  if (header.channels != 1 && header.channels != 3)
    return Error{en::say("the picture has {} channels; 1 or 3 are needed", header.channels),
                 "",
                 en::say("the picture as the camera took it")};
  return std::nullopt;
}

/// Mean absolute distance of the channels from grey, relative to the mean grey.
double colourfulness(const cv::Mat& bgr, const cv::Mat& grey) {
  cv::Mat three, distance;
  cv::cvtColor(grey, three, cv::COLOR_GRAY2BGR);
  cv::absdiff(bgr, three, distance);
  const cv::Scalar mean = cv::mean(distance);
  const double grey_level = cv::mean(grey)[0];
  return grey_level > 0 ? (mean[0] + mean[1] + mean[2]) / 3 / grey_level : 0;
}

Result<std::vector<unsigned char>> encode(const std::filesystem::path& file, const cv::Mat& image) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  const int type = image.type();
  const bool is_png = ending == ".png" && (type == CV_8UC1 || type == CV_8UC3);
  const bool is_tiff =
      (ending == ".tif" || ending == ".tiff") && (type == CV_32FC1 || type == CV_32FC3);
  if (image.empty() || !(is_png || is_tiff)) {
    const Message kind = image.empty() ? en::say("empty") : Message::typed(cv::typeToString(type));
    return Error{en::say("cannot write this kind of picture ({}) under that name", kind),
                 file.string(),
                 en::say("'.png' for 8-bit pictures, '.tiff' for floating point")};
  }
  const std::vector<int> options = is_png ? std::vector<int>{cv::IMWRITE_PNG_COMPRESSION, 3}
                                          : std::vector<int>{cv::IMWRITE_TIFF_COMPRESSION, 1};
  std::vector<unsigned char> bytes;
  try {
    if (cv::imencode(ending, image, bytes, options)) return bytes;
  } catch (const cv::Exception&) {
    // Like a returned false: neither gives a reason.
  }
  return Error{
      en::say("could not encode the picture"), file.string(), en::say("a smaller picture")};
}

}  // namespace

Result<cv::Mat> read_grey_image(const std::filesystem::path& file, std::string* note) {
  const auto encoded = read_encoded(file);
  if (!encoded) return encoded.error();
  if (auto problem = unfit_for_grey(encoded->header)) return at(file, *problem);
  cv::Mat image = decode(*encoded);
  if (image.empty()) return not_decodable(file);
  // The decoded type counts, not the header's.
  if (image.type() != CV_8UC1 && image.type() != CV_8UC3)
    return Error{en::say("the picture is of a kind that cannot be used ({})",
                         std::string(cv::typeToString(image.type()))),
                 file.string(),
                 en::say("8-bit grey pictures")};
  if (image.channels() == 3) {
    cv::Mat grey;
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
    if (const double colour = colourfulness(image, grey); colour > kMaxColour)
      return Error{en::say("the picture is in colour: its channels differ from grey by {:.0f} %",
                           100 * colour),
                   file.string(),
                   en::say("a picture of the finger under white light")};
    image = grey;
  }
  double brightest = 0;
  cv::minMaxLoc(image, nullptr, &brightest);
  if (brightest <= kBlack)
    return Error{en::say("the picture is all black"),
                 file.string(),
                 en::say("switch on the light, or take off the lens cap")};
  if (note != nullptr) *note = note_of(encoded->content);
  return image;
}

Status write_image(const std::filesystem::path& file, const cv::Mat& image, std::string_view note) {
  const auto bytes = encode(file, image);
  if (!bytes) return bytes.error();
  const std::string_view content(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  if (note.empty()) return write_file_atomically(file, content);
  assert(image.depth() == CV_8U);  // a PNG
  return write_file_atomically(file, with_note(content, note));
}

Result<cv::Mat> read_float_image(const std::filesystem::path& file) {
  const auto encoded = read_encoded(file);
  if (!encoded) return encoded.error();
  const ImageHeader& header = encoded->header;
  if (header.format != ImageFormat::kTiff || !header.is_float || header.bits != 32 ||
      (header.channels != 1 && header.channels != 3))
    return Error{en::say("the picture is no TIFF of 32-bit floating point with 1 or 3 channels"),
                 file.string(),
                 en::say("a depth or points picture written by this program")};
  cv::Mat image = decode(*encoded);
  if (image.empty()) return not_decodable(file);
  if (image.type() != CV_32FC1 && image.type() != CV_32FC3) return not_decodable(file);
  return image;
}

}  // namespace alltact
