# libtribolog: what the room api declares as exported, as a shared library with all rooms inside. Its
# modules lie where the program's do. To be installed with headers, a CMake package and a .pc file.
include(CMakePackageConfigHelpers)

# What it takes to be replaced under a program that was linked with it: while the version begins with
# 0, the same second number.
set(TRIBOLOG_SOVERSION ${PROJECT_VERSION_MAJOR})
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(TRIBOLOG_SOVERSION 0.${PROJECT_VERSION_MINOR})
endif()

set(exports ${CMAKE_CURRENT_LIST_DIR}/exported_symbols.map)
add_library(tribolog_shared SHARED $<TARGET_OBJECTS:tribolog_api>)
target_link_libraries(tribolog_shared PRIVATE tribolog_api)
file(MAKE_DIRECTORY ${TRIBOLOG_ROOM_VIEWS}/tribolog_shared)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/src/api/tribolog
  ${TRIBOLOG_ROOM_VIEWS}/tribolog_shared/tribolog SYMBOLIC)
target_include_directories(tribolog_shared INTERFACE
  $<BUILD_INTERFACE:${TRIBOLOG_ROOM_VIEWS}/tribolog_shared>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(tribolog_shared INTERFACE cxx_std_20)
target_link_options(tribolog_shared PRIVATE -Wl,--exclude-libs,ALL -Wl,--gc-sections
  -Wl,--version-script=${exports})
if(NOT TRIBOLOG_SANITIZE AND NOT TRIBOLOG_FUZZ)
  target_link_options(tribolog_shared PRIVATE -Wl,--no-undefined)
endif()
set_target_properties(tribolog_shared PROPERTIES OUTPUT_NAME tribolog EXPORT_NAME tribolog
  VERSION ${PROJECT_VERSION} SOVERSION ${TRIBOLOG_SOVERSION} LINKER_LANGUAGE CXX
  LINK_DEPENDS ${exports}
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}
  BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "$ORIGIN/tribolog")
tribolog_needs_modules(tribolog_shared)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/tribolog)
install(TARGETS tribolog_shared EXPORT tribolog
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/api/tribolog DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT development FILES_MATCHING PATTERN "*.h")
install(EXPORT tribolog NAMESPACE tribolog:: DESTINATION ${package} COMPONENT development
  FILE tribologTargets.cmake)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/tribologConfig.cmake.in
  ${PROJECT_BINARY_DIR}/tribologConfig.cmake INSTALL_DESTINATION ${package}
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
set(compatible SameMajorVersion)
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(compatible SameMinorVersion)
endif()
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tribologConfigVersion.cmake
  COMPATIBILITY ${compatible})
install(FILES ${PROJECT_BINARY_DIR}/tribologConfig.cmake
              ${PROJECT_BINARY_DIR}/tribologConfigVersion.cmake
  DESTINATION ${package} COMPONENT development)

# The prefix may be moved: pkg-config finds it from where the file lies.
file(RELATIVE_PATH TRIBOLOG_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/tribolog.pc.in ${PROJECT_BINARY_DIR}/tribolog.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/tribolog.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)
