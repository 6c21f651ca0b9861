// A bag that the format's own library writes, of a robot in a corridor of known width, through
// `tcert import log`: every value of the bundle is the one that was written.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { ros2humble } from "@foxglove/rosmsg-msgs-common";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";
import { McapWriter } from "@mcap/core";

const TCERT = process.env.TCERT;
const WORK = path.resolve("imports");
rmSync(WORK, { recursive: true, force: true });
mkdirSync(WORK, { recursive: true });

const BEGIN = 1_778_234_353_000_000_000n; // when it was recorded
const SIMULATED = 928; // seconds, what the stamps in the headers say
const TICKS = 120;
const TYPES = ["nav_msgs/Odometry", "sensor_msgs/LaserScan", "geometry_msgs/Twist", "tf2_msgs/TFMessage",
  "std_msgs/Float32MultiArray", "sensor_msgs/Range"];

const ROS2_TIMES = { time: "builtin_interfaces/Time", duration: "builtin_interfaces/Duration" };

/** The type with all that it is made of, itself first. */
function definitionsOf(name) {
  const canonical = (type) => type.replace("/msg/", "/");
  const found = [];
  const visit = (type) => {
    const [key] = [type, type.replace("/", "/msg/")].filter((one) => ros2humble[one] !== undefined);
    if (key === undefined || found.some((one) => canonical(one.name) === canonical(key))) {
      return;
    }
    found.push({ ...ros2humble[key], name: type });
    for (const field of ros2humble[key].definitions) {
      if (field.isComplex) {
        visit(field.type);
      }
    }
  };
  visit(name);
  return found;
}

function textOf(definitions) {
  const body = ({ definitions: fields }) => fields.map((field) => field.isConstant ?
    `${field.type} ${field.name}=${field.valueText}` :
    `${ROS2_TIMES[field.type] ?? field.type}${field.isArray ? `[${field.arrayLength ?? ""}]` : ""} ${field.name}`).join("\n");
  return definitions.map((one, i) => (i === 0 ? "" : `${"=".repeat(80)}\nMSG: ${one.name}\n`) + body(one))
    .join("\n");
}

const yaw = (angle) => ({ x: 0, y: 0, z: Math.sin(angle / 2), w: Math.cos(angle / 2) });
const stamp = (i) => ({ sec: SIMULATED + Math.floor(i / 10), nanosec: (i % 10) * 100_000_000 });
const header = (i, frame_id) => ({ stamp: stamp(i), frame_id });
const still = { linear: { x: 0, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } };

/** Beams of a scanner that is turned by 90 degrees; some see nothing, in each way that there is. */
function rangesAt(i) {
  return Float32Array.from({ length: 16 }, (_, k) =>
    k === 3 ? Infinity : k === 4 ? 0 : k === 5 ? NaN : k === 6 ? -Infinity : k === 7 ? 31 : 0.5 + k / 16 + i / 1024);
}

