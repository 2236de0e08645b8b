#!/bin/sh
# Does an example print what the comment at its end says? check.sh PROGRAM SOURCE
set -eu
printed=$("$1")
shown=$(sed '1,/^\/\/ Prints:$/d; s,^// \{0\,1\},,' "$2")
[ "$printed" = "$shown" ] || { printf 'prints\n%s\nand shows\n%s\n' "$printed" "$shown"; exit 1; }
