// ROS 1 bags, written by rosbag if it is installed.
#include "io/bag.hpp"

#include "io/sequence_support.hpp"

#ifdef SYMSCENE_HAS_ROSBAG
#include <rosbag/bag.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#endif

namespace symscene {
namespace {

namespace fs = std::filesystem;
using namespace io_test;

TEST(Bag, OtherFilesAreRefused) {
  EXPECT_EQ(refusal([] { require_sound_bag("", "a.bag"); }),
            "a.bag: expected a whole ROS 1 bag of version 2.0, found \"\"");
  EXPECT_THROW(require_sound_bag("#ROSBAG V2.0\n", "a.bag"), InputError);
  EXPECT_THROW(require_sound_bag("#ROSBAG V1.2\n", "a.bag"), InputError);
  const TemporaryFolder folder;
  write_text(folder / "a.bag", "text");
  EXPECT_TRUE(refusal([&] {
                open_sequence(folder / "a.bag");
              }).starts_with((folder / "a.bag").string() + ": expected"));
}

#ifdef SYMSCENE_HAS_ROSBAG

/// The messages need an allocator with a member that C++20 removed from std::allocator.
template <class T>
struct RosAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = RosAllocator<U>;
  };
  RosAllocator() = default;
  template <class U>
  RosAllocator(const RosAllocator<U>&) {}
};
using ImageMessage = sensor_msgs::Image_<RosAllocator<void>>;
using CameraInfoMessage = sensor_msgs::CameraInfo_<RosAllocator<void>>;

ros::Time stamp(int i) { return ros::Time(small_frame(i).time); }

ImageMessage image_message(const std::string& encoding, std::uint32_t pixel_bytes,
                           const std::string& frame = "camera") {
  ImageMessage image;
  image.header.frame_id = frame.c_str();
  image.width = frame_size.width;
  image.height = frame_size.height;
  image.encoding = encoding.c_str();
  image.step = image.width * pixel_bytes + 3;  // rows may be padded
  image.data.resize(std::size_t{image.step} * image.height);
  return image;
}

/// Calls put(bytes of the pixel, pixel) for every pixel.
template <class Put>
ImageMessage filled(ImageMessage image, std::uint32_t pixel_bytes, const Put& put) {
  for (std::uint32_t k = 0; k < image.width * image.height; ++k) {
    put(&image.data[k / image.width * image.step + k % image.width * pixel_bytes], k);
  }
  return image;
}

ImageMessage depth_16(int i, bool big_endian = false) {
  ImageMessage image = image_message("16UC1", 2);
  image.is_bigendian = big_endian;
  const std::vector<float> depth = small_frame(i).depth;
  return filled(image, 2, [&](std::uint8_t* bytes, std::uint32_t k) {
    const auto value = static_cast<unsigned>(std::lround(depth[k] * 1000.0F));
    bytes[big_endian ? 1 : 0] = static_cast<std::uint8_t>(value & 255U);
    bytes[big_endian ? 0 : 1] = static_cast<std::uint8_t>(value >> 8);
  });
}

ImageMessage depth_32(int i) {
  std::vector<float> depth = small_frame(i).depth;
  depth[5] = std::numeric_limits<float>::quiet_NaN();
  return filled(image_message("32FC1", 4), 4,
                [&](std::uint8_t* bytes, std::uint32_t k) { std::memcpy(bytes, &depth[k], 4); });
}

ImageMessage color(const std::string& encoding, const std::string& frame = "camera") {
  const Colors colors = color_ramp(frame_size).pixels;
  return filled(image_message(encoding, 3, frame), 3, [&](std::uint8_t* bytes, std::uint32_t k) {
    for (int c = 0; c < 3; ++c) bytes[encoding == "rgb8" ? c : 2 - c] = colors(k, c);
  });
}

CameraInfoMessage camera_info() {
  CameraInfoMessage info;
  info.width = frame_size.width;
  info.height = frame_size.height;
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0.0);
  info.K = {10, 0, 3.5, 0, 11, 2.5, 0, 0, 1};
  return info;
}

class RosBag : public ::testing::Test {
 protected:
  /// Writes three depth images, and colour images of the first two.
  template <class Depth>
  void write(const Depth& depth, const ImageMessage& colors,
             rosbag::CompressionType compression = rosbag::compression::Uncompressed) {
    rosbag::Bag bag(file.string(), rosbag::bagmode::Write);
    bag.setCompression(compression);
    for (int i = 0; i < 3; ++i) {
      bag.write("/camera/depth/camera_info", stamp(i), camera_info());
      bag.write("/camera/depth/image_raw", stamp(i), depth(i));
      if (i < 2) bag.write("/camera/rgb/image_color", stamp(i) + ros::Duration(0.01), colors);
    }
  }

  void expect_small(const DepthSequence& sequence) const {
    EXPECT_EQ(sequence.layout(), "ROS bag");
    EXPECT_EQ(sequence.camera().fy, 11.0);
    EXPECT_EQ(sequence.camera().height, frame_size.height);
    ASSERT_EQ(sequence.size(), 3U);
    for (int i : {2, 0, 1}) {
      expect_same_frame(sequence.read(static_cast<std::size_t>(i)), small_frame(i, i < 2), 1e-6);
    }
  }

