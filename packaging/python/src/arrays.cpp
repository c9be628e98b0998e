#include "packaging/python/src/arrays.h"

#include <vector>

#include "packaging/python/src/module.h"

namespace alltact::python {
namespace {

struct Held {
  cv::Mat image;
  std::shared_ptr<const void> owner;
};

py::dtype dtype_of(int depth) {
  switch (depth) {
    case CV_8U:
      return py::dtype::of<std::uint8_t>();
    case CV_16U:
      return py::dtype::of<std::uint16_t>();
    case CV_32F:
      return py::dtype::of<float>();
    default:
      return py::dtype::of<double>();
  }
}

/// The memory of an array of this kind, with any distance between rows.
cv::Mat image_over(const py::object& given, const py::dtype& dtype, int type, const char* what) {
  const py::array array =
      py::isinstance<py::array>(given) ? py::reinterpret_borrow<py::array>(given) : py::array();
  const auto size = static_cast<py::ssize_t>(CV_ELEM_SIZE(type));
  const bool fits = array.ndim() == 2 && array.dtype().equal(dtype) && array.shape(0) > 0 &&
                    array.shape(1) > 0 && array.strides(1) == size &&
                    array.strides(0) >= array.shape(1) * size;
  if (!fits)
    throw Failure({en::say("this is not {}", Message::typed(what)), "",
                   en::say("numpy.ascontiguousarray, and one channel")});
  // OpenCV's headers have no type for a read-only image.
  return {static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)), type,
          const_cast<void*>(array.data()), static_cast<std::size_t>(array.strides(0))};
}

/// Releases a Python object on whatever thread; not once the interpreter has gone.
void release_object(py::object* object) {
  if (Py_IsInitialized() == 0) return;
  const py::gil_scoped_acquire python;
  delete object;
}

}  // namespace

py::object array_of(const cv::Mat& image, std::shared_ptr<const void> owner) {
  if (image.empty()) return py::none();
  auto held = std::make_unique<Held>(Held{image, std::move(owner)});
  const cv::Mat& mat = held->image;
  std::vector<py::ssize_t> shape{mat.rows, mat.cols};
  std::vector<py::ssize_t> strides{static_cast<py::ssize_t>(mat.step[0]),
                                   static_cast<py::ssize_t>(mat.elemSize())};
  if (mat.channels() > 1) {
    shape.push_back(mat.channels());
    strides.push_back(static_cast<py::ssize_t>(mat.elemSize1()));
  }
  const void* data = mat.data;
  const py::capsule base(held.release(), [](void* all) { delete static_cast<Held*>(all); });
  py::array array(dtype_of(image.depth()), shape, strides, data, base);
  array.attr("flags").attr("writeable") = false;
  return array;
}

std::shared_ptr<Frame> frame_over(const py::object& image) {
  const cv::Mat grey = image_over(image, py::dtype::of<std::uint8_t>(), CV_8UC1,
                                  "a grey picture: an array uint8 [v, u]");
  auto* const held = new py::object(image);
  std::shared_ptr<Frame> frame(new Frame, [held](Frame* over) {
    delete over;
    release_object(held);
  });
  frame->grey = grey;
  return frame;
}

cv::Mat depth_over(const py::object& depth) {
  return image_over(depth, py::dtype::of<float>(), CV_32FC1, "depth: an array float32 [v, u], mm");
}

}  // namespace alltact::python
