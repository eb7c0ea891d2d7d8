# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# The layers below session/ know no TOML, and build without a reader of it. What they need of the files in data/ becomes
# C++ here: one call for each value.
#
# tactooth_toml_calls(OUT FILE) reads blocks below a [name], or rows in braces of a list, with texts, numbers, lists of
# three numbers, and no '#' but before comments. A test compares the result with what the program's reader of TOML makes
# of the same file.
function(tactooth_toml_calls out file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} calls)
  string(REGEX REPLACE " *#[^\n]*" "" calls "${calls}")
  string(REGEX REPLACE "\n+" "\n" calls "${calls}")
  string(REGEX REPLACE "\n[a-z]+ = \\[\n" "\n" calls "${calls}")
  string(REGEX REPLACE "\n\\](\n|$)" "\n" calls "${calls}")
  string(REGEX REPLACE "\n\\[([a-z0-9_-]+)\\]" "\n    all.begin(\"\\1\");" calls "${calls}")
  string(REGEX REPLACE "\n *{ " "\n    all.begin();\n    " calls "${calls}")
  string(REGEX REPLACE " *},?\n" "\n" calls "${calls}")
  string(REGEX REPLACE "([a-z_]+) = (\"[^\"\n]*\"),? ?" "    all.setText(\"\\1\", \\2);\n" calls "${calls}")
  string(REGEX REPLACE "([a-z_]+) = \\[([^]]*)\\],? ?" "    all.setList(\"\\1\", {\\2});\n" calls "${calls}")
  string(REGEX REPLACE "([a-z_]+) = ([^,\n]+),? ?" "    all.setNumber(\"\\1\", \\2);\n" calls "${calls}")
  string(REGEX REPLACE "\n[ \n]*\n" "\n" calls "${calls}")
  set(${out} "${calls}" PARENT_SCOPE)
endfunction()
