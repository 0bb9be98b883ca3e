# Libraries of the program that it loads where they are first needed (program_module.h).
include(GNUInstallDirs)
# In the build directory they lie as in the installation: the program finds them by the same way.
set(TRIBOLOG_MODULE_DIR ${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/tribolog)

# tribolog_module(NAME ROOM SOURCES ... ROOMS ... LIBRARIES ...)
# A room that is such a library. Only what its sources declare as exported can be seen in it.
function(tribolog_module name room)
  cmake_parse_arguments(M "" "" "SOURCES;ROOMS;LIBRARIES" ${ARGN})
  tribolog_targets_of(rooms ${M_ROOMS})
  tribolog_show_room(${name} ${room})
  add_library(${name} MODULE ${M_SOURCES} ${PROJECT_SOURCE_DIR}/src/base/module_version.cpp)
  target_include_directories(${name} PRIVATE ${TRIBOLOG_ROOM_VIEWS}/${name})
  target_compile_definitions(${name} PRIVATE TRIBOLOG_VERSION="${PROJECT_VERSION}")
  target_compile_options(${name} PRIVATE ${TRIBOLOG_CONVERSION_WARNINGS})
  target_link_libraries(${name} PRIVATE tribolog_flags tribolog_base ${rooms} ${M_LIBRARIES})
  target_link_options(${name} PRIVATE -Wl,--exclude-libs,ALL)
  # A name that nothing defines would end the program where it is first used.
  if(NOT TRIBOLOG_SANITIZE)
    target_link_options(${name} PRIVATE -Wl,--no-undefined)
  endif()
  set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${TRIBOLOG_MODULE_DIR}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    BUILD_RPATH "" INSTALL_RPATH "")
  set_property(GLOBAL APPEND PROPERTY TRIBOLOG_MODULES ${name})
  install(TARGETS ${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/tribolog)
endfunction()

# Programs that may load any of them have all of them beside them.
function(tribolog_needs_modules program)
  get_property(modules GLOBAL PROPERTY TRIBOLOG_MODULES)
  add_dependencies(${program} ${modules})
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
