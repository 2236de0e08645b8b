#!/bin/sh
# Installs the packages of packages.txt, or of the list given instead, if one of them is missing; otherwise touches
# nothing and needs no rights.
set -eu

list="$(dirname "$0")/${1:-packages.txt}"

command -v dpkg-query >/dev/null || {
    echo "setup: not a Debian system; going on with what is installed ($list says what is needed)" >&2
    exit 0
}

missing=
for package in $(sed 's/#.*//' "$list"); do
    status=$(dpkg-query --show --showformat '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" = 0 ]; then
    as_root=
elif command -v sudo >/dev/null; then
    as_root=sudo
else
    echo "setup: packages are missing; become root or install sudo, or have somebody run: apt-get install$missing" >&2
    exit 1
fi

echo "setup: installing$missing"
apt_get="$as_root env DEBIAN_FRONTEND=noninteractive apt-get --option DPkg::Lock::Timeout=600"
$apt_get update --quiet
$apt_get install --quiet --yes --no-install-recommends $missing
