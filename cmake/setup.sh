# SPDX-License-Identifier: BSL-1.0
# shellcheck shell=bash
# Sourced by examples/run, tests/run and the scripts of .ci: finds or installs what riprap needs,
# then configures and builds in build/release, or in the folder that RIPRAP_BUILD_DIR names.

root=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
# Absolute, for scripts that call others from elsewhere.
[[ ${RIPRAP_BUILD_DIR:-/} == /* ]] || RIPRAP_BUILD_DIR=$PWD/$RIPRAP_BUILD_DIR
build=${RIPRAP_BUILD_DIR:-$root/build/release}
log=$build/setup.log
jobs=$(nproc 2>/dev/null || getconf _NPROCESSORS_ONLN)

# Debian package | header that shows it is there, or several to choose from | name
libraries=(
  "libeigen3-dev|eigen3/Eigen/Core Eigen/Core|Eigen 3.3"
  "libboost-dev|boost/version.hpp|Boost 1.74 (headers)"
  "libcli11-dev|CLI/CLI.hpp|CLI11"
  "nlohmann-json3-dev|nlohmann/json.hpp|nlohmann-json 3"
  "libhdf5-dev|hdf5/serial/hdf5.h hdf5.h|HDF5 (C library)"
)

# Debian package | command or file that shows it is there | name
tools=("make|make|make")

# To stderr, so that what an example prints can be piped.
say() { printf '%s\n' "$*" >&2; }

check_build_folder() {
  { mkdir -p "$build" && : >"$log"; } 2>/dev/null && return
  say "The build folder $build is not writable; RIPRAP_BUILD_DIR=FOLDER in the environment names another."
  exit 1
}

# into_log COMMAND...: its output goes to the log.
into_log() {
  check_build_folder
  "$@" >"$log" 2>&1 </dev/null
}

# fail COMMAND...: shows the log of a command that has failed.
fail() {
  cat "$log" >&2
  say "failed: $*"
  exit 1
}

# quietly COMMAND...: its output is shown only when it fails, and then this is the end.
quietly() { into_log "$@" || fail "$@"; }

has_compiler() {
  local compiler
  read -ra compiler <<<"${CXX:-c++}"
  "${compiler[@]}" -std=c++20 -fsyntax-only -x c++ "$root/include/riprap/core/compiler.hpp" >/dev/null 2>&1
}

has_cmake() {
  local version
  version=$(cmake --version 2>/dev/null | sed -n 's/^cmake version //p')
  [[ $(printf '%s\n' 3.21 "$version" | sort -V | head -n 1) == 3.21 ]]
}

# has_header HEADER...: is one of them where CMake looks for libraries, that is under
# CMAKE_PREFIX_PATH, next to a bin folder on PATH, or in /usr?
has_header() {
  local prefix header
  while IFS= read -r -d : prefix; do
    for header in "$@"; do
      [[ -e ${prefix%/*bin}/include/$header ]] && return
    done
  done <<<"${CMAKE_PREFIX_PATH:-}:$PATH:/usr:"
  return 1
}

# Fills `missing` with the packages and says what each of them is.
look_for_needs() {
  local library tool package headers command name
  missing=()
  has_compiler || { missing+=(g++); say "missing: a C++20 compiler, g++ 12 or clang 16 (CXX says which)"; }
  has_cmake || { missing+=(cmake); say "missing: CMake 3.21"; }
  for tool in "${tools[@]}"; do
    IFS='|' read -r package command name <<<"$tool"
    [[ -e $command ]] || command -v "$command" >/dev/null ||
      { missing+=("$package"); say "missing: $name"; }
  done
  for library in "${libraries[@]}"; do
    IFS='|' read -r package headers name <<<"$library"
    # shellcheck disable=SC2086 # several headers
    has_header $headers || { missing+=("$package"); say "missing: $name"; }
  done
}

# wait_for_apt COMMAND...: like quietly, but tries again while another process holds a lock of apt,
# for ten minutes. Not apt's DPkg::Lock::Timeout, which does not cover the lock of its lists.
wait_for_apt() {
  local tries
  for tries in {1..120}; do
    into_log "$@" && return
    grep -q 'Could not get lock\|locked by another process' "$log" || break
    ((tries > 1)) || say "waiting for another process that holds the lock of apt ..."
    sleep 5
  done
  fail "$@"
}

# install_packages PACKAGE...: false where there is no apt, or no right to use it.
install_packages() {
  local as_root=(env)
  ((EUID == 0)) || as_root=(sudo env)
  as_root+=(LC_ALL=C DEBIAN_FRONTEND=noninteractive)
  command -v apt-get >/dev/null && command -v "${as_root[0]}" >/dev/null || return
  say "installing $* ..."
  wait_for_apt "${as_root[@]}" apt-get update
  wait_for_apt "${as_root[@]}" apt-get install --yes --no-install-recommends "$@"
}

install_needs() {
  look_for_needs
  ((${#missing[@]})) || return 0

  if ! install_packages "${missing[@]}"; then
    say "Install these (by the names of their Debian packages) and try again: ${missing[*]}"
    say "Libraries in a place of their own are found through CMAKE_PREFIX_PATH."
    exit 1
  fi
  look_for_needs
  ((${#missing[@]} == 0)) || { say "still missing after the installation"; exit 1; }
}

# Makes configure run CMake again.
forget_configuration() {
  check_build_folder
  rm -f "$build/configured"
}

# configure SETTING...: configures the build folder, unless that is done and the settings (NAME=ON or
# NAME=OFF) are as they stand. The two named below may also come from the environment.
configure() {
  local settings=("$@") setting
  for setting in RIPRAP_WARNINGS_AS_ERRORS RIPRAP_CHECK_HEADERS; do
    [[ -z ${!setting:-} ]] || settings+=("$setting=${!setting}")
  done
  for setting in "${settings[@]}"; do
    grep -qsx "${setting/=/:BOOL=}" "$build/CMakeCache.txt" || forget_configuration
  done
  [[ ! -e $build/configured ]] || return 0

  if [[ ! -e $build/CMakeCache.txt ]]; then
    # Only what is asked for, so that running an example does not need doctest.
    settings=(CMAKE_BUILD_TYPE=Release RIPRAP_BUILD_TESTS=OFF RIPRAP_BUILD_EXAMPLES=OFF
      RIPRAP_BUILD_BENCHMARKS=OFF "${settings[@]}")
  fi
  quietly cmake -S "$root" -B "$build" "${settings[@]/#/-D}"
  touch "$build/configured"
}

build_target() { quietly cmake --build "$build" --target "$1" --parallel "$jobs"; }

# The short programs of examples/basics, and the others, of which each has a folder.
short_example_names() { basename -s .cpp "$root"/examples/basics/*.cpp; }
long_example_names() {
  local folder name
  for folder in "$root"/examples/*/; do
    name=$(basename "$folder")
    [[ ! -f $folder$name.cpp ]] || echo "$name"
  done
}
example_names() { short_example_names; long_example_names; }

# example_source NAME: the file with its main function; false where there is no such example.
example_source() {
  local file
  for file in "$root/examples/basics/$1.cpp" "$root/examples/$1/$1.cpp"; do
    [[ ! -f $file ]] || { echo "$file"; return; }
  done
  return 1
}
