# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# Writes FROM to TO with the commit that SOURCE_DIR is at; GIT is the program, or not found.
set(TACTOOTH_COMMIT "unknown")
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE_DIR} rev-parse --short=10 HEAD
    OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(TACTOOTH_COMMIT ${said})
  endif()
endif()
configure_file(${FROM} ${TO} @ONLY)
file(TOUCH ${TO})
