// Readers of pictures, videos, meshes and networks.
#include "core/base/atomic_file.h"
#include "core/image/grey_decoder.h"
#include "core/image/image_file.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/surface_file.h"
#include "core/recording/depth_video.h"
#include "core/recording/matroska.h"
#include "core/recording/video_file.h"
#include "core/sensing/markers/dot_network.h"
#include "core/thumbnail/thumbnail.h"
#include "tests/core/recording/recording_frames.h"
#include "tests/fuzz/readers.h"
#include "tests/support/onnx_bytes.h"

#include <fcntl.h>
#include <unistd.h>

namespace alltact::test {
namespace {

const cv::Size kSize(16, 12);

std::vector<std::string> video_seeds() {
  std::vector<std::string> seeds;
  for (const VideoCodec codec : {VideoCodec::kMagicYuv, VideoCodec::kFfv1, VideoCodec::kMjpeg}) {
    const bool is_jpeg = codec == VideoCodec::kMjpeg;
    seeds.push_back(written_by("v.mkv", [&](const std::filesystem::path& file) {
      auto writer = VideoWriter::create(file, *camera_frame(0, is_jpeg, kSize), codec, 30);
      for (std::uint32_t i = 0; i < 3; ++i)
        (void)writer->add(*camera_frame(i, is_jpeg, kSize)).ok();
      (void)writer->finish().ok();
    }));
  }
  return seeds;
}

std::vector<std::string> foreign_video_seeds() {
  std::vector<std::string> seeds;
  for (const char* options :
       {"-c:v libx264 -bf 2 -f avi", "-c:v libx264 -bf 2 -f mp4", "-c:v mpeg4 -bf 2 -f avi",
        "-c:v mpeg2video -bf 2 -f mpegts", "-c:v libvpx-vp9 -f webm", "-c:v png -f mov",
        "-pix_fmt gray16le -f matroska -c:v ffv1", "-pix_fmt gray -f yuv4mpegpipe -strict -1"})
    seeds.push_back(written_by("v", [&](const std::filesystem::path& file) {
      output_of(
          "ffmpeg -v quiet -nostdin -y -f lavfi -i testsrc=s=16x16:r=25 -frames:v 4 -threads "
          "1 " +
          std::string(options) + " '" + file.string() + "' </dev/null");
    }));
  return seeds;
}

/// Whole blocks only, each within the file.
Reading read_index(const std::string& bytes) {
  static const ScratchFile file("v.mkv");
  return reading_of(index_matroska(file.write(bytes)),
                    [&](const MatroskaIndex& index) -> std::string {
                      const int descriptor = ::open(file.path().c_str(), O_RDONLY | O_CLOEXEC);
                      std::string broken;
                      for (const auto& block : index.blocks) {
                        if (block.data_bytes_at < 0 || block.data_bytes_at > std::ssize(bytes))
                          broken = "a block beyond the file";
                        (void)is_undamaged(descriptor, block);
                      }
                      ::close(descriptor);
                      return broken;
                    });
}

std::function<Reading(const std::string&)> as_video(const std::string& name) {
  return [file = ScratchFile(name)](const std::string& bytes) -> Reading {
    auto video = VideoFile::open(file.write(bytes));
    if (!video) return {video.error()};
    if (video->frame_count() == 0) return {std::nullopt, "a video without frames"};
    for (std::size_t i = 0; i < std::min<std::size_t>(video->frame_count(), 4); ++i) {
      const auto frame = video->frame(i);
      if (!frame) return {frame.error()};
      if ((*frame)->grey.empty()) return {std::nullopt, "a frame without pixels"};
    }
    return {std::nullopt, file.stray()};
  };
}

std::vector<std::string> depth_video_seeds() {
  return {written_by("depth.mkv", [](const std::filesystem::path& file) {
    auto packets = DepthPackets::create(kSize);
    auto writer = DepthVideoWriter::create(file, kSize, 30);
    for (int i = 0; i < 2; ++i)
      (void)writer->add(*packets->packet(cv::Mat(kSize, CV_16UC1, cv::Scalar(10000 + i)))).ok();
    (void)writer->finish().ok();
  })};
}

Reading read_depth_video(const std::string& bytes) {
  static const ScratchFile file("depth.mkv");
  auto video = DepthVideo::open(file.write(bytes));
  if (!video) return {video.error()};
  for (int i = 0; i < 4; ++i) {
    const auto depth = video->next_mm();
    if (!depth) return {depth.error()};
    if (depth->empty()) break;
    if (depth->size() != video->size()) return {std::nullopt, "a picture of another size"};
  }
  return {};
}

template <class Law>
std::function<Reading(const std::string&)> as_picture(
    const std::string& name, Result<cv::Mat> (*read)(const std::filesystem::path&),
    const Law& law) {
  return [file = ScratchFile(name), read, law](const std::string& bytes) {
    return reading_of(read(file.write(bytes)), law);
  };
}

Result<cv::Mat> grey_of_file(const std::filesystem::path& file) {
  std::string note;
  return read_grey_image(file, &note);
}

std::vector<std::string> grey_seeds() {
  std::vector<std::string> seeds;
  const cv::Mat image = camera_picture(1, kSize);
  for (const char* ending : {".png", ".jpg", ".bmp", ".pgm", ".tiff"}) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(ending, image, bytes);
    seeds.emplace_back(bytes.begin(), bytes.end());
  }
  seeds.push_back(written_by("n.png", [&](const std::filesystem::path& file) {
    (void)write_image(file, image, "light: 0.5").ok();
  }));
  return seeds;
}

Reading read_note(const std::string& bytes) {
  const std::string note = note_of(bytes);
  if (!note.empty() && note_of(with_note(grey_png(camera_picture(1, kSize)), note)) != note)
    return {std::nullopt, "another note comes back"};
  return {};
}

cv::Mat some_depth() {
  cv::Mat depth(kSize, CV_32FC1, cv::Scalar(0.25));
  depth.at<float>(2, 3) = std::numeric_limits<float>::quiet_NaN();
  return depth;
}

std::string surface_as(const std::string& name) {
  cv::Mat points(4, 5, CV_32FC3), depth(4, 5, CV_32FC1, cv::Scalar(0.5));
  for (int v = 0; v < points.rows; ++v)
    for (int u = 0; u < points.cols; ++u)
      points.at<cv::Vec3f>(v, u) = {0.5F * static_cast<float>(u), 0.25F * static_cast<float>(v),
                                    40};
  return written_by(name, [&](const std::filesystem::path& file) {
    (void)write_surface(file, points, depth).ok();
  });
}

std::string law_of_triangles(const Triangles& triangles) {
  for (const auto& corners : triangles.corners)
    for (const auto corner : corners)
      if (static_cast<std::size_t>(corner) >= triangles.points_mm.size())
        return "a triangle of points that are not there";
  return {};
}

Reader triangles_of(std::string_view name, const std::string& file_name) {
  return {name, [file_name] { return std::vector{surface_as(file_name)}; },
          [file = ScratchFile(file_name)](const std::string& bytes) {
            return reading_of(read_triangles(file.write(bytes)), law_of_triangles);
          }};
}

Reader mesh_of(std::string_view name, const std::string& file_name, const std::string& seed) {
  return {name, [seed] { return std::vector{seed}; },
          [file = ScratchFile(file_name)](const std::string& bytes) {
            return reading_of(read_mesh(file.write(bytes)), [](const TriangleMesh& mesh) {
              for (const auto& triangle : mesh.triangles)
                for (const int corner : triangle)
                  if (corner < 0 || corner >= std::ssize(mesh.points))
                    return std::string("a triangle of points that are not there");
              (void)check_closed(mesh).ok();
              return std::string();
            });
          }};
}

std::vector<std::string> network_seeds() {
  OnnxBytes network;
  network.input("images", {1, 1, 8, 8}).output("out", {1, 1, 8, 8});
  network.weights("w", {1, 1, 3, 3}, std::vector<float>(9, 0.1F));
  network.node("Conv", {"images", "w"}, "out", {{"pads", {1, 1, 1, 1}}});
  return {network.bytes()};
}

}  // namespace

