include(CMakePackageConfigHelpers)

# The evaluation's wing is a component of its own: find_package(symscene COMPONENTS evaluation), and
# cmake --install BUILD --component robot leaves it out.
foreach(wing LIBRARIES EVALUATION_LIBRARIES)
  get_property(libraries GLOBAL PROPERTY SYMSCENE_${wing})
  if(NOT libraries)
    continue()
  endif()
  set(export symsceneTargets)
  set(component robot)
  if(wing STREQUAL "EVALUATION_LIBRARIES")
    set(export symsceneEvaluationTargets)
    set(component evaluation)
  endif()
  install(TARGETS ${libraries} EXPORT ${export} ARCHIVE
    DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component})
  install(EXPORT ${export} NAMESPACE symscene:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/symscene
    COMPONENT ${component})
  foreach(library ${libraries})
    get_target_property(folder ${library} SYMSCENE_FOLDER)
    install(DIRECTORY ${folder}/include/symscene DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
      COMPONENT ${component})
  endforeach()
  list(APPEND installed ${libraries})
endforeach()
# What is installed, without tests and benchmarks.
add_custom_target(symscene_installed DEPENDS ${installed} $<TARGET_NAME_IF_EXISTS:symscene_app>)
if(TARGET symscene_app)
  install(TARGETS symscene_app RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT robot)
  # Where they were built: a cross build cannot run the command that prints them.
  set(generated ${PROJECT_BINARY_DIR}/share)
  install(FILES ${generated}/symscene.bash RENAME symscene OPTIONAL COMPONENT robot
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${generated}/_symscene OPTIONAL COMPONENT robot
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
  install(FILES ${generated}/symscene.1 OPTIONAL COMPONENT robot DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()

configure_package_config_file(cmake/symsceneConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/symsceneConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/symscene)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/symsceneConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/symsceneConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/symsceneConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/symscene COMPONENT robot)

install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT robot)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT robot)

# symscene.pc: the libraries of the robot's wing, those that need others first, and the optional libraries behind them.
get_property(libraries GLOBAL PROPERTY SYMSCENE_LIBRARIES)
list(REVERSE libraries)
set(pkgconfig_libraries "")
set(pkgconfig_optional "")
foreach(library ${libraries})
  list(APPEND pkgconfig_libraries -l${library})
  get_target_property(optional ${library} SYMSCENE_OPTIONAL_LIBRARIES)
  if(optional)
    list(TRANSFORM optional PREPEND -l)
    list(APPEND pkgconfig_optional ${optional})
  endif()
endforeach()
list(REMOVE_DUPLICATES pkgconfig_optional)
list(JOIN pkgconfig_libraries " " pkgconfig_libraries)
list(JOIN pkgconfig_optional " " pkgconfig_optional)
file(RELATIVE_PATH pkgconfig_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/symscene.pc.in ${CMAKE_CURRENT_BINARY_DIR}/symscene.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/symscene.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT robot)

# cpack -G DEB: a package per wing. `symscene` has the command, the robot's libraries with their headers, and through the
# command the page; `symscene-evaluation` has the libraries of the evaluation's wing.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL robot)
get_property(evaluation_libraries GLOBAL PROPERTY SYMSCENE_EVALUATION_LIBRARIES)
if(evaluation_libraries)
  list(APPEND CPACK_COMPONENTS_ALL evaluation)
endif()
set(CPACK_PACKAGE_NAME symscene)
set(CPACK_PACKAGE_VENDOR SymScene)
set(CPACK_PACKAGE_CONTACT "The SymScene authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_ROBOT_PACKAGE_NAME symscene)
set(CPACK_DEBIAN_EVALUATION_PACKAGE_NAME symscene-evaluation)
set(CPACK_COMPONENT_EVALUATION_DESCRIPTION "Simulation, datasets, baselines and metrics, as libraries.")
# The packages that those who link the libraries need.
set(CPACK_DEBIAN_ROBOT_PACKAGE_RECOMMENDS
  "libeigen3-dev, libtbb-dev, libfmt-dev, nlohmann-json3-dev, libpng-dev, libjpeg-dev")
set(CPACK_DEBIAN_EVALUATION_PACKAGE_DEPENDS "symscene (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_EVALUATION_PACKAGE_RECOMMENDS "libembree-dev")
include(CPack)
