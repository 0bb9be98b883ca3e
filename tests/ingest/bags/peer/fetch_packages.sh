#!/bin/sh
# Puts the packages of package.json into a directory, once.
#   fetch_packages.sh DIRECTORY
# Several may run at once. After a failure none tries again for 10 minutes. Says why it fails.
peer=$(cd "$(dirname "$0")" && pwd)
command -v node npm flock >/dev/null || { echo 'node, npm or flock is not installed'; exit 1; }
mkdir -p "$1" && cd "$1" && exec 9>lock && flock 9 || exit 1
cmp -s "$peer/package.json" installed.json && exit 0
[ -z "$(find . -name failed -mmin -10)" ] || { echo 'npm failed a short while ago'; exit 1; }
cp "$peer/package.json" package.json
timeout 60 npm install --no-audit --no-fund --silent --fetch-retries=0 >npm.log 2>&1 ||
  { touch failed; echo 'npm cannot install the packages'; exit 1; }
cp package.json installed.json
