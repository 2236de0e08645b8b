#!/bin/sh
# run.sh PROGRAM RUNS: what libFuzzer makes of so many inputs; one that fails is left beside the program.
exec "$1" -runs="$2" -seed=1 -max_len=2000 -len_control=0 -dict="$(dirname "$0")/words.txt" -print_final_stats=1 \
    -artifact_prefix="$(dirname "$1")/"
