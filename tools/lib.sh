# What the scripts under tools/ and .ci/ share: which packages each job needs, and how to build.
# To be sourced by bash.
# shellcheck shell=bash disable=SC2034

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)

# What ccache asks for where headers are precompiled.
export CCACHE_SLOPPINESS=pch_defines,time_macros

# One line per package: its name, then a file that is there once it is installed. Looking at files
# takes no time; asking dpkg would.
packages_to_build='
ca-certificates      /etc/ssl/certs
cmake                /usr/bin/cmake
g++                  /usr/bin/g++
libboost-dev         /usr/include/boost/version.hpp
libcadical-dev       /usr/include/cadical.hpp
libcli11-dev         /usr/include/CLI/CLI.hpp
libedit-dev          /usr/include/editline/readline.h
libfmt-dev           /usr/include/fmt/core.h
libpugixml-dev       /usr/include/pugixml.hpp
libtomlplusplus-dev  /usr/include/toml++/toml.h
libutf8proc-dev      /usr/include/utf8proc.h
ninja-build          /usr/bin/ninja
nlohmann-json3-dev   /usr/include/nlohmann/json.hpp
verilator            /usr/share/verilator/include/gtkwave/fstapi.c
zlib1g-dev           /usr/include/zlib.h
'
packages_to_test='
arduino-core-avr     /usr/share/arduino/hardware/arduino/avr/cores/arduino/Arduino.h
avr-libc             /usr/lib/avr/include/avr/io.h
doctest-dev          /usr/include/doctest/doctest.h
dpkg-dev             /usr/bin/dpkg-shlibdeps
fish                 /usr/bin/fish
fp-compiler          /usr/bin/fpc
gcc-avr              /usr/bin/avr-g++
gtkwave              /usr/bin/gtkwave
iverilog             /usr/bin/iverilog
libsimavr-dev        /usr/include/simavr/sim_avr.h
libxml2-utils        /usr/bin/xmllint
lmodern              /usr/share/texmf/tex/latex/lm/lmodern.sty
man-db               /usr/bin/man
mandoc               /usr/bin/mandoc
mypy                 /usr/bin/mypy
ngspice              /usr/bin/ngspice
patch                /usr/bin/patch
pkg-config           /usr/bin/pkg-config
python3              /usr/bin/python3
python3-jsonschema   /usr/lib/python3/dist-packages/jsonschema/__init__.py
python3-yaml         /usr/lib/python3/dist-packages/yaml/__init__.py
texlive-lang-french  /usr/share/texlive/texmf-dist/tex/generic/babel-french/french.ldf
texlive-latex-base   /usr/bin/pdflatex
texlive-latex-recommended /usr/share/texlive/texmf-dist/tex/latex/booktabs/booktabs.sty
texlive-pictures     /usr/share/texlive/texmf-dist/tex/latex/pgf/frontendlayer/tikz.sty
xauth                /usr/bin/xauth
xvfb                 /usr/bin/xvfb-run
yosys                /usr/bin/yosys
zsh                  /usr/bin/zsh
'
packages_to_check='
clang                /usr/bin/clang++
clang-format         /usr/bin/clang-format
clang-tidy           /usr/bin/clang-tidy
libclang-rt-14-dev   /usr/lib/llvm-14/lib/clang/14.0.6/lib/linux/libclang_rt.fuzzer-x86_64.a
'
packages_to_package='
dpkg-dev             /usr/bin/dpkg-shlibdeps
'
packages_to_test_package='
debootstrap          /usr/sbin/debootstrap
lintian              /usr/bin/lintian
'
# For the page in a browser: a compiler to WebAssembly, the libraries of C and C++ for it, and what the
# compiler calls to make the module smaller.
packages_for_playground='
binaryen                  /usr/bin/wasm-opt
clang-22                  /usr/bin/clang++-22
libc++-22-dev-wasm32      /usr/lib/llvm-22/lib/wasm32-wasi/libc++.a
libclang-rt-22-dev-wasm32 /usr/lib/llvm-22/lib/clang/22/lib/wasi/libclang_rt.builtins-wasm32.a
lld-22                    /usr/bin/wasm-ld-22
nodejs                    /usr/bin/node
npm                       /usr/bin/npm
python3                   /usr/bin/python3
wasi-libc                 /usr/lib/wasm32-wasi/libc.a
'
packages_to_drive_playground='
chromium             /usr/bin/chromium
fonts-dejavu-core    /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
nodejs               /usr/bin/node
npm                  /usr/bin/npm
'

