// Writes one MCAP file with the format's own library.
//   node write_mcap.mjs OUTPUT none|lz4|zstd chunked|flat indexed|plain
// /joints holds 200 messages: stamp 1.7e18 + 1e6 i ns, names turned by i, position i / 8 + joint,
// velocity -i, no effort; logged 5 us after the stamp.
import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { definition, jointState } from "./joint_state.mjs";

const require = createRequire(join(process.env.PEER_PACKAGES, "package.json"));
const { McapWriter } = require("@mcap/core");
const lz4 = require("lz4js");
const zstd = require("@foxglove/wasm-zstd");
await zstd.isLoaded;

const [output, compression, chunks, index] = process.argv.slice(2);
const parts = [];
let length = 0n;
const writable = {
  position: () => length,
  write: async (bytes) => {
    parts.push(Uint8Array.from(bytes));
    length += BigInt(bytes.byteLength);
  },
};
const compressChunk = {
  none: undefined,
  lz4: (data) => ({ compression: "lz4", compressedData: lz4.compress(data) }),
  zstd: (data) => ({ compression: "zstd", compressedData: zstd.compress(data) }),
}[compression];
const indexed = index === "indexed";
const writer = new McapWriter({
  writable, compressChunk, useChunks: chunks === "chunked", chunkSize: 4096,
  useStatistics: indexed, useSummaryOffsets: indexed, useMessageIndex: indexed,
  useChunkIndex: indexed, repeatSchemas: indexed, repeatChannels: indexed,
});
await writer.start({ profile: "ros2", library: "peer" });
const encoded = new TextEncoder().encode(definition);
const schemaId = await writer.registerSchema(
  { name: "sensor_msgs/msg/JointState", encoding: "ros2msg", data: encoded });
const channelId = await writer.registerChannel(
  { schemaId, topic: "/joints", messageEncoding: "cdr", metadata: new Map([["qos", "x"]]) });
const otherId = await writer.registerChannel(
  { schemaId: 0, topic: "/json", messageEncoding: "json", metadata: new Map() });
const joints = ["shoulder", "elbow", "wrist"];
for (let i = 0; i < 200; ++i) {
  const stamp = 1700000000000000000n + BigInt(i) * 1000000n;
  const order = [0, 1, 2].map((k) => (k + i) % 3);
  const data = jointState(stamp, order.map((k) => joints[k]), order.map((k) => i / 8 + k),
                          order.map(() => -i), []);
  const logTime = stamp + 5000n;
  await writer.addMessage({ channelId, sequence: i, logTime, publishTime: stamp, data });
  await writer.addMessage({ channelId: otherId, sequence: i, logTime, publishTime: stamp,
                            data: new TextEncoder().encode("{}") });
}
await writer.addAttachment({ name: "note.txt", logTime: 0n, createTime: 0n,
                             mediaType: "text/plain", data: new TextEncoder().encode("x") });
await writer.addMetadata({ name: "robot", metadata: new Map([["model", "test"]]) });
await writer.end();
writeFileSync(output, Buffer.concat(parts));
