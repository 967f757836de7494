# Run by cpack before it builds the packages: every Debian package has its licences and its changes in a folder of its
# own.
string(TIMESTAMP today "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} COMPONENT)
  set(folder ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share/doc/${CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME})
  file(MAKE_DIRECTORY ${folder})

  configure_file(${CPACK_HALFSPACE_LICENCE} ${folder}/copyright COPYONLY)
  foreach(name IN LISTS CPACK_HALFSPACE_${COMPONENT}_COMPILED_IN)
    file(READ ${CPACK_HALFSPACE_NOTICES}/${name}.txt notice)
    file(APPEND ${folder}/copyright "\n\n${notice}")
  endforeach()

  configure_file(${CPACK_HALFSPACE_CHANGES} ${folder}/changelog COPYONLY)
  file(WRITE ${folder}/changelog.Debian "\
${CPACK_PACKAGE_NAME} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) UNRELEASED; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}: changelog.gz says what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${today}
")
  execute_process(COMMAND gzip --best --no-name --force ${folder}/changelog ${folder}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
endforeach()