# The exit status where the product could not even be built: none of grafwire's own.
cannot_build=70

say() {
    printf '%s\n' "$*" >&2
}

# The version of the sources.
version() {
    sed -nE 's/^project\(grafwire VERSION ([0-9.]+).*/\1/p' "$root/CMakeLists.txt"
}

# Runs a command quietly; shows what it printed only where it fails.
quietly() {
    local log status=0
    log=$(mktemp)
    "$@" >"$log" 2>&1 </dev/null || status=$?
    if [ "$status" -ne 0 ]; then
        say "failed: $*"
        cat "$log" >&2
    fi
    rm -f "$log"
    return "$status"
}

# missing_of LIST: sets `missing` to the packages of the list that are not installed.
missing_of() {
    local package file
    missing=()
    while read -r package file; do
        [ -z "$package" ] || [ -e "$file" ] || missing+=("$package")
    done <<<"$1"
}

# need LIST: installs what is missing of it. Says nothing where nothing is.
need() {
    local missing as_root=()
    missing_of "$1"
    [ "${#missing[@]}" -gt 0 ] || return 0
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || {
            say "missing: ${missing[*]}; install with: apt-get install ${missing[*]}"
            return 1
        }
        as_root=(sudo)
    fi
    as_root+=(env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=600)
    say "installing: ${missing[*]}"
    quietly "${as_root[@]}" update &&
        quietly "${as_root[@]}" install --no-install-recommends "${missing[@]}"
}

# The mirror that packages come from.
mirror() {
    local found
    found=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' \
        'Component: main' 2>/dev/null | grep -v security | head -n 1)
    printf '%s\n' "${found:-http://deb.debian.org/debian/}"
}

# locked NAME COMMAND…: one caller at a time in this work tree, which must be one to write to.
locked() {
    local name=$1 status=0 lock
    shift
    # A redirection of `exec` that fails would end the script, and not as it should.
    if ! { mkdir -p "$root/build" && : >>"$root/build/.$name.lock"; } 2>/dev/null; then
        say "cannot write to $root/build: is it read-only, or was it made by another user?"
        return "$cannot_build"
    fi
    exec {lock}>"$root/build/.$name.lock"
    flock "$lock"
    # The lock is not for the command's children to keep.
    "$@" {lock}>&- || status=$?
    exec {lock}>&-
    return "$status"
}

# configure FOLDER [-DNAME=VALUE…]: sets build/FOLDER up, the first time and where a setting has
# changed. Needs the packages to build.
configure() {
    local folder=$root/build/$1 settings=("${@:2}")
    ! configured "$folder" "${settings[@]}" || return 0
    [ -e "$folder/.ninja_log" ] || say "building in ${folder#"$root"/}, which takes some minutes once"
    ! command -v ccache >/dev/null || settings+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    quietly cmake -S "$root" -B "$folder" -G Ninja \
        -DCMAKE_RUNTIME_OUTPUT_DIRECTORY="$folder/bin" "${settings[@]}"
}

# build FOLDER TARGET… [-DNAME=VALUE…]: configures build/FOLDER and brings the targets up to date,
# telling how far it is. Shows what the compiler says; where `quiet_warnings` is set, only if it fails.
build() {
    local folder=$root/build/$1 targets=() settings=() word
    for word in "${@:2}"; do
        case $word in
            -D*) settings+=("$word") ;;
            *) targets+=("$word") ;;
        esac
    done
    configure "$1" "${settings[@]}" || return
    NINJA_STATUS='[%f/%t] ' ninja -C "$folder" "${jobs_of_ninja[@]}" "${targets[@]}" 2>&1 </dev/null |
        show_progress
    [ "${PIPESTATUS[0]}" -eq 0 ]
}

