# grafwire_precompile(TARGET): with PRECOMPILE on, its files share the headers that most of them
# include and that take longest to read.

if(PRECOMPILE)
  file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "")
  add_library(grafwire_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(grafwire_precompiled PRIVATE fmt::fmt)
  target_precompile_headers(grafwire_precompiled PRIVATE
    <algorithm> <functional> <map> <memory> <optional> <set> <span> <sstream> <string>
    <unordered_map> <vector> <fmt/format.h>)
endif()

function(grafwire_precompile target)
  if(PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM grafwire_precompiled)
  endif()
endfunction()
