# Licence, changes, and the notices of code of others that is compiled in or linked.
halfspace_install(FILES LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
set(notices eigen qhull)
if(HALFSPACE_BUILD_CLI)
  list(APPEND notices cli11 muparser png three tomlplusplus voro++ zlib)
endif()
list(TRANSFORM notices REPLACE "(.+)" "docs/notices/\\1.txt")
halfspace_install(FILES ${notices} DESTINATION ${CMAKE_INSTALL_DOCDIR}/notices COMPONENT documentation)

# Pages and examples, which every installed tree has, also one without the reference.
file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
halfspace_install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
halfspace_install(DIRECTORY docs/scenes docs/concepts docs/measured docs/decisions docs/coming_from docs/images docs/examples
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation
  PATTERN CMakeLists.txt EXCLUDE
  PATTERN run EXCLUDE)  # which builds the command first, in the source tree
