# Packages for Debian, by `cpack -G DEB`: `grafwire` with the program, `libgrafwire-dev` with the library.
# tools/package/build makes them with the flags of Debian's own packages; tools/package/README.md says
# what is in them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME grafwire)
set(CPACK_PACKAGE_VENDOR grafwire)
# Whoever hands packages on gives a name and an address: -DCPACK_PACKAGE_CONTACT="Name <address>".
if(NOT CPACK_PACKAGE_CONTACT)
  set(CPACK_PACKAGE_CONTACT "The authors of grafwire <grafwire@example.org>")
endif()
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/tools/package/finish.cmake)

set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME grafwire)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "gtkwave, yosys, iverilog, ngspice")
# Behind the first line, which is the description of the project.
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"grafwire turns a GRAFCET, written as text, into the equations of its steps,
into wiring (gates, latches, flip-flops) and into programs for PLCs and
microcontrollers. It proves that wiring or program does what the GRAFCET says
in every case that can be reached, or shows the shortest case in which it does
not, and why.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libgrafwire-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libcadical-dev, libfmt-dev, libpugixml-dev, libutf8proc-dev")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
"grafwire turns a GRAFCET, written as text, into equations, wiring and
programs, and proves that they do what the GRAFCET says.
.
This package has all of it as a static library for programs in C++17 or later,
with its headers, found by CMake and pkg-config.")

include(CPack)
