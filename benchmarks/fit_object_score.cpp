// Fits the probability that a proposal is an object to datasets with truth: see README.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>

#include "boosted_trees.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/random.hpp"
#include "symscene/dataset/dataset_folder.hpp"
#include "symscene/evaluation/mask_measures.hpp"
#include "symscene/io/atomic_file.hpp"
#include "symscene/pipeline/object_score.hpp"
#include "symscene/pipeline/proposals.hpp"
#include "symscene/pipeline/selection.hpp"

namespace symscene::bench {
namespace {

struct Arguments {
  std::vector<std::filesystem::path> datasets;
  std::filesystem::path output;
  BoostingOptions boosting;
  double half_right = 0.35;  ///< target of a proposal with an IoU between 0.75 and 0.9
  std::vector<std::string> without;
  std::vector<double> beliefs{0.5};  ///< in the confidence of cuts, to compare
  std::vector<double> noise{0.0};    ///< of normals, each scene once with each [degrees]
};

/// What a scene proposes, and what it should have.
struct ScoredScene {
  std::size_t dataset = 0;
  std::vector<PointIndices> truth;
  std::vector<SceneObject> objects;
  std::vector<Sample> samples;      ///< one an object
  std::vector<double> confidences;  ///< of the cuts, one an object
};

double target_of(const std::vector<PointIndices>& truth, const PointIndices& points,
                 double half_right) {
  double best = 0.0;
  for (const PointIndices& mask : truth)
    best = std::max(best, intersection_over_union(mask, points));
  return best > 0.9 ? 1.0 : best > 0.75 ? half_right : 0.0;
}

/// The cloud as a worse sensor would have it: normals turned at random, alike within a centimetre,
/// as the noise of a depth image is, and points off the surface in proportion.
PointCloud with_noise(PointCloud cloud, double degrees, std::uint64_t seed) {
  constexpr double cell = 0.01;               // [m]
  constexpr double offset_per_degree = 1e-4;  // [m]
  const auto sigma = static_cast<float>(radians(degrees));
  if (!cloud.has_normals()) return cloud;
  for (Index i = 0; i < cloud.size() && sigma > 0.0F; ++i) {
    const Eigen::Vector3d at = (cloud.position(i).cast<double>() / cell).array().floor();
    const auto key = static_cast<std::uint64_t>((at.x() * 73856093.0) + (at.y() * 19349663.0) +
                                                (at.z() * 83492791.0) + 1e12);
    Random shared(key, seed), own(i, seed + 1);
    const auto turn = [&](Random& random) {
      return Eigen::Vector3f(static_cast<float>(random.normal()),
                             static_cast<float>(random.normal()),
                             static_cast<float>(random.normal()));
    };
    const Eigen::Vector3f n =
        (cloud.normal(i) + sigma * (turn(shared) + 0.5F * turn(own))).normalized();
    const auto off = static_cast<float>(degrees * offset_per_degree * shared.normal());
    cloud.positions.row(i) += off * cloud.normals.row(i);
    cloud.normals.row(i) = n.transpose();
  }
  return cloud;
}

ScoredScene load(const DatasetEntry& entry, std::size_t dataset, double noise,
                 const Arguments& arguments) {
  LoadedEntry loaded = load_entry(entry);
  loaded.scene.cloud = with_noise(std::move(loaded.scene.cloud), noise, dataset);
  ScoredScene scene;
  scene.dataset = dataset;
  SceneProposals proposals = propose_objects(loaded.scene);
  scene.truth = transfer_masks(loaded.scene.cloud, loaded.truth, proposals.cloud);
  for (ObjectProposal& proposal : proposals.objects) {
    Sample sample;
    ObjectMeasures::visit_fields(proposal.measures, [&](const std::string& name, double value) {
      const bool left_out = std::find(arguments.without.begin(), arguments.without.end(), name) !=
                            arguments.without.end();
      sample.features.push_back(left_out ? 0.0 : value);
    });
    sample.target = target_of(scene.truth, proposal.object.points, arguments.half_right);
    scene.samples.push_back(std::move(sample));
    scene.confidences.push_back(proposal.measures.confidence);
    scene.objects.push_back(std::move(proposal.object));
  }
  return scene;
}

std::vector<ScoredScene> load_all(const Arguments& arguments) {
  std::vector<ScoredScene> scenes;
  for (std::size_t d = 0; d < arguments.datasets.size(); ++d) {
    for (const DatasetEntry& entry : read_dataset(arguments.datasets[d]).entries) {
      for (const double noise : arguments.noise) scenes.push_back(load(entry, d, noise, arguments));
      fmt::print(stderr, "\r{} scenes", scenes.size());
    }
  }
  fmt::print(stderr, "\n");
  return scenes;
}

/// Counts at one least probability.
struct Counts {
  Score over_90, over_75;
};

Counts count(const std::vector<ScoredScene>& scenes, const SelectionOptions& options) {
  Counts counts;
  for (const ScoredScene& scene : scenes) {
    std::vector<Rejection> rejected;
    std::vector<PointIndices> masks;
    for (const SceneObject& object : select_probable(scene.objects, options, rejected))
      masks.push_back(object.points);
    const OverlapMatrix overlaps = overlap_matrix(scene.truth, masks);
    counts.over_90 += mask_score(overlaps, 0.9);
    counts.over_75 += mask_score(overlaps, 0.75);
  }
  return counts;
}

void print_curve(const std::vector<ScoredScene>& scenes) {
  fmt::print("min score   P .9   R .9   F .9   F .75\n");
  for (int k = 1; k <= 12; ++k) {
    SelectionOptions options;
    options.min_score = 0.05 * k;
    const Counts counts = count(scenes, options);
    fmt::print("{:9.2f}  {:.3f}  {:.3f}  {:.3f}   {:.3f}\n", options.min_score,
               counts.over_90.precision(), counts.over_90.recall(), counts.over_90.f_measure(),
               counts.over_75.f_measure());
  }
}

void print_ceiling(const std::vector<ScoredScene>& scenes) {
  std::size_t truth = 0, proposals = 0, reached = 0;
  for (const ScoredScene& scene : scenes) {
    truth += scene.truth.size();
    proposals += scene.objects.size();
    for (const PointIndices& mask : scene.truth) {
      reached += std::any_of(scene.objects.begin(), scene.objects.end(),
                             [&](const auto& object) {
                               return intersection_over_union(mask, object.points) > 0.9;
                             })
                     ? 1
                     : 0;
    }
  }
  fmt::print("{} scenes, {} objects, {} of them proposed (IoU > 0.9), {} proposals\n",
             scenes.size(), truth, reached, proposals);
}

std::vector<Sample> samples_of(const std::vector<ScoredScene>& scenes, std::size_t left_out) {
  std::vector<Sample> samples;
  for (const ScoredScene& scene : scenes) {
    if (scene.dataset != left_out)
      samples.insert(samples.end(), scene.samples.begin(), scene.samples.end());
  }
  return samples;
}

void rescore(const BoostedTrees& model, double belief, ScoredScene& scene) {
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    scene.objects[k].score =
        combined_score(model.probability(scene.samples[k].features), scene.confidences[k], belief);
  }
}

/// Every dataset with trees that were fitted to the others.
void cross_validate(std::vector<ScoredScene> scenes, const Arguments& arguments) {
  std::vector<BoostedTrees> models;
  for (std::size_t d = 0; d < arguments.datasets.size(); ++d)
    models.push_back(fit_trees(samples_of(scenes, d), arguments.boosting));
  for (const double belief : arguments.beliefs) {
    for (ScoredScene& scene : scenes) rescore(models[scene.dataset], belief, scene);
    fmt::print("each dataset scored by the others, belief {}:\n", belief);
    print_curve(scenes);
  }
  for (std::size_t d = 0; d < arguments.datasets.size(); ++d) {
    std::vector<ScoredScene> own;
    std::copy_if(scenes.begin(), scenes.end(), std::back_inserter(own),
                 [&](const ScoredScene& scene) { return scene.dataset == d; });
    fmt::print("{}:\n", arguments.datasets[d].filename().string());
    print_curve(own);
  }
}

/// How much each measure's questions gain is told by how often it is asked.
void print_use(const BoostedTrees& model) {
  std::vector<std::size_t> asked(ObjectMeasures::count);
  for (const Tree& tree : model.trees) {
    for (const TreeNode& node : tree) {
      if (node.feature >= 0) ++asked[static_cast<std::size_t>(node.feature)];
    }
  }
  std::size_t next = 0;
  const ObjectMeasures none;
  ObjectMeasures::visit_fields(
      none, [&](const char* name, double) { fmt::print("{} {}, ", name, asked[next++]); });
  fmt::print("\n");
}

std::string as_table(const BoostedTrees& model) {
  std::string text = fmt::format(
      "// Written by symscene_fit_object_score.\nconstexpr float object_score_base = {:.6f}F;\n",
      model.base);
  std::string roots, nodes;
  std::size_t count = 0;
  for (const Tree& tree : model.trees) {
    roots += fmt::format("{}{},", count % 16 == 0 ? "\n    " : " ", count);
    for (const TreeNode& node : tree) {
      const double value = node.feature >= 0 ? double{node.bound} : node.value;
      nodes += fmt::format("    {{{}, {}, {:#.9g}F}},\n", node.feature, node.right, value);
    }
    count += tree.size();
  }
  text += "constexpr std::int32_t object_score_roots[] = {" + roots + "\n};\n";
  text += "constexpr TreeNode object_score_nodes[] = {\n" + nodes + "};\n";
  return text;
}

void run(const Arguments& arguments) {
  std::vector<ScoredScene> scenes = load_all(arguments);
  print_ceiling(scenes);
  fmt::print("as it is:\n");
  print_curve(scenes);
  if (arguments.datasets.size() > 1) cross_validate(scenes, arguments);
  const BoostedTrees model =
      fit_trees(samples_of(scenes, arguments.datasets.size()), arguments.boosting);
  print_use(model);
  if (!arguments.output.empty()) write_file_atomically(arguments.output, as_table(model));
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{"Fits the probability that a proposal is an object to datasets with truth."};
  app.add_option("datasets", arguments.datasets, "datasets of the tune split")->required();
  app.add_option("-o,--output", arguments.output,
                 "table to write: src/pipeline/object_score_trees.inc");
  app.add_option("--rounds", arguments.boosting.rounds, "trees")->capture_default_str();
  app.add_option("--depth", arguments.boosting.depth, "questions in a row")->capture_default_str();
  app.add_option("--rate", arguments.boosting.rate, "share of a step")->capture_default_str();
  app.add_option("--min-leaf", arguments.boosting.min_leaf, "samples")->capture_default_str();
  app.add_option("--half-right", arguments.half_right, "target for an IoU from 0.75 to 0.9")
      ->capture_default_str();
  app.add_option("--noise", arguments.noise, "of normals: each scene once with each [degrees]");
  app.add_option("--beliefs", arguments.beliefs, "in the confidence of cuts, to compare");
  app.add_option("--without", arguments.without, "measures to leave out");
  CLI11_PARSE(app, argc, argv);
  try {
    symscene::bench::run(arguments);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "symscene_fit_object_score: %s\n", error.what());
    return 1;
  }
}
