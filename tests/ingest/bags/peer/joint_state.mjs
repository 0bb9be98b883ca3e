// sensor_msgs/msg/JointState as ROS 2 records it: its definition, and its bytes.

export const definition = `std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
`;

export class Cdr {
  bytes = [0, 1, 0, 0];
  number(size, set) {
    while ((this.bytes.length - 4) % size !== 0) this.bytes.push(0);
    const view = new DataView(new ArrayBuffer(size));
    set(view);
    this.bytes.push(...new Uint8Array(view.buffer));
  }
  uint32(value) { this.number(4, (view) => view.setUint32(0, value, true)); }
  float64(value) { this.number(8, (view) => view.setFloat64(0, value, true)); }
  text(value) {
    const bytes = new TextEncoder().encode(value);
    this.uint32(bytes.length + 1);
    this.bytes.push(...bytes, 0);
  }
  numbers(values) {
    this.uint32(values.length);
    values.forEach((value) => this.float64(value));
  }
}

/// @param stamp in nanoseconds, a BigInt.
export function jointState(stamp, names, positions, velocities, efforts) {
  const cdr = new Cdr();
  cdr.uint32(Number(stamp / 1000000000n));
  cdr.uint32(Number(stamp % 1000000000n));
  cdr.text("base");
  cdr.uint32(names.length);
  names.forEach((name) => cdr.text(name));
  cdr.numbers(positions);
  cdr.numbers(velocities);
  cdr.numbers(efforts);
  return Uint8Array.from(cdr.bytes);
}
