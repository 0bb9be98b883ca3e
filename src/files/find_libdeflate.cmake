# PkgConfig::TRIBOLOG_DEFLATE, for the directory that includes this.
find_package(PkgConfig REQUIRED)
pkg_check_modules(TRIBOLOG_DEFLATE IMPORTED_TARGET libdeflate)
if(NOT TRIBOLOG_DEFLATE_FOUND)  # Ubuntu 22.04 ships it without its .pc file
  find_path(TRIBOLOG_DEFLATE_INCLUDE libdeflate.h REQUIRED)
  find_library(TRIBOLOG_DEFLATE_LIBRARY deflate REQUIRED)
  add_library(PkgConfig::TRIBOLOG_DEFLATE UNKNOWN IMPORTED)
  set_target_properties(PkgConfig::TRIBOLOG_DEFLATE PROPERTIES
    IMPORTED_LOCATION ${TRIBOLOG_DEFLATE_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${TRIBOLOG_DEFLATE_INCLUDE})
endif()
