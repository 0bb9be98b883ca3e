#include "cli/misuse_calls.h"

namespace tribolog::test::misuse_test {

const std::vector<Call>& calls() {
  static const std::vector<Call> all{
      {"init --column angle=q log.csv -o i1.toml", 0, "manifest: i1.toml"},
      {"init --gear-ratio 101 log.csv -o i2.toml", 0, "manifest: i2.toml"},
      {"init log.csv --gear-ratio 101 -o i3.toml", 0, "manifest: i3.toml"},
      {"init --column angle=q --gear-ratio 101 log.csv --column effort=tau -o i4.toml", 0,
       "manifest: i4.toml"},
      {"init --torque-constant 0.5 log.csv -o i5.toml", 0, "manifest: i5.toml"},
      {"init --gear-ratio 101:1 log.csv -o i6.toml", 0, "manifest: i6.toml"},
      {"init --torque-constant 10,696 log.csv -o i7.toml", 2,
       "--torque-constant: 2 values for one joint; several are for --all-joints, and a decimal has "
       "a "
       "point: 1.5"},
      {"init --joint 2 log.csv -o i8.toml", 2, "the logs name no joint: leave --joint 2 out"},
      {"inspect --column time=t log.csv", 0, "file = \"log.csv\""},
      {"inspect --gear-ratio 50 log.csv", 0, "file = \"log.csv\""},
      {"figures --format svg dataset.toml -o f1", 0, "f1: 3 figures as svg"},
      {"study --factor cycles scenario.toml --runs 2 --json s.json", 0, "numbers: s.json"},
      {"study --json m.json --runs 2 --mixed", 0, "numbers: m.json"},
      {"plan --runs 0 -o next report.html", 0, "plan: next/plan.html"},
      {"study --sound --json m.json --mixed", 2,
       "--misfit, --sound, --mixed and --less-data are studies of their own: choose one"},
      {"study --unstated --mixed --json m.json", 2,
       "--unstated is for --sound, which is not given"},
      {"study --sound --unstated --logs d --json m.json", 2,
       "--logs keeps manifests that state the effects: leave out --unstated"},
      {"study --mixed --joint geared_arm --json m.json", 2,
       "--mixed draws joints and effects: --joint and --disturbance do not apply"},
      {"report --archive dataset.toml -o r1.html --no-figures --truth-runs 0", 0,
       "report: r1.html"},
      {"report dataset.toml --archive new.db -o r2.html --no-figures --truth-runs 0", 0,
       "report: r2.html"},
      {"identify --archive dataset.toml -o c1.json --truth-runs 0", 0, "calibration: c1.json"},
      {"identify --archive --truth-runs 0 dataset.toml -o c2.json", 0, "calibration: c2.json"},
      {"identify dataset.toml -o c3.json --truth-runs 0 --archive report.html", 6,
       "report.html: is no archive (no SQLite file); it is left as it is"},
      {"identify dataset.toml -o c4.json --truth-runs 0 --archive=report.html", 6,
       "report.html: is no archive (no SQLite file); it is left as it is"},
      {"help", 0, "Usage: tribolog [OPTIONS] [SUBCOMMAND]"},
      {"help report", 0, "Usage: tribolog report [OPTIONS] DATA..."},
      {"help archive diff", 0, "Usage: tribolog archive diff [OPTIONS] ID(2x)"},
      {"report help", 0, "Usage: tribolog report [OPTIONS] DATA..."},
      {"archive diff help", 0, "Usage: tribolog archive diff [OPTIONS] ID(2x)"},
      {"report -h", 0, "Usage: tribolog report [OPTIONS] DATA..."},
      {"version", 0, "tribolog 0.2.0"},
      {"-V", 0, "tribolog 0.2.0"},
      {"help reprot", 2,
       "'reprot' is no command of tribolog; did you mean 'report'?; see tribolog --help"},
      {"help archive lst", 2,
       "'lst' is no command of tribolog archive; did you mean 'list'?; see tribolog archive "
       "--help"},
      {"reprot dataset.toml", 2,
       "'reprot' is no command of tribolog; did you mean 'report'?; see tribolog --help"},
      {"identfy dataset.toml", 2,
       "'identfy' is no command of tribolog; did you mean 'identify'?; see tribolog --help"},
      {"make reprot dataset.toml", 2,
       "'reprot' is no command of tribolog; did you mean 'report'?; see tribolog --help"},
      {"archiv list", 2,
       "'archiv' is no command of tribolog; did you mean 'archive'?; see tribolog --help"},
      {"archive lst", 2,
       "'lst' is no command of tribolog archive; did you mean 'list'?; see tribolog archive "
       "--help"},
      {"archive", 2,
       "tribolog archive needs a command: add, list, show, report, diff, trend, fleet, export, "
       "verify, backup, remove; see tribolog archive --help"},
      {"diff 0123 4567", 2,
       "'diff' is no command of tribolog; did you mean 'tribolog archive diff'?; see tribolog "
       "--help"},
      {"tred", 2,
       "'tred' is no command of tribolog; did you mean 'tribolog archive trend'?; see tribolog "
       "--help"},
      {"compare a b", 2,
       "'compare' is no command of tribolog; did you mean 'tribolog archive diff'?; see tribolog "
       "--help"},
      {"plot dataset.toml", 2,
       "'plot' is no command of tribolog; did you mean 'tribolog figures'?; see tribolog --help"},
      {"dataset.toml", 2,
       "'dataset.toml' is no command of tribolog; it is a manifest: tribolog report dataset.toml; "
       "see tribolog --help"},
      {"log.csv", 2,
       "'log.csv' is no command of tribolog; it is a log: tribolog report log.csv; see tribolog "
       "--help"},
      {"report.html", 2,
       "'report.html' is no command of tribolog; it is a report: tribolog show report.html; see "
       "tribolog --help"},
      {"nonsense", 2,
       "'nonsense' is no command of tribolog; commands: inspect, init, simulate, identify, "
       "figures, report, show, models, plan, study, paper, archive, review, export, apply, "
       "manifest, schema, help, version; "
       "see tribolog --help"},
      {"figures dataset.toml extra -o f", 2,
       "'extra' is one argument too many: tribolog figures takes DATASET; see tribolog figures "
       "--help"},
      {"report dataset.toml log.csv -o r.html", 2,
       "dataset.toml is a manifest: one alone, or logs"},
      {"models now", 2,
       "'now' is not expected: tribolog models takes options alone; see tribolog models --help"},
      {"init log.csv --gear-ration 101 -o i.toml", 2,
       "'--gear-ration' is no option of tribolog init; did you mean '--gear-ratio'?; see tribolog "
       "init --help"},
      {"report dataset.toml --outptu r.html", 2,
       "'--outptu' is no option of tribolog report; did you mean '--output'?; see tribolog report "
       "--help"},
      {"report dataset.toml -output r.html", 2,
       "'-output': a long name has two dashes: --output; see tribolog report --help"},
      {"report dataset.toml --gear-ratio 101 -o r.html", 2,
       "--gear-ratio is for logs; beside a manifest, dataset.toml, state it there"},
      {"figures dataset.toml --gear-ratio 101 -o f", 2,
       "'--gear-ratio' is no option of tribolog figures, but of: inspect, init, identify, report; "
       "see tribolog figures --help"},
      {"report dataset.toml -x -o r.html", 2,
       "'-x' is no option of tribolog report; see tribolog report --help"},
      {"--gear-ratio 101 init log.csv -o i.toml", 2,
       "--gear-ratio is an option of tribolog init and stands behind it; see tribolog init --help"},
      {"report dataset.toml -o", 2,
       "--output: the value is missing: report (HTML) to write; default: beside the input; see "
       "tribolog report --help"},
      {"report dataset.toml -o a.html -o b.html", 2,
       "--output is given 2 times, and can be given once; see tribolog report --help"},
      {"report", 2,
       "DATA is required: dataset manifest (TOML); or logs of any format, or folders of them; see "
       "tribolog report --help"},
      {"figures dataset.toml", 2,
       "-o, --output is required: directory to write to; see tribolog figures --help"},
      {"init --robot= log.csv -o i.toml", 2,
       "--robot: the value is empty; state one, or leave the option out; see tribolog init --help"},
      {"report dataset.toml -o r.html --archive ''", 2,
       "--archive: the value is empty; state one, or leave the option out; see tribolog report "
       "--help"},
      {"init log.csv --all-joints --joint J1 -o i.toml", 2,
       "--joint and --all-joints exclude each other; see tribolog init --help"},
      {"init log.csv --effort-kind joint_torqe -o i.toml", 2,
       "--effort-kind: 'joint_torqe' is not usable, expected one of joint_torque, motor_current, "
       "motor_torque, target_torque; did you mean 'joint_torque'?; see tribolog init --help"},
      {"init log.csv --effort-side moter -o i.toml", 2,
       "--effort-side: 'moter' is not usable, expected one of joint, motor; did you mean 'motor'?; "
       "see tribolog init --help"},
      {"init log.csv --angle-unit dge -o i.toml", 2,
       "--angle-unit 'dge': one of rad, mrad, deg, turn, or a multiple such as '0.018 deg'; "
       "did you mean 'deg'?"},
      {"init log.csv --gear-ratio 1:101 -o i.toml", 2,
       "--gear-ratio: '1:101' would make the joint turn faster than the motor, expected turns of "
       "the motor first: did you mean '101:1'? A gear that speeds up is stated as one number, "
       "0.00990099; see tribolog init --help"},
      {"init log.csv --gear-ratio 101:x -o i.toml", 2,
       "--gear-ratio: '101:x' is no gear ratio, expected motor angle / joint angle: 101 or 101:1; "
       "see tribolog init --help"},
      {"init log.csv --gear-ratio ten -o i.toml", 2,
       "--gear-ratio: ten is not usable, expected a number from 0.001 to 1e+06; see tribolog init "
       "--help"},
      {"figures dataset.toml -o f --format jpg", 2,
       "--format: 'jpg' is not usable, expected one of pdf, png, svg; see tribolog figures --help"},
      {"figures dataset.toml -o f --style papr", 2,
       "--style: 'papr' is not usable, expected one of paper, report; did you mean 'paper'?; see "
       "tribolog figures --help"},
      {"report dataset.toml -o r.html --language pol", 2,
       "--language: 'pol' is not usable, expected one of en, pl; did you mean 'pl'?; see tribolog "
       "report --help"},
      {"report dataset.toml -o r.html --fail-on doubtfull", 2,
       "--fail-on: 'doubtfull' is not usable, expected one of doubtful, not-identifiable; did you "
       "mean 'doubtful'?; see tribolog report --help"},
      {"export report.html --format cvs", 2,
       "--format: 'cvs' is not usable, expected one of csv, json, mat, latex, dcc, urdf, sdf, "
       "mjcf, mjcf-lugre, isaaclab, usd, modelica, simscape, ros2, c, python, feedforward, bam; "
       "did you mean "
       "'csv'?; see tribolog export --help"},
      {"study -o s.html --factor cycle", 2,
       "--factor: 'cycle' is not usable, expected one of torque_noise, torque_step, encoder, "
       "ripple_one_position, ripple_eight_positions, amplitude, cycles; did you mean 'cycles'?; "
       "see tribolog study --help"},
      {"report dataset.toml -o r.html --processes many", 2,
       "--processes: Value many not in range 1 to 64; see tribolog report --help"},
      {"report dataset.toml -o report.pdf", 2,
       "--output: 'report.pdf' is not usable, the page is HTML: write it to 'report.html'; print "
       "it from a browser for a PDF; tribolog figures --format pdf gives the figures as PDF; see "
       "tribolog report --help"},
      {"report dataset.toml -o report.docx", 2,
       "--output: 'report.docx' is not usable, the page is HTML: write it to 'report.html'; word "
       "processors open it; tribolog figures gives the figures, tribolog export --format latex a "
       "table; see tribolog report --help"},
      {"report dataset.toml -o report.csv", 2,
       "--output: 'report.csv' is not usable, the page is HTML: write it to 'report.html'; "
       "tribolog export --format csv (or mat, dcc) gives the numbers; see tribolog report --help"},
      {"report dataset.toml -o report.PNG", 2,
       "--output: 'report.PNG' is not usable, the page is HTML: write it to 'report.html'; "
       "tribolog figures --format png (or svg, pdf) gives the figures; see tribolog report --help"},
      {"paper -o paper.pdf", 2,
       "--output: 'paper.pdf' is not usable, the page is HTML: write it to 'paper.html'; print it "
       "from a browser for a PDF; tribolog figures --format pdf gives the figures as PDF; see "
       "tribolog paper --help"},
      {"study -o study.pdf", 2,
       "--output: 'study.pdf' is not usable, the page is HTML: write it to 'study.html'; print it "
       "from a browser for a PDF; tribolog figures --format pdf gives the figures as PDF; see "
       "tribolog study --help"},
      {"models --compare -o models.pdf", 2,
       "--output: 'models.pdf' is not usable, the page is HTML: write it to 'models.html'; print "
       "it from a browser for a PDF; tribolog figures --format pdf gives the figures as PDF; see "
       "tribolog models --help"},
      {"archive fleet -o fleet.pdf", 2,
       "--output: 'fleet.pdf' is not usable, the page is HTML: write it to 'fleet.html'; print it "
       "from a browser for a PDF; tribolog figures --format pdf gives the figures as PDF; see "
       "tribolog archive fleet --help"},
      {"archive trend -o trend.json", 2,
       "--output: 'trend.json' is not usable, the page is HTML: write it to 'trend.html'; tribolog "
       "identify -o FILE.json gives the numbers; see tribolog archive trend --help"},
      {"archive diff 01 23 -o diff.pdf", 2,
       "--output: 'diff.pdf' is not usable, the page is HTML: write it to 'diff.html'; print it "
       "from a browser for a PDF; tribolog figures --format pdf gives the figures as PDF; see "
       "tribolog archive diff --help"},
      {"archive report 01 -o report.pdf", 2,
       "--output: 'report.pdf' is not usable, the page is HTML: write it to 'report.html'; print "
       "it from a browser for a PDF; tribolog figures --format pdf gives the figures as PDF; see "
       "tribolog archive report --help"},
      {"review 01 --approve --reviewer me -o report.pdf", 2,
       "--output: 'report.pdf' is not usable, the page is HTML: write it to 'report.html'; print "
       "it from a browser for a PDF; tribolog figures --format pdf gives the figures as PDF; see "
       "tribolog review --help"},
      {"identify report.html", 3,
       "report.html: is a report, expected a dataset manifest (TOML) or logs; hint: tribolog show "
       "report.html"},
      {"identify report.html -o c.json", 3,
       "report.html: is a report, expected a dataset manifest (TOML) or logs; hint: tribolog show "
       "report.html"},
      {"identify renamed.csv -o c.json", 3,
       "renamed.csv: is a report, expected a dataset manifest (TOML) or logs; hint: tribolog show "
       "renamed.csv"},
      {"identify report.calibration.json -o c.json", 3,
       "report.calibration.json: is a calibration, expected a dataset manifest (TOML) or logs; "
       "hint: tribolog show report.calibration.json"},
      {"report report.calibration.json -o r.html", 3,
       "report.calibration.json: is a calibration, expected a dataset manifest (TOML) or logs; "
       "hint: tribolog show report.calibration.json"},
      {"report archive.db -o r.html", 3,
       "archive.db: is an archive, expected a dataset manifest (TOML) or logs; hint: tribolog "
       "archive list --archive archive.db"},
      {"report scenario.toml -o r.html", 3,
       "scenario.toml: is a scenario, expected a dataset manifest (TOML) or logs; hint: tribolog "
       "simulate scenario.toml -o DIRECTORY"},
      {"report joint.toml -o r.html", 3,
       "joint.toml: is the file of a joint to plan for, expected a dataset manifest (TOML) or "
       "logs; hint: tribolog plan joint.toml -o DIRECTORY"},
      {"report am100ib.toml -o r.html", 3,
       "am100ib.toml: is the description of an arm, expected a dataset manifest (TOML) or logs; "
       "hint: a manifest names it: [robot] description = \"am100ib.toml\""},
      {"report plan.json -o r.html", 3,
       "plan.json: holds the numbers of a plan, expected a dataset manifest (TOML) or logs; hint: "
       "plan.html beside it shows them"},
      {"report truth.json -o r.html", 3,
       "truth.json: holds the true values of a simulation, expected a dataset manifest (TOML) or "
       "logs; hint: dataset.toml beside it is the manifest"},
      {"figures report.html -o f", 3,
       "report.html: is a report, expected a dataset manifest (TOML); hint: tribolog show "
       "report.html"},
      {"show dataset.toml", 3,
       "dataset.toml: is a manifest, expected a report (HTML) or a calibration (JSON); hint: "
       "tribolog report dataset.toml"},
      {"show log.csv", 3,
       "log.csv: is a log, expected a report (HTML) or a calibration (JSON); hint: tribolog report "
       "log.csv"},
      {"show archive.db", 3,
       "archive.db: is an archive, expected a report (HTML) or a calibration (JSON); hint: "
       "tribolog archive list --archive archive.db"},
      {"show scenario.toml", 3,
       "scenario.toml: is a scenario, expected a report (HTML) or a calibration (JSON); hint: "
       "tribolog simulate scenario.toml -o DIRECTORY"},
      {"simulate dataset.toml -o s", 3,
       "dataset.toml: is a manifest, expected a scenario (TOML); hint: tribolog report "
       "dataset.toml"},
      {"simulate log.csv -o s", 3,
       "log.csv: is a log, expected a scenario (TOML); hint: tribolog report log.csv"},
      {"study report.html -o s.html", 3,
       "report.html: is a report, expected a scenario (TOML); hint: tribolog show report.html"},
      {"paper dataset.toml -o p.html", 3,
       "dataset.toml: is a manifest, expected a scenario (TOML); hint: tribolog report "
       "dataset.toml"},
      {"export dataset.toml --format csv", 3,
       "dataset.toml: is a manifest, expected a report (HTML) or a calibration (JSON); hint: "
       "tribolog report dataset.toml"},
      {"export log.csv --format csv", 3,
       "log.csv: is a log, expected a report (HTML) or a calibration (JSON); hint: tribolog report "
       "log.csv"},
      {"export archive.db --format csv", 3,
       "archive.db: is an archive, expected a report (HTML) or a calibration (JSON); hint: "
       "tribolog archive list --archive archive.db"},
      {"plan dataset.toml -o p", 3,
       "dataset.toml: is a manifest, expected the file of a joint or of a robot's joints (TOML), a "
       "report or a calibration; hint: tribolog report dataset.toml"},
      {"plan scenario.toml -o p", 3,
       "scenario.toml: is a scenario, expected the file of a joint or of a robot's joints (TOML), "
       "a "
       "report or a calibration; hint: tribolog simulate scenario.toml -o DIRECTORY"},
      {"plan joint.toml --calibration archive.db -o p", 3,
       "archive.db: is an archive, expected a report (HTML) or a calibration (JSON); hint: "
       "tribolog archive list --archive archive.db"},
      {"plan report.html --joint 3 -o p", 2,
       "plan of a report or calibration: --calibration and --joint are for a joint's file"},
      {"init dataset.toml -o i.toml", 3,
       "dataset.toml: is a manifest, expected a log; hint: tribolog report dataset.toml"},
      {"init report.html -o i.toml", 3,
       "report.html: is a report, expected a log; hint: tribolog show report.html"},
      {"inspect archive.db", 3,
       "archive.db: is an archive, expected a log; hint: tribolog archive list --archive "
       "archive.db"},
      {"inspect fleet.html", 3,
       "fleet.html: is a page of tribolog without numbers to read, expected a log"},
      {"review dataset.toml --approve --reviewer me", 3,
       "dataset.toml: is a manifest, expected a report (HTML); hint: tribolog report dataset.toml"},
      {"archive add report.html --archive archive.db", 3,
       "report.html: is a report, expected a calibration (JSON); hint: tribolog show report.html"},
      {"archive add dataset.toml --archive archive.db", 3,
       "dataset.toml: is a manifest, expected a calibration (JSON); hint: tribolog report "
       "dataset.toml"},
      {"archive add report.calibration.json --report dataset.toml --archive archive.db", 3,
       "dataset.toml: is a manifest, expected a report (HTML); hint: tribolog report dataset.toml"},
      {"archive diff report.calibration.json report.calibration.json --archive archive.db", 3,
       "report.calibration.json: is a calibration, expected the id of an archived calibration, "
       "which tribolog archive list shows; hint: tribolog archive add report.calibration.json "
       "keeps it and prints its id"},
      {"archive show report.html --archive archive.db", 3,
       "report.html: is a report, expected the id of an archived calibration, which tribolog "
       "archive list shows; hint: tribolog show report.html"},
      {"archive remove dataset.toml --archive archive.db", 3,
       "dataset.toml: is a manifest, expected the id of an archived calibration, which tribolog "
       "archive list shows; hint: tribolog report dataset.toml"},
      {"identify gone.toml -o c.json", 3, "gone.toml: cannot open: No such file or directory"},
      {"models --compare -o scenario.csv", 2,
       "--output: 'scenario.csv' is not usable, the page is HTML: write it to 'scenario.html'; "
       "tribolog export --format csv (or mat, dcc) gives the numbers; see tribolog models --help"},
      {"show fleet.html", 3,
       "fleet.html: is a page of tribolog without numbers to read, expected a report (HTML) or a "
       "calibration (JSON)"},
      {"export report.html --format jsno", 2,
       "--format: 'jsno' is not usable, expected one of csv, json, mat, latex, dcc, urdf, sdf, "
       "mjcf, mjcf-lugre, isaaclab, usd, modelica, simscape, ros2, c, python, feedforward, bam; "
       "did you mean "
       "'json'?; see tribolog export --help"},
      {"archive list --archive=", 2,
       "--archive: the value is empty; state one, or leave the option out; see tribolog archive "
       "list --help"},
      {"archive list --archive report.html", 6,
       "report.html: is no archive (no SQLite file); it is left as it is"},
      {"init log.csv -o i.toml --column", 2,
       "--column: the value is missing: which column is which: time, angle, speed, effort or "
       "temperature (may be given again); see tribolog init --help"},
  };
  return all;
}

}  // namespace tribolog::test::misuse_test
