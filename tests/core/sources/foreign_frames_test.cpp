// Videos and images as other programs make them: read right, with a sentence for what was assumed.
#include "core/image/image_file.h"
#include "core/open/open_source.h"
#include "core/recording/video_file.h"
#include "core/sources/file_source.h"
#include "tests/core/recording/recording_frames.h"
#include "tests/support/locales.h"
#include "tests/support/temporary_folder.h"

#include <clocale>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kFrames = 24;

/// A video of ffmpeg's, 64 x 48. `source`: ffmpeg's filters behind a black picture; `options`: of
/// the encoder. False: this ffmpeg cannot.
bool make_video(const fs::path& file, const std::string& source, const std::string& options) {
  output_of(
      fmt::format("ffmpeg -v quiet -nostdin -y -f lavfi -i \"color=c=black:s=64x48:r=25,{}\" "
                  "-frames:v {} {} '{}' </dev/null",
                  source, kFrames, options, file.string()));
  std::error_code ignored;
  return fs::file_size(file, ignored) > 0 && !ignored;
}

std::string texts_of(const std::vector<Message>& remarks) {
  std::string text;
  for (const Message& remark : remarks) text += remark.english() + "\n";
  return text;
}

/// Frame n is a flat grey of 30 + 7 n.
constexpr const char* kGreySteps = "format=gray,geq=lum='30+7*N'";
/// The same as luma as it is, with a border of level 8.
constexpr const char* kFullSteps =
    "format=yuv420p,geq=lum='if(lt(X\\,8)\\,8\\,30+7*N)':cb=128:cr=128";

/// A video of GStreamer's, 64 x 48, of grey 30 + 7 n as red, green and blue. `pipeline`: from the
/// conversion to the container. False: this GStreamer cannot.
bool make_by_gstreamer(const fs::path& file, const std::string& pipeline) {
  const TemporaryFolder folder;
  std::ofstream raw(folder / "raw", std::ios::binary);
  for (int i = 0; i < kFrames; ++i)
    raw << std::string(std::size_t{64} * 48 * 3, static_cast<char>(30 + 7 * i));
  raw.close();
  output_of(
      fmt::format("gst-launch-1.0 -q filesrc location='{}' ! rawvideoparse format=rgb "
                  "width=64 height=48 framerate=25/1 ! videoconvert ! {} ! filesink "
                  "location='{}' >/dev/null 2>&1",
                  (folder / "raw").string(), pipeline, file.string()));
  std::error_code ignored;
  return fs::file_size(file, ignored) > 0 && !ignored;
}

template <class Check>
void in_every_locale(const Check& check) {
  for (const std::string& locale : locales()) {
    SCOPED_TRACE(locale);
    std::setlocale(LC_ALL, locale.c_str());
    check();
    std::setlocale(LC_ALL, "C");
  }
}

TEST(ForeignVideo, LocalesAreMade) {
  if (locales().size() < 4) GTEST_SKIP() << "localedef makes no locales";
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(std::stod("0,5"), 0.5);
  std::setlocale(LC_ALL, "C");
}

constexpr const char* kByGStreamer = nullptr;

struct Foreign {
  const char* name;     // of the file
  const char* source;   // filters, or kByGStreamer
  const char* options;  // of the encoder, or GStreamer's pipeline
  double tolerance;     // grey levels
  const char* remark;   // part of what is said; "": nothing is
};

template <class Made>
std::string name_of(const testing::TestParamInfo<Made>& info) {
  std::string name = info.param.name;
  std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  return name;
}

class ForeignVideo : public testing::TestWithParam<Foreign> {};

