# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# OpenVDB is optional: where it is found, there is a target tactooth_openvdb to link. The library's own find script asks
# for parts that neither the program nor Debian's package needs.
find_path(TACTOOTH_OPENVDB_INCLUDE openvdb/openvdb.h)
find_library(TACTOOTH_OPENVDB_LIBRARY openvdb)
# Debian's package names the library of a Python module that it does not hold, and says so at length.
set(log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
find_package(Imath QUIET)
set(CMAKE_MESSAGE_LOG_LEVEL "${log_level}")
mark_as_advanced(TACTOOTH_OPENVDB_INCLUDE TACTOOTH_OPENVDB_LIBRARY)
if(TACTOOTH_OPENVDB AND TACTOOTH_OPENVDB_INCLUDE AND TACTOOTH_OPENVDB_LIBRARY AND Imath_FOUND)
  find_package(TBB REQUIRED)
  add_library(tactooth_openvdb INTERFACE)
  target_include_directories(tactooth_openvdb SYSTEM INTERFACE ${TACTOOTH_OPENVDB_INCLUDE})
  target_link_libraries(tactooth_openvdb INTERFACE ${TACTOOTH_OPENVDB_LIBRARY} Imath::Imath TBB::tbb)
endif()
