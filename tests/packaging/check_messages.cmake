# cmake -D ROOT=... -P check_messages.cmake
#
# The library serves more than one front end: what it says must name no flag and no command of the program. An error or
# a note carries a Remedy instead, and the front end words it.
cmake_policy(VERSION 3.25)
set(violations "")
file(GLOB_RECURSE files ${ROOT}/include/*.hpp ${ROOT}/src/*.hpp ${ROOT}/src/*.cpp)
list(LENGTH files count)
if(count LESS 100)
  message(FATAL_ERROR "only ${count} files under ${ROOT}")
endif()
foreach(file IN LISTS files)
  file(STRINGS ${file} lines REGEX "\"[^\"]*(--[a-z]|`foramen |[ (`]-o[^a-z])")
  foreach(line IN LISTS lines)
    string(REPLACE ";" "\\;" line "${line}")
    list(APPEND violations "${file}: ${line}")
  endforeach()
endforeach()
if(violations)
  list(JOIN violations "\n  " text)
  message(FATAL_ERROR "literals that name a flag or a command of the program (see core/remedy.hpp):\n  ${text}")
endif()
message(STATUS "no literal of ${count} files names a flag or a command")
