# What `cmake --install` puts in place, in two components. `program`: the program, its manual pages and
# completions, the examples, the schema of the reports of `check`. `library`: the library as one file
# with its public headers, and what lets others find it: a package for CMake (find_package(grafwire),
# grafwire::grafwire) and one for pkg-config.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS grafwire RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
if(TARGET describe)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/share/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT program)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/src/check/report.schema.json ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  ${PROJECT_SOURCE_DIR}/tools/package/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
  FILES_MATCHING PATTERN "*.grafcet" PATTERN "*.stim" PATTERN "*.awl" PATTERN "*.io" PATTERN "*.delays"
  PATTERN library EXCLUDE PATTERN pictures EXCLUDE)

# A static program is made with a {fmt} of its own, and its library would be of use to nobody.
if(STATIC)
  return()
endif()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/grafwire)

# The libraries of the folders, in one: their users see the public headers alone.
get_property(libraries GLOBAL PROPERTY GRAFWIRE_LIBRARIES)
set(objects "")
foreach(library ${libraries})
  list(APPEND objects $<TARGET_OBJECTS:${library}>)
endforeach()
add_library(grafwire_whole STATIC ${objects})
set_target_properties(grafwire_whole PROPERTIES
  OUTPUT_NAME grafwire EXPORT_NAME grafwire LINKER_LANGUAGE CXX)
target_compile_features(grafwire_whole INTERFACE cxx_std_17)
target_include_directories(grafwire_whole INTERFACE
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(grafwire_whole PRIVATE fmt::fmt pugixml::pugixml cadical utf8proc)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/grafwire/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/grafwire
  COMPONENT library FILES_MATCHING PATTERN "*.h" PATTERN parts.h EXCLUDE
  PATTERN messages.h EXCLUDE)
install(TARGETS grafwire_whole EXPORT grafwireTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  COMPONENT library)
install(EXPORT grafwireTargets NAMESPACE grafwire:: DESTINATION ${package_folder}
  COMPONENT library)

set(package_files
  ${PROJECT_BINARY_DIR}/grafwireConfig.cmake ${PROJECT_BINARY_DIR}/grafwireConfigVersion.cmake)
configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/grafwireConfig.cmake.in
  ${PROJECT_BINARY_DIR}/grafwireConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/grafwireConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${package_files} DESTINATION ${package_folder} COMPONENT library)

# The paths are relative to the file, so that the folder can be installed or moved anywhere.
file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/grafwire.pc.in
  ${PROJECT_BINARY_DIR}/grafwire.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/grafwire.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT library)
