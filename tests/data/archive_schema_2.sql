-- An archive of schema 2, as `sqlite3 .dump` writes it: two calibrations, one with report, inputs and review.
PRAGMA user_version = 2;
CREATE TABLE calibration (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE CHECK (length(id) = 64),
  identity TEXT NOT NULL CHECK (length(identity) = 64),
  revision INTEGER NOT NULL CHECK (revision >= 1),
  robot TEXT NOT NULL,
  serial TEXT NOT NULL,
  joint TEXT NOT NULL,
  measured_at TEXT NOT NULL CHECK (length(measured_at) = 20),
  measured_on TEXT NOT NULL,
  time_is_stated INTEGER NOT NULL CHECK (time_is_stated IN (0, 1)),
  created_utc TEXT NOT NULL,
  operator TEXT NOT NULL,
  note TEXT NOT NULL,
  payload TEXT NOT NULL,
  payload_kg REAL CHECK (payload_kg >= 0),
  payload_distance_m REAL CHECK (payload_distance_m > 0),
  temperature_C REAL CHECK (temperature_C > -273.15),
  gear_ratio REAL NOT NULL CHECK (gear_ratio <> 0),
  sampling_Hz REAL CHECK (sampling_Hz > 0),
  verdict TEXT NOT NULL CHECK (verdict IN ('usable', 'doubtful', 'not_identifiable')),
  sentence TEXT NOT NULL,
  configuration TEXT NOT NULL,
  tool_version TEXT NOT NULL,
  git_revision TEXT NOT NULL,
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  UNIQUE (identity, revision)
) STRICT;
INSERT INTO calibration VALUES(1,'08c3129e1bca5a0b5d58f8b9141ca6f326c7a2aa9439b830b2bfee86b41d7848','a06f0fe026a5cc2d7f39fa2064451b52cbb2e0e6fb161337c95625de06e6cd2d',1,'R1','S1','J1','2026-01-31T00:00:00Z','2026-01-31',1,'2026-02-01T00:00:00Z','A. Nowak','warm','a box',5.0,0.25,21.5,100.0,100.0,'usable','All stages have their data.',replace('Resamples: 1000\n','\n',char(10)),'0.1.0','0123456789ab','60f2484179be6a0c43fb1d13b84443fb2f489d33436e84dfaf848ac875202649');
INSERT INTO calibration VALUES(2,'d9831b06c876f5c40585a1165f9f82c02786e3b19bb0d97e68c33bd167fe1852','f180c98787b2fd3a3f9b91e91b5409c8d5f4c7f56c1c51b1360921ad1afb85b1',1,'R1','S1','J2','2026-01-31T00:00:00Z','2026-01-31',1,'2026-02-01T00:00:00Z','A. Nowak','warm','a box',5.0,0.25,21.5,100.0,100.0,'usable','All stages have their data.',replace('Resamples: 1000\n','\n',char(10)),'0.1.0','0123456789ab','a6f1798eaf6da796c7aa9696eecb05caba4a4b1cff2dc7415e053805945f9a02');
CREATE TABLE quantity (
  calibration INTEGER NOT NULL REFERENCES calibration (number) ON DELETE CASCADE,
  place INTEGER NOT NULL,
  name TEXT NOT NULL,
  words TEXT NOT NULL,
  unit TEXT NOT NULL,
  verdict TEXT NOT NULL CHECK (verdict IN ('usable', 'doubtful', 'not_identifiable')),
  value REAL CHECK (abs(value) <= 1.7976931348623157e308),
  low REAL CHECK (low <= value),
  high REAL CHECK (high >= value),
  PRIMARY KEY (calibration, place)
) STRICT;
INSERT INTO quantity VALUES(1,0,'coulomb_torque','Coulomb torque','N·m','usable',0.5,0.4500000000000000111,0.5500000000000000444);
INSERT INTO quantity VALUES(1,1,'viscous_curve','Viscous curve','','doubtful',NULL,NULL,NULL);
INSERT INTO quantity VALUES(2,0,'coulomb_torque','Coulomb torque','N·m','usable',0.5,0.4500000000000000111,0.5500000000000000444);
INSERT INTO quantity VALUES(2,1,'viscous_curve','Viscous curve','','doubtful',NULL,NULL,NULL);
CREATE TABLE input (
  calibration INTEGER NOT NULL REFERENCES calibration (number) ON DELETE CASCADE,
  place INTEGER NOT NULL,
  name TEXT NOT NULL,
  role TEXT NOT NULL,
  bytes INTEGER NOT NULL CHECK (bytes >= 0),
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  PRIMARY KEY (calibration, place)
) STRICT;
INSERT INTO input VALUES(1,0,'dataset.toml','manifest',13,'e1d00f57bdc4942e31ca3266c339320d5c732faf34975273f1b6f8e1a147c571');
INSERT INTO input VALUES(1,1,'log.csv','rough_sweep',8,'e14fda2796c090d0d2992254a00be1b07f25618a58f76ab0c9557a93270143a6');
INSERT INTO input VALUES(2,0,'dataset.toml','manifest',13,'e1d00f57bdc4942e31ca3266c339320d5c732faf34975273f1b6f8e1a147c571');
INSERT INTO input VALUES(2,1,'log.csv','rough_sweep',8,'abababababababababababababababababababababababababababababababab');
CREATE TABLE document (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  calibration INTEGER NOT NULL REFERENCES calibration (number) ON DELETE CASCADE,
  kind TEXT NOT NULL CHECK (kind IN ('calibration', 'report', 'input')),
  name TEXT NOT NULL,
  bytes INTEGER NOT NULL CHECK (bytes >= 0),
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  stored_bytes INTEGER NOT NULL
) STRICT;
INSERT INTO document VALUES(1,1,'calibration','',1145,'96a17547b7b0048e1d4c1d67df5e75da8423f67a45f39e0d37c3d55a83d69599',640);
INSERT INTO document VALUES(2,1,'input','dataset.toml',13,'e1d00f57bdc4942e31ca3266c339320d5c732faf34975273f1b6f8e1a147c571',22);
INSERT INTO document VALUES(3,1,'input','log.csv',8,'e14fda2796c090d0d2992254a00be1b07f25618a58f76ab0c9557a93270143a6',17);
INSERT INTO document VALUES(4,1,'report','',13,'b633a587c652d02386c4f16f8c6f6aab7352d97f16367c3c40576214372dd628',22);
INSERT INTO document VALUES(5,2,'calibration','',1145,'0783713f24a54a32af440fbca362a5d902eab1a1af411f0b98bdfed4888358b5',604);
CREATE TABLE content (
  document INTEGER PRIMARY KEY REFERENCES document (number) ON DELETE CASCADE,
  zstd BLOB NOT NULL
) STRICT;
INSERT INTO content VALUES(1,X'28b52ffd607903b5130026246b22206df5e1311aa33d1a56bb609bddd2cea1bb4062167651f5fdb2ceb688249000b05c60006100600097ea770943168b821a527e2b2323394010fe108eec33821954e5c63b75e08613204940f5e7da0c57128d251ac71c752876bd969b1a782abdc160b2ac6d0b9a62ba1cc862bd3faf0b01582d415d3ed72727c384e4d39facbf90c562aa27689723886d89df227306ac7edaf3b1bd0bcaf8588f1f85d3308be29aacba422f2596b4842d5bbb5a8cb1f6107d25195187090bc60e1a4b38f8178afddc15d2aebc323c1000db9341b1851a1ea96c2c87828ddd0ccb58832ab7d495acf1c124cd09405d030de378523ee2bded4852a6a657ca3ff9b6f62f834a86c79c97ce1bfdbb1e1184aa5e08d9ebd0caeab1207cfaa626494e4bc367c21ccf947cdbce63ec2e10487a11011bab37ee43f5871ee5f33a8c6887962f9ff27d48f8392255f6f448573c050f86c76a58591a73d8619807b2c78d13291856b4c861aff5638c17c6b9e7719145f630d83c8ee3182d0a4677c3429374bd56162692cfe630d0591ab75644cd6b91e238c6791625e2c8290e642273caa328b0699cc2b029ed966781f1394cc4586c1d5ba8c128248d54560a93921a190e308410a9e83c615c2e89ccd4426b0749430ae67a82ff14f77dc097a1098002a9665a49c636816759253e260461d933719234fa3fc497fa7ed5d463d5f415a306841349428756a023279dee154c7be3cdf9de026194e0503cdd573bc3a5594ac20d1e15614bdd59476b0ae6392f27205f48e75fb42f23c1fd9ab6813e981b82a2deda11d8abbd07d98927854013ee71729241b504e630ecc02dd41edd275e0f3952a1a730836350b62fadf90940e28c9510790ede7246cf836a');
INSERT INTO content VALUES(2,X'28b52ffd200d690000736368656d61203d202278220a');
INSERT INTO content VALUES(3,X'28b52ffd2008410000742c710a302c310a');
INSERT INTO content VALUES(4,X'28b52ffd200d6900003c68746d6c3e3c2f68746d6c3e');
INSERT INTO content VALUES(5,X'28b52ffd607903951200d6206222206df4b388dfb447a28baf7da46d5c3a199542d08843f4102fec2a1628140210227057005900560094dfcaa8380f4c843fc5917d4af003aa2cbdd30796bc402102d59f6b3f3c5134a66038e6a833b1ebb5dc9023782adde160b2ac6d0d1a62ba269463bd3faf4b01aca6a02e9feb9393a1c2f1e94fd65fcab118ea07da35118f1b010b435924aec9a82bf3d2614843d8b2b5a3c5186b1fd1d7910d75a8e0600ca13185837f99d8cf5d21edc86bc3a4006ccf07c496913c5229ad89051bbb1f96b1c6546ea72359e3a420cd0d305d2fd4ef10a61c0b621a06b7f9773daa84a85ec8d8ebd0ca685a11fe7c438f239f85e4136113cf907cdbcb63ec3214487ad5808dd5a50b51fd9907f9bc0e25faa1e5cba77c21107e8eaaca7e5e75c48fb2edf05b35a7c0eaa73d1fdbbba08cd30a53c3b41e073cba25cb3ccef51a5988383edba2c065d1b87540c378ad4916a72c8d45d270e392052a91b9a4912490c17009c396b45b341630be4569188bad198ae3277989f7b61b49199a5e217fe4dbdabf0f2a1ba6392f9d015aa8c128258d54560a934a8de5308410a9e83c92986950885258625bfb7f06abd689d4a898e3015ec61f0005a266a792206de2e7b54a7c270467d9f371b23e3a2cc435f573a35937d5c82bb20d8844a48560ad46674e9e2e21ccfe459bb57b0bc24841403cb9af4e067266a91ef7ffa814b6449f275a46303b795d42c80530efa0771924ee13696b7adedc02145136a2c0b2361d84252e0a8f86c7a3d2a4073de9cd91b1d737b83677477b8b6457cd38d5bcc741d95f48d3d243c7815321b539fc25825e15aa01');
CREATE TABLE event (
  number INTEGER PRIMARY KEY CHECK (number >= 1),
  at_utc TEXT NOT NULL,
  what TEXT NOT NULL CHECK (what IN ('added', 'report', 'reviewed', 'removed')),
  id TEXT NOT NULL,
  digest TEXT NOT NULL,
  chain TEXT NOT NULL CHECK (length(chain) = 64)
) STRICT;
INSERT INTO event VALUES(1,'2026-02-01T00:00:00Z','added','08c3129e1bca5a0b5d58f8b9141ca6f326c7a2aa9439b830b2bfee86b41d7848','60f2484179be6a0c43fb1d13b84443fb2f489d33436e84dfaf848ac875202649','d8d74e75fda8d8f86036e364feca6bee15d3b5cd1629a14f5bf58bf932a20167');
INSERT INTO event VALUES(2,'2026-02-01T00:00:00Z','report','08c3129e1bca5a0b5d58f8b9141ca6f326c7a2aa9439b830b2bfee86b41d7848','b633a587c652d02386c4f16f8c6f6aab7352d97f16367c3c40576214372dd628','45716a583b7a11c4b9b30ecd008991124aa057bcf81d806bef110b15e5476827');
INSERT INTO event VALUES(3,'2026-02-01T00:00:00Z','added','d9831b06c876f5c40585a1165f9f82c02786e3b19bb0d97e68c33bd167fe1852','a6f1798eaf6da796c7aa9696eecb05caba4a4b1cff2dc7415e053805945f9a02','3ca5319ebd96003ac5b5b2637ff4d78a1009f1a35eefba06f485e9fa1414bb7c');
INSERT INTO event VALUES(4,'2026-02-01T00:00:00Z','reviewed','08c3129e1bca5a0b5d58f8b9141ca6f326c7a2aa9439b830b2bfee86b41d7848','1fc6b41b9f4aa40fb3075ee18cb317d04066550f5c7b50eb1132bee0cf11b913','3c0cc2225e99291fb85105f079300ad515e2eecbf227c752d7558789c805b852');
CREATE TABLE review (
  calibration INTEGER NOT NULL REFERENCES calibration (number) ON DELETE CASCADE,
  place INTEGER NOT NULL,
  at_utc TEXT NOT NULL,
  reviewer TEXT NOT NULL,
  decision TEXT NOT NULL CHECK (decision IN ('approved', 'rejected')),
  note TEXT NOT NULL,
  PRIMARY KEY (calibration, place)
) STRICT;
INSERT INTO review VALUES(1,0,'2026-02-01T00:00:00Z','A. Nowak','approved','good');
DELETE FROM sqlite_sequence;
INSERT INTO sqlite_sequence VALUES('calibration',2);
INSERT INTO sqlite_sequence VALUES('document',5);
CREATE INDEX document_of_calibration ON document (calibration);
CREATE UNIQUE INDEX one_document_of_a_kind ON document (calibration, kind) WHERE kind <> 'input';
CREATE INDEX calibration_of_joint ON calibration (robot, serial, joint, measured_at);
