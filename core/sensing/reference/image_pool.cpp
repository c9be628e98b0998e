#include "core/sensing/reference/image_pool.h"

#include <map>
#include <mutex>
#include <vector>

namespace alltact {
namespace {

constexpr std::size_t kMaxIdleBytes = std::size_t{256} << 20;

/// Blocks by size. Never destroyed: images may outlive everything else.
class Pool final : public cv::MatAllocator {
 public:
  cv::UMatData* allocate(int dims,
                         const int* sizes,
                         int type,
                         void* data,
                         std::size_t* step,
                         cv::AccessFlag flags,
                         cv::UMatUsageFlags usage) const override {
    CV_Assert(data == nullptr && dims == 2);
    (void)flags, (void)usage;
    step[1] = CV_ELEM_SIZE(type);
    step[0] = static_cast<std::size_t>(sizes[1]) * step[1];
    auto* block = new cv::UMatData(this);
    block->size = static_cast<std::size_t>(sizes[0]) * step[0];
    block->data = block->origdata = take(block->size);
    return block;
  }
  bool allocate(cv::UMatData* block, cv::AccessFlag, cv::UMatUsageFlags) const override {
    return block != nullptr;
  }
  void deallocate(cv::UMatData* block) const override {
    give_back(block->size, block->origdata);
    block->origdata = nullptr;
    delete block;
  }

 private:
  [[nodiscard]] uchar* take(std::size_t bytes) const {
    {
      const std::lock_guard lock(mutex_);
      const auto found = idle_.find(bytes);
      if (found != idle_.end() && !found->second.empty()) {
        uchar* block = found->second.back();
        found->second.pop_back();
        idle_bytes_ -= bytes;
        return block;
      }
    }
    return static_cast<uchar*>(cv::fastMalloc(bytes));
  }
  void give_back(std::size_t bytes, uchar* block) const {
    {
      const std::lock_guard lock(mutex_);
      if (idle_bytes_ + bytes <= kMaxIdleBytes) {
        idle_[bytes].push_back(block);
        idle_bytes_ += bytes;
        return;
      }
    }
    cv::fastFree(block);
  }

  mutable std::mutex mutex_;
  mutable std::map<std::size_t, std::vector<uchar*>> idle_;
  mutable std::size_t idle_bytes_ = 0;
};

}  // namespace

cv::Mat pooled_image(const cv::Size& size, int type) {
  static auto* pool = new Pool;
  cv::Mat image;
  image.allocator = pool;
  image.create(size, type);
  return image;
}

}  // namespace alltact
