"""Copies a simulated dataset and puts a text of one's own into everything that a stranger may name.

plant_markup.py FROM TO TEXT
"""
import json
import pathlib
import re
import shutil
import sys

source, target, text = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
shutil.rmtree(target, ignore_errors=True)
target.mkdir()
quoted = json.dumps(text)
file_text = text.replace('/', '\\')  # no slash in a file's name

columns = {'t_s': 't', 'q_rad': 'q', 'torque_Nm': 'T', 'dq_rad_s': 'w'}
manifest = (source / 'dataset.toml').read_text()
for log in sorted(source.glob('*.csv')):
    head, rows = log.read_text().split('\n', 1)
    names = [columns[name] + text for name in head.split(',')]
    head = ','.join('"%s"' % name.replace('"', '""') for name in names)
    (target / (file_text + log.name)).write_text(head + '\n' + rows)
    manifest = manifest.replace(json.dumps(log.name), json.dumps(file_text + log.name))
for column, short in columns.items():
    manifest = manifest.replace('name = "%s"' % column, 'name = ' + json.dumps(short + text))
manifest = re.sub(r'note = ".*"', lambda _: 'note = ' + quoted, manifest)
manifest = re.sub(r'description = ".*"\n', '', manifest)
manifest = manifest.replace('name = "FANUC AM100iB"', 'name = ' + quoted)
manifest = manifest.replace('serial = "simulated"',
                            '\n'.join('%s = %s' % (key, quoted)
                                      for key in ('serial', 'operator', 'measured_on')))
manifest = manifest.replace('[joint]\nname = "3"', '[joint]\nname = ' + quoted)
manifest = manifest.replace('[[recording]]', '[[recording]]\nnote = ' + quoted)
manifest += '\n[payload]\nnote = %s\n' % quoted
manifest += '\n[[known_load]]\namplitude_Nm = 1e-6\nangles = [%s]\nnote = %s\n' % (
    json.dumps('q' + text), quoted)
(target / 'dataset.toml').write_text(manifest)
