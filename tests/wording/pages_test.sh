#!/bin/sh
# Every page and every figure in every language: no text that a reader sees is left in English, and
# the numbers are the same.
#   pages_test.sh TRIBOLOG DIRECTORY
set -e
tribolog="$1 --quiet"
here=$(cd "$(dirname "$0")" && pwd)
examples=$here/../../examples
mkdir -p "$2" && cd "$2"
rm -rf ./*

# One report says what resampling and simulation bring; the others need not.
full='--truth-runs 2 --no-figures'
quick='--truth-runs 0 --no-figures'
$tribolog simulate "$examples/paper/scenario_noise.toml" -o noise
python3 "$here/vary_dataset.py" noise
# At every change those that say most; each night, by tests/nightly.sh cases, all.
every_case=$TRIBOLOG_EVERY_CASE
variants='noise/limits_variant.toml noise/no_torque_variant.toml noise/runs_variant.toml'
[ -z "$every_case" ] || variants=$(echo noise/*_variant.toml)
for manifest in $variants; do
  name=$(basename "$manifest" .toml)
  for language in en pl; do
    $tribolog report "$manifest" $quick --language $language -o $name.$language.html \
      --archive $language.tribolog --archive-again
  done
done
for language in en pl; do
  # Of a joint that was measured before, so that there is a change to tell.
  $tribolog report noise/dataset.toml $full --language $language -o whole.$language.html \
    --archive $language.tribolog --archive-again
  if [ -n "$every_case" ]; then
    $tribolog figures noise/dataset.toml --truth-runs 1 --format svg --language $language \
      -o svg.$language
    $tribolog plan "$examples/plan/joint.toml" --runs 2 --language $language -o plan.$language
    cp plan.$language/plan.html plan.$language.html
    $tribolog models --compare --language $language -o models.$language.html
    $tribolog study --runs 2 --factor torque_noise --language $language -o study.$language.html
    $tribolog paper "$examples/paper/scenario_ripple.toml" --language $language \
      -o claims.$language.html
  fi
  $tribolog paper --language $language -o paper.$language.html
  $tribolog archive trend --archive $language.tribolog --language $language -o trend.$language.html \
    >/dev/null
  $tribolog archive fleet --archive $language.tribolog --language $language -o fleet.$language.html
  set -- $($tribolog archive list --archive $language.tribolog --json |
    python3 -c 'import json, sys; print(*[one["id"] for one in json.load(sys.stdin)["calibrations"]][:2])')
  $tribolog archive diff "$1" "$2" --archive $language.tribolog --language $language \
    -o diff.$language.html >/dev/null
done

status=0
for page in *.en.html; do
  other=$(basename "$page" .en.html).pl.html
  grep -q '<html lang="pl">' "$other" || { echo "$other: not in Polish"; status=1; }
  python3 "$here/untranslated.py" "$page" "$other" >left || { echo "## $other"; cat left; status=1; }
done
if [ -n "$every_case" ]; then
  python3 "$here/untranslated.py" svg.en svg.pl >left || { echo "## figures"; cat left; status=1; }
fi
exit $status
