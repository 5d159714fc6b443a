# cmake -D BUILD=… -D SCRATCH=… -D CONSUMER=… -D GENERATOR=… -D COMPILER=… -D BUILD_TYPE=… -D FLAGS=…
#       -P install_and_use.cmake

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_file path)
  if(NOT EXISTS ${SCRATCH}/prefix/${path})
    message(FATAL_ERROR "${path} was not installed")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH}/prefix ${SCRATCH}/build)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
expect_file(bin/grafwire)
expect_file(include/grafwire/grafcet/grafcet.h)
expect_file(include/grafwire/check/check_equivalence.h)
expect_file(share/doc/grafwire/report.schema.json)

run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build -G ${GENERATOR}
  -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix
  -D CMAKE_CXX_COMPILER=${COMPILER}
  -D CMAKE_BUILD_TYPE=${BUILD_TYPE}
  -D CMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/consumer)
set(expected "3 steps, equivalent\n")
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "the consumer printed:\n${output}instead of:\n${expected}")
endif()