void expect_in_order(const fs::path& file, const Foreign& made) {
  auto source = open_source({file});
  ASSERT_TRUE(source.ok()) << source.error().sentence();
  ASSERT_EQ((*source)->count(), static_cast<std::size_t>(kFrames));
  std::optional<std::int64_t> first_ns;
  for (int i = 0; i < kFrames; ++i) {
    const auto frame = (*source)->next();
    ASSERT_TRUE(frame.ok()) << frame.error().sentence();
    EXPECT_NEAR((*frame)->grey.at<std::uint8_t>(24, 40), 30 + 7 * i, made.tolerance) << i;
    ASSERT_TRUE((*frame)->time_ns.has_value());  // 0 is a time
    if (!first_ns) first_ns = (*frame)->time_ns;
    EXPECT_NEAR(1e-6 * static_cast<double>(*(*frame)->time_ns - *first_ns), 40.0 * i, 1.1) << i;
  }
  const std::string said = texts_of((*source)->remarks());
  if (std::string(made.remark).empty()) {
    EXPECT_EQ(said, "");
  } else {
    EXPECT_THAT(said, HasSubstr(made.remark));
  }
}

void expect_backwards(const fs::path& file, const Foreign& made) {
  auto video = VideoFile::open(file);
  ASSERT_TRUE(video.ok()) << video.error().sentence();
  for (const int number : {23, 11, 12, 5, 4, 0, 17})
    EXPECT_NEAR((*video->frame(static_cast<std::size_t>(number)))->grey.at<std::uint8_t>(24, 40),
                30 + 7 * number, made.tolerance)
        << number;
}

TEST_P(ForeignVideo, IsReadInOrderWithItsLevelsAndTimes) {
  const Foreign& made = GetParam();
  const TemporaryFolder folder;
  const fs::path file = folder / made.name;
  if (!(made.source != kByGStreamer ? make_video(file, made.source, made.options)
                                    : make_by_gstreamer(file, made.options)))
    GTEST_SKIP() << "the program is not here or lacks a codec: " << made.options;
  in_every_locale([&] {
    expect_in_order(file, made);
    expect_backwards(file, made);
  });
}

constexpr const char* kNoRange = "does not state the range";

INSTANTIATE_TEST_SUITE_P(
    Made, ForeignVideo,
    testing::Values(
        // Order without presentation times.
        Foreign{"h264.avi", kGreySteps, "-c:v libx264 -qp 0 -bf 2 -g 12 -pix_fmt yuvj420p", 1.2,
                ""},
        Foreign{"pyramid.avi", kGreySteps,
                "-c:v libx264 -qp 0 -bf 4 -b-pyramid normal -g 100 -pix_fmt yuvj420p", 1.2, ""},
        Foreign{"mpeg4.avi", kGreySteps, "-c:v mpeg4 -q:v 1 -bf 2 -g 12", 2.0, kNoRange},
        Foreign{"mpeg2.mpg", kGreySteps, "-c:v mpeg2video -q:v 1 -bf 2 -g 12", 2.5, ""},
        Foreign{"open.ts", kGreySteps,
                "-c:v libx264 -qp 0 -bf 2 -g 8 -x264-params open-gop=1 -pix_fmt yuvj420p", 1.2, ""},
        // Names and containers.
        Foreign{"clip.mov", kGreySteps, "-c:v libx264 -qp 0 -bf 2 -pix_fmt yuvj420p", 1.2, ""},
        Foreign{"clip.M4V", kGreySteps, "-c:v libx264 -qp 0 -pix_fmt yuvj420p -f ipod", 1.2, ""},
        Foreign{"CLIP.AVI", kGreySteps, "-c:v ffv1 -pix_fmt gray", 0, ""},
        Foreign{"clip", kGreySteps, "-c:v ffv1 -pix_fmt gray -f matroska", 0, ""},
        Foreign{"a:b.mkv", kGreySteps, "-c:v ffv1 -pix_fmt gray", 0, ""},
        Foreign{"clip.webm", kGreySteps, "-c:v libvpx-vp9 -lossless 1 -pix_fmt yuv420p", 1.2, ""},
        Foreign{"clip.y4m", kGreySteps, "-pix_fmt gray -strict -1", 0, ""},
        Foreign{"clip.flv", kGreySteps, "-c:v libx264 -qp 0 -bf 2 -pix_fmt yuvj420p", 1.2, ""},
        Foreign{"disc.vob", kGreySteps, "-c:v mpeg2video -q:v 1 -bf 2 -g 12", 2.5, ""},
        Foreign{"screen.wmv", kGreySteps, "-c:v wmv2 -q:v 1", 2.5, kNoRange},
        Foreign{"part.nut", kGreySteps, "-c:v libx264 -qp 0 -bf 2 -g 12 -pix_fmt yuvj420p", 1.2,
                ""},
        Foreign{"free.ogv", kGreySteps, "-c:v libtheora -q:v 10", 2.5, kNoRange},
        Foreign{"stream.h264", kGreySteps, "-c:v libx264 -qp 0 -bf 2 -g 12 -pix_fmt yuvj420p", 1.2,
                "no times of its frames: 25 frames per second"},
        Foreign{"stream.m4v", kGreySteps, "-c:v mpeg4 -q:v 1 -bf 2 -g 12 -f m4v", 2.5, kNoRange},
        // Range and depth of grey.
        Foreign{"full.mp4", kFullSteps, "-c:v libx264 -qp 0 -bf 2", 0, "0 to 255 was assumed"},
        Foreign{"full8.webm", kFullSteps, "-c:v libvpx -b:v 8M -qmax 4", 2,
                "does not state the range of its brightness: it has levels below 9"},
        Foreign{"wrong.mp4", kFullSteps,
                "-c:v libx264 -qp 0 -bsf:v h264_metadata=video_full_range_flag=0", 0,
                "it states that its brightness is stored as 16 to 235, but 12 %"},
        Foreign{"narrow.mp4", kGreySteps, "-c:v libx264 -qp 0 -pix_fmt yuv420p", 1.2,
                "16 to 235 was assumed"},
        Foreign{"of16.mkv", "format=gray16le,geq=lum='(30+7*N)*16'", "-c:v ffv1 -pix_fmt gray16le",
                0, "of its 16 bits per pixel only the lower 12 are in use"},
        Foreign{"all16.mkv", "format=gray16le,geq=lum='(30+7*N)*256+255'",
                "-c:v ffv1 -pix_fmt gray16le", 0, ""},
        Foreign{"of10.mkv", "format=gray10le,geq=lum='(30+7*N)*4+3'", "-c:v ffv1 -pix_fmt gray10le",
                0, ""}),
    name_of<Foreign>);

