# Optional parts are built where what they need works. A library or compiler that is absent, half installed or broken is
# left out, and never ends the configuration: it is tried in a project of its own, whose errors stay there.

# halfspace_works(variable WHAT name PACKAGE package FIND code LINK libraries... HEADER header): sets the variable in the
# cache once a program that includes the header and links the libraries, after the code has found them, is built; until
# then it is tried again in each configuration. Says in one line what is left out, and the Debian package that brings it.
function(halfspace_works variable)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "WHAT;PACKAGE;FIND;HEADER" "LINK")
  if(${variable})
    return()
  endif()
  set(folder ${CMAKE_BINARY_DIR}/probes/${variable})
  file(REMOVE_RECURSE ${folder})
  file(WRITE ${folder}/source/find.cmake "${arg_FIND}\nset(link ${arg_LINK})\n")
  file(WRITE ${folder}/source/probe.cpp "#include <${arg_HEADER}>\nint main() {}\n")
  configure_file(${PROJECT_SOURCE_DIR}/capi/cmake/probe/CMakeLists.txt ${folder}/source/CMakeLists.txt COPYONLY)
  # A process of its own: an error inside of try_compile() would end this configuration.
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${folder}/source -B ${folder}/build -G ${CMAKE_GENERATOR}
      -DCMAKE_C_COMPILER=${CMAKE_C_COMPILER} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      -DCMAKE_C_FLAGS=${CMAKE_C_FLAGS} -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
      "-DCMAKE_PREFIX_PATH=${CMAKE_PREFIX_PATH}" "-DCMAKE_TOOLCHAIN_FILE=${CMAKE_TOOLCHAIN_FILE}"
    RESULT_VARIABLE fault OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(fault EQUAL 0)
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder}/build
      RESULT_VARIABLE fault OUTPUT_VARIABLE built ERROR_VARIABLE built)
  endif()
  file(WRITE ${folder}/log.txt "${output}${built}")
  if(fault EQUAL 0)
    set(${variable} TRUE CACHE INTERNAL "")
  else()
    message(STATUS "Left out: ${arg_WHAT} (Debian: ${arg_PACKAGE}); ${folder}/log.txt says why")
  endif()
endfunction()
