# Libraries of the program that it loads where they are first needed (program_module.h).
include(GNUInstallDirs)
# In the build directory they lie as in the installation: the program finds them by the same way.
set(TRIBOLOG_MODULE_DIR ${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/tribolog)

# tribolog_module(NAME SOURCES ... LIBRARIES ...)
# Only what its sources declare as exported can be seen in it.
function(tribolog_module name)
  cmake_parse_arguments(M "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_library(${name} MODULE ${M_SOURCES} ${PROJECT_SOURCE_DIR}/src/modules/module_version.cpp)
  target_compile_definitions(${name} PRIVATE TRIBOLOG_VERSION="${PROJECT_VERSION}")
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PRIVATE tribolog_flags tribolog_errors ${M_LIBRARIES})
  # A name that nothing defines would end the program where it is first used.
  if(NOT TRIBOLOG_SANITIZE)
    target_link_options(${name} PRIVATE -Wl,--no-undefined)
  endif()
  set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${TRIBOLOG_MODULE_DIR}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    BUILD_RPATH "" INSTALL_RPATH "")
  install(TARGETS ${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/tribolog)
endfunction()

# The distribution's packages that hold these libraries, "libpq5" or "libvtk9.1 and libosmesa6", for
# what the program says where one is missing.
function(tribolog_packages_of variable)
  find_program(TRIBOLOG_DPKG_QUERY dpkg-query)
  set(packages "")
  foreach(library IN LISTS ARGN)
    file(REAL_PATH ${library} file)
    get_filename_component(package ${file} NAME)
    if(TRIBOLOG_DPKG_QUERY)
      execute_process(COMMAND ${TRIBOLOG_DPKG_QUERY} -S ${file}
                      OUTPUT_VARIABLE owner ERROR_QUIET)
      if(owner MATCHES "^([^:, ]+)")
        set(package ${CMAKE_MATCH_1})
      endif()
    endif()
    list(APPEND packages ${package})
  endforeach()
  list(REMOVE_DUPLICATES packages)
  list(JOIN packages " and " packages)
  set(${variable} "${packages}" PARENT_SCOPE)
endfunction()
