#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# check_format.sh: prints the C++ files that clang-format would lay out in another way, and fails if there are any.
# Versions of clang-format differ: it ends with 77 (skipped) where the one of Debian 12 is missing.
set -uo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

format=
for candidate in clang-format-14 clang-format; do
  if [[ $("$candidate" --version 2>/dev/null) == *'version 14.'* ]]; then format=$candidate; fi
done
if [ -z "$format" ]; then
  echo "skipped: clang-format 14 is not installed (apt-get install clang-format)"
  exit 77
fi

files=$(find src include tests bench examples \( -name '*.h' -o -name '*.cpp' \) -not -path '*/corpus/*')
offences=$(xargs -P 2 -n 40 "$format" --dry-run -Werror --ferror-limit=1 <<<"$files" 2>&1 | grep 'error:' | sort -u)
names=$(cut -d: -f1 <<<"$offences" | sort -u)
if [ -n "$offences" ]; then
  echo "$names"
  echo "$(wc -l <<<"$names") of $(wc -l <<<"$files") files; run: $format -i FILES"
  exit 1
fi
echo "$(wc -l <<<"$files") files, 0 offences"
