// Pictures one after the other.
#pragma once

#include "core/sources/source.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace alltact {

/// True when the name ends as pictures' names do.
[[nodiscard]] bool is_picture(const std::filesystem::path& file);

/// A folder's pictures in name order. Errors: it cannot be read, or holds none.
[[nodiscard]] Result<std::vector<std::filesystem::path>> pictures_in(
    const std::filesystem::path& folder);

/// Continuous when the pictures are named alike and numbered without a gap.
class PictureSource : public Source {
 public:
  explicit PictureSource(std::vector<std::filesystem::path> files);

  [[nodiscard]] Result<FramePtr> next() override;
  void skip(std::size_t count) override { position_ += std::min(count, files_.size() - position_); }
  [[nodiscard]] std::optional<std::size_t> count() const override { return files_.size(); }
  [[nodiscard]] bool is_continuous() const override { return is_continuous_; }

 private:
  std::vector<std::filesystem::path> files_;
  bool is_continuous_;
  std::size_t position_ = 0;
};

/// Frames that are at hand. Continuous when their names are numbered as pictures' would have to be.
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
