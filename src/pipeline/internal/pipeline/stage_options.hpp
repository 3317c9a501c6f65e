#pragma once

#include "segmentation/removal.hpp"
#include "segmentation/workspace.hpp"
#include "symscene/pipeline/pipeline_options.hpp"

namespace symscene {

/// The options of stages that take theirs from several groups of the pipeline's options.
WorkspaceOptions workspace_options(const PipelineOptions& options);
RemovalOptions removal_options(const PipelineOptions& options);

}  // namespace symscene
