# Sets SYMSCENE_FCL_LIBRARIES and SYMSCENE_FCL_INCLUDE to what tests of collision compare with, or the libraries to
# nothing where FCL is not installed.
include(SymsceneCompiles)

find_path(SYMSCENE_FCL_INCLUDE fcl/narrowphase/distance.h)
set(SYMSCENE_FCL_LIBRARIES "")
foreach(name fcl ccd)
  find_library(SYMSCENE_LIBRARY_${name} ${name})
  mark_as_advanced(SYMSCENE_LIBRARY_${name})
  list(APPEND SYMSCENE_FCL_LIBRARIES ${SYMSCENE_LIBRARY_${name}})
endforeach()
mark_as_advanced(SYMSCENE_FCL_INCLUDE)
symscene_check_compiles(SYMSCENE_FCL_WORKS
  "#include <fcl/narrowphase/distance.h>
  int main() { fcl::Boxd box(1.0, 1.0, 1.0); return box.side.x() > 2.0; }"
  INCLUDES ${SYMSCENE_FCL_INCLUDE} ${EIGEN3_INCLUDE_DIRS}
  LIBRARIES ${SYMSCENE_FCL_LIBRARIES} Eigen3::Eigen)
if(NOT SYMSCENE_FCL_WORKS)
  set(SYMSCENE_FCL_LIBRARIES "")
  message(STATUS "Collisions are not compared with FCL's: libfcl-dev not found")
endif()
