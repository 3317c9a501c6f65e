# What drops meshes on the table: MuJoCo, and HACD from Bullet's extras. Without them everything else is built.
# MuJoCo's own CMake package names folders that Debian does not install.
find_library(SYMSCENE_MUJOCO_LIBRARY mujoco)
find_path(SYMSCENE_MUJOCO_INCLUDE mujoco/mujoco.h)
find_library(SYMSCENE_HACD_LIBRARY HACD)
find_path(SYMSCENE_HACD_INCLUDE bullet/HACD/hacdHACD.h)
mark_as_advanced(SYMSCENE_MUJOCO_LIBRARY SYMSCENE_MUJOCO_INCLUDE SYMSCENE_HACD_LIBRARY SYMSCENE_HACD_INCLUDE)

set(SYMSCENE_PHYSICS OFF)
set(SYMSCENE_PHYSICS_LIBRARIES "")
if(SYMSCENE_MUJOCO_LIBRARY AND SYMSCENE_MUJOCO_INCLUDE AND SYMSCENE_HACD_LIBRARY AND SYMSCENE_HACD_INCLUDE)
  set(SYMSCENE_PHYSICS ON)
  set(SYMSCENE_PHYSICS_LIBRARIES ${SYMSCENE_MUJOCO_LIBRARY} ${SYMSCENE_HACD_LIBRARY})
else()
  message(STATUS "Without physics: libmujoco-dev and libbullet-extras-dev would add it")
endif()
