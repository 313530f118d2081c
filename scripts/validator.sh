# Sourced by ./test and .ci/run: checks exported glTF with the Khronos validator, which comes from npm.

# Node.js, and the validator in the version of tests/validator/package-lock.json, under build/validator.
install_validator() {
    # Where Node.js comes with an npm of its own, Debian's package would conflict.
    command -v npm >/dev/null || install_missing nodejs npm
    local place="$root/build/validator"
    mkdir -p "$place"
    cp "$root"/tests/validator/*.json "$root"/tests/validator/validate.mjs "$place"
    if ! cmp -s "$place/package-lock.json" "$place/installed-lock.json"; then
        say "Installing the glTF validator from npm"
        (cd "$place" && npm ci --no-audit --no-fund --loglevel=error >&2)
        cp "$place/package-lock.json" "$place/installed-lock.json"
    fi
}

# Every scene that the program can generate, and every sample model, character and scene, exported and checked.
# build/test must hold the program and rambla_reexport.
validate_exports() {
    install_validator
    local program="$root/build/test/bin" out="$root/build/validator/exports" scene scenes corpus
    rm -rf "$out"
    mkdir -p "$out"
    # The program names its scenes when it is asked for one that it does not have.
    scenes="$("$program/rambla" generate none -o none.glb 2>&1 | sed -n 's/.*known: //p')" || true
    [ -n "$scenes" ] || { say "The list of scenes is not where it was"; return 1; }
    say "Exporting: ${scenes//,/}"
    for scene in ${scenes//,/} city:blocks=1x1 city:blocks=3x2; do
        "$program/rambla" generate "$scene" --seed 7 -o "$out/$scene.glb" --quiet
    done
    corpus="$(sed -n 's/^RAMBLA_GLTF_DIR:PATH=//p' "$root/build/test/CMakeCache.txt")"
    if [ -n "$corpus" ]; then
        for scene in models characters scenes; do
            "$program/rambla_reexport" "$corpus/$scene" "$out"
        done
    else
        say "NOT RUN: exports of sample glTF files, because RAMBLA_GLTF_DIR is not set"
    fi
    say "Checking them with the Khronos validator"
    node "$root/build/validator/validate.mjs" "$out"
}