INSTANTIATE_TEST_SUITE_P(
    ByGStreamer, ForeignVideo,
    testing::Values(
        Foreign{"vp8.webm", kByGStreamer, "vp8enc deadline=1 max-quantizer=4 ! webmmux", 2.5, ""},
        Foreign{"vp9.mkv", kByGStreamer, "vp9enc deadline=1 max-quantizer=4 ! matroskamux", 2.5,
                ""},
        Foreign{"planes.y4m", kByGStreamer, "video/x-raw,format=I420 ! y4menc", 1.2, kNoRange},
        Foreign{"yuy2.avi", kByGStreamer, "video/x-raw,format=YUY2 ! avimux", 1.2, kNoRange},
        Foreign{"uyvy.mov", kByGStreamer, "video/x-raw,format=UYVY ! qtmux", 1.2, kNoRange},
        Foreign{"bgr.avi", kByGStreamer, "video/x-raw,format=BGR ! avimux", 1.2, ""},
        Foreign{"grey.mkv", kByGStreamer, "video/x-raw,format=GRAY8 ! matroskamux", 1.2, ""},
        Foreign{"ffv1.mkv", kByGStreamer, "avenc_ffv1 ! matroskamux", 1.2, ""},
        Foreign{"jpeg.avi", kByGStreamer, "jpegenc quality=95 ! avimux", 1.2, ""},
        Foreign{"jpeg.mov", kByGStreamer, "jpegenc quality=95 ! qtmux", 1.2, ""},
        Foreign{"png.mov", kByGStreamer, "pngenc ! qtmux", 1.2, ""},
        Foreign{"prores.mov", kByGStreamer, "avenc_prores_ks ! qtmux", 1.2, ""},
        Foreign{"theora.ogv", kByGStreamer, "theoraenc quality=63 ! oggmux", 2.5, kNoRange},
        Foreign{"flash.flv", kByGStreamer, "avenc_flv bitrate=4000000 ! flvmux", 2.5, kNoRange},
        Foreign{"frames.avi", kByGStreamer, "avenc_mpeg4 bitrate=4000000 max-bframes=2 ! avimux",
                2.5, kNoRange},
        Foreign{"stream.mjpg", kByGStreamer, "jpegenc quality=95", 1.2,
                "no times of its frames: 25 frames per second"}),
    name_of<Foreign>);

