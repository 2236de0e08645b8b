#!/bin/bash
# Does what is installed work for others? package.sh CHECK SOURCE BUILD; the check "install" comes first.
set -euo pipefail
check=$1 source=$2 build=$3
installed=$build/installed
snug=$installed/bin/snug
answer="$("$build/snug" --version | cut -d' ' -f2): 18 direction changes, 18 in vectors"

fail() {
    echo "$*" >&2
    exit 1
}
same() { # WHAT SHOWN WANTED
    [[ $2 == "$3" ]] && return
    echo "$3" >"$build/wanted"
    echo "$2" | diff - "$build/wanted" || fail "$1: < is there and > is wanted"
}

install() {
    rm -rf "$installed"
    mv "$build/package/snug.1" "$build/package/away"
    ! cmake --install "$build" --prefix "$installed" &>"$build/install_errors" || fail "installs without its manual"
    mv "$build/package/away" "$build/package/snug.1"
    grep -q "cmake --build" "$build/install_errors" && [[ ! -e $installed ]] || fail "installs half of it"
    cmake --install "$build" --prefix "$installed" >/dev/null
    ! grep -rlI --exclude-dir=include -e "$source" -e "$build" "$installed" || fail "names a folder of the build"
}

with_cmake() {
    rm -rf "$build/consumer"
    cmake -S "$source/tests/consumer" -B "$build/consumer" -DCMAKE_PREFIX_PATH="$installed" >/dev/null
    cmake --build "$build/consumer"
    same "core" "$("$build/consumer/core")" "$answer"
    "$build/consumer/layers"
    for wrong in "1.0" "0.1 COMPONENTS streets"; do
        mkdir -p "$build/consumer/wrong"
        printf '%s\n' "cmake_minimum_required(VERSION 3.25)" "project(wrong LANGUAGES CXX)" \
            "find_package(snug $wrong REQUIRED)" >"$build/consumer/wrong/CMakeLists.txt"
        ! cmake -S "$build/consumer/wrong" -B "$build/consumer/wrong" -DCMAKE_PREFIX_PATH="$installed" &>/dev/null ||
            fail "finds snug $wrong"
    done
}

with_pkg_config() {
    export PKG_CONFIG_PATH=$installed/lib/pkgconfig
    cd "$build"
    c++ -std=c++20 "$source/tests/consumer/core.cpp" $(pkg-config --cflags --libs snug) -o consumer_core
    same "core" "$(./consumer_core)" "$answer"
    c++ -std=c++20 "$source/tests/consumer/layers.cpp" \
        $(pkg-config --cflags --libs snug-baselines snug-io snug-sweep snug-drive snug-draw snug-atlas) -o consumer_layers
    ./consumer_layers
    ! c++ -std=c++17 "$source/tests/consumer/core.cpp" $(pkg-config --cflags snug) -fsyntax-only 2>consumer_errors ||
        fail "compiles as C++17"
    grep -q "error: .*snug needs C++20" consumer_errors || fail "does not say that it needs C++20"
    same "version" "$(pkg-config --modversion snug)" "$("$snug" --version | cut -d' ' -f2)"
}

commands() { "$snug" $1 --help | sed -n '/^Commands:/,/^$/s/^  \([a-z-]*\) .*/\1/p'; }
all_commands() { # a line each, those below others behind them
    for command in $(commands ""); do
        echo "$command"
        for below in $(commands "$command"); do echo "$command $below"; done
    done
}

# The page says all that the command says of itself, and troff has nothing to say about it.
manual() {
    local page=$installed/share/man/man1/snug.1
    same "troff" "$(groff -man -Tutf8 -ww "$page" 2>&1 >/dev/null)" ""
    words() { tr -s ' \n' '\n\n' | sed '/^Usage:$/d'; }
    same "words" "$(sed '/^\.TH/d; /^\.SH \(NAME\|SYNOPSIS\|SNUG\)/d; s/^\.[A-Za-z]*//; s/\\-/-/g
                         s/\\&//; s/\\e/\\/g; s/^ *COMMANDS$/Commands/; s/snug - an/snug: an/' "$page" | words)" \
        "$( ("$snug" --help; all_commands | while read -r command; do "$snug" $command --help; done) |
            sed 's/^\([A-Z][A-Za-z ]*\):$/\1/' | words)"
}

