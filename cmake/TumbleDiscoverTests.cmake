# tumble_discover_tests(TARGET): CTest tests of the cases of a Catch2 program, with the cases' tags as CTest
# labels: `ctest -L '^chatter$'`. Cases tagged [.long] exist only for
# `ctest -C Long`. Catch2's own module cannot do the labels in the version that Debian 12 has.
#
# Included in a CMakeLists.txt, this file defines the function; run as a script after the program
# has been linked, it asks the program for its cases.

if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(TUMBLE_DISCOVER_TESTS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(tumble_discover_tests target)
    set(list ${CMAKE_CURRENT_BINARY_DIR}/${target}_list.cmake)
    set(include ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake)
    add_custom_command(TARGET ${target} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${target}> -D LIST=${list}
              -D CATCH_VERSION=${Catch2_VERSION} -P ${TUMBLE_DISCOVER_TESTS_SCRIPT}
      BYPRODUCTS ${list} VERBATIM)
    file(CONFIGURE OUTPUT ${include} @ONLY CONTENT [[
if(EXISTS "@list@")
  include("@list@")
else()
  add_test("@target@ is not built" "@target@_is_not_built")
endif()
]])
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
  endfunction()
  return()
endif()

cmake_minimum_required(VERSION 3.25)  # a script has no policies from elsewhere

# The names that a test specification selects, as a list. Brackets and semicolons mean something
# inside CMake's lists, so they are replaced by control characters until a name is written. Version 2
# returns the number of cases as exit status, so only a crash is an error.
string(ASCII 1 open)
string(ASCII 2 close)
string(ASCII 3 semicolon)
function(names_of result)
  if(CATCH_VERSION VERSION_LESS 3)
    set(how --list-test-names-only)
  else()
    set(how --list-tests --verbosity quiet)
  endif()
  execute_process(COMMAND ${PROGRAM} ${ARGN} ${how} OUTPUT_VARIABLE text RESULT_VARIABLE status)
  if(NOT status MATCHES "^[0-9]+$")
    message(FATAL_ERROR "${PROGRAM} cannot list its test cases: ${status}")
  endif()
  string(STRIP "${text}" text)
  string(REPLACE "[" "${open}" text "${text}")
  string(REPLACE "]" "${close}" text "${text}")
  string(REPLACE ";" "${semicolon}" text "${text}")
  string(REPLACE "\n" ";" names "${text}")
  set(${result} "${names}" PARENT_SCOPE)
endfunction()

# The list of tags has lines such as "  3  [chatter]"; each tag gets its cases. Those that begin with
# a point or an exclamation mark are Catch2's own.
execute_process(COMMAND ${PROGRAM} "*,[.]" --list-tags OUTPUT_VARIABLE text)
string(REGEX MATCHALL "\\[[^].!\n][^]\n]*\\]" tags "${text}")
string(REGEX REPLACE "[][]" "" tags "${tags}")
list(REMOVE_DUPLICATES tags)
foreach(tag IN LISTS tags)
  names_of(names "[${tag}]")
  foreach(name IN LISTS names)
    string(MAKE_C_IDENTIFIER "${name}" key)
    list(APPEND labels_${key} ${tag})
  endforeach()
endforeach()

# CTest reads add_test() with [==[...]==], which quotes whatever stands inside. Short cases of the same labels are run
# by one process, twenty at a time: most need less time than the program needs to start.
set(script)
names_of(names "*")
names_of(hidden "[.]")
list(APPEND names ${hidden})
list(REMOVE_DUPLICATES names)
set(group_size 20)
set(groups)
foreach(name IN LISTS names)
  string(MAKE_C_IDENTIFIER "${name}" key)
  string(REPLACE "${open}" "[" name "${name}")
  string(REPLACE "${close}" "]" name "${name}")
  string(REPLACE "${semicolon}" ";" name "${name}")
  string(REGEX REPLACE "([],[])" "\\\\\\1" specification "${name}")  # as Catch2 wants to be asked
  if("long" IN_LIST labels_${key})
    string(APPEND script "if(CTEST_CONFIGURATION_TYPE STREQUAL \"Long\")\n"
      "add_test([==[${name}]==] [==[${PROGRAM}]==] [==[${specification}]==])\n"
      "set_tests_properties([==[${name}]==] PROPERTIES LABELS \"${labels_${key}}\" TIMEOUT 3600)\nendif()\n")
    continue()
  endif()
  list(JOIN labels_${key} " " group)
  list(APPEND groups "${group}")
  set(labels_of_${group} "${labels_${key}}")
  string(REPLACE ";" "${semicolon}" specification "${specification}")
  list(APPEND cases_of_${group} "${specification}")
endforeach()
list(REMOVE_DUPLICATES groups)
foreach(group IN LISTS groups)
  list(LENGTH cases_of_${group} count)
  foreach(from RANGE 1 ${count} ${group_size})
    math(EXPR begin "${from} - 1")
    list(SUBLIST cases_of_${group} ${begin} ${group_size} cases)
    list(JOIN cases "," specification)
    string(REPLACE "${semicolon}" ";" specification "${specification}")
    set(name "${group} ${from}")
    string(APPEND script "add_test([==[${name}]==] [==[${PROGRAM}]==] [==[${specification}]==])\n"
      "set_tests_properties([==[${name}]==] PROPERTIES LABELS \"${labels_of_${group}}\" TIMEOUT 300)\n")
  endforeach()
endforeach()
file(WRITE ${LIST} "${script}")