TEST(ForeignVideo, TimesThatAreAllTheSameAreNone) {
  const TemporaryFolder folder;
  // From raw frames GStreamer's encoder leaves all at time 0.
  if (!make_by_gstreamer(folder / "v.mp4", "avenc_mpeg4 bitrate=4000000 max-bframes=2 ! mp4mux"))
    GTEST_SKIP() << "GStreamer is not here";
  auto video = VideoFile::open(folder / "v.mp4");
  ASSERT_TRUE(video.ok()) << video.error().sentence();
  EXPECT_THAT(texts_of(video->remarks()), HasSubstr("30 frames per second were assumed"));
  for (std::size_t i = 0; i < kFrames; ++i) {
    EXPECT_NEAR(static_cast<double>(video->time_ns(i)) * 1e-9, static_cast<double>(i) / 30, 1e-9);
    EXPECT_NEAR((*video->frame(i))->grey.at<std::uint8_t>(24, 40), 30 + 7 * static_cast<int>(i),
                2.5);
  }
}

/// What is said about a video.
std::string remarks_on(const std::string& source, const std::string& options) {
  const TemporaryFolder folder;
  if (!make_video(folder / "v.mov", source, options)) return "none was made";
  const auto video = VideoFile::open(folder / "v.mov");
  return video ? texts_of(video->remarks()) : video.error().sentence();
}

TEST(ForeignVideo, WhatMakesItHardToMeasureIsSaid) {
  const std::string lossless = "-c:v libx264 -qp 0 -pix_fmt yuvj420p";
  if (remarks_on(kGreySteps, lossless) == "none was made") GTEST_SKIP() << "ffmpeg is not here";
  EXPECT_THAT(remarks_on("format=gray,geq=lum=25", lossless), HasSubstr("nearly black"));
  EXPECT_THAT(remarks_on("format=gray,geq=lum='if(lt(X\\,32)\\,255\\,90)'", lossless),
              HasSubstr("50 % of it is saturated"));
  EXPECT_THAT(
      remarks_on("format=yuv444p,geq=lum=100:cb=60:cr=180", "-c:v libx264 -qp 0 -pix_fmt yuv444p"),
      HasSubstr("it is in colour"));
  const TemporaryFolder folder;
  ASSERT_TRUE(make_video(folder / "v.mov", kGreySteps, lossless));
  output_of(
      fmt::format("cd '{}' && ffmpeg -v quiet -nostdin -i v.mov -c copy -metadata:s:v rotate=90 "
                  "turned.mov </dev/null",
                  folder.path().string()));
  EXPECT_THAT(texts_of(VideoFile::open(folder / "turned.mov")->remarks()),
              HasSubstr("turn it by 90"));
  EXPECT_EQ(remarks_on(kGreySteps, lossless), "");
}

TEST(ForeignVideo, TextsAndListsOfFilesAreNoVideos) {
  const TemporaryFolder folder;
  std::ofstream(folder / "notes.txt") << "# Notes\n" << std::string(500, 'x') << "\n";
  std::ofstream(folder / "list.m3u8") << "#EXTM3U\n#EXTINF:10,\nhttp://127.0.0.1/v.ts\n";
  for (const char* name : {"notes.txt", "list.m3u8"}) {
    const auto source = open_source({folder / name});
    ASSERT_FALSE(source.ok()) << name;
    EXPECT_THAT(source.error().sentence(), HasSubstr("neither an image"));
  }
}

