# With PRECOMPILE on, the headers that most files include and that take longest to read are read
# once for the product and once for its tests.

# grafwire_precompiled(NAME HEADERS…): makes them ready, with the settings of the folder.
function(grafwire_precompiled name)
  if(PRECOMPILE)
    file(WRITE ${PROJECT_BINARY_DIR}/${name}.cpp "")
    add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE fmt::fmt grafwire_settings)
    target_precompile_headers(${name} PRIVATE
      <algorithm> <functional> <map> <memory> <optional> <set> <span> <sstream> <string>
      <unordered_map> <vector> <fmt/format.h> ${ARGN})
  endif()
endfunction()

# grafwire_use_precompiled(TARGET NAME)
function(grafwire_use_precompiled target name)
  if(PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${name})
    # The compiler takes them only where the macros are those they were read with.
    target_compile_definitions(${target} PRIVATE
      $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
    # For ccache, which preprocesses first.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    # g++ 12 forgets that they are the system's, and warns of overlaps in them that are not there.
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>)
  endif()
endfunction()
