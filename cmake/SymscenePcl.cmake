# Sets SYMSCENE_PCL_LIBRARIES and SYMSCENE_PCL_INCLUDE to what LCCP, a baseline in the evaluation, needs, or to nothing where
# it is not installed. PCL's own package configuration looks for VTK and all else that any of its modules might use: this
# looks for the files of the modules.
include(SymsceneCompiles)

option(SYMSCENE_WITH_PCL "Compare with LCCP where PCL is installed" ON)

set(SYMSCENE_PCL_LIBRARIES "")
if(SYMSCENE_WITH_PCL)
  find_path(SYMSCENE_PCL_INCLUDE pcl/segmentation/lccp_segmentation.h
    PATH_SUFFIXES pcl-1.15 pcl-1.14 pcl-1.13 pcl-1.12)
  mark_as_advanced(SYMSCENE_PCL_INCLUDE)
  foreach(module segmentation search kdtree octree common)
    find_library(SYMSCENE_LIBRARY_pcl_${module} pcl_${module})
    mark_as_advanced(SYMSCENE_LIBRARY_pcl_${module})
    list(APPEND SYMSCENE_PCL_LIBRARIES ${SYMSCENE_LIBRARY_pcl_${module}})
  endforeach()
  symscene_check_compiles(SYMSCENE_PCL_WORKS
    "#include <pcl/point_types.h>\n#include <pcl/segmentation/lccp_segmentation.h>
    int main() { pcl::LCCPSegmentation<pcl::PointXYZRGBA> lccp; }"
    INCLUDES ${SYMSCENE_PCL_INCLUDE} ${EIGEN3_INCLUDE_DIRS}
    LIBRARIES ${SYMSCENE_PCL_LIBRARIES} Eigen3::Eigen)
endif()
if(NOT SYMSCENE_WITH_PCL OR NOT SYMSCENE_PCL_WORKS)
  set(SYMSCENE_PCL_LIBRARIES "")
  message(STATUS "No LCCP to compare with: libpcl-dev not found or disabled")
endif()
