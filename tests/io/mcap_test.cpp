// Recordings of ROS 2 in MCAP, and MCAP files of results.
#include "symscene/io/mcap.hpp"

#include "io/compression.hpp"
#include "io/mcap_reader.hpp"
#include "io/recording.hpp"
#include "io/recording_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

class Mcap : public ::testing::Test {
 protected:
  std::unique_ptr<DepthSequence> opened(const std::string& bytes,
                                        const SequenceOptions& options = {}) const {
    write_text(file, bytes);
    return open_sequence(file, options);
  }
  std::string refused(const std::string& bytes) const {
    return refusal([&] { opened(bytes); });
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file = folder_ / "table.mcap";
};

std::vector<McapCompression> compressions() {
  std::vector<McapCompression> all{McapCompression::none};
  if (has_lz4()) all.push_back(McapCompression::lz4);
  if (has_zstd()) all.push_back(McapCompression::zstd);
  return all;
}

TEST_F(Mcap, DepthImagesOfRos2AreReadFromChunksOfEachCompression) {
  for (const McapCompression compression : compressions()) {
    const auto sequence = opened(mcap_of(small_recording(), "cdr", compression));
    EXPECT_EQ(sequence->layout(), "MCAP");
    expect_small_recording(*sequence);
  }
}

TEST_F(Mcap, ASequenceThatIsWrittenIsReadBack) {
  SequenceWriter writer(folder_ / "sweep", small_camera());
  for (int i = 0; i < 3; ++i) {
    const Eigen::Isometry3d pose = small_pose(i);
    writer.add(small_frame(i), &pose);
  }
  writer.finish();
  const auto written = open_sequence(folder_ / "sweep");
  const auto read = opened(format_sequence_mcap(*written));
  ASSERT_EQ(read->size(), 3U);
  for (int i = 0; i < 3; ++i) {
    const auto frame = static_cast<std::size_t>(i);
    expect_same_frame(read->read(frame), small_frame(i), 1e-6);
    ASSERT_TRUE(read->pose(frame));
    EXPECT_TRUE(read->pose(frame)->isApprox(*written->pose(frame), 1e-9));
  }
}

TEST_F(Mcap, MessagesOfRos1AreReadToo) {
  // The same fields without alignment, encapsulation and zeros behind strings.
  const auto put = [](std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255U);
  };
  std::string image;
  for (const std::uint32_t value : {0U, 100U, 0U, 3U}) put(image, value);
  image += "cam";
  put(image, frame_size.height);
  put(image, frame_size.width);
  put(image, 5);
  image += "16UC1";
  image += '\0';
  put(image, 2 * frame_size.width);
  const std::string pixels = depth_bytes_of(0);
  put(image, static_cast<std::uint32_t>(pixels.size()));
  image += pixels;
  const auto sequence =
      opened(mcap_of({{"/depth/image", "sensor_msgs/Image", 100 * second, image}}, "ros1"),
             given_camera());
  expect_same_frame(sequence->read(0), small_frame(0, false), 1e-6);
}

TEST_F(Mcap, CompressedDepthInMillimetresIsThatOfItsPng) {
  const std::string topic = "/camera/depth/image_raw/compressedDepth";
  const auto sequence =
      opened(mcap_of({camera_info_beside("/camera/depth/camera_info"),
                      compressed_image(0, topic, "16UC1; compressedDepth",
                                       depth_config(0.0F, 0.0F) + small_depth_png(0))}));
  EXPECT_EQ(sequence->camera().fx, 10.0);
  expect_same_frame(sequence->read(0), small_frame(0, false), 1e-6);
}

