# Sourced by ./test and .ci/run: runs what a preset has built of the tests.

# run_tests PRESET [argument...]: ctest on build/PRESET with these arguments, its exit code. With RAMBLA_TEST_SHARDS=N in
# the environment, unit tests share N processes of each program (cmake/rambla_tests.cmake): then, what became of each.
run_tests() {
    local folder="$root/build/$1" status=0
    shift
    ctest --test-dir "$folder" -j 2 --output-on-failure --no-tests=error "$@" || status=$?
    if [ -n "${RAMBLA_TEST_SHARDS:-}" ] && [ -f "$folder/Testing/Temporary/LastTest.log" ]; then
        awk -f "$root/scripts/count_tests.awk" "$folder/Testing/Temporary/LastTest.log" >&2
    fi
    return $status
}
