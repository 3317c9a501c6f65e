# Sets SYMSCENE_OPENCV_LIBRARIES and SYMSCENE_OPENCV_INCLUDE to what finding and matching features needs, or to nothing
# where it is not installed. The package configuration comes with the umbrella package alone, which is twice the size:
# this looks for the files of the modules. SYMSCENE_ARUCO_LIBRARIES is what finding ChArUco boards needs, the module
# aruco of OpenCV's contrib package, or nothing.
include(SymsceneCompiles)

option(SYMSCENE_WITH_OPENCV "Stitch frames where OpenCV's features2d and calib3d are installed" ON)

set(SYMSCENE_OPENCV_LIBRARIES "")
if(SYMSCENE_WITH_OPENCV)
  find_path(SYMSCENE_OPENCV_INCLUDE opencv2/calib3d.hpp PATH_SUFFIXES opencv4)
  mark_as_advanced(SYMSCENE_OPENCV_INCLUDE)
  foreach(module calib3d features2d imgproc core)
    find_library(SYMSCENE_LIBRARY_opencv_${module} opencv_${module})
    mark_as_advanced(SYMSCENE_LIBRARY_opencv_${module})
    list(APPEND SYMSCENE_OPENCV_LIBRARIES ${SYMSCENE_LIBRARY_opencv_${module}})
  endforeach()
  symscene_check_compiles(SYMSCENE_OPENCV_WORKS
    "#include <opencv2/calib3d.hpp>\n#include <opencv2/features2d.hpp>\nint main() { cv::SIFT::create(); }"
    INCLUDES ${SYMSCENE_OPENCV_INCLUDE} LIBRARIES ${SYMSCENE_OPENCV_LIBRARIES})
endif()
if(NOT SYMSCENE_WITH_OPENCV OR NOT SYMSCENE_OPENCV_WORKS)
  set(SYMSCENE_OPENCV_LIBRARIES "")
  message(STATUS "No stitching: libopencv-features2d-dev and libopencv-calib3d-dev not found or disabled")
endif()

set(SYMSCENE_ARUCO_LIBRARIES "")
if(SYMSCENE_OPENCV_LIBRARIES)
  find_library(SYMSCENE_LIBRARY_opencv_aruco opencv_aruco)
  mark_as_advanced(SYMSCENE_LIBRARY_opencv_aruco)
  set(SYMSCENE_ARUCO_LIBRARIES ${SYMSCENE_LIBRARY_opencv_aruco} ${SYMSCENE_OPENCV_LIBRARIES})
  # The interface up to OpenCV 4.6.
  symscene_check_compiles(SYMSCENE_ARUCO_WORKS
    "#include <opencv2/aruco/charuco.hpp>\nint main() { cv::aruco::CharucoBoard::create(3, 3, 1, 0.5F, cv::aruco::getPredefinedDictionary(0)); }"
    INCLUDES ${SYMSCENE_OPENCV_INCLUDE} LIBRARIES ${SYMSCENE_ARUCO_LIBRARIES})
  if(NOT SYMSCENE_LIBRARY_opencv_aruco OR NOT SYMSCENE_ARUCO_WORKS)
    set(SYMSCENE_ARUCO_LIBRARIES "")
    message(STATUS "No ChArUco boards: libopencv-contrib-dev of OpenCV 4.6 not found")
  endif()
endif()
