# Sourced by ./test: shows what becomes of every sample glTF file.

# A table of all of them on standard output and in build/corpus/files.csv, and contact sheets of what is drawn: sheet-*.png
# as the files stand, clips-*.png 1.2 s into the first clip. What each file must do, a test checks first.
# build/test must hold the program and rambla_assets_tests.
show_corpus() {
    local program="$root/build/test/bin/rambla" out="$root/build/corpus" corpus refused undrawn
    corpus="$(sed -n 's/^RAMBLA_GLTF_DIR:PATH=//p' "$root/build/test/CMakeCache.txt")"
    if [ -z "$corpus" ]; then
        say "RAMBLA_GLTF_DIR is not set: there are no sample files to show"
        return 1
    fi
    export RAMBLA_CACHE_DIR="$root/build/test/cache"
    rm -rf "$out"
    mkdir -p "$out"
    ctest --test-dir "$root/build/test" --output-on-failure --no-tests=error -R '^assets\.GltfCorpus' >&2
    cd "$corpus"
    local files clips
    mapfile -d '' files < <(find . -type f \( -name '*.gltf' -o -name '*.glb' \) -printf '%P\0' | LC_ALL=C sort -z)
    say "Importing ${#files[@]} files"
    "$program" inspect "${files[@]}" --csv "$out/files.csv"
    say "Drawing them"
    draw_sheets "$out/sheet" "${files[@]}"
    # No name in the corpus holds a comma.
    mapfile -t clips < <(awk -F, 'NR > 1 && $6 > 0 { print $1 }' "$out/files.csv")
    draw_sheets "$out/clips" "${clips[@]}" --clip-time 1.2
    refused="$(grep -c ',refuse,' "$out/files.csv" || true)"
    undrawn="$(cat "$out"/sheet-*.json | grep -c '"error":' || true)"
    say "Wrote $out/files.csv and $(ls "$out"/*.png | wc -l) sheets beside it"
    if [ "$refused" != "$undrawn" ]; then
        say "$refused files are refused, but $undrawn were not drawn"
        return 1
    fi
}

# draw_sheets PREFIX FILE... [option...]: thirty files to a sheet, as large as a screen shows at once.
draw_sheets() {
    local prefix="$1" files=() options=() number=1 first
    shift
    while [ $# -gt 0 ] && [ "${1#--}" = "$1" ]; do
        files+=("$1")
        shift
    done
    options=("$@")
    for ((first = 0; first < ${#files[@]}; first += 30, ++number)); do
        local sheet
        sheet="$prefix-$(printf %02d "$number")"
        "$root/build/test/bin/rambla" view "${files[@]:first:30}" "${options[@]}" --headless --quiet \
            --out "$sheet.png" --json "$sheet.json" 2>"$sheet.log"
    done
}
