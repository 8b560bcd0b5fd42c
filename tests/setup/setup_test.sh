#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Functions of cmake/setup.sh, with an apt-get of the test's own.
# shellcheck disable=SC2016,SC2317 # variables for another shell; functions that check calls
set -euo pipefail
here=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

# check NAME COMMAND...: the command must succeed.
check() {
  if "${@:2}"; then echo "passed: $1"; return; fi
  echo "FAILED: $1"
  sed 's/^/  | /' "$scratch/said"
  failures=$((failures + 1))
}
is() { [[ $1 == "$2" ]]; }
# says N PATTERN: N lines of what was said match.
says() { is "$(grep -c -- "$2" "$scratch/said")" "$1"; }

# with_setup SCRIPT: runs it after cmake/setup.sh, without waiting; `status` and the file `said` tell
# the outcome.
with_setup() {
  status=0
  bash -euo pipefail -c '. "$1"; sleep() { :; }; eval "$2"' - "$root/cmake/setup.sh" "$1" \
    >"$scratch/said" 2>&1 || status=$?
}

# An apt-get that fails as often as the file `failures` has lines, with their text.
mkdir "$scratch/bin"
cat >"$scratch/bin/apt-get" <<'APT'
#!/usr/bin/env bash
folder=$(dirname "$0")
echo "$*" >>"$folder/calls"
[[ -s $folder/failures ]] || exit 0
head -n 1 "$folder/failures" >&2
sed -i 1d "$folder/failures"
exit 100
APT
printf '%s\n' '#!/bin/sh' 'exec "$@"' >"$scratch/bin/sudo"
chmod +x "$scratch"/bin/*
export PATH=$scratch/bin:$PATH RIPRAP_BUILD_DIR=$scratch/build

# install LINE...: apt-get fails with these lines first.
install() {
  rm -f "$scratch/bin/calls"
  (($# == 0)) || printf '%s\n' "$@" >"$scratch/bin/failures"
  with_setup 'install_packages some-package'
}
calls() { is "$(wc -l <"$scratch/bin/calls")" "$1"; }
lists='E: Could not get lock /var/lib/apt/lists/lock. It is held by process 77 (apt-get)'
dpkg='E: Could not get lock /var/lib/dpkg/lock-frontend. It is held by process 77 (unattended-upgr)'

install
check "packages are installed" is $status 0
check "with an update first" is "$(cut -d ' ' -f 1 "$scratch/bin/calls" | paste -sd ' ')" "update install"
install "$lists" "$lists" "$lists"
check "the lock of the lists is waited for" is $status 0
check "with a message" says 1 'waiting for another process'
check "until it is free" calls 5
install "$dpkg"
check "so is the lock of dpkg" is $status 0
with_setup "held() { echo '$lists'; return 100; }
  sleep() { echo \$1 >>$scratch/slept; }
  wait_for_apt held"
check "a lock that stays is a failure" is $status 1
check "after ten minutes" is "$(awk '{ s += $1 } END { print s }' "$scratch/slept")" 600
check "and is shown" says 1 'lists/lock'
install 'E: Unable to locate package some-package'
check "other failures are not waited for" is $status 1
check "and shown at once" calls 1
rm -f "$scratch/bin/failures"

export RIPRAP_BUILD_DIR=/dev/null/x
for command in 'quietly true' 'configure' 'install_packages some-package'; do
  with_setup "$command"
  check "$command in a folder that is not writable fails" is $status 1
  check "with its name and the way out" says 1 "/dev/null/x is not writable; RIPRAP_BUILD_DIR=FOLDER"
done

cd "$scratch"
RIPRAP_BUILD_DIR=relative with_setup 'cd /; quietly true; bash -c "echo \$RIPRAP_BUILD_DIR"'
check "a relative build folder stays where it was named" is "$(<said)" "$PWD/relative"
unset RIPRAP_BUILD_DIR
with_setup 'echo "${build#"$root/"} ${log#"$root/"}"'
check "the build folder without RIPRAP_BUILD_DIR" is "$(<said)" "build/release build/release/setup.log"

for script in tests/run examples/run benchmarks/run; do
  bash "$root/$script" --help >said 2>&1
  check "$script --help says how it is called" says 1 "^$script \(NAME \)\?\["
done
exit $((failures > 0))
