# Run by cpack before it builds the packages: every Debian package has its licence and its changes in a folder of its own.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} COMPONENT)
  set(folder ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share/doc/${CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME})
  file(MAKE_DIRECTORY ${folder})
  configure_file(${CPACK_HALFSPACE_LICENCE} ${folder}/copyright COPYONLY)
  configure_file(${CPACK_HALFSPACE_CHANGES} ${folder}/changelog COPYONLY)
  execute_process(COMMAND gzip --best --no-name --force ${folder}/changelog COMMAND_ERROR_IS_FATAL ANY)
endforeach()
