# cmake -D BUILD=… -D SCRATCH=… -D EXAMPLES=… -D LIBRARY_FOLDER=… -D GENERATOR=… -D COMPILER=…
#       -D BUILD_TYPE=… -D FLAGS=… -P install_and_use.cmake

function(run expected_status)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE errors)
  if(NOT status EQUAL expected_status)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}${errors}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_file path)
  if(NOT EXISTS ${SCRATCH}/prefix/${path})
    message(FATAL_ERROR "${path} was not installed")
  endif()
endfunction()

# The verdicts on a chart that one style wires rightly and another does not.
function(expect_verdicts program)
  set(chart ${EXAMPLES}/rule-5.grafcet)
  run(0 ${program} ${chart} nand)
  if(NOT output MATCHES "^[^\n]*: 2 steps, [0-9]+ cells, equivalent in [1-9][0-9]* cases\n$")
    message(FATAL_ERROR "${program} printed:\n${output}")
  endif()
  run(1 ${program} ${chart} nor)
  if(NOT output MATCHES "different:\n.*What helps:")
    message(FATAL_ERROR "${program} printed:\n${output}")
  endif()
  run(2 ${program} ${EXAMPLES}/rule-5.stim)
endfunction()

file(REMOVE_RECURSE ${SCRATCH}/prefix ${SCRATCH}/build)
run(0 ${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
expect_file(bin/grafwire)
foreach(file bash-completion/completions/grafwire fish/vendor_completions.d/grafwire.fish
             zsh/site-functions/_grafwire man/man1/grafwire.1 man/fr/man1/grafwire-check.1
             doc/grafwire/copyright doc/grafwire/examples/rule-5.grafcet doc/grafwire/report.schema.json)
  expect_file(share/${file})
endforeach()
file(GLOB headers RELATIVE ${SCRATCH}/prefix/include ${SCRATCH}/prefix/include/*
  ${SCRATCH}/prefix/include/grafwire/*)
set(public check equations grafwire netlist read simulate version write)
list(TRANSFORM public PREPEND grafwire/)
list(TRANSFORM public APPEND .h)
list(PREPEND public grafwire)
if(NOT headers STREQUAL public)
  message(FATAL_ERROR "installed headers: ${headers}\ninstead of: ${public}")
endif()

# Through the package of CMake.
run(0 ${CMAKE_COMMAND} -S ${EXAMPLES}/library -B ${SCRATCH}/build -G ${GENERATOR}
  -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix
  -D CMAKE_CXX_COMPILER=${COMPILER}
  -D CMAKE_BUILD_TYPE=${BUILD_TYPE}
  -D CMAKE_CXX_FLAGS=${FLAGS})
run(0 ${CMAKE_COMMAND} --build ${SCRATCH}/build)
expect_verdicts(${SCRATCH}/build/verdict)

# Through pkg-config; a moved folder is found as well.
file(RENAME ${SCRATCH}/prefix ${SCRATCH}/moved)
set(ENV{PKG_CONFIG_PATH} ${SCRATCH}/moved/${LIBRARY_FOLDER}/pkgconfig)
run(0 pkg-config --cflags --libs grafwire)
separate_arguments(from_package UNIX_COMMAND "${output}")
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
run(0 ${COMPILER} -std=c++17 ${flags} ${EXAMPLES}/library/main.cpp ${from_package}
  -o ${SCRATCH}/by-pkg-config)
expect_verdicts(${SCRATCH}/by-pkg-config)
file(REMOVE_RECURSE ${SCRATCH}/moved)
