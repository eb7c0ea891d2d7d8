#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# check_install.sh BUILD_FOLDER: installs the programs of this build into a temporary folder. An installed tactooth
# finds its tactooth-hand when it is started by its path, by a link to it or by PATH, from any folder, and says so where
# there is none.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$1" --prefix "$folder/installed" >"$folder/log" || { cat "$folder/log"; exit 1; }
mkdir "$folder/links" "$folder/elsewhere"
ln -s "$folder/installed/bin/tactooth" "$folder/links/drill"
cd "$folder/elsewhere"
export XDG_STATE_HOME="$folder/state"  # no faults of the user

# expect TEXT PROGRAM: what doctor says of the hand process begins with the text. Doctor ends with 1 without a display.
expect() {
  local said
  said=$("$2" doctor --json || true)
  said=$(grep -o '"The program that holds the devices[^"]*"' <<<"$said" || true)
  if [[ "$said" != "\"$1"* ]]; then
    echo "started as $2, doctor says: $said"
    exit 1
  fi
}
there="The program that holds the devices is there"
expect "$there" "$folder/installed/bin/tactooth"
expect "$there" "$folder/links/drill"
PATH="$folder/links:$PATH" expect "$there" drill
PATH="$folder/installed/bin:$PATH" expect "$there" tactooth
rm "$folder/installed/bin/tactooth-hand"
expect "The program that holds the devices is missing" "$folder/installed/bin/tactooth"
