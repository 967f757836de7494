# Optional parts are built where what they need works. A library, compiler or program that is absent, half installed or
# broken is left out with one line that names its Debian package, and never ends the configuration: it is tried in a
# process of its own, whose errors stay there. parts.cmake lists the parts and what they need.

# halfspace_dependency(name PACKAGE package [RUN command...] [FIND code] [LINK libraries...] [SOURCE program]): what
# parts can need. It works if the command succeeds, and the program can be built with the libraries after the code has
# found them.
function(halfspace_dependency name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PACKAGE;FIND;SOURCE" "RUN;LINK")
  foreach(property PACKAGE FIND SOURCE RUN LINK)
    set_property(GLOBAL PROPERTY halfspace_${property}_${name} "${arg_${property}}")
  endforeach()
endfunction()

# halfspace_find(name): runs the code that finds the dependency, in the scope of the caller.
macro(halfspace_find name)
  get_property(halfspace_find_code GLOBAL PROPERTY halfspace_FIND_${name})
  cmake_language(EVAL CODE "${halfspace_find_code}")
endmacro()

# Writes the compilers, flags and places of the cache, for the project that builds a probe.
function(halfspace_write_known_places file)
  set(text "set(CMAKE_PLATFORM_INFO_INITIALIZED 1 CACHE INTERNAL [[]])\n")  # the compilers' checks are copied
  get_cmake_property(variables CACHE_VARIABLES)
  set(of_cmake MAKE_PROGRAM PREFIX_PATH SYSROOT TOOLCHAIN_FILE FIND_ROOT_PATH Fortran_COMPILER
    C_FLAGS CXX_FLAGS Fortran_FLAGS EXE_LINKER_FLAGS)
  list(JOIN of_cmake "|" of_cmake)
  list(FILTER variables INCLUDE REGEX "_(DIRS?|ROOT|LIBRARY|LIBRARY_RELEASE)$|^CMAKE_(${of_cmake})$")
  list(FILTER variables EXCLUDE REGEX "_(SOURCE|BINARY)_DIR$|^CMAKE_.*_DIR$|^HALFSPACE_")
  foreach(variable IN LISTS variables)
    if(${variable})
      string(APPEND text "set(${variable} [[${${variable}}]] CACHE STRING [[]] FORCE)\n")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)
endfunction()

# Builds a program with the dependency in a project of its own, which knows the compilers and places of this one. It is
# quick where nothing has changed since it was built before; if it fails, it is tried without what is left of that.
function(halfspace_build_probe name folder fault_variable log_variable)
  foreach(property FIND SOURCE LINK)
    get_property(${property} GLOBAL PROPERTY halfspace_${property}_${name})
  endforeach()
  string(JOIN " " LINK ${LINK})
  file(CONFIGURE OUTPUT ${folder}/find.cmake CONTENT "${FIND}\nset(link ${LINK})\n" @ONLY)
  file(CONFIGURE OUTPUT ${folder}/probe.cpp CONTENT "${SOURCE}\n" @ONLY)
  configure_file(${PROJECT_SOURCE_DIR}/capi/cmake/probe/CMakeLists.txt ${folder}/CMakeLists.txt COPYONLY)
  halfspace_write_known_places(${folder}/known.cmake)
  foreach(attempt with_what_is_left anew)
    file(COPY ${CMAKE_PLATFORM_INFO_DIR} DESTINATION ${folder}/build/CMakeFiles
      PATTERN CMakeFortranCompiler.cmake EXCLUDE)
    execute_process(TIMEOUT 120
      COMMAND ${CMAKE_COMMAND} -C ${folder}/known.cmake -S ${folder} -B ${folder}/build -G ${CMAKE_GENERATOR}
      RESULT_VARIABLE fault OUTPUT_VARIABLE log ERROR_VARIABLE log)
    if(fault EQUAL 0)
      execute_process(TIMEOUT 120 COMMAND ${CMAKE_COMMAND} --build ${folder}/build
        RESULT_VARIABLE fault OUTPUT_VARIABLE log ERROR_VARIABLE log)
    endif()
    if(fault EQUAL 0)
      break()
    endif()
    file(REMOVE_RECURSE ${folder}/build)
  endforeach()
  set(${fault_variable} "${fault}" PARENT_SCOPE)
  set(${log_variable} "${log}" PARENT_SCOPE)