# Reads what ninja prints. On a terminal its progress is one line that is written over; elsewhere it
# is a line every ten seconds. What else it prints, that is, what the compiler says, goes through.
show_progress() {
    local line kept=() began=$SECONDS shown=$SECONDS failed=0 on_terminal=''
    [ ! -t 2 ] || on_terminal=1
    while IFS= read -r line; do
        case $line in
            'ninja: Entering directory'* | 'ninja: no work to do.' | '-- '*) ;;
            \[*/*\]\ *)
                if [ -n "$on_terminal" ]; then
                    [ "$SECONDS" -eq "$began" ] || printf '\r\033[K%.*s' "$((${COLUMNS:-80} - 1))" "$line" >&2
                elif [ "$((SECONDS - shown))" -ge 10 ]; then
                    say "$line"
                    shown=$SECONDS
                fi
                ;;
            *)
                case $line in FAILED:* | 'ninja: '*) failed=1 ;; esac
                kept+=("$line")
                if [ -z "${quiet_warnings:-}" ] || [ "$failed" -eq 1 ]; then
                    [ -z "$on_terminal" ] || printf '\r\033[K' >&2
                    printf '%s\n' "${kept[@]}" >&2
                    kept=()
                fi
                ;;
        esac
    done
    [ -z "$on_terminal" ] || printf '\r\033[K' >&2
}

# JOBS=N in the environment limits what runs at a time.
jobs_of_ninja=(${JOBS:+-j "$JOBS"})

# configured FOLDER -DNAME=VALUE…: whether CMake has set it up with these settings. One that was set
# up for a work tree elsewhere is thrown away.
configured() {
    local folder=$1 cache setting name
    shift
    [ -e "$folder/build.ninja" ] && [ -e "$folder/CMakeCache.txt" ] || return 1
    cache=$'\n'$(<"$folder/CMakeCache.txt")$'\n'
    if [[ $cache != *$'\n'"CMAKE_CACHEFILE_DIR:INTERNAL=$folder"$'\n'* ]]; then
        rm -rf "$folder"
        return 1
    fi
    for setting in "$@"; do
        setting=${setting#-D}
        name=${setting%%=*}
        [[ $cache =~ $'\n'"$name":[A-Z]+="${setting#*=}"$'\n' ]] || return 1
    done
}

# How build/release is set up by whoever comes first: for speed of building. The product is compiled
# some files at a time, as its tests always are, so that what they include is read once for all of
# them; common headers are read once for all; and only what runs long is optimised fully. In .ci/run
# clang-tidy reads each file of the product by itself as well.
fast_settings=(-DCMAKE_BUILD_TYPE=Release '-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG' -DPRECOMPILE=ON
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=14)

# is_new FOLDER: whether build/FOLDER has not been set up yet.
is_new() {
    [ ! -e "$root/build/$1/build.ninja" ]
}

# Builds the program, and puts a copy beside it that appears whole or not at all, so that a call
# that comes while another one links never runs half a program. Sets `program`.
build_program() {
    local built=$root/build/release/bin/grafwire settings=()
    program=$root/build/release/grafwire
    # A folder that tools/test has set up keeps its tests.
    ! is_new release || settings=("${fast_settings[@]}" -DBUILD_TESTING=OFF)
    quiet_warnings=1 build release grafwire "${settings[@]}" || return
    [ "$program" -nt "$built" ] ||
        { cp -f "$built" "$program.new" && mv -f "$program.new" "$program"; }
}

# targets_of_tests FOLDER NAME: what must be built for the tests of build/FOLDER whose name matches.
targets_of_tests() {
    local name targets
    # Brings the list of tests up to date first, where CMake has to be asked again.
    quietly ninja -C "$root/build/$1" build.ninja || return
    while read -r name targets; do
        # shellcheck disable=SC2086
        [[ ! $name =~ $2 || -z $targets ]] || printf '%s\n' $targets
    done <"$root/build/$1/tests.txt" | sort -u
}

# run_tests FOLDER [-R NAME | -E NAME]: the tests of build/FOLDER, those whose name matches NAME, or
# those whose name does not. Sets `passed` and `failed`: a doctest program counts for each of its
# cases, any other test for one.
run_tests() {
    local report status=0
    report=$(mktemp)
    ctest --test-dir "$root/build/$1" --output-on-failure --no-tests=error -j "${JOBS:-2}" \
        --test-output-size-passed 1000000 --test-output-size-failed 1000000 \
        --output-junit "$report" "${@:2}" </dev/null || status=$?
    read -r passed failed < <(count_tests <"$report")
    rm -f "$report"
    # A failure of CTest itself counts as one.
    [ "$status" -eq 0 ] || [ "$failed" -gt 0 ] || failed=1
    return "$status"
}

# Reads a JUnit report of CTest, prints the number of tests passed and failed.
count_tests() {
    awk '
        /^\t<testcase / { cases_passed = cases_failed = 0; good = /status="run"/ }
        /\[doctest\] test cases:/ {
            n = split($0, part, "|")
            split(part[2], word, " "); cases_passed += word[1]
            split(part[3], word, " "); cases_failed += word[1]
        }
        /^\t<\/testcase>/ {
            if (good && cases_passed == 0) cases_passed = 1
            if (!good && cases_failed == 0) cases_failed = 1
            passed += cases_passed; failed += cases_failed
        }
        END { print passed + 0, failed + 0 }'
}
