# Sets SYMSCENE_GIF_LIBRARIES and SYMSCENE_GIF_INCLUDE to what videos of runs need, or to nothing where it is not installed.
include(SymsceneCompiles)

find_path(SYMSCENE_GIF_INCLUDE gif_lib.h)
find_library(SYMSCENE_LIBRARY_gif gif)
mark_as_advanced(SYMSCENE_GIF_INCLUDE SYMSCENE_LIBRARY_gif)
symscene_check_compiles(SYMSCENE_GIF_WORKS
  "#include <gif_lib.h>\nint main() { int error = 0; EGifOpen(nullptr, nullptr, &error); }"
  INCLUDES ${SYMSCENE_GIF_INCLUDE} LIBRARIES ${SYMSCENE_LIBRARY_gif})
set(SYMSCENE_GIF_LIBRARIES "")
if(SYMSCENE_GIF_WORKS)
  set(SYMSCENE_GIF_LIBRARIES ${SYMSCENE_LIBRARY_gif})
else()
  message(STATUS "No videos of runs: libgif-dev would add them")
endif()
