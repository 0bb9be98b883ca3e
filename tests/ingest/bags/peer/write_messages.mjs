// Writes one MCAP file with messages in JSON, protobuf and of ROS 1, by the libraries of MCAP and of
// protobuf, and a CSV file of each topic's numbers.
//   node write_messages.mjs OUTPUT DIRECTORY_OF_CSV
// 100 messages a topic, at 1.7e18 + 4e6 i ns, logged 9 us later.
import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const require = createRequire(join(process.env.PEER_PACKAGES, "package.json"));
const { McapWriter } = require("@mcap/core");
const protobuf = require("protobufjs");
require("protobufjs/ext/descriptor");

const [output, directory] = process.argv.slice(2);
const joints = ["shoulder", "elbow", "wrist"];
const start = 1700000000000000000n;
const count = 100;
const stampOf = (i) => start + BigInt(i) * 4000000n;
const secondsOf = (stamp) => Number(stamp / 1000000000n);
const nanosecondsOf = (stamp) => Number(stamp % 1000000000n);
const position = (i, k) => Math.sin(i / 7 + k);
const velocity = (i, k) => Math.cos(i / 7 + k) / 7;
const effort = (i, k) => Math.sqrt(i + k) * (k - 1);
const turned = (i) => [0, 1, 2].map((k) => (k + i) % 3);

const proto = `
syntax = "proto3";
package arm;
import "google/protobuf/timestamp.proto";
import "google/protobuf/wrappers.proto";
enum Mode { IDLE = 0; MOVING = 7; }
message Vector3 { double x = 1; double y = 2; }
message Motor { string name = 1; float current = 2; optional double temperature = 3; }
message JointStates {
  repeated double position = 2;
  repeated double velocity = 3;
  repeated double effort = 4;
  repeated string name = 9;
  google.protobuf.Timestamp timestamp = 1;
}
message State {
  google.protobuf.Timestamp stamp = 1;
  Mode mode = 2;
  Vector3 force = 3;
  repeated sint32 counts = 4;
  map<string, double> load = 5;
  map<uint32, fixed64> ticks = 6;
  oneof command { double target = 7; bool hold = 8; }
  repeated Motor motors = 10;
  bytes raw = 11;
  google.protobuf.DoubleValue limit = 12;
  repeated float cloud = 13;
  uint64 sequence = 14;
  bool ready = 15;
}`;
const root = new protobuf.Root();
for (const name of ["google/protobuf/timestamp.proto", "google/protobuf/wrappers.proto"]) {
  root.addJSON(protobuf.common.get(name).nested);
}
protobuf.parse(proto, root, { keepCase: true });
root.resolveAll();

/// Without their imports, as protobufjs writes them.
const descriptors = root.toDescriptor("proto3");
/// protobufjs calls the entries of a map `ticks` "Ticks", where protobuf asks for "TicksEntry".
for (const type of descriptors.file.flatMap((file) => file.messageType)) {
  for (const entry of type.nestedType.filter((inner) => inner.options?.mapEntry)) {
    const field = type.field.find((one) => one.typeName === entry.name);
    field.typeName = entry.name = `${entry.name}Entry`;
  }
}
const encodedSet = descriptors.constructor.encode(descriptors).finish();
const JointStates = root.lookupType("arm.JointStates");
const State = root.lookupType("arm.State");
const timestamp = (stamp) => ({ seconds: secondsOf(stamp), nanos: nanosecondsOf(stamp) });

const ros1Definition = `Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
================================================================================
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
`;

function ros1JointState(i, stamp) {
  const bytes = [];
  const number = (size, set) => {
    const view = new DataView(new ArrayBuffer(size));
    set(view);
    bytes.push(...new Uint8Array(view.buffer));
  };
  const uint32 = (value) => number(4, (view) => view.setUint32(0, value, true));
  const text = (value) => {
    uint32(value.length);
    bytes.push(...new TextEncoder().encode(value));
  };
  const numbers = (values) => {
    uint32(values.length);
    values.forEach((value) => number(8, (view) => view.setFloat64(0, value, true)));
  };
  uint32(i);
  uint32(secondsOf(stamp));
  uint32(nanosecondsOf(stamp));
  text("arm");
  uint32(joints.length);
  turned(i).forEach((k) => text(joints[k]));
  for (const signal of [position, velocity, effort]) numbers(turned(i).map((k) => signal(i, k)));
  return Uint8Array.from(bytes);
}

const json = (value) => new TextEncoder().encode(JSON.stringify(value));

/// What the columns of joints must be.
const jointRow = (i) => Object.fromEntries(joints.flatMap((joint, k) => [
  [`${joint}.position`, position(i, k)], [`${joint}.velocity`, velocity(i, k)],
  [`${joint}.effort`, effort(i, k)]]));
const states = (i) => ({
  name: turned(i).map((k) => joints[k]),
  position: turned(i).map((k) => position(i, k)),
  velocity: turned(i).map((k) => velocity(i, k)),
  effort: turned(i).map((k) => effort(i, k)),
});

