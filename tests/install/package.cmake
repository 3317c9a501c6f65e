# Packs the build for Debian, unpacks the package of the robot's wing, runs its command and builds a project with its
# libraries; then the same with the package of the evaluation's wing unpacked beside it.
#   cmake -D source=FOLDER -D build=BUILD -D generator=... -D compiler=... -D cpack=... -P package.cmake
set(work ${build}/package-test)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${work} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# unpack(PACKAGE)
function(unpack package)
  file(GLOB file ${work}/${package}_*.deb)
  if(NOT file)
    file(GLOB found RELATIVE ${work} ${work}/*.deb)
    message(FATAL_ERROR "expected ${package}_*.deb, found ${found}")
  endif()
  run(dpkg-deb --extract ${file} ${work}/root)
endfunction()

# consume(PROJECT [-D...]): builds and runs tests/install/PROJECT with the libraries that are unpacked.
function(consume project)
  run(${CMAKE_COMMAND} -S ${source}/${project} -B ${work}/${project} -G ${generator}
    -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${work}/root/usr -D CMAKE_BUILD_TYPE=Debug ${ARGN})
  run(${CMAKE_COMMAND} --build ${work}/${project})
  run(${work}/${project}/consumer)
endfunction()

run(${cpack} --config ${build}/CPackConfig.cmake -G DEB -B ${work})
unpack(symscene)
run(${work}/root/usr/bin/symscene --version)
run(${work}/root/usr/bin/symscene simulate -o scene --objects 1 --seed 1)
run(${work}/root/usr/bin/symscene segment scene -o result --page page.html)
if(NOT EXISTS ${work}/page.html)
  message(FATAL_ERROR "The command of the package wrote no page")
endif()
foreach(folder simulation evaluation clutter picking dataset baselines ground_truth)
  if(EXISTS ${work}/root/usr/include/symscene/${folder})
    message(FATAL_ERROR "The package of the robot's wing has the headers of ${folder}")
  endif()
endforeach()
consume(robot -D CMAKE_DISABLE_FIND_PACKAGE_embree=ON)
unpack(symscene-evaluation)
consume(evaluation)
