#include "prosup/prepare/dicom.h"

#include <gtest/gtest.h>
#include <itkGDCMImageIO.h>
#include <itkImage.h>
#include <itkImageFileWriter.h>
#include <itkMetaDataObject.h>

#include "expect_error.h"
#include "temporary_folder.h"

namespace prosup::tests {
namespace {

/// A slice of 60 x 50 voxels of 2 x 3 mm whose value is its height.
struct TestSlice {
  std::string series = "1.2.3.1";
  unsigned number = 1;
  double z = 0.;
  std::string position = "HFP";
  int value = 100;
};

class DicomFolder {
public:
  void add(const TestSlice& slice) {
    using Image = itk::Image<short, 3>;
    auto image = Image::New();
    Image::SizeType size{{60, 50, 1}};
    image->SetRegions(size);
    image->Allocate();
    image->FillBuffer(short(slice.value));
    auto io = itk::GDCMImageIO::New();
    io->SetKeepOriginalUID(true);
    itk::MetaDataDictionary& header = io->GetMetaDataDictionary();
    const auto set = [&](const char* key, const std::string& value) {
      itk::EncapsulateMetaData<std::string>(header, key, value);
    };
    ++n_files_;
    set("0028|0004", "MONOCHROME2");
    set("0008|0060", "MR");
    set("0008|103e", "test");
    set("0008|0018", "1.2.3.9." + std::to_string(n_files_));
    set("0010|0010", "Doe^Jane");
    set("0018|5100", slice.position);
    set("0020|000d", "1.2.3");
    set("0020|000e", slice.series);
    set("0020|0011", std::to_string(slice.number));
    set("0020|0013", std::to_string(n_files_));
    Image::PointType origin;
    origin[0] = -60.;
    origin[1] = -75.;
    origin[2] = slice.z;
    Image::SpacingType spacing;
    spacing[0] = 2.;
    spacing[1] = 3.;
    spacing[2] = 4.;
    image->SetOrigin(origin);
    image->SetSpacing(spacing);
    image->SetMetaDataDictionary(header);
    auto writer = itk::ImageFileWriter<Image>::New();
    writer->SetInput(image);
    writer->SetImageIO(io);
    // Names say nothing of the order.
    writer->SetFileName(path() + "IM" + std::to_string(n_files_ * 7919 % 1000) + ".dcm");
    writer->Update();
  }

  void add_series(const TestSlice& first, unsigned n_slices) {
    for (unsigned i = 0; i < n_slices; ++i) {
      TestSlice slice = first;
      slice.z += 4. * i;
      slice.value += int(i);
      add(slice);
    }
  }

  std::string path() const { return (folder_ / "").string(); }

  image::ScalarImage read(unsigned series = 0, Position position = Position::prone) {
    return prepare::read_dicom(path(), position, series, Log(), remarks_);
  }
  const std::vector<std::string>& remarks() const { return remarks_.all(); }

private:
  TemporaryFolder folder_;
  Remarks remarks_;
  unsigned n_files_ = 0;
};

TEST(Dicom, SlicesAreSortedByTheirPlace) {
  DicomFolder folder;
  folder.add_series({}, 30);
  const image::ScalarImage image = folder.read();
  ASSERT_EQ(image.grid.size, (std::array<std::size_t, 3>{60, 50, 30}));
  EXPECT_NEAR(image.grid.spacing[0], 2., 1e-6);
  EXPECT_NEAR(image.grid.spacing[1], 3., 1e-6);
  EXPECT_NEAR(image.grid.spacing[2], 4., 1e-6);
  EXPECT_NEAR(image.grid.origin.distance({-60., -75., 0.}), 0., 1e-6);
  for (std::size_t k = 0; k < 30; ++k)
    EXPECT_EQ(image(3, 4, k), 100.f + float(k));
  EXPECT_TRUE(folder.remarks().empty());
}

TEST(Dicom, TheSeriesWithMostSlicesIsTakenUnlessToldOtherwise) {
  DicomFolder folder;
  folder.add_series({"1.2.3.4", 4, 0., "HFP", 400}, 26);
  folder.add_series({"1.2.3.5", 5, 0., "HFP", 500}, 28);
  EXPECT_EQ(folder.read()(0, 0, 0), 500.f);
  EXPECT_EQ(folder.read(4)(0, 0, 0), 400.f);
  expect_error([&] { folder.read(6); }, {"series 6", "list"});
}

TEST(Dicom, DoubledSlicesAreToldAndGapsRefused) {
  DicomFolder folder;
  folder.add_series({}, 30);
  folder.add({"1.2.3.1", 1, 8., "HFP", 900});
  EXPECT_EQ(folder.read()(0, 0, 2), 102.f);
  ASSERT_EQ(folder.remarks().size(), 1u);
  EXPECT_NE(folder.remarks()[0].find("31 images at 30"), std::string::npos);
  folder.add({"1.2.3.1", 1, 128.});
  expect_error([&] { folder.read(); }, {"gap", "30 and 31", "12.00"});
}

TEST(Dicom, ThePositionIsComparedWithWhatIsTold) {
  DicomFolder folder;
  folder.add_series({}, 30);
  expect_error([&] { folder.read(0, Position::supine); }, {"given as supine", "HFP", "prone"});
  DicomFolder silent;
  silent.add_series({"1.2.3.1", 1, 0., ""}, 30);
  silent.read();
  ASSERT_EQ(silent.remarks().size(), 1u);
  EXPECT_NE(silent.remarks()[0].find("does not say"), std::string::npos);
}

TEST(Dicom, FoldersWithoutSlicesAreRefused) {
  DicomFolder folder;
  expect_error([&] { folder.read(); }, {"no DICOM slices"});
  folder.add_series({}, 5);
  expect_error([&] { folder.read(); }, {"100 mm", "--series"});
}

} // namespace
} // namespace prosup::tests
