# Pages and examples, which every installed tree has, also one without the reference.
file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
install(DIRECTORY docs/concepts docs/measured docs/decisions docs/images docs/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation
  PATTERN CMakeLists.txt EXCLUDE
  PATTERN run EXCLUDE)  # which builds the command first, in the source tree
