# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# The checks of the sources and of the commits as tests, label `gate`; those that take more than seconds also `long`.
# A check whose program is not installed is skipped and says so.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# tactooth_gate(NAME COMMAND...)
function(tactooth_gate name)
  add_test(NAME ${name} COMMAND ${ARGN} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES LABELS gate SKIP_RETURN_CODE 77)
endfunction()

set(checks ${PROJECT_SOURCE_DIR}/cmake)
tactooth_gate(Sources.KeepTheHouseRules ${Python3_EXECUTABLE} ${checks}/check_sources.py ${PROJECT_SOURCE_DIR})
if(NOT TACTOOTH_SANITIZE)  # where they would say the same again
  tactooth_gate(Sources.ChecksFindOffences ${Python3_EXECUTABLE} ${checks}/checks/test_checks.py)
  tactooth_gate(Sources.AreFormatted ${checks}/check_format.sh)
  tactooth_gate(Sources.AreSpelledRight ${checks}/check_spelling.sh)
  tactooth_gate(Commits.HaveClearSubjects ${Python3_EXECUTABLE} ${checks}/check_commits.py)
  tactooth_gate(Benchmarks.AreComparedRight ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/bench/compare_test.py)
  tactooth_gate(Sources.AreGroupedRight ${Python3_EXECUTABLE} ${checks}/unity_groups_test.py)
  find_program(TACTOOTH_CLANG_TIDY clang-tidy)
  if(TACTOOTH_CLANG_TIDY AND CMAKE_EXPORT_COMPILE_COMMANDS)
    # Not yet in the preset `test`: not every file has passed.
    if(CMAKE_DISABLE_PRECOMPILE_HEADERS)
      tactooth_gate(Sources.AreTidy ${Python3_EXECUTABLE} ${checks}/check_tidy.py ${PROJECT_BINARY_DIR})
      set_tests_properties(Sources.AreTidy PROPERTIES LABELS "gate;long" TIMEOUT 20000)
    endif()
  endif()
endif()
