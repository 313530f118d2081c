# Shared by ./run, ./test and .ci/run: installs what is missing and builds a preset. Sourced, never run.

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
export MESA_SHADER_CACHE_DIR="${MESA_SHADER_CACHE_DIR:-$root/build/mesa-shader-cache}"

say() { printf '\033[1m%s\033[0m\n' "== $*" >&2; }

# Installs the packages of scripts/packages.txt that are missing.
install_packages() {
    local wanted
    mapfile -t wanted < <(grep -Ev '^[[:space:]]*(#|$)' "$root/scripts/packages.txt")
    install_missing "${wanted[@]}"
}

# install_missing PACKAGE...: installs those that are missing; without root and sudo it names them and ends with 3.
install_missing() {
    local missing=() package
    if ! command -v dpkg-query >/dev/null; then
        say "Not a Debian system: install what corresponds to these packages: $*"
        return
    fi
    for package in "$@"; do
        dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            say "Missing packages, and neither root nor sudo to install them. As root, run:"
            echo "apt-get install --no-install-recommends ${missing[*]}" >&2
            exit 3
        fi
        as_root=(sudo)
    fi
    say "Installing ${#missing[@]} missing packages: ${missing[*]}"
    "${as_root[@]}" apt-get -q -o Acquire::Retries=3 update
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get -q -y -o Acquire::Retries=3 install --no-install-recommends "${missing[@]}"
}

# build PRESET [target...]: configures build/PRESET once and builds it.
build() {
    local preset="$1"
    shift
    if [ ! -f "$root/build/$preset/build.ninja" ]; then
        say "Configuring build/$preset"
        (cd "$root" && cmake --preset "$preset" >&2)
    fi
    say "Building build/$preset"
    cmake --build "$root/build/$preset" ${1:+--target "$@"} >&2
}
