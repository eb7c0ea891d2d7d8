# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# Headers that nearly every file of a kind includes are read by the compiler once, which saves it half of its time on a
# usual test. Each file still includes what it uses: the preset `dev` builds without this.

# _REENTRANT as SDL's users have it. GCC 12 takes warnings of its own library for ours when they come from such a header.
set(tactooth_headers_options
  -D_REENTRANT $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess -Wno-array-bounds -Wno-maybe-uninitialized -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict>)

# tactooth_headers(NAME LINKS tactooth::geometry ... HEADERS <vector> ...)
function(tactooth_headers name)
  cmake_parse_arguments(ARG "" "" "LINKS;HEADERS" ${ARGN})
  add_library(${name} STATIC ${PROJECT_SOURCE_DIR}/cmake/empty.cpp)
  target_link_libraries(${name} PRIVATE ${ARG_LINKS})
  target_compile_options(${name} PRIVATE ${tactooth_headers_options})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
  # The compiler knows a header that it has read by its time. One that ccache keeps would be of another checkout in the
  # same folder, and its headers would be read twice.
  set_target_properties(${name} PROPERTIES CXX_COMPILER_LAUNCHER "")
endfunction()

# tactooth_use_headers(TARGET NAME): for a target with no compiler options of its own.
function(tactooth_use_headers target name)
  target_compile_options(${target} PRIVATE ${tactooth_headers_options})
  target_precompile_headers(${target} REUSE_FROM ${name})
endfunction()
