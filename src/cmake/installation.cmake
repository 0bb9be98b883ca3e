# What `cmake --install` puts where, and the Debian packages that `cpack` makes of it: the program, the
# shared library, and what it takes to build with that. All of it finds each other by relative ways:
# the prefix may be chosen, and moved.
include(GNUInstallDirs)
install(FILES README.md CHANGELOG.md CITATION.cff SECURITY.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN *.md PATTERN *.svg PATTERN *.png)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} USE_SOURCE_PERMISSIONS
        PATTERN run.sh EXCLUDE)  # which builds
install(FILES templates/export.schema.json ${PROJECT_BINARY_DIR}/guides/calibration.schema.json
        DESTINATION ${CMAKE_INSTALL_DATADIR}/tribolog)

# Manual, completion and schema are made by the program, and are never older than it is.
set(guides ${PROJECT_BINARY_DIR}/guides)
set(guide_files ${guides}/man1/tribolog.1 ${guides}/tribolog.bash ${guides}/_tribolog
    ${guides}/tribolog.fish ${guides}/calibration.schema.json)
add_custom_command(
  OUTPUT ${guide_files}
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${guides}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${guides}
  COMMAND tribolog manual ${guides}/man1
  COMMAND tribolog completion bash >${guides}/tribolog.bash
  COMMAND tribolog completion zsh >${guides}/_tribolog
  COMMAND tribolog completion fish >${guides}/tribolog.fish
  COMMAND tribolog schema >${guides}/calibration.schema.json
  DEPENDS tribolog
  COMMENT "Writing manual, completion and schema")
add_custom_target(guides ALL DEPENDS ${guide_files})
install(DIRECTORY ${guides}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
install(FILES ${guides}/tribolog.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME tribolog)
install(FILES ${guides}/_tribolog DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${guides}/tribolog.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program library development)
set(CPACK_PACKAGE_CONTACT "the tribolog authors <tribolog@localhost>")
set(CPACK_PACKAGE_VENDOR "the tribolog authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tribolog)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"Finds a joint's centre of gravity, surrogate mass, friction hysteresis and
viscous curve, says how sure it is of each, draws every figure without a
display, and writes one HTML report with the numbers beside it as JSON.")
# Besides the libraries of program and modules, which dpkg-shlibdeps finds.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS fonts-dejavu-core)
if(TRIBOLOG_GL_NAME STREQUAL "EGL")  # whose drivers are loaded by name
  string(APPEND CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS ", libgl1-mesa-dri")
endif()

# The library loads the program's modules, which lie in the program's package.
get_target_property(soversion tribolog_shared SOVERSION)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libtribolog${soversion})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
"The shared library: reads logs, identifies a joint, and writes report, figures and numbers from
within another program.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "tribolog (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtribolog-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"To build with the shared library: headers, the CMake package and the .pc file of libtribolog.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME} (= ${PROJECT_VERSION})")
include(CPack)
