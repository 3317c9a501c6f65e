# Packs the build for Debian, unpacks the package, runs its command and builds a project with its libraries.
set(work ${build}/package-test)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${work} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${cpack} --config ${build}/CPackConfig.cmake -G DEB -B ${work})
file(GLOB package ${work}/*.deb)
run(dpkg-deb --extract ${package} ${work}/root)
run(${work}/root/usr/bin/symscene --version)
run(${work}/root/usr/bin/symscene simulate -o scene --objects 1 --seed 1)
run(${work}/root/usr/bin/symscene segment scene -o result --page page.html)
foreach(file usr/include/symscene/pipeline/pipeline.hpp ${libdir}/cmake/symscene/symsceneConfig.cmake)
  if(NOT EXISTS ${work}/root/${file})
    file(GLOB_RECURSE found RELATIVE ${work}/root ${work}/root/*Config.cmake)
    message(FATAL_ERROR "${package}: expected ${file}, found ${found}")
  endif()
endforeach()
if(NOT EXISTS ${work}/page.html)
  message(FATAL_ERROR "The command of the package wrote no page")
endif()

# A project that links the libraries of the package.
run(${CMAKE_COMMAND} -S ${source} -B ${work}/consumer -G ${generator}
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${work}/root/usr -D CMAKE_BUILD_TYPE=Debug)
run(${CMAKE_COMMAND} --build ${work}/consumer)
run(${work}/consumer/consumer)
