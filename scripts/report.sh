# Sourced by ./test and .ci/run: checks the page of studies in a browser. Chromium is Debian's; what drives it comes from
# npm.

# Node.js, Chromium, and playwright-core in the version of tests/report/package-lock.json, under build/report-check.
install_browser() {
    install_missing chromium
    # Where Node.js comes with an npm of its own, Debian's package would conflict.
    command -v npm >/dev/null || install_missing nodejs npm
    local place="$root/build/report-check"
    mkdir -p "$place"
    cp "$root"/tests/report/*.json "$root"/tests/report/*.mjs "$place"
    if ! cmp -s "$place/package-lock.json" "$place/installed-lock.json"; then
        say "Installing playwright-core from npm"
        (cd "$place" && npm ci --no-audit --no-fund --loglevel=error >&2)
        cp "$place/package-lock.json" "$place/installed-lock.json"
    fi
}

# Runs every study in its quickest form and looks at the page that they write. build/test must hold the program.
check_report() {
    install_browser
    local out="$root/build/report"
    rm -rf "$out"
    say "Running all studies, quickly"
    "$root/build/test/bin/rambla" study all --quick --size 160x90 -o "$out"
    say "Looking at their page with Chromium"
    node "$root/build/report-check/check.mjs" "$out"
}
