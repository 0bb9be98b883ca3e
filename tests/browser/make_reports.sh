#!/bin/sh
# The reports that the browser tests open: the paper's joint without and with noise, the noisy one in
# Polish, both compared, the plan of an experiment, the paper regenerated, the fleet's page, and with markup of strangers in every text of its
# manifest and its logs.
#   make_reports.sh TRIBOLOG FLEET_ARCHIVE DIRECTORY
set -e
tribolog=$1
fleet_archive=$2
sources=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$3" && cd "$3"

quick='--truth-runs 0'

for name in scenario scenario_noise; do
  "$tribolog" --quiet simulate "$sources/../../examples/paper/$name.toml" -o $name
done
# All that a certificate may state.
cat scenario_noise/dataset.toml - > scenario_noise/certificate.toml <<'END'
[uncertainty]
torque_constant_percent = 0.5
angle_zero_deg = 0.01
[temperature]
degC = 21.5
[payload]
mass_kg = 5
[[limit]]
quantity = "surrogate_mass_kg"
min = 75
max = 85
[certificate]
number = "K-2026-0117"
laboratory = "Joint Laboratory"
laboratory_address = "Example Street 1, 10115 Berlin"
country = "DE"
customer = "Robot User Ltd"
customer_address = "Industry Road 5, Hannover"
place = "laboratory"
received_on = 2026-11-20
procedure = "AA-12, edition 3"
conditions = "indoors, no draught"
humidity_percent = 45
adjustment = "none was made"
decision_rule = "simple acceptance"
responsible = "Dr. A. Nowak"
[[certificate.instrument]]
name = "Torque sensor T20"
identification = "SN 4711"
traceability = "D-K-15195-01-00, 2026-03"
END
"$tribolog" --quiet report scenario_noise/certificate.toml $quick --no-figures -o certificate.html
rm -f pair.tribolog
"$tribolog" --quiet report scenario/dataset.toml $quick -o paper.html
"$tribolog" --quiet report scenario_noise/dataset.toml $quick --no-figures -o noisy.html
"$tribolog" --quiet archive add --archive pair.tribolog paper.calibration.json noisy.calibration.json
ids=$("$tribolog" archive list --archive pair.tribolog | awk 'length($1) == 10 { print $1 }')
"$tribolog" --quiet archive diff $ids --archive pair.tribolog -o diff.html
"$tribolog" --quiet report scenario_noise/dataset.toml $quick --no-figures --language pl -o polish.html
"$tribolog" --quiet plan "$sources/../../examples/plan/joint.toml" --runs 2 -o planned
cp planned/plan.html plan.html
"$tribolog" --quiet paper -o regenerated.html
rm -f fleet.tribolog
"$fleet_archive" fleet.tribolog 30 4 6
"$tribolog" --quiet archive fleet --archive fleet.tribolog -o fleet.html

# Recorded names of columns and files become markup too.
python3 "$sources/plant_markup.py" scenario_noise harmless x
python3 "$sources/plant_markup.py" scenario_noise hostile \
  "\"'></script><script>window.ran=1</script><img src=x onerror=window.ran=1></title></style><!--"
for name in harmless hostile; do
  "$tribolog" --quiet report $name/dataset.toml $quick --no-figures -o $name.html
done