async function writeBag(file) {
  const bytes = [];
  let length = 0;
  const writer = new McapWriter({ chunkSize: 20_000, writable: {
    write: async (piece) => { bytes.push(Uint8Array.from(piece)); length += piece.byteLength; },
    position: () => BigInt(length) } });
  await writer.start({ profile: "ros2", library: "test" });
  const channels = {};
  for (const [topic, type] of Object.entries({ "/odom": TYPES[0], "/scan": TYPES[1], "/cmd_vel": TYPES[2],
    "/tf_static": TYPES[3], "/bends": TYPES[4], "/sonar": TYPES[5] })) {
    const definitions = definitionsOf(type);
    const schemaId = await writer.registerSchema({ name: type.replace("/", "/msg/"), encoding: "ros2msg",
      data: new TextEncoder().encode(textOf(definitions)) });
    const id = await writer.registerChannel({ topic, schemaId, messageEncoding: "cdr", metadata: new Map() });
    channels[topic] = { id, serializer: new MessageWriter(definitions) };
  }
  const add = (topic, log, message) => writer.addMessage({ channelId: channels[topic].id, sequence: 0, logTime: log,
    publishTime: log, data: channels[topic].serializer.writeMessage(message) });
  await add("/tf_static", BEGIN, { transforms: [{ header: header(0, "base_link"), child_frame_id: "mast",
    transform: { translation: { x: 0.1, y: 0, z: 0.5 }, rotation: yaw(Math.PI / 2) } },
  { header: header(0, "mast"), child_frame_id: "laser",
    transform: { translation: { x: 0.2, y: 0, z: 0 }, rotation: yaw(0) } }] });
  for (let i = 0; i < TICKS; ++i) {
    const log = BEGIN + BigInt(i) * 100_000_000n;
    await add("/odom", log, { header: header(i, "odom"), child_frame_id: "base_link",
      pose: { pose: { position: { x: i / 64, y: -i / 128, z: 0 }, orientation: yaw(i / 200) },
        covariance: new Float64Array(36) }, twist: { twist: still, covariance: new Float64Array(36) } });
    await add("/scan", log + 1n, { header: header(i, "laser"), angle_min: -1.5, angle_max: 1.5, angle_increment: 0.2,
      time_increment: 0, scan_time: 0.1, range_min: 0.1, range_max: 30, ranges: rangesAt(i),
      intensities: new Float32Array(0) });
    await add("/cmd_vel", log + 2n, { linear: { x: 0.25, y: 0, z: 0 }, angular: { x: 0, y: 0, z: -0.5 } });
    await add("/sonar", log + 4n, { header: header(i, "sonar"), radiation_type: 0, field_of_view: 0.1, min_range: 0.25,
      max_range: 4, range: [1.5, 0.125, 5, Infinity, 4][i % 5] });
    await add("/bends", log + 3n, { layout: { dim: [], data_offset: 0 }, data: Float32Array.of(i / 256, 0.5) });
  }
  await writer.end();
  writeFileSync(file, Buffer.concat(bytes));
}

const rows = (file) => {
  const [names, ...lines] = readFileSync(file, "utf8").trimEnd().split("\n").map((line) => line.split(","));
  return lines.map((cells) => Object.fromEntries(cells.map((cell, i) => [names[i], cell])));
};

const bag = path.join(WORK, "run.mcap");
await writeBag(bag);

function importBag(name, map) {
  const mapFile = path.join(WORK, `${name}.json`);
  const output = path.join(WORK, name);
  writeFileSync(mapFile, JSON.stringify(map));
  const run = spawnSync(TCERT, ["import", "log", bag, "--map", mapFile, "--output", output], { encoding: "utf8" });
  return { ...run, output, logs: path.join(output, "logs/run") };
}

const MAP = { clock: "log", robot: { body_width_m: 0.4 }, pose: { from: "/odom" }, control: { from: "/cmd_vel" },
  rays: { from: "/scan", every: 1, no_return: ["inf", 0], offset: "tf_static" } };

test("topics become streams", () => {
  const { status, stderr, output, logs } = importBag("topics", MAP);
  assert.equal(status, 0, stderr);
  const pose = rows(path.join(logs, "pose.csv"));
  assert.equal(pose.length, TICKS);
  assert.equal(pose[1].time_s, "1778234353.1");
  pose.forEach((row, i) => {
    assert.equal(Number(row.x_m), i / 64);
    assert.equal(Number(row.y_m), 0 - i / 128);
    assert.ok(Math.abs(Number(row.yaw_rad) - i / 200) < 1e-12);
  });
  const touch = rows(path.join(logs, "tactile.csv"));
  assert.equal(touch.length, TICKS);
  assert.equal(touch[1].time_s, "1778234353.100000001");
  const written = rangesAt(7);
  for (let k = 0; k < 16; ++k) {
    const cell = touch[7][`b${String(k).padStart(3, "0")}_range_m`];
    const expected = k === 3 || k === 4 ? "30" : k === 5 || k === 7 ? "" : k === 6 ? "0" : String(written[k]);
    assert.equal(cell, expected, `beam ${k}`);
  }
  const control = rows(path.join(logs, "control.csv"));
  assert.deepEqual([control[3].speed_cmd_mps, control[3].yaw_rate_cmd_rps, control[3].loop_latency_ms],
    ["0.25", "-0.5", ""]);
  const { rays, provenance } = JSON.parse(readFileSync(path.join(output, "bundle.json"), "utf8"));
  assert.equal(rays.length, 16);
  // On a mast that is turned by 90 degrees, 0.2 m along it.
  assert.ok(Math.abs(rays[0].bearing_rad - (Math.PI / 2 - 1.5)) < 1e-6);
  assert.ok(Math.abs(rays[0].mount_x_m - 0.1) < 1e-9 && Math.abs(rays[0].mount_y_m - 0.2) < 1e-9);
  assert.match(provenance, /run\.mcap/);
  assert.match(provenance, /pose: 120 of 120 rows used/);
});

