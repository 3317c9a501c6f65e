# Sets SYMSCENE_URDF_LIBRARIES and SYMSCENE_URDF_INCLUDE to what reading URDF files needs, SYMSCENE_YAML_LIBRARIES and
# SYMSCENE_YAML_INCLUDE to what reading descriptions of robots needs, or to nothing where it is not installed.
include(SymsceneCompiles)

option(SYMSCENE_WITH_ROBOTS "Read robots where urdfdom and yaml-cpp are installed" ON)

set(SYMSCENE_URDF_LIBRARIES "")
set(SYMSCENE_YAML_LIBRARIES "")
if(SYMSCENE_WITH_ROBOTS)
  find_path(SYMSCENE_URDF_INCLUDE urdf_parser/urdf_parser.h)
  find_path(SYMSCENE_YAML_INCLUDE yaml-cpp/yaml.h)
  find_library(SYMSCENE_LIBRARY_urdfdom_model urdfdom_model)
  find_library(SYMSCENE_LIBRARY_console_bridge console_bridge)
  find_library(SYMSCENE_LIBRARY_tinyxml tinyxml)
  find_library(SYMSCENE_LIBRARY_yaml_cpp yaml-cpp)
  mark_as_advanced(SYMSCENE_URDF_INCLUDE SYMSCENE_YAML_INCLUDE SYMSCENE_LIBRARY_urdfdom_model
    SYMSCENE_LIBRARY_console_bridge SYMSCENE_LIBRARY_tinyxml SYMSCENE_LIBRARY_yaml_cpp)
  set(SYMSCENE_URDF_LIBRARIES ${SYMSCENE_LIBRARY_urdfdom_model} ${SYMSCENE_LIBRARY_console_bridge}
    ${SYMSCENE_LIBRARY_tinyxml})
  set(SYMSCENE_YAML_LIBRARIES ${SYMSCENE_LIBRARY_yaml_cpp})
  symscene_check_compiles(SYMSCENE_URDF_WORKS
    "#include <console_bridge/console.h>\n#include <tinyxml.h>\n#include <urdf_parser/urdf_parser.h>
    int main() { console_bridge::noOutputHandler(); urdf::parseURDF(\"\"); TiXmlDocument().Parse(\"\"); }"
    INCLUDES ${SYMSCENE_URDF_INCLUDE} LIBRARIES ${SYMSCENE_URDF_LIBRARIES})
  symscene_check_compiles(SYMSCENE_YAML_WORKS
    "#include <yaml-cpp/yaml.h>\nint main() { YAML::Load(\"a: 1\"); }"
    INCLUDES ${SYMSCENE_YAML_INCLUDE} LIBRARIES ${SYMSCENE_YAML_LIBRARIES})
endif()
if(NOT SYMSCENE_WITH_ROBOTS OR NOT SYMSCENE_URDF_WORKS)
  set(SYMSCENE_URDF_LIBRARIES "")
  message(STATUS "No reader of robots: liburdfdom-dev not found or disabled")
endif()
if(NOT SYMSCENE_WITH_ROBOTS OR NOT SYMSCENE_YAML_WORKS)
  set(SYMSCENE_YAML_LIBRARIES "")
  message(STATUS "No reader of robots: libyaml-cpp-dev not found or disabled")
endif()
