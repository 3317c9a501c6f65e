# What drops meshes on the table. Without it everything else is built.
# MuJoCo's own CMake package names folders that Debian does not install.
find_library(SYMSCENE_MUJOCO_LIBRARY mujoco)
find_path(SYMSCENE_MUJOCO_INCLUDE mujoco/mujoco.h)
mark_as_advanced(SYMSCENE_MUJOCO_LIBRARY SYMSCENE_MUJOCO_INCLUDE)

set(SYMSCENE_PHYSICS_LIBRARIES "")
if(SYMSCENE_MUJOCO_LIBRARY AND SYMSCENE_MUJOCO_INCLUDE)
  set(SYMSCENE_PHYSICS_LIBRARIES ${SYMSCENE_MUJOCO_LIBRARY})
else()
  message(STATUS "Without physics: libmujoco-dev would add it")
endif()
