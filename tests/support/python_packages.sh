#!/bin/sh
# Makes a virtual environment with the packages of a requirements file, once; its interpreter is
# DIRECTORY/bin/python.
#   python_packages.sh DIRECTORY REQUIREMENTS
# Several may run at once. After a failure none tries again for 10 minutes. Says why it fails.
wanted=$(realpath "$2") || exit 1
command -v python3 flock >/dev/null || { echo 'python3 or flock is not installed'; exit 1; }
mkdir -p "$1" && cd "$1" && exec 9>lock && flock 9 || exit 1
cmp -s "$wanted" installed.txt && exit 0
[ -z "$(find . -maxdepth 1 -name failed -mmin -10)" ] || { echo 'pip failed a short while ago'; exit 1; }
{ python3 -m venv . &&
  timeout 120 bin/pip install --quiet --no-input --disable-pip-version-check --only-binary :all: \
    --retries 0 -r "$wanted"; } >pip.log 2>&1 ||
  { touch failed; echo 'pip cannot install the packages'; exit 1; }
cp "$wanted" installed.txt
