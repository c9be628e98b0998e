#include "core/image/grey_decoder.h"

#include <cstring>
#include <string_view>

#include <turbojpeg.h>

namespace alltact {

std::string fourcc_text(std::uint32_t code) {
  std::string text;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto letter = static_cast<char>((code >> shift) & 0x7FU);
    text += letter >= ' ' && letter <= '~' ? letter : '?';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

bool can_decode(std::uint32_t code) {
  switch (static_cast<PixelFormat>(code)) {
    case PixelFormat::kGrey:
    case PixelFormat::kYuyv:
    case PixelFormat::kY16:
    case PixelFormat::kMjpeg:
      return true;
  }
  return false;
}

struct GreyDecoder::Jpeg {
  tjhandle handle = tjInitDecompress();
  Jpeg() = default;
  Jpeg(const Jpeg&) = delete;
  Jpeg& operator=(const Jpeg&) = delete;
  ~Jpeg() {
    if (handle != nullptr) tjDestroy(handle);
  }
};

GreyDecoder::GreyDecoder() : jpeg_(std::make_unique<Jpeg>()) {}
GreyDecoder::~GreyDecoder() = default;
GreyDecoder::GreyDecoder(GreyDecoder&&) noexcept = default;
GreyDecoder& GreyDecoder::operator=(GreyDecoder&&) noexcept = default;

namespace {

/// The second byte of each pixel (kOffset 1) or the first (0).
template <int kOffset>
void take_alternate_bytes(const std::uint8_t* from, std::uint8_t* to, int count) {
  for (int i = 0; i < count; ++i) to[i] = from[2 * i + kOffset];
}

Error damaged_packet(Message what) {
  return {
      std::move(what), "",
      en::say(
          "a shorter USB cable or another port; if it persists, another format or a lower rate")};
}

}  // namespace

Result<cv::Mat> GreyDecoder::operator()(PixelFormat format, int width_px, int height_px,
                                        std::size_t stride_bytes,
                                        std::span<const std::uint8_t> bytes) {
  if (format == PixelFormat::kMjpeg) return decode_jpeg(width_px, height_px, bytes);
  const auto row_bytes =
      static_cast<std::size_t>(width_px) * (format == PixelFormat::kGrey ? 1U : 2U);
  const std::size_t stride = std::max(stride_bytes, row_bytes);
  const std::size_t needed = stride * (static_cast<std::size_t>(height_px) - 1) + row_bytes;
  if (bytes.size() < needed)
    return damaged_packet(en::say("a frame arrived with {} of {} bytes", bytes.size(), needed));
  cv::Mat grey(height_px, width_px, CV_8UC1);
  for (int v = 0; v < height_px; ++v) {
    const std::uint8_t* from = bytes.data() + stride * static_cast<std::size_t>(v);
    std::uint8_t* to = grey.ptr(v);
    if (format == PixelFormat::kGrey) {
      std::memcpy(to, from, row_bytes);
    } else if (format == PixelFormat::kYuyv) {
      take_alternate_bytes<0>(from, to, width_px);
    } else {
      take_alternate_bytes<1>(from, to, width_px);
    }
  }
  return grey;
}

Result<cv::Mat> GreyDecoder::decode_jpeg(int width_px, int height_px,
                                         std::span<const std::uint8_t> bytes) {
  auto image = complete_jpeg(width_px, height_px, bytes);
  // A decoder that stopped halfway has a remaining state: the next image gets a new one.
  if (!image) jpeg_ = std::make_unique<Jpeg>();
  return image;
}

Result<cv::Mat> GreyDecoder::complete_jpeg(int width_px, int height_px,
                                           std::span<const std::uint8_t> bytes) {
  const auto size = static_cast<unsigned long>(bytes.size());  // NOLINT: TurboJPEG's type
  int width = 0, height = 0, sampling = 0, colours = 0;
  if (jpeg_->handle == nullptr || tjDecompressHeader3(jpeg_->handle, bytes.data(), size, &width,
                                                      &height, &sampling, &colours) != 0)
    return damaged_packet(en::say("a frame arrived that is no JPEG"));
  if (width != width_px || height != height_px)
    return damaged_packet(
        en::say("a {}x{} frame arrived instead of {}x{}", width, height, width_px, height_px));
  cv::Mat grey(height, width, CV_8UC1);
  const int status =
      tjDecompress2(jpeg_->handle, bytes.data(), size, grey.data, width,
                    static_cast<int>(grey.step), height, TJPF_GRAY, TJFLAG_STOPONWARNING);
  if (status != 0) {
    // The first complaint stops the decoder. This one comes after the last row: the image is
    // complete, with a few stray bytes between it and its end mark.
    const std::string_view complaint = tjGetErrorStr2(jpeg_->handle);
    const bool is_complete =
        complaint.find("extraneous bytes before marker 0xd9") != std::string_view::npos;
    if (!is_complete) return damaged_packet(en::say("a JPEG arrived truncated or damaged"));
    jpeg_ = std::make_unique<Jpeg>();
  }
  return grey;
}

}  // namespace alltact
