#!/bin/sh
# One test file in a browser; skips, saying so, where there is none that can be driven.
#   run.sh PACKAGES REPORTS TEST.mjs [ARGUMENT...]
skip() { echo "SKIPPED: $*"; exit 0; }
chromium=$(command -v chromium || command -v chromium-browser) || skip 'chromium is not installed'
case $(readlink -f "$chromium") in
  */snap*) skip 'chromium is a snap, which opens no files of a build directory' ;;
esac
! grep -qsI /snap/bin "$chromium" || skip 'chromium is a snap, which opens no files of a build directory'
command -v node >/dev/null || skip 'node is not installed'
[ "$(node -p 'process.versions.node.split(".")[0]')" -ge 18 ] || skip 'node is older than 18'
packages=$1
missing=$("$(dirname "$0")/../support/npm_packages.sh" "$packages" "$(dirname "$0")/package.json") ||
  skip "$missing"
export CHROMIUM="$chromium" TRIBOLOG_PACKAGES="$packages" TRIBOLOG_REPORTS="$2"
shift 2
exec node "$@"
