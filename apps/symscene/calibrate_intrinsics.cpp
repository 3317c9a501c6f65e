#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "calibrate.hpp"
#include "io/atomic_file.hpp"
#include "models.hpp"
#include "session.hpp"
#include "symscene/io/camera_file.hpp"
#include "symscene/io/image.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

/// The images in which the board was found, all of one size.
struct BoardImages {
  ImageSize size;
  std::vector<BoardImage> found;
  std::vector<std::string> missing;  ///< names of those without the board, and why
  std::vector<std::size_t> numbers;  ///< per found image its number among all
};

bool is_image(const fs::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

/// Images as named, and those in folders by name.
std::vector<fs::path> image_files(const std::vector<fs::path>& paths) {
  std::vector<fs::path> files;
  for (const fs::path& path : paths) {
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    std::vector<fs::path> inside;
    for (const auto& entry : fs::directory_iterator(path)) {
      if (is_image(entry.path())) inside.push_back(entry.path());
    }
    if (inside.empty()) throw InputError(path.string(), "images (.png, .jpg)", "none");
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

void require_same_size(const ColorImage& image, const BoardImages& images, const fs::path& file) {
  if (image.size == images.size) return;
  throw InputError(file.string(),
                   fmt::format("{}×{} pixels like the images before it (calibrate each resolution "
                               "by itself)",
                               images.size.width, images.size.height),
                   fmt::format("{}×{}", image.size.width, image.size.height));
}

struct CalibrateIntrinsics {
  SharedOptions shared;
  IntrinsicCalibrationOptions options;
  std::vector<fs::path> paths;
  fs::path color;
  fs::path page;
  BoardArguments board_arguments;

  OptionFields configure() { return configure_options(options, shared.config); }

  static BoardImages find_boards(const std::vector<fs::path>& files, const BoardTarget& target,
                                 Session& session) {
    BoardImages images;
    for (std::size_t i = 0; i < files.size(); ++i) {
      session.on_begin()(fmt::format("image {} of {}", i + 1, files.size()));
      const ColorImage image = read_color_image(files[i]);
      if (i == 0) images.size = image.size;
      require_same_size(image, images, files[i]);
      CharucoView view =
          target.find(grey_values(image.pixels), image.size.width, image.size.height);
      const std::string name = files[i].filename().string();
      if (!view.is_found()) {
        images.missing.push_back(fmt::format("{} ({})", name, view.reason));
        continue;
      }
      view.image.name = name;
      images.found.push_back(std::move(view.image));
      images.numbers.push_back(i);
    }
    // Boards that are partly covered look smaller: only if no image shows the one that was named.
    if (images.found.empty()) refuse_other(files, target);
    return images;
  }

  /// Throws InputError if an image shows another board than the one that was named.
  static void refuse_other(const std::vector<fs::path>& files, const BoardTarget& target) {
    for (const fs::path& file : files) {
      const ColorImage image = read_color_image(file);
      const std::vector<std::uint8_t> grey = grey_values(image.pixels);
      const CharucoView view = target.find(grey, image.size.width, image.size.height);
      target.refuse_other(grey, image.size.width, image.size.height, view);
    }
  }

  static IntrinsicCalibration calibrate(const BoardImages& images, const Board& board,
                                        const IntrinsicCalibrationOptions& options,
                                        Session& session) {
    if (!images.missing.empty())
      session.warn(fmt::format("the board is not found in {} of {} images, such as {}",
                               images.missing.size(), images.missing.size() + images.found.size(),
                               images.missing.front()));
    IntrinsicCalibration found =
        calibrate_intrinsics(images.found, images.size.width, images.size.height, board, options);
    for (const BoardViewReport& view : found.views) {
      if (!view.used) session.warn(fmt::format("{} is left out: {}", view.name, view.reason));
    }
    session.warn(found.warnings);
    return found;
  }

  static void print(const char* camera, const IntrinsicCalibration& found, Session& session) {
    const CameraIntrinsics& K = found.camera.intrinsics;
    const auto used = std::count_if(found.views.begin(), found.views.end(),
                                    [](const BoardViewReport& view) { return view.used; });
    session.print_line(fmt::format(
        "{}: fx {:.2f} ± {:.2f}, fy {:.2f}, cx {:.2f}, cy {:.2f} ± {:.2f} px; reprojection error "
        "{:.3f} px in {} images; corners in {:.0f} % of the image",
        camera, K.fx, found.focal_deviation, K.fy, K.cx, K.cy, found.center_deviation, found.error,
        used, 100.0 * found.coverage));
  }

  /// The pose of the colour camera, by the images of both that have one number and show the board.
  static ColorPose color_pose(const BoardImages& depth, const IntrinsicCalibration& depth_found,
                              const BoardImages& color, const IntrinsicCalibration& color_found,
                              const Board& board) {
    std::vector<BoardImage> first, second;
    for (std::size_t i = 0; i < depth.found.size(); ++i) {
      const auto same = std::find(color.numbers.begin(), color.numbers.end(), depth.numbers[i]);
      if (same == color.numbers.end()) continue;
      const auto k = static_cast<std::size_t>(same - color.numbers.begin());
      if (!depth_found.views[i].used || !color_found.views[k].used) continue;
      first.push_back(depth.found[i]);
      second.push_back(color.found[k]);
    }
    return calibrate_color_pose(first, second, depth_found.camera, color_found.camera, board);
  }

  void run() {
    configure();
    const BoardTarget target = board_arguments.target();
    target.require_finder();
    const Board& board = target.board;
    Session session("calibrate intrinsics", shared);
    StageTimer timer(session.on_begin());
    const std::vector<fs::path> files = image_files(paths);
    const std::vector<fs::path> color_files =
        color.empty() ? std::vector<fs::path>() : image_files({color});
    if (!color.empty() && files.size() != color_files.size())
      throw InputError(color.string(),
                       fmt::format("{} images, one per image of the depth camera", files.size()),
                       fmt::format("{}", color_files.size()));
    const BoardImages images =
        timer.time("find boards", [&] { return find_boards(files, target, session); });
    IntrinsicCalibration found =
        timer.time("calibrate", [&] { return calibrate(images, board, options, session); });
    print("camera", found, session);
    if (!color_files.empty()) {
      const BoardImages beside = timer.time(
          "find boards in colour", [&] { return find_boards(color_files, target, session); });
      const IntrinsicCalibration other = timer.time(
          "calibrate colour", [&] { return calibrate(beside, board, options, session); });
      print("colour camera", other, session);
      const ColorPose pose =
          timer.time("pose", [&] { return color_pose(images, found, beside, other, board); });
      const Eigen::Vector3d at = 1e3 * pose.T_depth_color.translation();
      session.print_line(fmt::format(
          "colour camera at {:.1f}, {:.1f}, {:.1f} mm, turned by {:.2f} degrees: reprojection "
          "error "
          "{:.3f} px in {} pairs",
          at.x(), at.y(), at.z(), degrees(Eigen::AngleAxisd(pose.T_depth_color.linear()).angle()),
          pose.error, pose.pairs));
      found.camera = pose.depth;
      found.camera.color =
          ColorCamera{pose.color.intrinsics, pose.color.distortion, pose.T_depth_color};
    }
    timer.time("write", [&] {
      write_file_atomically(shared.output, format_camera_model(found.camera));
      if (!page.empty()) write_file_atomically(page, intrinsics_page(found, images.found));
    });
    session.finish({{"output", shared.output}, {"images", images.found.size()}}, timer.stages());
  }
};

}  // namespace

void add_calibrate_intrinsics(CommandLine& line) {
  const auto state = std::make_shared<CalibrateIntrinsics>();
  Arguments arguments(
      line, "intrinsics",
      "Find focal lengths, centre and lens distortion by images of a checkerboard or "
      "ChArUco board",
      "symscene calibrate intrinsics infrared --board 8x6 --square 0.0245 "
      "-o camera.yaml --page camera.html\n"
      "  symscene calibrate intrinsics infrared --board 8x6 --square 0.03 --charuco "
      "DICT_5X5_50 --marker 0.022 -o camera.yaml");
  arguments.inputs(state->paths, "IMAGES",
                   "infrared or colour images of the camera, or folders of them, one resolution");
  arguments.output_file(state->shared, "camera.yaml to write");
  state->board_arguments.add_to(arguments);
  arguments.folder("--color", state->color,
                   "images of the colour camera taken at the same moments, in the same order: its "
                   "intrinsics and pose are found too");
  arguments.file("--page", state->page, "page to write: coverage and residual vectors");
  arguments.run_stages(state);
}

}  // namespace symscene::app
