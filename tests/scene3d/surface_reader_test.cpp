// What the program writes for others, read by others: VTK's own readers.
#include "core/mesh/surface_file.h"
#include "tests/support/temporary_folder.h"

#include <limits>

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkGLTFReader.h>
#include <vtkMassProperties.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

namespace alltact::test {
namespace {

class SurfaceReader : public testing::Test {
 protected:
  SurfaceReader() : points_(6, 9, CV_32FC3), depth_(6, 9, CV_32FC1) {
    for (int v = 0; v < points_.rows; ++v) {
      for (int u = 0; u < points_.cols; ++u) {
        points_.at<cv::Vec3f>(v, u) = cv::Vec3f(0.5F * float(u), 0.25F * float(v), 40);
        depth_.at<float>(v, u) = 0.01F * static_cast<float>(10 * v + u);
      }
    }
    points_.at<cv::Vec3f>(2, 3)[2] = std::numeric_limits<float>::quiet_NaN();
    depth_.at<float>(2, 3) = std::numeric_limits<float>::quiet_NaN();
  }
  static constexpr double kArea = (8 * 5 - 3) * 0.5 * 0.25;  // an inner point's six triangles go
  static constexpr int kPoints = 53, kTriangles = 2 * 8 * 5 - 6;

  std::string write(const std::string& name) {
    const auto status = write_surface(folder_ / name, points_, depth_);
    EXPECT_TRUE(status.ok());
    return (folder_ / name).string();
  }
  static void expect_surface(vtkPolyData* data, int points) {
    EXPECT_EQ(data->GetNumberOfPoints(), points);
    EXPECT_EQ(data->GetNumberOfCells(), kTriangles);
    const vtkNew<vtkMassProperties> measure;
    measure->SetInputData(data);
    EXPECT_NEAR(measure->GetSurfaceArea(), kArea, 1e-5);
    double box[6];
    data->GetBounds(box);
    EXPECT_EQ(box[1], 4.0);
    EXPECT_EQ(box[3], 1.25);
    EXPECT_EQ(box[4], 40.0);
  }
  TemporaryFolder folder_;
  cv::Mat points_, depth_;
};

TEST_F(SurfaceReader, Vtp) {
  const vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(write("a.vtp").c_str());
  reader->Update();
  expect_surface(reader->GetOutput(), kPoints);
  vtkDataArray* depth = reader->GetOutput()->GetPointData()->GetArray("depth_mm");
  ASSERT_NE(depth, nullptr);
  EXPECT_FLOAT_EQ(static_cast<float>(depth->GetTuple1(kPoints - 1)), 0.58F);
}

TEST_F(SurfaceReader, Ply) {
  const vtkNew<vtkPLYReader> reader;
  reader->SetFileName(write("a.ply").c_str());
  reader->Update();
  expect_surface(reader->GetOutput(), kPoints);
}

TEST_F(SurfaceReader, Stl) {
  const vtkNew<vtkSTLReader> reader;
  reader->SetFileName(write("a.stl").c_str());
  reader->Update();
  expect_surface(reader->GetOutput(), kPoints);  // it merges equal points
}

TEST_F(SurfaceReader, Glb) {
  const vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(write("a.glb").c_str());
  reader->ApplyDeformationsToGeometryOff();
  reader->Update();
  vtkDataObject* at = reader->GetOutput();
  while (auto* block = vtkMultiBlockDataSet::SafeDownCast(at)) {
    ASSERT_EQ(block->GetNumberOfBlocks(), 1U);
    at = block->GetBlock(0);
  }
  auto* data = vtkPolyData::SafeDownCast(at);
  ASSERT_NE(data, nullptr);
  expect_surface(data, kPoints);
  ASSERT_NE(data->GetPointData()->GetArray("COLOR_0"), nullptr);
  // In metres, y up, towards whoever looks: what the node does.
  const vtkNew<vtkGLTFReader> placed;
  placed->SetFileName((folder_ / "a.glb").c_str());
  placed->Update();
  at = placed->GetOutput();
  while (auto* block = vtkMultiBlockDataSet::SafeDownCast(at)) at = block->GetBlock(0);
  double box[6];
  vtkPolyData::SafeDownCast(at)->GetBounds(box);
  EXPECT_NEAR(box[1], 0.004, 1e-7);
  EXPECT_NEAR(box[2], -0.00125, 1e-7);
  EXPECT_NEAR(box[4], -0.04, 1e-7);
}

TEST_F(SurfaceReader, AnotherEndingIsRefused) {
  const auto status = write_surface(folder_ / "a.obj", points_, depth_);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().sentence().find(".glb"), std::string::npos);
}

}  // namespace
}  // namespace alltact::test
