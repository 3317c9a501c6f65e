# Sets SYMSCENE_ROSBAG_LIBRARIES and _INCLUDES to what reading ROS 1 bags needs, or to nothing where it is not
# installed. ROS' own package configurations require packages that reading does not need: this looks for the files.
include(SymsceneCompiles)

option(SYMSCENE_WITH_ROSBAG "Read ROS 1 bags where librosbag-storage is installed" ON)

# symscene_find_rosbag(): sets the two lists.
function(symscene_find_rosbag)
  set(includes "")
  # librosbag's header includes these; Debian puts each in a folder of its own.
  foreach(header rosbag/view.h pluginlib/class_loader.hpp class_loader/class_loader.hpp
      ament_index_cpp/get_package_prefix.hpp rcpputils/shared_library.hpp rcutils/shared_library.h)
    get_filename_component(package ${header} DIRECTORY)
    find_path(SYMSCENE_INCLUDE_${package} ${header} PATH_SUFFIXES ${package})
    mark_as_advanced(SYMSCENE_INCLUDE_${package})
    if(SYMSCENE_INCLUDE_${package})
      list(APPEND includes ${SYMSCENE_INCLUDE_${package}})
    endif()
  endforeach()
  set(libraries "")
  foreach(library rosbag_storage roscpp_serialization rostime cpp_common console_bridge)
    find_library(SYMSCENE_LIBRARY_${library} ${library})
    mark_as_advanced(SYMSCENE_LIBRARY_${library})
    list(APPEND libraries ${SYMSCENE_LIBRARY_${library}})
  endforeach()
  list(REMOVE_DUPLICATES includes)
  set(SYMSCENE_ROSBAG_INCLUDES ${includes} PARENT_SCOPE)
  set(SYMSCENE_ROSBAG_LIBRARIES ${libraries} PARENT_SCOPE)
endfunction()

set(SYMSCENE_ROSBAG_LIBRARIES "")
if(SYMSCENE_WITH_ROSBAG)
  symscene_find_rosbag()
  symscene_check_compiles(SYMSCENE_ROSBAG_WORKS
    "#include <rosbag/bag.h>\n#include <rosbag/view.h>\nint main() { rosbag::Bag bag; rosbag::View view(bag); }"
    INCLUDES ${SYMSCENE_ROSBAG_INCLUDES} LIBRARIES ${SYMSCENE_ROSBAG_LIBRARIES})
endif()
if(NOT SYMSCENE_WITH_ROSBAG OR NOT SYMSCENE_ROSBAG_WORKS)
  set(SYMSCENE_ROSBAG_LIBRARIES "")
  message(STATUS "No reader of ROS bags: librosbag-storage-dev not found or disabled")
endif()
