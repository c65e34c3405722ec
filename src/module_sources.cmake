# The sources of the library in the module of the live page, as CMakeLists.txt reads them: ten of equal options are
# compiled as one, since em++ takes seconds to read the headers of each.
include(${PROJECT_SOURCE_DIR}/cmake/TumbleBatches.cmake)

# Its standard library has no <charconv> for floating point: whoever links has to bring these functions.
list(FILTER sources EXCLUDE REGEX "/base/number_text\\.cpp$")

foreach(source IN LISTS sources)
  set(group often)
  # What runs once, at the start: small rather than fast.
  if(source MATCHES "/(base|scenes)/[^/]+$|/techniques\\.cpp$")
    set(group once)
  endif()
  # Errors pass through most sources on their way to module.cpp. What is undone on that way is memory alone,
  # and code for it would be a fortieth of the module: after an error the page makes a new one.
  file(STRINGS ${source} caught REGEX "catch \\(" LIMIT_COUNT 1)
  if(NOT caught)
    string(APPEND group _passed)
  endif()
  list(APPEND ${group} ${source})
endforeach()

set(sources)
foreach(group IN ITEMS once once_passed often often_passed)
  set(alone ${${group}})
  list(FILTER alone INCLUDE REGEX "/version\\.cpp$")  # has definitions of its own
  list(REMOVE_ITEM ${group} ${alone})
  tumble_batches(files ${group} ${${group}})
  list(APPEND files ${alone})
  if(group MATCHES "once")
    set_property(SOURCE ${files} APPEND PROPERTY COMPILE_OPTIONS -Oz)
  endif()
  if(group MATCHES "passed")
    set_property(SOURCE ${files} APPEND PROPERTY COMPILE_OPTIONS -fignore-exceptions)
  endif()
  list(APPEND sources ${files})
endforeach()