  const TemporaryFolder folder_;
  const fs::path file = folder_ / "table.bag";
};

TEST_F(RosBag, DepthInMillimetresAndColourAreRead) {
  write([](int i) { return depth_16(i); }, color("rgb8"));
  expect_small(*open_sequence(file));
}

TEST_F(RosBag, DepthInMetresIsReadAndNanIsNoMeasurement) {
  write(depth_32, color("bgr8"));
  expect_small(*open_sequence(file));
}

TEST_F(RosBag, BigEndianImagesAndCompressedChunksAreRead) {
  for (const auto compression : {rosbag::compression::LZ4, rosbag::compression::BZ2}) {
    write([](int i) { return depth_16(i, true); }, color("rgb8"), compression);
    expect_small(*open_sequence(file));
  }
}

TEST_F(RosBag, ColourOfAnotherCameraIsLeftOutWithAWarning) {
  write([](int i) { return depth_16(i); }, color("rgb8", "other_camera"));
  const auto sequence = open_sequence(file);
  ASSERT_EQ(sequence->warnings().size(), 1U);
  const std::string& warning = sequence->warnings()[0];
  EXPECT_FALSE(sequence->has_color());
  EXPECT_NE(warning.find("not registered"), std::string::npos);
  expect_same_frame(sequence->read(0), small_frame(0, false), 1e-6);
}

TEST_F(RosBag, IsRefusedWithoutDepthOrCamera) {
  rosbag::Bag bag(file.string(), rosbag::bagmode::Write);
  bag.write("/rgb/image", stamp(0), color("rgb8"));
  bag.close();
  EXPECT_EQ(refusal([&] { open_sequence(file); }),
            file.string() +
                ": expected a topic of depth images, 16UC1 or 32FC1, found /rgb/image "
                "(rgb8)");
  bag.open(file.string(), rosbag::bagmode::Write);
  bag.write("/depth/image", stamp(0), depth_16(0));
  bag.close();
  EXPECT_NE(refusal([&] {
              open_sequence(file);
            }).find("pass --intrinsics fx,fy,cx,cy (or a camera.yaml), found none"),
            std::string::npos);
  expect_same_frame(open_sequence(file, given_camera())->read(0), small_frame(0, false), 1e-6);
}

TEST_F(RosBag, OfSeveralDepthTopicsTheRegisteredOneIsReadWithAWarning) {
  rosbag::Bag bag(file.string(), rosbag::bagmode::Write);
  bag.write("/camera/depth/image", stamp(0), depth_16(1));
  bag.write("/camera/depth_registered/image", stamp(0), depth_16(0));
  bag.write("/camera/ir/image", stamp(0), image_message("mono16", 2));
  bag.close();
  const auto sequence = open_sequence(file, given_camera());
  ASSERT_EQ(sequence->warnings().size(), 1U);
  const std::string& warning = sequence->warnings()[0];
  EXPECT_NE(warning.find("/camera/depth_registered/image (16UC1), /camera/depth/image (16UC1): the "
                         "first is read"),
            std::string::npos)
      << warning;
  expect_same_frame(sequence->read(0), small_frame(0, false), 1e-6);
}

TEST_F(RosBag, ImagesShorterThanDeclaredAreRefused) {
  ImageMessage short_image = depth_16(0);
  short_image.height = 100000;
  rosbag::Bag bag(file.string(), rosbag::bagmode::Write);
  bag.write("/depth/image", stamp(0), short_image);
  bag.close();
  EXPECT_NE(refusal([&] {
              open_sequence(file, given_camera())->read(0);
            }).find("an image of 8×100000 16UC1 pixels"),
            std::string::npos);
}

TEST_F(RosBag, FilesAreCheckedAsTheirBytesAre) {
  write([](int i) { return depth_16(i); }, color("rgb8"));
  const std::string bytes = read_text(file);
  for (const std::size_t kept :
       {std::size_t{0}, std::size_t{20}, bytes.size() / 2, bytes.size() - 1}) {
    const std::string cut = bytes.substr(0, kept);
    write_text(file, cut);
    EXPECT_EQ(refusal([&] { require_sound_bag(file); }),
              refusal([&] { require_sound_bag(cut, file.string()); }));
  }
}

TEST_F(RosBag, DamagedBagsAreReadOrRefused) {
  write([](int i) { return depth_16(i); }, color("rgb8"));
  const std::string bytes = read_text(file);
  EXPECT_NO_THROW(require_sound_bag(bytes, "x"));
  EXPECT_NO_THROW(require_sound_bag(file));
  EXPECT_EQ(damage(
                bytes, [](std::string_view cut) { require_sound_bag(cut, "x"); }, 500, 500),
            0);
  damage(
      bytes,
      [&](std::string_view damaged) {
        write_text(file, std::string(damaged));
        const auto sequence = open_sequence(file, given_camera());
        for (std::size_t i = 0; i < sequence->size(); ++i) sequence->read(i);
      },
      100, 700);
}

#endif

}  // namespace
}  // namespace symscene
