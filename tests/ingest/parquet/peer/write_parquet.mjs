// Writes the same rows as CSV and as Parquet, in many forms, by two other implementations.
//   PARQUET_PACKAGES=DIR node write_parquet.mjs DIRECTORY
import { createRequire } from 'node:module';
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { pathToFileURL } from 'node:url';

const packages = path.join(process.env.PARQUET_PACKAGES, 'package.json');
const require = createRequire(packages);
const modules = path.join(process.env.PARQUET_PACKAGES, 'node_modules');
const { parquetWriteBuffer } = await import(
  pathToFileURL(path.join(modules, 'hyparquet-writer/src/node.js')));
const wasm = require('parquet-wasm');

const directory = process.argv[2];
const rows = Number(process.env.PARQUET_ROWS ?? 3000);
const row = (make) => Array.from({ length: rows }, (_, i) => make(i));

// What CSV can say too: decimals that come back to the last bit.
const t = row((i) => i / 1000);
const q = row((i) => Math.sin(i / 100));
const steps = row((i) => Math.round(Math.sin(i / 100) * 50) / 10);
const tau = row((i) => (i % 7 === 3 ? null : Math.cos(i / 100) * 3));
const ticks = row((i) => (i * 37) % 100000 - 50000);
const long = row((i) => BigInt(i) * 4294967296n - 5n);
const count = row((i) => Math.floor(i / 10));
const flag = row((i) => (i >> 4) % 2 === 1);
const half = row((i) => (i % 64) / 4);
const single = row((i) => Math.fround(Math.sin(i / 50)));
const word = row((i) => (i % 5 === 2 ? null : ['up', 'down', 'hold'][Math.floor(i / 100) % 3]));
const stamp = row((i) => new Date(Date.UTC(2026, 2, 1, 8, 15) + i * 4));
const gapful = row((i) => (i % 11 === 5 ? null : i % 1000));

const iso = (date) => date.toISOString().replace('Z', '');
const cell = (v) => v === null ? '' : v === true ? '1' : v === false ? '0' : v instanceof Date ? iso(v) : `${v}`;
const all = { t, q, steps, tau, ticks, long, count, flag, half, single, gapful, word, stamp };
const names = Object.keys(all);
fs.writeFileSync(path.join(directory, 'rows.csv'),
  [names.join(','), ...row((i) => names.map((n) => cell(all[n][i])).join(','))].join('\n') + '\n');

const column = (name, type, encoding, nullable = false) => ({ name, data: all[name], type, encoding, nullable });
function columns(encodings) {
  const e = encodings;
  return [column('t', 'DOUBLE', e.real), column('q', 'DOUBLE', e.real), column('steps', 'DOUBLE', e.real),
    column('tau', 'DOUBLE', e.real, true), column('ticks', 'INT32', e.integer), column('long', 'INT64', e.integer),
    column('count', 'INT32', e.integer), column('flag', 'BOOLEAN', e.boolean), column('half', 'FLOAT16', e.half),
    column('single', 'FLOAT', e.real), column('gapful', 'INT32', e.integer, true),
    column('word', 'STRING', e.text, true), column('stamp', 'TIMESTAMP', e.integer)];
}
const write = (name, bytes) => fs.writeFileSync(path.join(directory, name), Buffer.from(bytes));
const hy = (encodings, options) => parquetWriteBuffer({ columnData: columns(encodings), ...options });

const compressors = {
  GZIP: (bytes) => new Uint8Array(zlib.gzipSync(bytes)),
  BROTLI: (bytes) => new Uint8Array(zlib.brotliCompressSync(bytes)),
};
const plain = { real: 'PLAIN', integer: 'PLAIN', boolean: 'PLAIN', half: 'PLAIN', text: 'PLAIN' };
const delta = { real: 'BYTE_STREAM_SPLIT', integer: 'DELTA_BINARY_PACKED', boolean: 'RLE', half: 'BYTE_STREAM_SPLIT',
                text: 'DELTA_LENGTH_BYTE_ARRAY' };
write('hy_default.parquet', hy({}, {}));
write('hy_plain.parquet', hy(plain, { codec: 'UNCOMPRESSED', rowGroupSize: 700 }));
write('hy_pages.parquet', hy(plain, { pageSize: 1000 }));
write('hy_delta.parquet', hy(delta, { codec: 'GZIP', compressors, rowGroupSize: [10, 1000] }));
write('hy_texts.parquet', hy({ ...delta, integer: 'BYTE_STREAM_SPLIT', text: 'DELTA_BYTE_ARRAY' },
  { codec: 'BROTLI', compressors, pageSize: 2000 }));
const source = new Uint8Array(hy({}, { codec: 'UNCOMPRESSED' }));

const { WriterPropertiesBuilder, Compression, Encoding, WriterVersion } = wasm;
for (const codec of ['UNCOMPRESSED', 'SNAPPY', 'GZIP', 'BROTLI', 'ZSTD', 'LZ4_RAW']) {
  for (const version of [1, 2]) {
    const properties = new WriterPropertiesBuilder()
      .setCompression(Compression[codec])
      .setWriterVersion(version === 1 ? WriterVersion.V1 : WriterVersion.V2)
      .setDictionaryEnabled(version === 1)
      .setMaxRowGroupSize(version === 1 ? 1100 : 100000)
      .setDataPageSizeLimit(4000)
      .setWriteBatchSize(256)
      .build();
    write(`wasm_${codec.toLowerCase()}_${version}.parquet`, wasm.writeParquet(wasm.readParquet(source), properties));
  }
}

// Structures and lists, which no CSV has.
const nested = {
  schema: [
    { name: 'root', num_children: 3 },
    { name: 'state', num_children: 2, repetition_type: 'OPTIONAL' },
    { name: 'q', type: 'DOUBLE', repetition_type: 'OPTIONAL' },
    { name: 'n', type: 'INT64', repetition_type: 'REQUIRED' },
    { name: 'angles', num_children: 1, converted_type: 'LIST', repetition_type: 'OPTIONAL' },
    { name: 'list', num_children: 1, repetition_type: 'REPEATED' },
    { name: 'element', type: 'FLOAT', repetition_type: 'OPTIONAL' },
    { name: 'some', num_children: 1, converted_type: 'LIST', repetition_type: 'OPTIONAL' },
    { name: 'list', num_children: 1, repetition_type: 'REPEATED' },
    { name: 'element', type: 'DOUBLE', repetition_type: 'REQUIRED' },
  ],
  columnData: [
    { name: 'state', data: row((i) => (i % 10 === 9 ? null : { q: i % 4 === 3 ? null : i / 8, n: BigInt(i) })) },
    { name: 'angles', data: row((i) => (i % 6 === 0 ? null : [i, i % 5 === 0 ? null : -i, i / 2])) },
    { name: 'some', data: row((i) => Array.from({ length: 1 + (i % 3) }, () => i)) },
  ],
};
write('nested.parquet', parquetWriteBuffer({ ...nested, rowGroupSize: 900 }));
const bytes = new Uint8Array(parquetWriteBuffer({ ...nested, codec: 'UNCOMPRESSED' }));
write('nested_wasm.parquet', wasm.writeParquet(wasm.readParquet(bytes), new WriterPropertiesBuilder()
  .setWriterVersion(WriterVersion.V2).setCompression(Compression.ZSTD).setDataPageSizeLimit(3000)
  .setWriteBatchSize(100).build()));
