#!/bin/sh
# Makes the manual page from what the command says of itself: manual.sh build/release/snug > snug.1
set -eu
snug=$1

# What a command says of itself, then what the commands below it say.
tell() { # WORDS
    [ -z "$1" ] || printf '\f%s\n' "$1"
    "$snug" $1 --help
    for command in $("$snug" $1 --help | sed -n '/^Commands:/,/^$/s/^  \([a-z-]*\) .*/\1/p'); do
        tell "${1:+$1 }$command"
    done
}

tell "" | awk -v version="$("$snug" --version)" '
    # Hides what means something to troff.
    function plain(text) {
        gsub(/\\/, "\\e", text)
        gsub(/-/, "\\-", text)
        return text ~ /^[.\047]/ ? "\\&" text : text
    }
    # Lines are kept as they are, or run together.
    function keep_lines(wanted) {
        if (wanted != kept) print wanted ? ".nf" : ".fi"
        kept = wanted
    }
    function heading(macro, text) {
        keep_lines(0)
        print macro " " plain(text)
        title = text
    }

    NR == 1 {  # "snug: what it is"
        print ".TH SNUG 1 \"\" \"" version "\"\n.SH NAME\nsnug \\- " plain(substr($0, 7)) "\n.SH SYNOPSIS"
        next
    }
    /^\f/ { inside = 1; heading(".SH", toupper("snug " substr($0, 2))); next }
    /^Commands:$/ && !inside { heading(".SH", "COMMANDS"); next }
    /^[A-Z][A-Za-z ]*:$/ { heading(".SS", substr($0, 1, length($0) - 1)); next }
    /^Usage: / { print ".B " plain(substr($0, 8)); next }
    /^$/ { keep_lines(0); print ".PP"; next }
    /^  [^ ]+( [^ ]+)?  +[^ ]/ && $1 != "snug" {  # "  --option VALUE   what it is"
        keep_lines(0)
        match($0, /[^ ]  +/)
        print ".TP\n.B " plain(substr($0, 3, RSTART - 2)) "\n" plain(substr($0, RSTART + RLENGTH))
        next
    }
    /^          / { sub(/^ +/, ""); print plain($0); next }
    /^ / { keep_lines(1); print plain($0); next }
    { keep_lines(0); print plain($0) }' | uniq
