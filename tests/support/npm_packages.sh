#!/bin/sh
# Puts the packages of a package.json into a directory, once.
#   npm_packages.sh DIRECTORY PACKAGE_JSON
# Several may run at once. After a failure none tries again for 10 minutes. Says why it fails.
wanted=$(realpath "$2") || exit 1
command -v node npm flock >/dev/null || { echo 'node, npm or flock is not installed'; exit 1; }
mkdir -p "$1" && cd "$1" && exec 9>lock && flock 9 || exit 1
cmp -s "$wanted" installed.json && exit 0
[ -z "$(find . -maxdepth 1 -name failed -mmin -10)" ] || { echo 'npm failed a short while ago'; exit 1; }
cp "$wanted" package.json
timeout 60 npm install --no-audit --no-fund --silent --fetch-retries=0 >npm.log 2>&1 ||
  { touch failed; echo 'npm cannot install the packages'; exit 1; }
cp package.json installed.json
