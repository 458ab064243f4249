# cmake -D BUILD=... -D SOURCE=... -D WORK=... -P consumer_test.cmake
#
# Installs the build tree, then configures, builds and runs projects that find it by find_package(foramen).
function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(code)
    message(FATAL_ERROR "${ARGV}\n${output}")
  endif()
endfunction()
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/packaging/consumer -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
run(${WORK}/build/io_consumer)

# The examples are built against the installed package.
run(${CMAKE_COMMAND} -S ${SOURCE}/examples/cpp -B ${WORK}/examples -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/examples)
run(${WORK}/examples/own_meshes)
run(${WORK}/examples/corresponding_points)
run(${WORK}/examples/project_surface)
run(${BUILD}/bin/foramen synth -n 3 --vertices 2000 --quiet -o ${WORK}/cohort)
run(${WORK}/examples/files_to_model cohort/shapes/synth001.ply cohort/shapes/synth002.ply cohort/shapes/synth003.ply)