TEST_F(Mcap, CompressedDepthInMetresIsTheQuantisedInverse) {
  const float a = 4000.0F;
  const float b = -500.0F;
  DepthImage quantised{frame_size, {}};
  DepthFrame expected = small_frame(0, false);
  for (float& depth : expected.depth) {
    const auto value = static_cast<std::uint16_t>(depth > 0.0F ? std::lround(a / depth + b) : 0);
    quantised.values.push_back(value);
    depth = value > 0 ? a / (static_cast<float>(value) - b) : 0.0F;
  }
  const auto sequence =
      opened(mcap_of({compressed_image(0, "/depth/compressedDepth", "32FC1; compressedDepth png",
                                       depth_config(a, b) + format_png(quantised))}),
             given_camera());
  expect_same_frame(sequence->read(0), expected, 1e-6);
}

TEST_F(Mcap, CompressedColourBelongsToTheDepthOfItsFrame) {
  TestMessages messages = small_recording();
  messages.push_back(compressed_image(0, "/camera/color/image_raw/compressed",
                                      "rgb8; png compressed bgr8",
                                      format_png(color_ramp(frame_size))));
  const auto sequence = opened(mcap_of(messages));
  EXPECT_TRUE(sequence->has_color(0));
  expect_same_frame(sequence->read(0), small_frame(0), 1e-6);
}

TEST_F(Mcap, ATopicWhoseCompressionIsNotReadIsLeftOut) {
  TestMessages messages = small_recording();
  messages.push_back(compressed_image(0, "/camera/depth/image_raw/compressedDepth",
                                      "16UC1; compressedDepth rvl", depth_config(0, 0) + "rvl"));
  const auto sequence = opened(mcap_of(messages));
  EXPECT_TRUE(sequence->warnings().empty());
  expect_small_recording(*sequence);
}

TEST_F(Mcap, PosesAreThoseOfTfBetweenItsTransforms) {
  TestMessages messages = small_recording();
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()));
  // The arm moves by 1 m in the 80 ms of the three frames; the camera is fixed to it.
  messages.push_back(transform("/tf", time_of(0), "base", "hand", {0, 0, 0}));
  messages.push_back(transform("/tf", time_of(2), "base", "hand", {1, 0, 0}));
  messages.push_back(transform("/tf_static", 0, "/hand", "/camera", {0, 2, 0}, turned));
  const auto sequence = opened(mcap_of(messages));
  for (int i = 0; i < 3; ++i) {
    const auto pose = sequence->pose(static_cast<std::size_t>(i));
    ASSERT_TRUE(pose);
    Eigen::Isometry3d expected =
        Eigen::Translation3d(0.5 * i, 2.0, 0.0) * Eigen::Isometry3d(turned);
    EXPECT_TRUE(pose->isApprox(expected, 1e-6)) << pose->matrix();
  }
}

TEST_F(Mcap, StaticTransformsAloneDoNotTellHowACameraMoves) {
  TestMessages messages = small_recording();
  messages.push_back(transform("/tf_static", 0, "base", "camera", {0, 2, 0}));
  EXPECT_FALSE(opened(mcap_of(messages))->pose(0));
  messages.back() = transform("/tf", time_of(0), "camera", "camera", {0, 2, 0});  // a loop
  EXPECT_FALSE(opened(mcap_of(messages))->pose(0));
}

TEST_F(Mcap, MessagesInCdrOfEitherByteOrderAreEqual) {
  const std::string little = depth_image(0).data;
  std::string big("\0\0\0\0", 4);
  const auto put = [&](std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) big += static_cast<char>(value >> shift & 255U);
  };
  put(100), put(0), put(7), big += std::string("camera\0", 7) + '\0';
  put(frame_size.height), put(frame_size.width), put(6), big += std::string("16UC1\0\0\0", 8);
  put(2 * frame_size.width);
  const std::string pixels = depth_bytes_of(0);
  put(static_cast<std::uint32_t>(pixels.size()));
  big += pixels;
  const auto sequence = opened(
      mcap_of({{"/depth/image", "sensor_msgs/msg/Image", 100 * second, big}}), given_camera());
  expect_same_frame(sequence->read(0), small_frame(0, false), 1e-6);
}

