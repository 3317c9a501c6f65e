#pragma once

#include <new>

#include <opencv2/core.hpp>

namespace symscene {

/// To be called with an exception of OpenCV that was caught: throws std::bad_alloc in its place if
/// memory has ended, else throws it again.
[[noreturn]] inline void rethrow_opencv(const cv::Exception& error) {
  if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
  throw;
}

}  // namespace symscene