const topics = {
  json_states: {
    encoding: "json", schema: { name: "JointState", encoding: "jsonschema", data: json({ type: "object" }) },
    bytes: (i, stamp) => json({ ...states(i),
      header: { frame_id: "arm", seq: i, stamp: { sec: secondsOf(stamp), nanosec: nanosecondsOf(stamp) } } }),
    row: jointRow,
  },
  json_iso: {
    encoding: "json",
    bytes: (i, stamp) => json({ timestamp: new Date(Number(stamp / 1000000n)).toISOString(), q: position(i, 0) }),
    row: (i) => ({ q: position(i, 0) }),
  },
  json_flat: {
    encoding: "json", is_without_stamp: true,
    bytes: (i) => json({ "joint_1.pos": position(i, 1), "joint_1.torque": i % 3 ? effort(i, 1) : null,
      enabled: i % 2 === 0, note: "x", array: [i, i / 3], nested: { a: { b: -i } },
      ...(i < 50 ? {} : { late: i }), cloud: Array(70).fill(i) }),
    row: (i) => ({ "joint_1.pos": position(i, 1), "joint_1.torque": i % 3 ? effort(i, 1) : NaN,
      enabled: i % 2 === 0 ? 1 : 0, "array[0]": i, "array[1]": i / 3, "nested.a.b": -i,
      late: i < 50 ? NaN : i }),
  },
  pb_states: {
    encoding: "protobuf", schema: { name: "arm.JointStates", encoding: "protobuf", data: encodedSet },
    bytes: (i, stamp) =>
      JointStates.encode(JointStates.create({ ...states(i), timestamp: timestamp(stamp) })).finish(),
    row: jointRow,
  },
  pb_state: {
    encoding: "protobuf", schema: { name: "arm.State", encoding: "protobuf", data: encodedSet },
    bytes: (i, stamp) => State.encode(State.create({
      stamp: timestamp(stamp), mode: i % 2 ? 7 : 0, force: i % 4 ? { x: i / 3, y: -i } : undefined,
      counts: [-i, i], load: { b: i / 9, a: -i / 9 }, ticks: { 12: i }, 
      ...(i % 3 === 0 ? { target: i / 5 } : i % 3 === 1 ? { hold: true } : {}),
      motors: turned(i).map((k) => ({ name: joints[k], current: i + k / 2,
        ...(k === 1 ? { temperature: 20 + i / 10 } : {}) })),
      raw: new Uint8Array(100), limit: i % 5 ? { value: i / 11 } : undefined,
      cloud: Array(70).fill(i), sequence: i, ready: i % 2 === 1,
    })).finish(),
    row: (i) => ({
      mode: i % 2 ? 7 : 0, "force.x": i % 4 ? i / 3 : NaN, "force.y": i % 4 ? -i : NaN,
      "counts[0]": -i, "counts[1]": i, "load.a": -i / 9, "load.b": i / 9, "ticks.12": i,
      target: i % 3 === 0 ? i / 5 : NaN, hold: i % 3 === 1 ? 1 : NaN,
      ...Object.fromEntries(joints.map((joint, k) => [`${joint}.current`, i + k / 2])),
      "elbow.temperature": 20 + i / 10, limit: i % 5 ? i / 11 : NaN, sequence: i, ready: i % 2,
    }),
  },
  ros1_states: {
    encoding: "ros1",
    schema: { name: "sensor_msgs/JointState", encoding: "ros1msg", data: new TextEncoder().encode(ros1Definition) },
    bytes: ros1JointState,
    row: jointRow,
  },
};

const parts = [];
let length = 0n;
const writer = new McapWriter({
  writable: {
    position: () => length,
    write: async (bytes) => {
      parts.push(Uint8Array.from(bytes));
      length += BigInt(bytes.byteLength);
    },
  },
  useChunks: true, chunkSize: 4096,
});
await writer.start({ profile: "", library: "peer" });
const channels = new Map();
for (const [name, topic] of Object.entries(topics)) {
  const schemaId = topic.schema ? await writer.registerSchema(topic.schema) : 0;
  channels.set(name, await writer.registerChannel(
    { schemaId, topic: `/${name}`, messageEncoding: topic.encoding, metadata: new Map() }));
}
for (let i = 0; i < count; ++i) {
  const stamp = stampOf(i);
  for (const [name, topic] of Object.entries(topics)) {
    await writer.addMessage({ channelId: channels.get(name), sequence: i, logTime: stamp + 9000n,
                              publishTime: stamp, data: topic.bytes(i, stamp) });
  }
}
await writer.end();
writeFileSync(output, Buffer.concat(parts));

for (const [name, topic] of Object.entries(topics)) {
  const times = (i) => (topic.is_without_stamp ? {} : { time: i * 0.004 });
  const rows = [...Array(count).keys()].map((i) => ({ ...times(i), log_time: i * 0.004, ...topic.row(i) }));
  const names = Object.keys(rows[0]);
  const lines = [names, ...rows.map((row) => names.map((key) => (Number.isNaN(row[key]) ? "nan" : row[key])))];
  writeFileSync(join(directory, `${name}.csv`), lines.map((line) => line.join(",") + "\n").join(""));
}
