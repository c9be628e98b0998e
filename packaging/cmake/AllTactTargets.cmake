# How every library and program of the project is built: language level, warnings, floating-point
# rules, sanitizers, one precompiled header per library.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# Qt's moc reads headers only: nothing waits for libraries to be linked before it.
set(CMAKE_AUTOGEN_ORIGIN_DEPENDS OFF)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug or RelWithDebInfo" FORCE)
endif()
# Assertions stay in every build: what is tested is what runs. Those of Eigen, in every kernel, only with sanitizers.
string(REPLACE "-DNDEBUG" "" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
set(ALLTACT_SANITIZE "" CACHE STRING "Sanitizers for our own code, e.g. address,undefined or thread")

find_program(ALLTACT_CCACHE ccache)
if(ALLTACT_CCACHE)
  # Precompiled headers need the sloppiness, or nothing is ever found in the cache.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${ALLTACT_CCACHE})
endif()

# Installed: programs in bin, libraries in lib, the parts that programs load when they need them in lib/alltact. Each
# finds the others from where it lies itself, so the tree may be moved.
include(GNUInstallDirs)
set(ALLTACT_PARTS_FOLDER ${CMAKE_INSTALL_LIBDIR}/alltact)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
file(RELATIVE_PATH alltact_lib_from_bin ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set(CMAKE_INSTALL_RPATH "$ORIGIN/${alltact_lib_from_bin}:$ORIGIN/..:$ORIGIN")

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
            # Of sources that are compiled together g++ takes each for a header.
            -Wno-subobject-linkage
            # g++ 12 sees one where fmt checks for it by an assertion.
            -Wno-stringop-overflow
            # What is in one library is called as directly as in a static one.
            -fno-semantic-interposition
            # Files are named as they lie in the sources: the same bytes from any folder, and nobody's folders in a program.
            -ffile-prefix-map=${CMAKE_SOURCE_DIR}/=
            $<$<CONFIG:Release>:-DEIGEN_NO_DEBUG>
            # Unless the target only calls what was built for speed (property ALLTACT_QUICK_BUILD).
            $<$<CONFIG:Release>:-O$<IF:$<BOOL:$<TARGET_PROPERTY:ALLTACT_QUICK_BUILD>>,1,3>>)
if(ALLTACT_SANITIZE)
  target_compile_options(
    alltact_options INTERFACE -fsanitize=${ALLTACT_SANITIZE} -fno-omit-frame-pointer
                              -fno-sanitize-recover=all
                              # g++ warns of ways through the code that only the sanitizers' own checks make.
                              -Wno-error)
  target_link_options(alltact_options INTERFACE -fsanitize=${ALLTACT_SANITIZE})
  if(ALLTACT_SANITIZE MATCHES fuzzer)
    target_compile_options(alltact_options INTERFACE -fsanitize-coverage-ignorelist=${CMAKE_SOURCE_DIR}/tests/fuzz/untraced)
  endif()
endif()

# alltact_library(NAME [SHARED] [FOLDERS...] [SOURCES...] PUBLIC libs... PRIVATE libs... PCH headers... | PCH_OF target)
# makes the library alltact_NAME with the alias alltact::NAME; static unless several parts of a program share it. A shared
# one is installed for other programs too (AllTactInstall.cmake); what it offers may change with the minor version.
# FOLDERS: all sources below them. PCH_OF: the precompiled header that another library has already.
function(alltact_library name)
  cmake_parse_arguments(arg "SHARED" "PCH_OF" "FOLDERS;SOURCES;PUBLIC;PRIVATE;PCH" ${ARGN})
  foreach(folder IN LISTS arg_FOLDERS)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    list(APPEND arg_SOURCES ${sources})
  endforeach()
  if(arg_SHARED)
    add_library(alltact_${name} SHARED ${arg_SOURCES})
    # Where results are computed every narrowing is written down.
    target_compile_options(alltact_${name} PRIVATE -Wshadow -Wconversion)
    set_target_properties(
      alltact_${name} PROPERTIES OUTPUT_NAME alltact-${name} EXPORT_NAME ${name} VERSION ${PROJECT_VERSION}
                                 SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
                                 DEFINE_SYMBOL "") # one precompiled header serves several
    if(NOT ALLTACT_SANITIZE MATCHES fuzzer) # whose program brings what its libraries call
      target_link_options(alltact_${name} PRIVATE -Wl,--no-undefined)
    endif()
  else()
    add_library(alltact_${name} STATIC ${arg_SOURCES})
  endif()
  add_library(alltact::${name} ALIAS alltact_${name})
  target_include_directories(alltact_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>)
  target_link_libraries(
    alltact_${name}
    PUBLIC ${arg_PUBLIC}
    PRIVATE ${arg_PRIVATE} fmt::fmt alltact_options) # fmt: one precompiled header serves several
  if(arg_PCH_OF)
    target_precompile_headers(alltact_${name} REUSE_FROM ${arg_PCH_OF})
  else()
    target_precompile_headers(alltact_${name} PRIVATE ${arg_PCH})
  endif()
  alltact_system_includes(alltact_${name})
  alltact_compile_together(alltact_${name})
endfunction()

# alltact_libraries(NAME libraries...) makes alltact::NAME of several shared libraries, for programs that use most of them.
# One of them may be such a group itself.
function(alltact_libraries name)
  list(TRANSFORM ARGN PREPEND alltact_)
  add_library(alltact_${name} INTERFACE)
  add_library(alltact::${name} ALIAS alltact_${name})
  set_target_properties(alltact_${name} PROPERTIES EXPORT_NAME ${name})
  target_link_libraries(alltact_${name} INTERFACE ${ARGN})
  list(REMOVE_ITEM ARGN alltact_core) # which is installed already
  install(TARGETS alltact_${name} ${ARGN} EXPORT alltact
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# OpenCV's headers warn by the hundred in C++20; nobody here can mend them.
function(alltact_system_includes target)
  target_include_directories(${target} SYSTEM PRIVATE ${OpenCV_INCLUDE_DIRS} ${EIGEN3_INCLUDE_DIRS})
endfunction()

# alltact_compile_together(TARGET [MOST]) compiles a target's sources several at a time, those of one folder together,
# at most MOST of them: headers and templates that they share are read and built once. In return a name in an unnamed namespace stands once in its folder.
# -DALLTACT_UNITY=OFF builds each alone, which is quicker for whoever changes one file again and again.
option(ALLTACT_UNITY "Compile the sources of a folder together" ON)
function(alltact_compile_together target)
  if(NOT ALLTACT_UNITY)
    return()
  endif()
  set(most 8) # that one core still compiles in well under a minute
  if(ARGC GREATER 1)
    set(most ${ARGV1})
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} ABSOLUTE)
    get_filename_component(folder ${folder} DIRECTORY)
    string(MAKE_C_IDENTIFIER "${folder}" group)
    if(NOT DEFINED count_${group})
      set(count_${group} 0)
    endif()
    math(EXPR part "${count_${group}} / ${most}")
    math(EXPR count_${group} "${count_${group}} + 1")
    file(RELATIVE_PATH name ${CMAKE_SOURCE_DIR} ${folder})
    string(MAKE_C_IDENTIFIER "${name}" name)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${name}_${part}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