TEST(ForeignVideo, NamesAreReadAlikeInEveryLocale) {
  const TemporaryFolder folder;
  if (!make_video(folder / "V.AVI", kGreySteps, "-c:v ffv1 -pix_fmt gray"))
    GTEST_SKIP() << "ffmpeg is not here";
  cv::imwrite(folder / "i.png", cv::Mat(8, 8, CV_8UC1, cv::Scalar(90)));
  fs::rename(folder / "i.png", folder / "I.TIF.PNG");
  in_every_locale([&] {
    EXPECT_TRUE(open_source({folder / "V.AVI"}).ok());
    EXPECT_TRUE(open_source({folder / "I.TIF.PNG"}).ok());
  });
}

std::vector<std::string> names_of(Source& source) {
  std::vector<std::string> names;
  for (auto frame = source.next(); frame && *frame; frame = source.next())
    names.push_back((*frame)->name);
  return names;
}

TEST(ForeignImages, NumbersInNamesCountByTheirValues) {
  const TemporaryFolder folder;
  const cv::Mat image(8, 8, CV_8UC1, cv::Scalar(90));
  std::vector<fs::path> by_letters;
  for (const char* name : {"f_1", "f_10", "f_100", "f_11", "f_2", "f_9"}) {
    by_letters.push_back(folder / fmt::format("{}.png", name));
    cv::imwrite(by_letters.back().string(), image);
  }
  const auto by_value = ElementsAre("f_1", "f_2", "f_9", "f_10", "f_11", "f_100");
  EXPECT_THAT(names_of(**open_source({folder.path()})), by_value);
  EXPECT_THAT(names_of(**open_source(by_letters)), by_value);
  // An order that is no shell's is meant.
  std::swap(by_letters[0], by_letters[4]);
  EXPECT_THAT(names_of(**open_source(by_letters)),
              ElementsAre("f_2", "f_10", "f_100", "f_11", "f_1", "f_9"));
  EXPECT_TRUE(is_before("a/press_9.png", "a/press_010.png"));
  EXPECT_TRUE(is_before("99999999999999999999998.png", "99999999999999999999999.png"));
  EXPECT_FALSE(is_before("x_1.png", "x_1.png"));
}

TEST(ForeignImages, SixteenBitsCountByTheBrightestImage) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, int value) {
    cv::Mat image(48, 64, CV_16UC1, cv::Scalar(value));
    image.at<std::uint16_t>(0, 0) = 200;
    cv::imwrite(folder / name, image);
  };
  write("dark.png", 900);  // alone it would look like 10 bits
  write("light.png", 3600);
  auto source = open_source({folder.path()});
  for (const int level : {900 >> 4, 3600 >> 4}) {
    const auto frame = (*source)->next();
    ASSERT_TRUE(frame.ok()) << frame.error().sentence();
    EXPECT_EQ((*frame)->grey.at<std::uint8_t>(20, 20), level);
  }
  EXPECT_THAT(texts_of((*source)->remarks()), HasSubstr("only the lower 12 are in use"));
}

std::string read_refusal(const fs::path& file) {
  const auto read = read_grey_image(file);
  return read ? "" : read.error().sentence();
}

/// Images of a gradient of grey by another program, and as raw bytes what they show.
struct ForeignImage {
  const char* name;     // of the file
  const char* options;  // of ImageMagick's, or a function of the script
  int tolerance;        // grey levels
  const char* refusal;  // part of it; "": the image is read
};

void expect_gradient(const fs::path& file, const std::string& truth, const ForeignImage& made) {
  const auto read = read_grey_image(file);
  if (!std::string(made.refusal).empty()) {
    ASSERT_FALSE(read.ok());
    EXPECT_THAT(read.error().sentence(), HasSubstr(made.refusal));
    return;
  }
  ASSERT_TRUE(read.ok()) << read.error().sentence();
  ASSERT_EQ(truth.size(), read->total());
  for (int v = 0; v < 48; ++v) {
    const auto level = static_cast<std::uint8_t>(truth[static_cast<std::size_t>(v) * 64 + 30]);
    EXPECT_NEAR(read->at<std::uint8_t>(v, 30), level, made.tolerance) << v;
  }
}

