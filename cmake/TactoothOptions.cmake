# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# Build options and the compiler settings that every target shares (through one interface target).

option(TACTOOTH_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(TACTOOTH_LONG_TESTS "Build and run the tests with the label 'long', too" ON)
option(TACTOOTH_BENCHMARKS "Build the benchmarks" ${PROJECT_IS_TOP_LEVEL})
option(TACTOOTH_WERROR "Treat warnings as errors" OFF)
option(TACTOOTH_LIBRARY_ONLY "Build the layers that know no screen, sound or device (Eigen, TBB and Boost headers only)" OFF)
option(TACTOOTH_OPENVDB "Write .vdb files, if OpenVDB is found" ON)
option(TACTOOTH_ASSERTS "Check the asserts (geometry/util/assert.h)" OFF)
set(TACTOOTH_SANITIZE "" CACHE STRING "Sanitizers to build with: '', 'address,undefined' or 'thread'")

# Widest vector unit that this processor has. Only the width of a register changes with it, never a
# result: contraction to fused multiply-add is off everywhere.
if(NOT DEFINED TACTOOTH_SIMD)
  set(tactooth_simd_default sse2)
  if(EXISTS /proc/cpuinfo)
    file(STRINGS /proc/cpuinfo tactooth_cpu_flags REGEX "^flags.* avx2( |$)" LIMIT_COUNT 1)
    if(tactooth_cpu_flags)
      set(tactooth_simd_default avx2)
    endif()
  endif()
endif()
set(TACTOOTH_SIMD "${tactooth_simd_default}" CACHE STRING "Vector instructions: avx2, sse2 or scalar")
set_property(CACHE TACTOOTH_SIMD PROPERTY STRINGS avx2 sse2 scalar)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

find_program(TACTOOTH_CCACHE ccache)
if(TACTOOTH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Compiled headers are among what it may keep; it leaves them alone unless it is set to do so.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${TACTOOTH_CCACHE})
endif()

add_library(tactooth_settings INTERFACE)
target_compile_features(tactooth_settings INTERFACE cxx_std_20)
target_compile_options(tactooth_settings INTERFACE
  -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  $<$<BOOL:${TACTOOTH_WERROR}>:-Werror>
  $<$<STREQUAL:${TACTOOTH_SIMD},avx2>:-mavx2>)
target_compile_definitions(tactooth_settings INTERFACE
  $<$<STREQUAL:${TACTOOTH_SIMD},scalar>:TACTOOTH_SIMD_SCALAR>
  $<$<BOOL:${TACTOOTH_ASSERTS}>:TACTOOTH_ASSERTS>)
if(TACTOOTH_SANITIZE)
  target_compile_options(tactooth_settings INTERFACE -fsanitize=${TACTOOTH_SANITIZE} -fno-omit-frame-pointer -g1)
  target_link_options(tactooth_settings INTERFACE -fsanitize=${TACTOOTH_SANITIZE})
  if(TACTOOTH_SANITIZE MATCHES undefined)
    target_compile_options(tactooth_settings INTERFACE -fno-sanitize-recover=undefined)
  endif()
endif()

# Of TBB's scheduler the thread sanitizer would see but the half that stands in headers: files that include its loops,
# and be it by OpenVDB, are left out; geometry/util/parallel_for.h declares the order that these loops guarantee, there as well.
function(tactooth_includes_tbb_loops)
  if(TACTOOTH_SANITIZE MATCHES thread)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -fno-sanitize=thread SKIP_PRECOMPILE_HEADERS ON
      COMPILE_DEFINITIONS TACTOOTH_THREAD_SANITIZER)
  endif()
endfunction()
