# What `cmake --install` puts in place: the program, the libraries, their headers by folder, the schema
# of the reports of `check`, and the package that lets others write find_package(grafwire) and link to grafwire::check.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/grafwire)

get_property(libraries GLOBAL PROPERTY GRAFWIRE_LIBRARIES)
foreach(library ${libraries})
  target_compile_features(${library} PUBLIC cxx_std_20)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/grafwire
  FILES_MATCHING PATTERN "*.h" PATTERN command EXCLUDE)
install(TARGETS ${libraries} EXPORT grafwireTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT grafwireTargets NAMESPACE grafwire:: DESTINATION ${package_folder})
install(FILES ${PROJECT_SOURCE_DIR}/src/check/report.schema.json DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(TARGET grafwire)
  install(TARGETS grafwire RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

set(package_files
  ${PROJECT_BINARY_DIR}/grafwireConfig.cmake ${PROJECT_BINARY_DIR}/grafwireConfigVersion.cmake)
configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/grafwireConfig.cmake.in
  ${PROJECT_BINARY_DIR}/grafwireConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/grafwireConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${package_files} DESTINATION ${package_folder})
