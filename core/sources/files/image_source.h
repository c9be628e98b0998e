// A source of image files and a source of frames in memory.
#pragma once

#include "core/sources/source.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace alltact {

/// True for a file name with an image extension.
[[nodiscard]] bool is_image_file(const std::filesystem::path& file);

/// Returns a folder's images in name order. Errors: it cannot be read, or holds none.
[[nodiscard]] Result<std::vector<std::filesystem::path>> images_in(
    const std::filesystem::path& folder);

/// Continuous when the images have one name with numbers without a gap.
class ImageSource : public Source {
 public:
  explicit ImageSource(std::vector<std::filesystem::path> files);

  [[nodiscard]] Result<FramePtr> next() override;
  void skip(std::size_t count) override { position_ += std::min(count, files_.size() - position_); }
  [[nodiscard]] std::optional<std::size_t> count() const override { return files_.size(); }
  [[nodiscard]] bool is_continuous() const override { return is_continuous_; }

 private:
  std::vector<std::filesystem::path> files_;
  bool is_continuous_;
  std::size_t position_ = 0;
};

/// Frames in memory. Continuous when their names are numbered without a gap.
class FrameSource : public Source {
 public:
  explicit FrameSource(std::vector<FramePtr> frames);

  [[nodiscard]] Result<FramePtr> next() override;
  [[nodiscard]] std::optional<std::size_t> count() const override { return frames_.size(); }
  [[nodiscard]] bool is_continuous() const override { return is_continuous_; }

 private:
  std::vector<FramePtr> frames_;
  bool is_continuous_;
  std::size_t position_ = 0;
};

}  // namespace alltact