class ByImageMagick : public testing::TestWithParam<ForeignImage> {};

TEST_P(ByImageMagick, IsReadWithItsLevelsOrRefused) {
  const ForeignImage& made = GetParam();
  const TemporaryFolder folder;
  const auto convert = [&](const std::string& options, const std::string& name) {
    output_of(
        fmt::format("cd '{}' && convert -size 64x48 'gradient:gray(12%)-gray(78%)' -colorspace "
                    "gray {} {} 2>/dev/null",
                    folder.path().string(), options, name));
    return fs::exists(folder / name);
  };
  if (!convert("-depth 8", "truth.gray") || !convert(made.options, made.name))
    GTEST_SKIP() << "ImageMagick is not here or lacks the format";
  std::ifstream stream(folder / "truth.gray", std::ios::binary);
  const std::string truth{std::istreambuf_iterator<char>(stream), {}};
  in_every_locale([&] { expect_gradient(folder / made.name, truth, made); });
}

/// Python's own libraries: level 40 + 3 v in row v.
constexpr const char* kScript = R"(
import struct, sys, zlib
rows = [bytes([40 + 3 * v] * 64) for v in range(48)]
deep = [b''.join(struct.pack('>H', (40 + 3 * v) * 257) for u in range(64)) for v in range(48)]

def chunk(name, data):
    body = name + data
    return struct.pack('>I', len(data)) + body + struct.pack('>I', zlib.crc32(body))

def png(lines, bits, part=1 << 20):
    # the filters none, sub, up, average and Paeth in turn
    step, before, raw = bits // 8, bytes(len(lines[0])), b''
    for v, line in enumerate(lines):
        def guess(i):
            left = line[i - step] if i >= step else 0
            up, corner = before[i], before[i - step] if i >= step else 0
            near = min((left, up, corner), key=lambda one: abs(left + up - corner - one))
            return (0, left, up, (left + up) // 2, near)[v % 5]
        raw += bytes([v % 5]) + bytes((line[i] - guess(i)) % 256 for i in range(len(line)))
        before = line
    data = zlib.compress(raw)
    parts = [data[i:i + part] for i in range(0, len(data), part)]
    head = struct.pack('>IIBBBBB', 64, 48, bits, 0, 0, 0, 0)
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'tEXt', b'Software\0Python') +
            b''.join(chunk(b'IDAT', one) for one in parts) + chunk(b'IEND', b''))

def pgm(lines, most):
    return b'P5\n# by Python\n64 48\n%d\n' % most + b''.join(lines)

def bmp(lines, height):
    palette = b''.join(bytes([i, i, i, 0]) for i in range(256))
    pixels = b''.join(lines if height < 0 else reversed(lines))
    info = struct.pack('<IiiHHIIiiII', 40, 64, height, 1, 8, 0, len(pixels), 2835, 2835, 256, 0)
    return struct.pack('<2sIHHI', b'BM', 1078 + len(pixels), 0, 0, 1078) + info + palette + pixels

def tiff(lines, bits, order):
    tags = [(256, 3, 64), (257, 3, 48), (258, 3, bits), (259, 3, 1), (262, 3, 1), (273, 4, 8),
            (277, 3, 1), (278, 3, 48), (279, 4, 48 * len(lines[0]))]
    data = b''.join(lines)
    if order == '<' and bits == 16:
        data = b''.join(data[i + 1:i + 2] + data[i:i + 1] for i in range(0, len(data), 2))
    entry = lambda tag, kind, value: struct.pack(order + 'HHI', tag, kind, 1) + (
        struct.pack(order + 'HH', value, 0) if kind == 3 else struct.pack(order + 'I', value))
    head = (b'II' if order == '<' else b'MM') + struct.pack(order + 'HI', 42, 8 + len(data))
    return (head + data + struct.pack(order + 'H', len(tags)) + b''.join(entry(*t) for t in tags) +
            struct.pack(order + 'I', 0))

