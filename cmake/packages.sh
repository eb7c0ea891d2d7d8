# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# Shell functions that ./run and ./test share. The caller sets `root` to the folder of the sources.

say() { printf 'tactooth: %s\n' "$*" >&2; }

# packages_of GROUP... prints the packages of these groups, one a line.
packages_of() {
  awk -v groups=" $* " '$1 !~ /^#/ && NF > 1 && index(groups, " " $1 " ") { print $2 }' "$root/cmake/debian-packages.txt"
}

# ensure_packages GROUP... installs what is missing of these groups; as root itself, else with sudo.
ensure_packages() {
  if [ -n "${TACTOOTH_SKIP_PACKAGES:-}" ]; then return; fi
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    say "this system has no apt-get: install what cmake/debian-packages.txt lists in your system's way," \
      "then start again with TACTOOTH_SKIP_PACKAGES=1."
    exit 2
  fi
  local wanted missing sudo=()
  wanted=$(packages_of "$@")
  # dpkg-query fails if one package is unknown, and still reports the others.
  missing=$(comm -23 <(sort <<<"$wanted") <(
    dpkg-query -W -f='${Package} ${db:Status-Status}\n' $wanted 2>/dev/null | awk '$2 == "installed" { print $1 }' | sort -u))
  if [ -z "$missing" ]; then return; fi
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      say "these packages are missing: $(echo $missing). Let root run: apt-get install --no-install-recommends $(echo $missing)"
      exit 2
    fi
    sudo=(sudo)
  fi
  say "installing Debian packages: $(echo $missing)"
  "${sudo[@]}" apt-get update -q >&2
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing >&2
}

# jobs_that_fit prints how many files to compile at once: one a processor, but no more than memory allows (1 GB each).
jobs_that_fit() {
  local processors memory
  processors=$(nproc)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1000000) }' /proc/meminfo)
  if [ "$memory" -lt 1 ]; then memory=1; fi
  echo $((processors < memory ? processors : memory))
}
