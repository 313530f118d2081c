# Programs of tests, and what ctest knows of them.

find_package(GTest REQUIRED)
include(GoogleTest)

# Read by the compiler once for all of them. It holds no header of a room, so that no wall has a hole.
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp CONTENT "")
add_library(rambla_test_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
target_link_libraries(rambla_test_headers PRIVATE rambla_options GTest::gtest GTest::gmock)
set(rambla_test_precompiled <gtest/gtest.h> <gmock/gmock.h> <filesystem> <string> <vector>)
target_precompile_headers(rambla_test_headers PRIVATE ${rambla_test_precompiled})

# Tests are compiled more often than they are run: what they call is in the rooms, which have all optimisations.
if(CMAKE_BUILD_TYPE STREQUAL Release)
  set(rambla_test_optimisation -O1)
endif()
target_compile_options(rambla_test_headers PRIVATE ${rambla_test_optimisation})

# rambla_tests(NAME FOLDER LINKS target... [LABELS label...] [COST cost] [ALONE filter] [OPTIMISED] [SHARDED]): one program
# from FOLDER's *_test.cpp, one ctest entry per test. The dearest begin first, so that no long one is left over at the end;
# those that FILTER names never run beside each other. OPTIMISED is for long random runs inside of the test's own code.
# SHARDED says that its tests hold in any order in one process (try it by --gtest_shuffle).
function(rambla_tests name folder)
  cmake_parse_arguments(arg "OPTIMISED;SHARDED" "COST;ALONE" "LINKS;LABELS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE ${arg_LINKS} rambla_options GTest::gtest GTest::gmock GTest::gtest_main)
  if(arg_OPTIMISED)
    # GCC 12 falls over functions that a precompiled header brings with other optimisations.
    target_precompile_headers(${name} PRIVATE ${rambla_test_precompiled})
  else()
    target_precompile_headers(${name} REUSE_FROM rambla_test_headers)
    target_compile_options(${name} PRIVATE ${rambla_test_optimisation})
  endif()
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE
    RAMBLA_SOURCE_DIR="${CMAKE_SOURCE_DIR}" RAMBLA_BINARY_DIR="${CMAKE_BINARY_DIR}" RAMBLA_GLTF_DIR="${RAMBLA_GLTF_DIR}")
  cmake_path(GET folder FILENAME room)
  set(properties LABELS "${arg_LABELS}" TIMEOUT 300 ENVIRONMENT "LP_NUM_THREADS=1"
    ENVIRONMENT_MODIFICATION "RAMBLA_CACHE_DIR=set:${CMAKE_BINARY_DIR}/cache")
  set(discovery ${name} TEST_PREFIX ${room}. DISCOVERY_MODE PRE_TEST)
  if(arg_COST)
    list(APPEND properties COST ${arg_COST})
  endif()
  if(arg_ALONE)
    # They are one chain: the longest of all, unless it begins first.
    gtest_discover_tests(${discovery} TEST_FILTER ${arg_ALONE} TEST_LIST ${name}_ALONE
      PROPERTIES ${properties} COST 100 RESOURCE_LOCK ${name})
    gtest_discover_tests(${discovery} TEST_FILTER -${arg_ALONE} PROPERTIES ${properties})
  else()
    gtest_discover_tests(${discovery} PROPERTIES ${properties})
  endif()
  if(arg_SHARDED)
    rambla_shards(${name} ${room} ${properties})
  endif()
endfunction()

# rambla_shards(NAME ROOM property value...): where ctest's environment has RAMBLA_TEST_SHARDS=N, the tests of program
# NAME are N entries, each of which runs an Nth of them in one process, instead of an entry and a process per test. Most
# unit tests are over in less time than their program takes to start, with 270 shared libraries and perhaps a sanitizer.
function(rambla_shards name room)
  get_property(includes DIRECTORY PROPERTY TEST_INCLUDE_FILES)
  list(POP_BACK includes one_by_one)  # what gtest_discover_tests has just put there
  set(RAMBLA_PROGRAM ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${name})
  set(RAMBLA_ONE_BY_ONE ${one_by_one})
  set(RAMBLA_NAME ${room}.${name})
  list(JOIN ARGN "\" \"" RAMBLA_PROPERTIES)
  set(RAMBLA_PROPERTIES "\"${RAMBLA_PROPERTIES}\"")
  configure_file(${CMAKE_SOURCE_DIR}/cmake/test_shards.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/${name}_shards.cmake @ONLY)
  set_property(DIRECTORY PROPERTY TEST_INCLUDE_FILES ${includes} ${CMAKE_CURRENT_BINARY_DIR}/${name}_shards.cmake)
endfunction()
