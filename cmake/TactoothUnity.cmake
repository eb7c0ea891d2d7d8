# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# Most of the time of a usual file goes into headers that its neighbours read as well, so a few files of a target are
# compiled as one: docs/decisions/0018-compile-files-together.md has the figures. The preset `dev` compiles each file for
# itself, which shows an include that is missing.
option(TACTOOTH_UNITY "Compile a few files of a target together" ${PROJECT_IS_TOP_LEVEL})
find_package(Python3 COMPONENTS Interpreter QUIET)

# What one run of the compiler gets at most. With more, a first build takes less time and a build after a change takes more.
set(tactooth_unity_lines 1500)

# tactooth_unity(TARGET): for a target with two files or more.
function(tactooth_unity target)
  set_property(GLOBAL APPEND PROPERTY tactooth_unity_targets ${target})
endfunction()

# tactooth_choose_unity_groups(): once, after all targets and the properties of all files are known.
function(tactooth_choose_unity_groups)
  if(NOT TACTOOTH_UNITY OR NOT Python3_FOUND)
    return()
  endif()
  get_property(targets GLOBAL PROPERTY tactooth_unity_targets)
  set(files)
  foreach(target IN LISTS targets)
    get_target_property(sources ${target} SOURCES)
    get_target_property(folder ${target} SOURCE_DIR)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    foreach(source IN LISTS sources)
      get_source_file_property(generated ${source} TARGET_DIRECTORY ${target} GENERATED)
      get_source_file_property(definitions ${source} TARGET_DIRECTORY ${target} COMPILE_DEFINITIONS)
      get_source_file_property(options ${source} TARGET_DIRECTORY ${target} COMPILE_OPTIONS)
      if(NOT generated AND NOT definitions AND NOT options)
        cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} NORMALIZE)
        string(APPEND files "${target} ${source}\n")
      endif()
    endforeach()
  endforeach()
  set(list ${PROJECT_BINARY_DIR}/unity_files.txt)
  file(WRITE ${list} "${files}")
  execute_process(COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/unity_groups.py ${tactooth_unity_lines}
    INPUT_FILE ${list} OUTPUT_VARIABLE groups COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" groups "${groups}")
  foreach(line IN LISTS groups)
    string(REGEX MATCH "^([^ ]+) ([0-9]+) (.*)$" _ "${line}")
    set_source_files_properties(${CMAKE_MATCH_3} TARGET_DIRECTORY ${CMAKE_MATCH_1} PROPERTIES UNITY_GROUP ${CMAKE_MATCH_2})
  endforeach()
  set_target_properties(${targets} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# The compiler takes the files of a group for headers, where a type with a part that only that file knows is a mistake.
if(TACTOOTH_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(tactooth_settings INTERFACE -Wno-subobject-linkage)
endif()
