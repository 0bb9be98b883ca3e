# Other people's libraries, each found once. A room links those that it names, and no other sees them.
find_package(Boost REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(SUNDIALS REQUIRED COMPONENTS cvode nvecserial sunmatrixdense sunlinsoldense
             sunnonlinsolfixedpoint)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.10 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(CTEMPLATE REQUIRED IMPORTED_TARGET libctemplate)
pkg_check_modules(TRIBOLOG_FREETYPE REQUIRED IMPORTED_TARGET freetype2)
pkg_check_modules(TRIBOLOG_HDF5 REQUIRED IMPORTED_TARGET hdf5-serial)
pkg_check_modules(TRIBOLOG_LIBPQ REQUIRED IMPORTED_TARGET libpq)
pkg_check_modules(TRIBOLOG_LZ4 REQUIRED IMPORTED_TARGET liblz4)
pkg_check_modules(TRIBOLOG_MATIO REQUIRED IMPORTED_TARGET matio)
pkg_check_modules(TRIBOLOG_SQLITE REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(TRIBOLOG_ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(TRIBOLOG_DEFLATE IMPORTED_TARGET libdeflate)
if(NOT TRIBOLOG_DEFLATE_FOUND)  # Ubuntu 22.04 ships it without its .pc file
  find_path(TRIBOLOG_DEFLATE_INCLUDE libdeflate.h REQUIRED)
  find_library(TRIBOLOG_DEFLATE_LIBRARY deflate REQUIRED)
  add_library(PkgConfig::TRIBOLOG_DEFLATE UNKNOWN IMPORTED)
  set_target_properties(PkgConfig::TRIBOLOG_DEFLATE PROPERTIES
    IMPORTED_LOCATION ${TRIBOLOG_DEFLATE_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${TRIBOLOG_DEFLATE_INCLUDE})
endif()
