#pragma once

#include "segmentation/removal.hpp"
#include "segmentation/workspace.hpp"
#include "symscene/pipeline/pipeline_options.hpp"

namespace symscene {

/// What the options of the pipeline tell stages whose options are no group of their own.
WorkspaceOptions workspace_options(const PipelineOptions& options);
RemovalOptions removal_options(const PipelineOptions& options);

}  // namespace symscene
