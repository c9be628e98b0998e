// How the face would look untouched: one picture, or a weighted sum of recorded faces.
#pragma once

#include "core/sensing/face_picture.h"

#include <cstdint>
#include <memory>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Made row by row where it is needed: a whole picture of it would go through memory twice. Copies
/// share what they are made from; safe to read from any thread.
class ReferencePicture {
 public:
  ReferencePicture() = default;
  /// One picture, CV_32FC1, kept to 1/64 grey level; NaN where it tells nothing.
  explicit ReferencePicture(const cv::Mat& grey);
  /// sum of weights[i] * faces[i] where all of them show the face; all kept from pictures of
  /// `size`. `owner` keeps the faces alive. At least one face, as many weights, which sum to 1 and
  /// their magnitudes to at most 3 (beyond, sums would overflow).
  ReferencePicture(std::shared_ptr<const void> owner,
                   std::vector<const FacePicture*> faces,
                   const std::vector<float>& weights,
                   const cv::Size& size);

  [[nodiscard]] const cv::Size& size() const { return size_; }
  /// Of the one picture; faces belong to their owner.
  [[nodiscard]] std::size_t memory_bytes() const { return single_.total() * single_.elemSize(); }
  /// The whole of it: CV_32FC1, NaN where it tells nothing.
  [[nodiscard]] cv::Mat grey() const;

  /// Gives rows in any order.
  class Reader {
   public:
    /// The picture must live as long.
    explicit Reader(const ReferencePicture& picture);
    /// size().width grey levels in steps (grey_steps.h), kNoGrey where there is none; valid until
    /// the next call.
    const std::int16_t* row(int v);

   private:
    // Where one row's pixels of a face are, walked along run by run.
    struct Cursor {
      const FaceRun* run = nullptr;
      const FaceRun* end = nullptr;  // of the row
      const std::uint8_t* grey = nullptr;

      [[nodiscard]] const std::uint8_t* at(int column) const {
        return grey + run->before + (column - run->first);
      }
    };
    void mix(int first, int end);
    void fetch_ahead(int count);

    const ReferencePicture& picture_;
    std::vector<Cursor> cursors_;
    std::vector<const std::uint8_t*> rows_;
    std::vector<std::int16_t> buffer_;
  };

 private:
  cv::Mat single_;  // CV_16SC1 in steps; empty for a sum
  std::shared_ptr<const void> owner_;
  std::vector<const FacePicture*> faces_;
  std::vector<std::int16_t> weights_;  // of 2^-14
  cv::Size size_;
};

}  // namespace alltact
