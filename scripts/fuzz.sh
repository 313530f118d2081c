# Sourced by ./test: runs the fuzz targets, see tests/fuzz/README.md.

# fuzz SECONDS [TARGET...]: each target for so long, all of them by default, two beside each other, since each takes one
# processor. What they find lies in build/fuzz/findings; the inputs that reached new code stay in build/fuzz/corpus for the
# next time.
fuzz() {
    local seconds="$1" folder="$root/build/fuzz" target found=0 running=0
    shift
    build asan rambla_fuzzers
    rm -rf "$folder/seeds"
    "$root/build/asan/bin/rambla_fuzz_seeds" "$folder/seeds"
    mkdir -p "$folder/findings"
    [ $# -gt 0 ] || set -- $(cd "$root/tests/fuzz/targets" && ls -- *.cpp | sed 's/\.cpp$//')
    for target in "$@"; do
        if [ $running -eq 2 ]; then
            wait -n || found=1
            running=1
        fi
        say "Fuzzing $target for $seconds s"
        fuzz_one "$target" "$seconds" &
        running=$((running + 1))
    done
    while [ $running -gt 0 ]; do
        wait -n || found=1
        running=$((running - 1))
    done
    [ $found -eq 0 ] || say "Findings are in $folder/findings"
    return $found
}

# One target. An input may have 64 KiB, so that by the importer's promise (assets/import/gltf.h) a million elements of
# about 100 bytes and 256 MiB of pictures are the most that it may cost: no allocation may have more than 512 MiB.
fuzz_one() {
    local target="$1" seconds="$2" folder="$root/build/fuzz" dictionary="$root/tests/fuzz/dictionaries/$1.dict"
    local corpus="$folder/corpus/$target" log="$folder/$target.log" status=0
    mkdir -p "$corpus" "$folder/tmp"
    [ -f "$dictionary" ] && dictionary="-dict=$dictionary" || dictionary=
    TMPDIR="$folder/tmp" ASAN_OPTIONS=quarantine_size_mb=64:strict_string_checks=1 UBSAN_OPTIONS=print_stacktrace=1 \
        nice "$root/build/asan/bin/rambla_fuzz_$target" -max_total_time="$seconds" -timeout=10 -max_len=65536 \
        -rss_limit_mb=2048 -malloc_limit_mb=512 -print_final_stats=1 ${dictionary:+"$dictionary"} \
        -artifact_prefix="$folder/findings/$target-" "$corpus" "$folder/seeds/$target" >"$log" 2>&1 || status=1
    if [ $status -ne 0 ]; then
        { say "$target failed: the end of $log"; tail -n 60 "$log"; } >&2
    fi
    awk -v target="$target" '/stat::number_of_executed_units/ { runs = $2 }
        { for (i = 1; i < NF; ++i) { if ($i == "cov:") edges = $(i + 1); if ($i == "ft:") features = $(i + 1) } }
        /stat::peak_rss_mb/ { peak = $2 }
        END { printf "%s: %d runs, %d edges and %d features reached, peak %d MB\n", target, runs, edges, features, peak }' "$log" >&2
    return $status
}