endfunction()

# halfspace_works(name variable): sets the variable to whether the dependency works; each configuration tries it once.
function(halfspace_works name variable)
  get_property(works GLOBAL PROPERTY halfspace_WORKS_${name})
  if("${works}" STREQUAL "")
    set(folder ${PROJECT_BINARY_DIR}/probes/${name})
    get_property(run GLOBAL PROPERTY halfspace_RUN_${name})
    get_property(find GLOBAL PROPERTY halfspace_FIND_${name})
    set(fault 0)
    set(log "")
    if(NOT run STREQUAL "")  # a command may end with -NOTFOUND, which is false
      execute_process(COMMAND ${run} TIMEOUT 60 RESULT_VARIABLE fault OUTPUT_VARIABLE log ERROR_VARIABLE log)
    endif()
    if(fault EQUAL 0 AND find)
      halfspace_build_probe(${name} ${folder} fault log)
    endif()
    set(works TRUE)
    if(NOT fault EQUAL 0)
      set(works FALSE)
      file(WRITE ${folder}.log "${run}\n${fault}\n${log}")
    endif()
    set_property(GLOBAL PROPERTY halfspace_WORKS_${name} ${works})
  endif()
  set(${variable} ${works} PARENT_SCOPE)
endfunction()

# halfspace_leave_out(what name...): says in one line what is left out, and which packages bring what it needs.
function(halfspace_leave_out what)
  set(packages "")
  set(logs "")
  foreach(name IN LISTS ARGN)
    get_property(package GLOBAL PROPERTY halfspace_PACKAGE_${name})
    list(APPEND packages ${package})
    list(APPEND logs probes/${name}.log)
  endforeach()
  list(REMOVE_DUPLICATES packages)
  list(JOIN ARGN ", " names)
  list(JOIN packages " " packages)
  list(JOIN logs ", " logs)
  message(STATUS "Left out: ${what}, without ${names} (Debian: ${packages}); why: ${logs}")
  file(APPEND ${PROJECT_BINARY_DIR}/left_out.txt "${what}: ${packages}\n")
endfunction()

# halfspace_where_works(variable what name...): sets the variable to ON if all dependencies work; else it is OFF, and
# what is left out is said.
function(halfspace_where_works variable what)
  set(missing "")
  foreach(name IN LISTS ARGN)
    halfspace_works(${name} works)
    if(NOT works)
      list(APPEND missing ${name})
    endif()
  endforeach()
  if(missing)
    halfspace_leave_out("${what}" ${missing})
    set(${variable} OFF PARENT_SCOPE)
  else()
    set(${variable} ON PARENT_SCOPE)
  endif()
endfunction()

# halfspace_part(option at_first what name...): an option that is AUTO, OFF or ON, by default at_first. AUTO is ON where
# all dependencies work. ON by the user ends the configuration where one does not. The option is ON or OFF afterwards.
function(halfspace_part option at_first what)
  set(${option} ${at_first} CACHE STRING "Build ${what}: ON, OFF, or AUTO, which is ON where all that it needs works")
  set(wanted ${${option}})
  if(NOT wanted)
    set(${option} OFF PARENT_SCOPE)
    return()
  endif()
  halfspace_where_works(works "${what}" ${ARGN})
  if(NOT works AND NOT wanted STREQUAL AUTO)
    message(FATAL_ERROR "${option} is ${wanted}, and what it needs does not work. AUTO leaves it out.")
  endif()
  set(${option} ${works} PARENT_SCOPE)
endfunction()