TEST_F(Mcap, OtherRepresentationsAreRefused) {
  TestMessages messages = small_recording();
  messages[1].data[1] = 7;  // XCDR2
  EXPECT_EQ(refused(mcap_of(messages)),
            file.string() +
                ": expected a message sensor_msgs/Image, found the representation 0007 in place of "
                "CDR's 0000 or 0001");
}

TEST_F(Mcap, FilesThatAreNotWholeAreRefused) {
  EXPECT_EQ(refused("text"), file.string() + ": expected a whole MCAP file, found \"text\"");
  const std::string whole = mcap_of(small_recording());
  EXPECT_EQ(refused(whole.substr(0, whole.size() - 8)),
            file.string() + ": expected a whole MCAP file, found no magic bytes at its end");
  EXPECT_NE(refused(whole.substr(0, whole.size() / 2)).find("`mcap recover` repairs"),
            std::string::npos);
  std::string other = mcap_of(small_recording());
  other[other.find("16UC1")] = '3';
  EXPECT_NE(refused(other).find("a chunk with another checksum"), std::string::npos);
}

TEST_F(Mcap, AChunkThatClaimsToBeLargeIsRefusedBeforeMemoryIsTaken) {
  if (!has_zstd()) GTEST_SKIP() << "needs libzstd-dev";
  std::string file_bytes = mcap_of(small_recording(), "cdr", McapCompression::zstd);
  const std::size_t head = 8 + 9 + (4 + 4 + 4 + 8);  // magic and header, with "ros2" and "symscene"
  const std::size_t size_at = head + 9 + 16;
  file_bytes.replace(size_at, 8, std::string("\0\0\0\0\1\0\0\0", 8));
  EXPECT_NE(refused(file_bytes).find("a chunk of more than 256 MiB"), std::string::npos);
  file_bytes.replace(size_at, 8, std::string("\0\0\0\x0f\0\0\0\0", 8));
  EXPECT_NE(refused(file_bytes).find("a whole Zstandard frame"), std::string::npos);
}

TEST(McapFiles, DamagedOnesAreReadOrRefused) {
  for (const McapCompression compression : compressions()) {
    const std::string bytes = mcap_of(small_recording(), "cdr", compression);
    const int accepted = damage(
        bytes,
        [](std::string_view damaged) {
          const RecordingPointer recording = open_mcap_recording(damaged, "x");
          for (const RecordedTopic& topic : recording->topics()) {
            for (const RecordedMessage& message : recording->messages(topic.name)) {
              recording->bytes(message);
            }
          }
        },
        300, 500);
    EXPECT_EQ(accepted, 0);
  }
}

TEST(McapOfResult, HoldsTheCloudItsObjectsAndTheirPoses) {
  SegmentationResult result;
  result.cloud = random_cloud(5, 1);
  SceneObject object;
  object.points = {1, 3};
  object.score = 0.5;
  object.rotational = {{RotationAxis{}, 0.0}};
  object.reflectional = {{ReflectionPlane{}, 0.0}};
  object.box = ObjectBox{};
  result.objects = {object};
  result.surfaces.resize(1);
  const std::string bytes = format_result_mcap(result);
  McapReader reader(std::make_unique<BytesInMemory>(bytes), "x");
  std::map<std::string, std::string> text;
  for (const McapMessage& message : reader.messages()) {
    text[reader.channels().at(message.channel).topic] = reader.data(message);
  }
  ASSERT_EQ(text.size(), 4U);
  EXPECT_NE(text["/cloud"].find("\"point_stride\":18"), std::string::npos);
  EXPECT_NE(text["/objects"].find("\"text\":\"0: 0.50\""), std::string::npos);
  EXPECT_NE(text["/symmetries"].find("\"id\":\"symmetries_0\""), std::string::npos);
  EXPECT_NE(text["/poses"].find("\"poses\":[{\"position\":{\"x\":0.0"), std::string::npos);
}

}  // namespace
}  // namespace symscene
