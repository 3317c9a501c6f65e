include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY SYMSCENE_LIBRARIES)
install(TARGETS ${libraries} EXPORT symsceneTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT symsceneTargets NAMESPACE symscene:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/symscene)
install(DIRECTORY include/symscene DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(TARGET symscene_app)
  install(TARGETS symscene_app RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_package_config_file(cmake/symsceneConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/symsceneConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/symscene)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/symsceneConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/symsceneConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/symsceneConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/symscene)
