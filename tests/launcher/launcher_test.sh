#!/bin/sh
# Specifies ./palpate with stand-ins for the programs that it calls, which note how they were called: nothing is
# installed or built. Usage: launcher_test.sh LAUNCHER PACKAGES_TXT
set -u
launcher=$1 packages=$2
sandbox=$(mktemp -d)
trap 'rm -rf "$sandbox"' EXIT
failures=0

# A fresh checkout in a folder with a space, and a PATH that begins with the stand-ins.
fresh() {
  rm -rf "${sandbox:?}"/*
  home="$sandbox/a checkout"
  fakes=$sandbox/fakes
  calls=$sandbox/calls
  mkdir -p "$home" "$fakes" "$sandbox/elsewhere"
  : >"$calls"
  cp "$launcher" "$packages" "$home"
  fake id 'echo 0'
  fake dpkg-query "awk '/^[a-z0-9]/ { print \"installed \" \$1 \", \" }' '$home/packages.txt'"
  fake apt-get :
  fake cmake "mkdir -p '$home/build/release' && : >'$home/build/release/build.ninja'
    printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\n' '$home' >'$home/build/release/CMakeCache.txt'
    for a; do case \$a in -DPALPATE_TESTS=*) echo \"PALPATE_TESTS:BOOL=\${a#*=}\" >>'$home/build/release/CMakeCache.txt' ;; esac; done"
  fake ninja "mkdir '$sandbox/building' || exit 1
    sleep 0.2
    mkdir -p '$home/build/release/app'
    printf '#!/bin/sh\nprintf \"<%%s>\" \"\$@\"\nexit 42\n' >'$home/build/release/app/palpate'
    chmod +x '$home/build/release/app/palpate'
    rmdir '$sandbox/building'"
  fake ctest 'echo "100% tests passed, 0 tests failed out of 1"'
}

fake() {
  printf '#!/bin/sh\nprintf "%%s\\n" "%s $*" >>"%s"\n%s\n' "$1" "$calls" "$2" >"$fakes/$1"
  chmod +x "$fakes/$1"
}

# Calls the launcher from another folder; leaves $out, $err, $code.
call() {
  out=$(cd "$sandbox/elsewhere" && PATH="$fakes:$PATH" "$home/palpate" "$@" 2>"$sandbox/err" </dev/null)
  code=$?
  err=$(cat "$sandbox/err")
}

expect() {  # WHAT CONDITION...
  what=$1
  shift
  if ! "$@"; then
    failures=$((failures + 1))
    printf 'FAILED: %s\n  stdout: %s\n  stderr: %s\n  exit: %s\n  calls: %s\n' "$what" "$out" "$err" "$code" \
      "$(cat "$calls")"
  fi
}
called() { grep -q -e "$1" "$calls"; }
not_called() { ! grep -q -e "$1" "$calls"; }
says() { case $err in *"$1"*) ;; *) return 1 ;; esac; }

# dpkg-query that knows every package of the list but the one named.
lacking() {
  fake dpkg-query "awk '/^[a-z0-9]/ && \$1 != \"$1\" { print \"installed \" \$1 \", \" }' '$home/packages.txt'; $2"
}

fresh
call press "a scene.toml" --depth "5 mm" ""
expect "arguments reach the program as they are" [ "$out" = '<press><a scene.toml><--depth><5 mm><>' ]
expect "the program's exit code is handed on" [ "$code" -eq 42 ]
expect "only the program is built, without tests" called 'ninja -C .* palpate$'
expect "tests are not configured" called 'cmake .*-DPALPATE_TESTS=OFF'
expect "nothing is installed that is there" not_called 'apt-get'

: >"$calls"
call press
expect "a second call does not configure" not_called '^cmake'
expect "a second call does not ask dpkg" not_called '^dpkg-query'
expect "a second call says nothing of its own" [ "$err" = "" ]

call test
expect "test configures the tests" called 'cmake .*-DPALPATE_TESTS=ON'
: >"$calls"
call demo
expect "what test configured stays" not_called '^cmake'

ln -s "$home/palpate" "$sandbox/elsewhere/link"
out=$(PATH="$fakes:$PATH" "$sandbox/elsewhere/link" x 2>/dev/null)
expect "a link finds its checkout" [ "$out" = '<x>' ]

fresh
lacking libfmt-dev :
call demo
expect "what is missing is installed, and nothing else" \
  called 'apt-get .*install --no-install-recommends libfmt-dev$'

fresh
lacking libgtest-dev :
call demo
expect "what only the tests need is not installed for the program" not_called 'apt-get'
call test
expect "what the tests need is installed for them" called 'apt-get .*install --no-install-recommends libgtest-dev$'

fresh
# shellcheck disable=SC2016  # the stand-in expands these
lacking npm 'case "$*" in *Provides*) echo "installed nodejs, nodejs-doc (= 1), npm" ;; esac'
call test
expect "what another package provides is there" not_called 'apt-get'

fresh
lacking libfmt-dev :
PALPATE_NO_INSTALL=1
export PALPATE_NO_INSTALL
call demo
unset PALPATE_NO_INSTALL
expect "PALPATE_NO_INSTALL stops" [ "$code" -eq 3 ]
expect "PALPATE_NO_INSTALL names what is missing" says 'missing: libfmt-dev'
expect "PALPATE_NO_INSTALL installs nothing" not_called 'apt-get'

fresh
lacking libfmt-dev :
fake id 'echo 1000'
fake sudo 'exit 1'
call demo
expect "without a password and nobody to ask, it stops" [ "$code" -eq 3 ]
expect "and says what to do" says 'sudo apt-get install --no-install-recommends libfmt-dev'

fresh
lacking libfmt-dev :
# shellcheck disable=SC2016  # the stand-in expands these
fake apt-get 'case "$*" in *update*) : >"$0.updated" ;; *) [ -e "$0.updated" ] || exit 100 ;; esac'
call demo
expect "lists that know nothing are fetched" [ "$code" -eq 42 ]

fresh
fake ninja 'echo "FAILED: x.o"; echo "x.cpp:1: error: no such thing"; exit 1'
call demo
expect "a build that fails is exit code 3" [ "$code" -eq 3 ]
expect "the compiler's error is shown" says 'x.cpp:1: error: no such thing'
expect "the log is kept and named" says "$home/build/build.log"
expect "the program is not run" [ "$out" = "" ]

fresh
call test --fast -R stats
expect "--fast and further arguments go to ctest" called 'ctest .*-LE .* -R stats$'
expect "ctest's closing line is shown" [ "$out" = '100% tests passed, 0 tests failed out of 1' ]
fake ctest 'exit 8'
call test
expect "ctest's exit code is handed on" [ "$code" -eq 8 ]

fresh
call demo
mv "$home" "$sandbox/moved"
home=$sandbox/moved
call demo
expect "a checkout that was moved is configured anew" says 'moved'

# The stand-in for ninja fails when another one is at work.
fresh
call demo
(cd "$sandbox/elsewhere" && PATH="$fakes:$PATH" "$home/palpate" one >"$sandbox/one" 2>&1; echo $? >"$sandbox/code1") &
call two
wait
expect "calls at the same time build one after the other" [ "$code $(cat "$sandbox/code1")" = "42 42" ]

if [ "$failures" -gt 0 ]; then
  echo "$failures failures"
  exit 1
fi
echo "the launcher does all that is asked of it"