std::vector<Reader> picture_readers() {
  const std::string stl = surface_as("a.stl");
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  return {
      {"matroska_index", video_seeds, read_index},
      {"video", video_seeds, as_video("v.mkv")},
      {"foreign_video", foreign_video_seeds, as_video("v")},
      {"depth_video", depth_video_seeds, read_depth_video},
      {"picture", grey_seeds,
       as_picture("p.png", grey_of_file,
                  [](const cv::Mat& image) {
                    return image.type() == CV_8UC1 && !image.empty() ? "" : "no grey picture";
                  })},
      {"float_picture",
       [] {
         return std::vector{
             depth_tiff(some_depth()), written_by("f.tiff", [](const std::filesystem::path& file) {
               (void)write_image(file, cv::Mat(kSize, CV_32FC3, cv::Scalar(1, 2, 3))).ok();
             })};
       },
       as_picture(
           "f.tiff", read_float_image,
           [](const cv::Mat& image) { return image.depth() == CV_32F ? "" : "no float picture"; })},
      {"depth_picture", [] { return std::vector{depth_png(some_depth())}; },
       as_picture("d.png", read_depth_png,
                  [](const cv::Mat& image) { return image.type() == CV_32FC1 ? "" : "no depth"; })},
      {"picture_note",
       [] { return std::vector{with_note(grey_png(camera_picture(1, kSize)), "light: 0.5")}; },
       read_note},
      mesh_of("mesh_stl", "a.stl", stl),
      mesh_of("mesh_obj", "a.obj", obj),
      triangles_of("surface_ply", "s.ply"),
      triangles_of("surface_vtp", "s.vtp"),
      triangles_of("surface_glb", "s.glb"),
      {"network", network_seeds,
       [](const std::string& bytes) {
         return reading_of(read_onnx_header(bytes, Where(std::string("n.onnx"))), kNoLaw);
       }},
  };
}

}  // namespace alltact::test