open(sys.argv[1], 'wb').write(eval(sys.argv[2]))
)";

class ByPython : public testing::TestWithParam<ForeignImage> {};

TEST_P(ByPython, IsReadWithItsLevelsOrRefused) {
  const ForeignImage& made = GetParam();
  const TemporaryFolder folder;
  std::ofstream(folder / "make.py") << kScript;
  output_of(fmt::format("cd '{}' && python3 make.py {} '{}'", folder.path().string(), made.name,
                        made.options));
  if (!fs::exists(folder / made.name)) GTEST_SKIP() << "Python is not here";
  std::string truth;
  for (int v = 0; v < 48; ++v) truth += std::string(64, static_cast<char>(40 + 3 * v));
  in_every_locale([&] { expect_gradient(folder / made.name, truth, made); });
}

INSTANTIATE_TEST_SUITE_P(Made, ByPython,
                         testing::Values(ForeignImage{"filters.png", "png(rows, 8)", 0, ""},
                                         ForeignImage{"deep-filters.png", "png(deep, 16)", 0, ""},
                                         ForeignImage{"in-parts.png", "png(rows, 8, 7)", 0, ""},
                                         ForeignImage{"bytes.pgm", "pgm(rows, 255)", 0, ""},
                                         ForeignImage{"deep.pgm", "pgm(deep, 65535)", 0, ""},
                                         ForeignImage{"upwards.bmp", "bmp(rows, 48)", 0, ""},
                                         ForeignImage{"downwards.BMP", "bmp(rows, -48)", 0, ""},
                                         ForeignImage{"little.tif", "tiff(deep, 16, \"<\")", 0, ""},
                                         ForeignImage{"big.tif", "tiff(rows, 8, \">\")", 0, ""},
                                         ForeignImage{"cut.png", "png(rows, 8)[:-60]", 0,
                                                      "truncated"}),
                         name_of<ForeignImage>);

INSTANTIATE_TEST_SUITE_P(
    Made, ByImageMagick,
    testing::Values(
        ForeignImage{"plain.png", "-depth 8", 0, ""}, ForeignImage{"deep.png", "-depth 16", 1, ""},
        ForeignImage{"interlaced.png", "-depth 8 -interlace PNG", 0, ""},
        ForeignImage{"colours.png", "-depth 8 -define png:color-type=2", 0, ""},
        ForeignImage{"alpha.png", "-depth 8 -define png:color-type=6", 0, ""},
        ForeignImage{"grey-alpha.png", "-depth 8 -define png:color-type=4", 0, ""},
        ForeignImage{"lzw.tif", "-depth 8 -compress LZW", 0, ""},
        ForeignImage{"deflate.tiff", "-depth 16 -compress Zip", 1, ""},
        ForeignImage{"big-endian.tif", "-depth 16 -endian MSB", 1, ""},
        ForeignImage{"tiles.tif", "-depth 16 -define tiff:tile-geometry=16x16", 1, ""},
        ForeignImage{"bytes-in-tiles.tif", "-depth 8 -define tiff:tile-geometry=16x16", 0,
                     "of a rare kind of TIFF"},
        ForeignImage{"white-is-0.tif", "-depth 8 -negate -define quantum:polarity=min-is-white", 0,
                     ""},
        ForeignImage{"deep-white-is-0.tif",
                     "-depth 16 -negate -define quantum:polarity=min-is-white", 1, ""},
        ForeignImage{"bits.TIF", "-depth 8 -compress RLE", 0, ""},
        ForeignImage{"in-tiff.tif", "-depth 8 -compress JPEG -quality 95", 2, ""},
        ForeignImage{"progressive.jpg", "-interlace JPEG -quality 95", 2, ""},
        ForeignImage{"colours.JPEG", "-type TrueColor -quality 95", 2, ""},
        ForeignImage{"half.jpg", "-type TrueColor -sampling-factor 4:2:0 -quality 95", 2, ""},
        ForeignImage{"plain.bmp", "-depth 8", 1, ""}, ForeignImage{"plain.pgm", "-depth 8", 0, ""},
        ForeignImage{"deep.pgm", "-depth 16", 1, ""},
        ForeignImage{"two.png", "-monochrome", 0, "is black and white"},
        ForeignImage{"fax.tif", "-monochrome -compress Group4", 0, "is black and white"},
        ForeignImage{"inks.jpg", "-colorspace CMYK", 0, "has 4 channels"},
        ForeignImage{"letters.pgm", "-compress none", 0, "not an image of a known"}),
    name_of<ForeignImage>);

