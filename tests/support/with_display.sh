#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# with_display.sh PROGRAM ARGUMENTS...: runs a program on a display of its own. xvfb-run waits for ever where a busy
# machine lets the signal that the display is ready come before the shell waits for it; here the server notifies the
# number of the display through a pipe.
set -euo pipefail
folder=$(mktemp -d)
server=
end() {
  if [ -n "$server" ]; then
    kill "$server" 2>/dev/null || true
    wait "$server" 2>/dev/null || true
  fi
  rm -rf "$folder"
}
trap end EXIT
mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 1400x900x24 -nolisten tcp 3>"$folder/display" >/dev/null 2>"$folder/errors" &
server=$!
number=
read -r number <"$folder/display" || true
if [ -z "$number" ]; then
  echo "there is no display: $(cat "$folder/errors")" >&2
  exit 1
fi
status=0
DISPLAY=":$number" "$@" || status=$?
exit "$status"