test("the bundle is one that tcert certifies", () => {
  const { output } = importBag("certified", MAP);
  const results = path.join(WORK, "results");
  execFileSync(TCERT, ["certify", output, "--ticks", "--output", results]);
  assert.ok(rows(path.join(results, "ticks/run.csv")).length >= TICKS - 1);
});

test("stamps of headers are simulated time, and commands have none", () => {
  const { status, stderr, logs } = importBag("header", { ...MAP, clock: "header" });
  assert.equal(status, 0, stderr);
  assert.equal(rows(path.join(logs, "pose.csv"))[1].time_s, "928.1");
  assert.match(stderr, /no command/);
  assert.ok(!existsSync(path.join(logs, "control.csv")));
});

test("a scan and an array are rows of one file", () => {
  const bends = { from: "/bends", rays: [{ name: "whisker", kind: "bend", bearing_deg: 90, reach_m: 0.3,
    bend_rad: { column: "data[0]", scale: 2 }, fsr_n: "data[1]",
    calibration: { bend_rad: [0, 2], clearance_m: [0.3, 0] } }] };
  const { status, stderr, logs } = importBag("both", { ...MAP, rays: [{ ...MAP.rays, every: 8 }, bends] });
  assert.equal(status, 0, stderr);
  const touch = rows(path.join(logs, "tactile.csv"));
  assert.equal(touch.length, 2 * TICKS);
  const whisker = touch.filter((row) => row.whisker_bend_rad !== "");
  assert.equal(whisker.length, TICKS);
  assert.equal(Number(whisker[5].whisker_bend_rad), 10 / 256);
  assert.equal(whisker[5].whisker_fsr_n, "0.5");
  assert.equal(whisker[5].b000_range_m, "");
});

test("a sensor that says its limits keeps to them, unless the map says what lies beyond", () => {
  const sonar = (more) => ({ ...MAP, rays: { from: "/sonar", ...more,
    rays: [{ name: "s", kind: "range", bearing_deg: 0, reach_m: 3 }] } });
  const column = ({ logs }) => rows(path.join(logs, "tactile.csv")).slice(0, 5).map((row) => row.s_range_m);
  const plain = importBag("sonar", sonar({}));
  assert.equal(plain.status, 0, plain.stderr);
  // A row in which no ray reads anything is no sample.
  assert.deepEqual(column(plain), ["1.5", "3", "4", "1.5", "3"]);
  assert.match(plain.stderr, /40 % of the readings of rays that are no range/);
  assert.deepEqual(column(importBag("sonar_5", sonar({ no_return: [5] }))), ["1.5", "3", "3", "4", "1.5"]);
});

test("topics and types that are not there are said, and nothing is written", () => {
  const wrong = importBag("wrong", { ...MAP, pose: { from: "/odm" } });
  assert.equal(wrong.status, 65);
  assert.match(wrong.stderr, /did you mean '\/odom'/);
  assert.ok(!existsSync(wrong.output));
  const array = importBag("array", { ...MAP, pose: { from: "/bends" } });
  assert.equal(array.status, 65);
  assert.match(array.stderr, /columns in the map/);
  const frame = importBag("frame", { ...MAP, base_frame: "base_footprint" });
  assert.equal(frame.status, 65);
  assert.match(frame.stderr, /no transform from 'base_footprint' to 'laser'/);
});

test("check drafts the map", () => {
  const draft = path.join(WORK, "draft.json");
  const run = spawnSync(TCERT, ["check", bag, "--write-map", draft], { encoding: "utf8" });
  assert.equal(run.status, 0, run.stderr + run.stdout);
  assert.match(run.stdout, /\/odom +nav_msgs\/msg\/Odometry +120 +10\.0/);
  const map = JSON.parse(readFileSync(draft, "utf8"));
  assert.equal(map.pose.from, "/odom");
  assert.equal(map.rays.from, "/scan");
  assert.equal(map.control.from, "/cmd_vel");
  map.robot.body_width_m = 0.4;
  delete map.course;
  assert.equal(importBag("drafted", map).status, 0);
});