# What the shells offer after some words, one a line.
in_bash() {
    bash -c 'source "$1"; shift; COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)); _snug; printf "%s\n" "${COMPREPLY[@]}"' \
        bash "$installed/share/bash-completion/completions/snug" "$snug" "$@"
}
in_zsh() {
    zsh -f -c '_describe() { print -rl -- ${${(P)2}%%:*} }; compadd() { print -rl -- "$@" }; _files() { }; _message() { }
        complete() { source "$file" }
        file=$1; shift; words=("$@"); CURRENT=$#; complete' \
        zsh "$installed/share/zsh/site-functions/_snug" "$snug" "$@"
}

# Where a word is one of a few, the command lists them when it is given another: "...; write right or left".
completions() {
    local question="--car mid-size --length 5.1 --width 2.2"
    for shell in in_bash in_zsh; do
        same "$shell: commands" "$($shell "" | sort)" "$( (commands ""; echo --help; echo --version) | sort)"
        same "$shell: commands below" "$($shell atlas "" | sort)" "$( (commands atlas; echo --help) | sort)"
        all_commands | grep -vx atlas | while read -r command; do
            same "$shell: options of $command" "$($shell $command -- | sort)" \
                "$("$snug" $command --help | grep -o -e '^  \(-.,\)\?--[a-z-]*' | sed 's/.*--/--/' | sort)"
        done
        while read -r words; do
            same "$shell: $words" "$($shell $words "" | sort)" \
                "$("$snug" $words '?' 2>&1 | sed 's/.*; write //; s/, \| or /\n/g' | sort)"
        done <<END
            entry $question --side
            entry $question --curb
            entry $question --enter
            entry $question --strategy
            entry $question --strategy stepping --stop
            entry $question --draw x.svg --view
            entry $question --format
            min-slot $question --strategy
            min-slot $question --format
            cars --format
            atlas build --db x --cars all --width 2 --length 5 --strategy
END
        same "$shell: leave --format" "$($shell leave --format "" | xargs)" "text json"
        same "$shell: atlas query --format" "$($shell atlas query --format "" | xargs)" "text json"
        same "$shell: atlas build --cars" "$($shell atlas build --cars "" | grep -e all -e zoe | xargs)" "all renault-zoe"
        same "$shell: cars" "$($shell cars "" | grep zoe)" renault-zoe
        same "$shell: cars" "$($shell entry --car "" | grep zoe)" renault-zoe
        same "$shell: a number" "$($shell entry --length "")" ""
    done
}

deb() {
    rm -rf "$build/deb"
    (cd "$build" && cpack -G DEB -B "$build/deb" >/dev/null)
    local deb=$(ls "$build"/deb/snug_*.deb)
    dpkg-deb --info "$deb"
    for wanted in libc6 libcairo2 libsqlite3-0 libtbb12 libhwy1 libhwy-dev; do
        dpkg-deb --field "$deb" Depends | grep -q "\b$wanted\b" || fail "does not depend on $wanted"
    done
    same "version" "$(dpkg-deb --field "$deb" Version)" "$("$build/snug" --version | cut -d' ' -f2)"
    # The same files as installed, but for zsh's, and without what needs Open MPI.
    same "files" "$(dpkg-deb --contents "$deb" | sed -n 's,^-.* \./usr/,,p' | sed 's,vendor-completions,site-functions,' |
        sort)" "$(cd "$installed" && find . -type f | cut -c3- | grep -vx bin/snug-mpi | sort)"
    ! dpkg-deb --contents "$deb" | grep -v ' root/root ' || fail "is not all root's"
    if [[ -e $build/snug-mpi ]]; then
        deb=$(ls "$build"/deb/snug-mpi_*.deb)
        dpkg-deb --contents "$deb" | grep -q ' ./usr/bin/snug-mpi$' || fail "has no snug-mpi"
        dpkg-deb --field "$deb" Depends | grep -q "openmpi-bin" || fail "does not depend on Open MPI"
    fi
}

$check
