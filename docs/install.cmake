# Pages and examples, which every installed tree has, also one without the reference.
install(FILES docs/guide.md docs/choosing.md docs/trade.md docs/scenes.md docs/theory.md docs/architecture.md docs/references.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
install(DIRECTORY docs/concepts docs/measured docs/decisions docs/images docs/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation
  PATTERN CMakeLists.txt EXCLUDE
  PATTERN run EXCLUDE)  # which builds the command first, in the source tree
