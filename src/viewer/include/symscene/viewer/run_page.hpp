#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// What a solid of a recorded run is; it decides how the page draws the solid.
enum class RecordedKind { robot, hand, object, bin, table };

/// How an event ended. `success`: an object was put into the bin, or all of them were. `failure`:
/// an attempt failed, or an object was lost. `note`: anything else.
enum class RecordedOutcome { note, success, failure };

/// The names of kinds and outcomes in the page's data.
const char* to_string(RecordedKind kind);
const char* to_string(RecordedOutcome outcome);

/// A rigid body of a run.
struct RecordedSolid {
  std::string name;
  TriangleMesh mesh;  ///< in the solid's own frame [m]; may be empty
  RecordedKind kind = RecordedKind::object;
};

/// An object as the robot believes it to be.
struct BelievedObject {
  std::string name;
  TriangleMesh mesh;  ///< completed surface in the frame of the table [m]; may be empty
  std::string label;  ///< shown at the object
};

/// All objects that the robot believes to be there, from `time` [s] until the next belief.
struct RecordedBelief {
  double time = 0.0;
  std::vector<BelievedObject> objects;
};

struct RecordedEvent {
  double time = 0.0;  ///< [s]
  std::string text;
  RecordedOutcome outcome = RecordedOutcome::note;
};

/// A run of picks. The frame of the table has z up; the table is near z = 0.
struct RunRecording {
  std::vector<RecordedSolid> solids;
  std::vector<double> times;  ///< of the moments, never falling; none if the run never began [s]
  std::vector<std::vector<Eigen::Isometry3d>> poses;  ///< [moment][solid]: T_table_solid
  std::vector<RecordedBelief> beliefs;                ///< with times that never fall
  std::vector<RecordedEvent> events;                  ///< with times that never fall
  std::vector<std::string> left;  ///< a sentence per true object that was left, with the reason
};

/// A self-contained HTML page that plays the run: the robot among the true objects beside the robot
/// among the objects that it believes in. It needs no other file and no network. Texts are escaped.
/// Large meshes are thinned. Positions are kept within 0.1 mm, rotations within 0.1 mrad.
/// Throws InputError if there is not one pose per moment and solid, times fall, or a time, a pose
/// or a vertex is not finite.
std::string render_run_page(const RunRecording& recording, const std::string& title);

/// Writes render_run_page() to a file. A reader sees the old file or the new one, never a part.
/// Throws InputError as render_run_page() does, and if the file cannot be written.
void write_run_page(const std::filesystem::path& path, const RunRecording& recording,
                    const std::string& title);

}  // namespace symscene
