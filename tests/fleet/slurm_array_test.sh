#!/usr/bin/env bash
# A fleet of robots through examples/fleet/identify_fleet.sbatch, on a real Slurm of two nodes on
# this machine, into an SQLite file and into a PostgreSQL server: the archives hold the numbers of
# one into which they were archived one after the other, with a report of each joint.
#   slurm_array_test.sh TRIBOLOG [ROBOTS [JOINTS]]
# Skips, saying so, where Slurm is not installed.
set -euo pipefail
export TRIBOLOG PER_TASK=2
TRIBOLOG=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
source "$here/slurm_cluster.sh"
# At every change a few of them; each night (tests/nightly.sh cases) more.
robots=${2:-${TRIBOLOG_EVERY_CASE:+12}}
robots=${robots:-6}
joints=${3:-${TRIBOLOG_EVERY_CASE:+4}}
joints=${joints:-2}
options=(--truth-runs 0 --no-figures)
export SOURCE_DATE_EPOCH=1767225600  # when it was identified is part of a calibration

scratch=$(mktemp -d /tmp/tribolog-fleet-XXXXXX)
chmod 755 "$scratch"  # for the database's own user
finish() {
  local status=$?
  stop_slurm
  [ ! -f "$scratch/postgres/server.pid" ] || kill -QUIT "$(cat "$scratch/postgres/server.pid")"
  wait
  rm -rf "$scratch"
  exit "$status"
}
trap finish EXIT
trap 'exit 143' TERM INT
fail() { echo "FAILED: $*" >&2; exit 1; }
seconds_since() { echo "$(($(date +%s%N) / 1000000 - $1))" | sed 's/...$/.& s/; s/^\./0./'; }
now_ms() { echo $(($(date +%s%N) / 1000000)); }

start_slurm "$scratch/slurm" || { [ $? -eq 77 ] && { echo "SKIPPED: no Slurm here"; exit 0; }; exit 1; }

# Each joint with a friction, a load and noise of its own.
began=$(now_ms)
for ((robot = 1; robot <= robots; ++robot)); do
  scenario="$scratch/R$robot.toml"
  sed -e "s/@ROBOT@/R$robot/; s/@SERIAL@/S-$robot/" "$here/robot.toml.in" >"$scenario"
  for ((joint = 1; joint <= joints; ++joint)); do
    number=$((robot * joints + joint))
    sed -e "s/@JOINT@/J$joint/; s/@SEED@/$number/; s/@MASS@/$((40 + joint * 7)).$robot/" \
      -e "s/@COULOMB@/0.$((3000 + number))/" "$here/joint.toml.in"
  done >>"$scenario"
  echo "$scratch/fleet/R$robot/robot.toml"
  echo "$scenario $scratch/fleet/R$robot" >>"$scratch/scenarios"
done >"$scratch/manifests"
datasets=$((robots * joints))
xargs -P "$(nproc)" -L 1 sh -c '"$TRIBOLOG" --quiet simulate "$0" -o "$1"' <"$scratch/scenarios"
echo "$robots robots of $joints joints simulated in $(seconds_since "$began")"

began=$(now_ms)
cp -r "$scratch/fleet" "$scratch/serial"
while IFS= read -r manifest; do
  "$TRIBOLOG" --quiet report "$manifest" -o "${manifest%.toml}" "${options[@]}" </dev/null
done < <(sed "s|$scratch/fleet|$scratch/serial|" "$scratch/manifests")
find "$scratch/serial" -name '*.calibration.json' -print0 |
  xargs -0 "$TRIBOLOG" --quiet archive add --archive "$scratch/serial.tribolog"
echo "identified and archived one after the other in $(seconds_since "$began")"
# All numbers; what a calibration says of its command line is another one.
numbers_of() { "$TRIBOLOG" archive export --all --format csv --archive "$1"; }
numbers_of "$scratch/serial.tribolog" >"$scratch/expected.csv"
[ "$("$TRIBOLOG" archive list --json --archive "$scratch/serial.tribolog" | grep -c '"digest"')" \
  -eq "$datasets" ] || fail "the serial archive"

# One more, which is not there: it must be the only one that fails.
echo "$scratch/fleet/none/robot.toml" >>"$scratch/manifests"
tasks=$(((robots + PER_TASK) / PER_TASK))

array_into() {  # NAME ARCHIVE
  local began job states
  began=$(now_ms)
  find "$scratch/fleet" -type d -name robot -exec rm -r {} +
  job=$(sbatch --parsable --array="1-$tasks" --output="$scratch/$1-%a.log" \
    "$here/../../examples/fleet/identify_fleet.sbatch" "$scratch/manifests" "$2" "${options[@]}")
  while [ -n "$(squeue -h -j "$job" 2>/dev/null)" ]; do sleep 0.3; done
  echo "$1: $tasks tasks of $PER_TASK in $(seconds_since "$began")"
  states=$(scontrol -o show job "$job")
  [ "$(grep -c 'JobState=COMPLETED' <<<"$states")" -eq $((tasks - 1)) ] &&
    [ "$(grep -c 'JobState=FAILED' <<<"$states")" -eq 1 ] ||
    { cat "$scratch/$1"-*.log | grep -v '^archived' | head -n 20; fail "$1: tasks failed"; }
  for node in worker1 worker2; do
    grep -q " NodeList=$node " <<<"$states" || fail "$1: nothing ran on $node"
  done
  grep -q "not archived: .*none/robot.toml" "$scratch/$1-$tasks.log" || fail "$1: nothing said"
  numbers_of "$2" >"$scratch/$1.csv"
  cmp "$scratch/expected.csv" "$scratch/$1.csv" || fail "$1: the archive holds something else"
  "$TRIBOLOG" --quiet archive fleet -o "$scratch/$1.html" --reports "$scratch/$1-reports" \
    --archive "$2" || fail "$1: no fleet page"
  [ "$(find "$scratch/$1-reports" -name '*.html' | wc -l)" -eq "$datasets" ] &&
    [ "$(grep -o 'href="[^"]*-reports/[0-9a-f]*.html"' "$scratch/$1.html" | sort -u | wc -l)" \
      -eq "$datasets" ] || fail "$1: the fleet page does not lead to every report"
  "$TRIBOLOG" archive verify --archive "$2" || fail "$1: the archive is not whole"
}

array_into sqlite "$scratch/array.tribolog"

"$here/../support/postgres_server.sh" "$scratch/postgres" 2>"$scratch/postgres.log" &
server=$!
while :; do
  status=0
  kill -0 "$server" 2>/dev/null || { wait "$server" || status=$?; break; }
  [ ! -f "$scratch/postgres/uri" ] ||
    "$TRIBOLOG" archive list --archive "$(cat "$scratch/postgres/uri")" 2>/dev/null || status=$?
  [ "$status" -ne 3 ] || break  # it answers: there is no archive yet
  sleep 0.2
done
case $status in
  3) PGPASSFILE=/dev/null array_into postgres "$(cat "$scratch/postgres/uri")" ;;
  77) echo "without PostgreSQL: $(cat "$scratch/postgres.log")" ;;
  *) cat "$scratch/postgres.log"; fail "no PostgreSQL server" ;;
esac
echo "the archives are the same"