TEST(ForeignImages, AnOpaqueAlphaChannelIsNone) {
  const TemporaryFolder folder;
  cv::Mat image(48, 64, CV_8UC4, cv::Scalar(90, 90, 90, 255));
  cv::imwrite(folder / "opaque.png", image);
  const auto grey = read_grey_image(folder / "opaque.png");
  ASSERT_TRUE(grey.ok()) << grey.error().sentence();
  EXPECT_EQ(cv::norm(*grey, cv::Mat(48, 64, CV_8UC1, cv::Scalar(90)), cv::NORM_INF), 0);
  image.at<cv::Vec4b>(3, 3)[3] = 254;
  cv::imwrite(folder / "not.png", image);
  EXPECT_THAT(read_refusal(folder / "not.png"), HasSubstr("transparent"));
}

TEST(ForeignImages, ATagThatAsksForARotationIsNamed) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> jpeg;
  cv::imencode(".jpg", cv::Mat(48, 64, CV_8UC1, cv::Scalar(90)), jpeg);
  // Exif with one entry: orientation 6.
  const std::string exif(
      "\xFF\xE1\0\x22"
      "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
      36);
  jpeg.insert(jpeg.begin() + 2, exif.begin(), exif.end());
  std::ofstream(folder / "phone.jpg", std::ios::binary)
      .write(reinterpret_cast<const char*>(jpeg.data()), std::ssize(jpeg));
  auto source = open_source({folder / "phone.jpg"});
  const auto frame = (*source)->next();
  ASSERT_TRUE(frame.ok()) << frame.error().sentence();
  EXPECT_EQ((*frame)->grey.size(), cv::Size(64, 48));
  EXPECT_THAT(texts_of((*source)->remarks()), HasSubstr("Exif orientation 6"));
}

/// A chunk of a PNG file.
std::string chunk(const std::string& name, const std::string& data) {
  std::string content = name + data;
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char c : content) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? sum >> 1U ^ 0xEDB88320U : sum >> 1U;
  }
  const auto number = [](std::uint32_t value) {
    std::string bytes;
    for (const unsigned shift : {24U, 16U, 8U, 0U})
      bytes.push_back(static_cast<char>(value >> shift & 0xFFU));
    return bytes;
  };
  return number(static_cast<std::uint32_t>(data.size())) + content + number(~sum);
}

TEST(ForeignImages, LibrariesOfOthersWriteNothing) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> png, jpeg;
  cv::Mat image(48, 64, CV_8UC1);
  cv::randu(image, 60, 200);
  cv::imencode(".png", image, png);
  std::string odd(png.begin(), png.begin() + 33);
  odd += chunk("iCCP", "profile with nothing in it") + chunk("tIME", "x");
  odd.append(png.begin() + 33, png.end());
  std::ofstream(folder / "odd.png", std::ios::binary) << odd;
  cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_RST_INTERVAL, 4});
  const std::vector<std::uint8_t> stray = with_stray_zeros(jpeg);
  std::ofstream(folder / "stray.jpg", std::ios::binary)
      .write(reinterpret_cast<const char*>(stray.data()), std::ssize(stray));
  testing::internal::CaptureStderr();
  const auto read = read_grey_image(folder / "odd.png"),
             other = read_grey_image(folder / "stray.jpg");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_TRUE(read.ok() && other.ok());
  EXPECT_EQ(cv::norm(*read, image, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(*other, cv::imdecode(jpeg, cv::IMREAD_GRAYSCALE), cv::NORM_INF), 0);
}

}  // namespace
}  // namespace alltact::test
