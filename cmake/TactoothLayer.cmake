# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# One layer = one folder below src/ = one static library.
#
#   tactooth_layer(NAME collision FOLDERS narrow bvh ... SOURCES bvh/aabb_tree.cpp ... USES geometry LINKS TBB::tbb
#     [PRIVATE_LINKS ...] [HEADERS tactooth_session_headers])
#
# FOLDERS lists the folders of a large layer in their order: a file may include files of its own folder and of those before
# it in the list, never of a later one (checked by cmake/check_sources.py).
#
# A layer's headers are included as "collision/bvh/aabb_tree.h". The include root of a layer holds that layer alone
# (a link to its folder), so a header of a layer that the target does not use is not found: the compiler enforces
# the architecture.
function(tactooth_layer)
  cmake_parse_arguments(ARG "" "NAME;HEADERS" "FOLDERS;SOURCES;USES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(target tactooth_${ARG_NAME})
  set(root ${PROJECT_BINARY_DIR}/layers/${ARG_NAME})
  file(MAKE_DIRECTORY ${root})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${root}/${ARG_NAME} SYMBOLIC)

  if(NOT ARG_SOURCES)
    set(ARG_SOURCES ${PROJECT_SOURCE_DIR}/cmake/empty.cpp)
  endif()
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(tactooth::${ARG_NAME} ALIAS ${target})
  target_include_directories(${target} PUBLIC ${root})
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/include)
  list(TRANSFORM ARG_USES PREPEND tactooth::)
  target_link_libraries(${target} PUBLIC tactooth_settings ${ARG_USES} ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  if(NOT ARG_HEADERS)
    set(ARG_HEADERS tactooth_layer_headers)
  endif()
  tactooth_use_headers(${target} ${ARG_HEADERS})
  tactooth_unity(${target})
endfunction()

# tactooth_folder_order(gui FOLDERS text input ...): the order of the folders below a folder that is no layer, for
# cmake/check_sources.py.
function(tactooth_folder_order)
endfunction()

# tactooth_tests(NAME collision [PACED] [SPARE] [SANITIZED] [SHARDS 4] SOURCES aabb_tree_test.cpp ... [LABELS long] [LINKS ...])
# builds one test program for a layer and registers it with CTest as one test: its cases share teeth that take longer to
# model than to test. A program of more than half a minute is run as SHARDS tests, which several processors share. PACED is
# for programs that hold a real-time pace: one of them at a time, and no other test beside it under a sanitizer, which
# makes their threads too slow for one core. SPARE is for programs that lower their own priority and take a fixed time: one
# of them after the other from the beginning on, beside all others. Under a sanitizer the long programs are left out, but for
# those that are SANITIZED; without TACTOOTH_LONG_TESTS all of them.
#
# What a test does itself is little beside what it tests: compiled with less care it takes a quarter less time to compile.
set(tactooth_test_options $<$<CONFIG:Release>:-O1>)
function(tactooth_tests)
  cmake_parse_arguments(ARG "PACED;SPARE;SANITIZED" "NAME;SHARDS" "SOURCES;LABELS;LINKS" ${ARGN})
  set(target ${ARG_NAME}_tests)
  add_executable(${target} ${ARG_SOURCES})
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})  # the helpers of a layer's tests
  target_link_libraries(${target} PRIVATE ${ARG_LINKS} tactooth_test_support GTest::gtest GTest::gtest_main)
  if(ARG_LINKS MATCHES "tactooth_gui")
    tactooth_use_headers(${target} tactooth_app_headers)
  elseif(ARG_LINKS MATCHES "tactooth::(session|assessment|experiments)")
    tactooth_use_headers(${target} tactooth_session_test_headers)
    target_compile_options(${target} PRIVATE ${tactooth_test_options})
  elseif(NOT ARG_LINKS MATCHES "CGAL")
    tactooth_use_headers(${target} tactooth_test_headers)
    target_compile_options(${target} PRIVATE ${tactooth_test_options})
  endif()
  tactooth_unity(${target})
  if(NOT ARG_LABELS)
    set(ARG_LABELS ${ARG_NAME})
  endif()
  if("long" IN_LIST ARG_LABELS AND (NOT TACTOOTH_LONG_TESTS OR (TACTOOTH_SANITIZE AND NOT ARG_SANITIZED)))
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()

  set(company)
  if(ARG_SPARE)
    set(company COST 2000 RESOURCE_LOCK spare_time)
  elseif(ARG_PACED)  # a row of tests that mostly wait: the last one would have the processors for itself
    set(company COST 500)
  elseif("long" IN_LIST ARG_LABELS OR ARG_SHARDS)  # before the others, which fill the gaps that these leave
    set(company COST 100)
  endif()
  if(ARG_PACED AND TACTOOTH_SANITIZE)
    list(APPEND company RUN_SERIAL TRUE)
  elseif(ARG_PACED)
    list(APPEND company RESOURCE_LOCK real_time)
  endif()
  if(NOT ARG_SHARDS)
    set(ARG_SHARDS 1)
  endif()
  foreach(shard RANGE 1 ${ARG_SHARDS})
    set(name ${target})
    if(ARG_SHARDS GREATER 1)
      set(name ${target}.${shard})
    endif()
    math(EXPR index "${shard} - 1")
    add_test(NAME ${name} COMMAND ${target} --gtest_brief=1)
    set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 7200 ${company}
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${ARG_SHARDS};GTEST_SHARD_INDEX=${index}")
  endforeach()
endfunction()
