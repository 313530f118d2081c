# What became of the tests in the shards of a ctest run (cmake/rambla_tests.cmake), from its LastTest.log: ctest counts
# processes, this counts tests, and names those that did not pass. A test that took its process down is named too.
function add(list, name) { return list == "" ? name : list ", " name }
function died() {
    if (running == "") return
    ++failed
    failures = add(failures, running " (its process ended in it)")
    running = ""
}

/^\[==========\] Running [0-9]+ tests? from/ { wanted += $3; ++shards }
/^\[ RUN      \]/ { died(); running = $4; ++begun }
/^\[       OK \]/ { ++passed; running = "" }
/^\[  SKIPPED \]/ && running != "" { ++skipped; skips = add(skips, $4); running = "" }
/^\[  FAILED  \]/ && running != "" { ++failed; sub(/,$/, "", $4); failures = add(failures, $4); running = "" }
/^  YOU HAVE [0-9]+ DISABLED TESTS?/ { disabled += $3 }
/^<end of output>/ { died() }
END {
    if (shards == 0) exit
    printf "%d tests shared %d processes: %d passed, %d skipped, %d disabled, %d failed",
        wanted, shards, passed, skipped, disabled, failed
    if (wanted > begun) printf ", %d not run after a process ended", wanted - begun
    print ""
    if (skips != "") print "Skipped: " skips
    if (failures != "") print "FAILED: " failures
}
