// Writes a robot's log as an MCAP of JointState messages, with the format's own library.
//   node write_mcap.mjs CSV OUTPUT      the CSV: t_s, then an angle and a current of each joint
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { definition, jointState } from "../../ingest/bags/peer/joint_state.mjs";

const require = createRequire(join(process.env.PEER_PACKAGES, "package.json"));
const { McapWriter } = require("@mcap/core");

const [input, output] = process.argv.slice(2);
const parts = [];
let length = 0n;
const writer = new McapWriter({
  chunkSize: 1 << 20,
  writable: {
    position: () => length,
    write: async (bytes) => {
      parts.push(Uint8Array.from(bytes));
      length += BigInt(bytes.byteLength);
    },
  },
});
await writer.start({ profile: "ros2", library: "peer" });
const schemaId = await writer.registerSchema({
  name: "sensor_msgs/msg/JointState", encoding: "ros2msg", data: new TextEncoder().encode(definition),
});
const channelId = await writer.registerChannel(
  { schemaId, topic: "/joint_states", messageEncoding: "cdr", metadata: new Map() });
const [header, ...rows] = readFileSync(input, "utf8").trimEnd().split("\n");
const joints = Array.from({ length: (header.split(",").length - 1) / 2 }, (_, k) => `J${k + 1}`);
for (const [sequence, row] of rows.entries()) {
  const [time, ...numbers] = row.split(",").map(Number);
  const stamp = 1700000000000000000n + BigInt(Math.round(time * 1e9));
  const every = (first) => joints.map((_, k) => numbers[2 * k + first]);
  await writer.addMessage({ channelId, sequence, logTime: stamp + 50000n, publishTime: stamp,
                            data: jointState(stamp, joints, every(0), [], every(1)) });
}
await writer.end();
writeFileSync(output, Buffer.concat(parts));
