# With STATIC on the program holds all libraries and runs where nothing else is: from an empty folder, or in
# a container that holds nothing else. Debian has static libraries of all but {fmt}, which is compiled here. Left
# out is the editing of lines at the terminal: libedit looks for files that would not be there.

add_library(fmt_static STATIC ${PROJECT_SOURCE_DIR}/tools/playground/libraries/fmt/fmt.cpp)
target_compile_options(fmt_static PRIVATE -w)
# As with the shared library, so that ccache has the same files for both.
target_compile_definitions(fmt_static INTERFACE FMT_SHARED)
add_library(fmt::fmt ALIAS fmt_static)
find_package(pugixml REQUIRED)
set_property(TARGET pugixml::pugixml PROPERTY INTERFACE_LINK_LIBRARIES pugixml::static)
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
string(APPEND CMAKE_EXE_LINKER_FLAGS " -static")
