# How every library and program of the project is built: language level, warnings, floating-point
# rules, sanitizers, one precompiled header per library.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug or RelWithDebInfo" FORCE)
endif()
set(ALLTACT_SANITIZE "" CACHE STRING "Sanitizers for our own code, e.g. address,undefined or thread")

find_program(ALLTACT_CCACHE ccache)
if(ALLTACT_CCACHE)
  # Precompiled headers need the sloppiness, or nothing is ever found in the cache.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${ALLTACT_CCACHE})
endif()

add_library(alltact_options INTERFACE)
target_compile_options(
  alltact_options
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            -Werror
            # The same bytes everywhere: no contraction into fused multiply-adds, no -ffast-math.
            -ffp-contract=off
            # Costs nothing in meaning (we never read errno of a maths call nor unmask traps in
            # release code) and lets loops with sqrt vectorise.
            -fno-math-errno
            -fno-trapping-math
            -fpch-preprocess
            # Unless the target only calls what was built for speed (property ALLTACT_QUICK_BUILD).
            $<$<CONFIG:Release>:-O$<IF:$<BOOL:$<TARGET_PROPERTY:ALLTACT_QUICK_BUILD>>,1,3>>)
if(ALLTACT_SANITIZE)
  target_compile_options(
    alltact_options INTERFACE -fsanitize=${ALLTACT_SANITIZE} -fno-omit-frame-pointer
                              -fno-sanitize-recover=all)
  target_link_options(alltact_options INTERFACE -fsanitize=${ALLTACT_SANITIZE})
endif()

# alltact_library(NAME SOURCES... PUBLIC libs... PRIVATE libs... PCH headers...)
# makes the static library alltact_NAME with the alias alltact::NAME.
function(alltact_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE;PCH" ${ARGN})
  add_library(alltact_${name} STATIC ${arg_SOURCES})
  add_library(alltact::${name} ALIAS alltact_${name})
  target_include_directories(alltact_${name} PUBLIC ${CMAKE_SOURCE_DIR})
  target_link_libraries(
    alltact_${name}
    PUBLIC ${arg_PUBLIC}
    PRIVATE ${arg_PRIVATE} alltact_options)
  target_precompile_headers(alltact_${name} PRIVATE ${arg_PCH})
  alltact_system_includes(alltact_${name})
endfunction()

# OpenCV's headers warn by the hundred in C++20; nobody here can mend them.
function(alltact_system_includes target)
  target_include_directories(${target} SYSTEM PRIVATE ${OpenCV_INCLUDE_DIRS} ${EIGEN3_INCLUDE_DIRS})
endfunction()
