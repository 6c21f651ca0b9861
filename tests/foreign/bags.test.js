// Our reader (PRINT_BAG) against the format's own libraries, both ways: what they write is what it reads, and
// what it reads from real recordings is what they read.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { test } from "node:test";
import { EncapsulationKind } from "@foxglove/cdr";
import { parse } from "@foxglove/rosmsg";
import { ros2humble } from "@foxglove/rosmsg-msgs-common";
import { MessageWriter as Ros1Writer } from "@foxglove/rosmsg-serialization";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";
import { McapStreamReader, McapWriter } from "@mcap/core";
import { randomDefinition, randomMessage, randomOf } from "./random_type.js";
import { writeCdr } from "./write_cdr.js";

const require = createRequire(import.meta.url);
const zstd = require("@foxglove/wasm-zstd");
const lz4 = require("lz4js");
await zstd.isLoaded;

const WORK = path.resolve("files");
rmSync(WORK, { recursive: true, force: true });
mkdirSync(WORK, { recursive: true });
const DATA = process.env.TCERT_SHARED_DATA ?? "";

/** Lines that our reader prints: { topics, messages, problems }. */
function printed(file) {
  const text = execFileSync(process.env.PRINT_BAG, [file], { encoding: "utf8", maxBuffer: 2 ** 30 });
  const lines = text.trimEnd().split("\n").map((line) => JSON.parse(line));
  return { topics: lines[0].topics, messages: lines.slice(1, -1), problems: lines.at(-1).problems };
}

/** A value as our reader prints it. */
function plain(value) {
  if (typeof value === "bigint") {
    const isExact = value > -(2n ** 53n) && value < 2n ** 53n;
    return isExact ? Number(value) : `${value}n`;
  }
  if (typeof value === "number" && !Number.isFinite(value)) {
    return String(value);
  }
  if (Array.isArray(value) || ArrayBuffer.isView(value)) {
    return Array.from(value, plain);
  }
  if (value !== null && typeof value === "object") {
    return Object.fromEntries(Object.entries(value).map(([name, member]) =>
      [name === "nsec" ? "nanosec" : name, plain(member)]));
  }
  return value;
}

class Memory {
  bytes = [];
  length = 0;
  async write(piece) {
    this.bytes.push(Uint8Array.from(piece));
    this.length += piece.byteLength;
  }
  position() {
    return BigInt(this.length);
  }
}

const COMPRESSIONS = {
  none: undefined,
  zstd: (data) => ({ compression: "zstd", compressedData: zstd.compress(data, 3) }),
  lz4: (data) => ({ compression: "lz4", compressedData: lz4.compress(data) }),
};

/** An MCAP of `messages` ({ topic, log, publish, data }) on `topics` ({ name, type, encoding, text, ... }). */
async function writeMcap(file, topics, messages, options) {
  const memory = new Memory();
  const writer = new McapWriter({ writable: memory, ...options });
  await writer.start({ profile: "ros2", library: "test" });
  const ids = [];
  for (const topic of topics) {
    const schemaId = await writer.registerSchema(
      { name: topic.type, encoding: topic.schemaEncoding, data: new TextEncoder().encode(topic.text) });
    ids.push(await writer.registerChannel(
      { topic: topic.name, schemaId, messageEncoding: topic.encoding, metadata: new Map([["a", "b"]]) }));
  }
  await writer.addAttachment(
    { name: "a.bin", mediaType: "x", logTime: 1n, createTime: 1n, data: new Uint8Array(300000) });
  let sequence = 0;
  for (const message of messages) {
    await writer.addMessage({
      channelId: ids[message.topic], sequence: sequence++, logTime: message.log, publishTime: message.publish,
      data: message.data });
  }
  await writer.addMetadata({ name: "m", metadata: new Map([["k", "v"]]) });
  await writer.end();
  writeFileSync(file, Buffer.concat(memory.bytes));
}

/** Compares what is printed with `messages` ({ topic, log, publish, data, value }). */
function assertPrinted(shown, topics, messages) {
  assert.deepEqual(shown.problems, []);
  assert.equal(shown.messages.length, messages.length);
  messages.forEach((message, i) => {
    const line = shown.messages[i];
    assert.equal(line.problem, undefined, `message ${i} of ${topics[message.topic].text}`);
    assert.deepEqual(line.value, plain(message.value), `message ${i} of ${topics[message.topic].text}`);
    assert.deepEqual([line.topic, line.log, line.publish, line.bytes],
      [topics[message.topic].name, String(message.log), String(message.publish), message.data.length]);
  });
  shown.topics.forEach(({ name, messages: count }) => {
    const topic = topics.findIndex((one) => one.name === name);
    assert.equal(count, messages.filter((message) => message.topic === topic).length);
  });
}

const KINDS = [
  EncapsulationKind.CDR_LE, EncapsulationKind.CDR_BE, EncapsulationKind.RTPS_CDR2_LE, EncapsulationKind.RTPS_CDR2_BE,
];

/** Random topics with random messages in random order; { topics, messages }. */
function randomBag(seed, topicCount, messageCount) {
  const random = randomOf(seed);
  const topics = Array.from({ length: topicCount }, (_, i) => {
    const definition = randomDefinition(random);
    return { name: `/t${i}`, type: definition.name, encoding: "cdr", schemaEncoding: "ros2msg",
      text: definition.text, definitions: parse(definition.text, { ros2: true }) };
  });
  const messages = Array.from({ length: messageCount }, (_, i) => {
    const topic = Math.floor(random() * topicCount);
    const { definitions } = topics[topic];
    const value = randomMessage(random, definitions);
    const kind = KINDS[Math.floor(random() * KINDS.length)];
    const data = writeCdr(definitions, value, kind);
    // The foreign writer cuts off texts that are not ASCII: it counts characters, not bytes.
    if (kind === EncapsulationKind.CDR_LE && /^[ -~]*$/.test(JSON.stringify(plain(value)))) {
      assert.deepEqual(data, Uint8Array.from(new MessageWriter(definitions).writeMessage(value)));
    }
    if (kind === EncapsulationKind.CDR_LE || kind === EncapsulationKind.CDR_BE) {
      assert.deepEqual(plain(new MessageReader(definitions).readMessage(data)), plain(value));
    }
    return { topic, log: 1_700_000_000_000_000_000n + BigInt(i), publish: BigInt(i), data, value };
  });
  return { topics, messages };
}

test("random types and messages in MCAP files of every kind", async () => {
  for (let seed = 0; seed < 72; ++seed) {
    const { topics, messages } = randomBag(seed, 1 + (seed % 5), 40);
    const file = path.join(WORK, `random_${seed}.mcap`);
    await writeMcap(file, topics, messages, {
      useChunks: seed % 4 !== 0, compressChunk: Object.values(COMPRESSIONS)[seed % 3], chunkSize: 1 + (seed % 7) * 700,
      useStatistics: seed % 5 !== 0, repeatChannels: seed % 6 !== 0, repeatSchemas: seed % 7 !== 0,
      useChunkIndex: seed % 8 !== 0, useMessageIndex: seed % 9 !== 0, useSummaryOffsets: seed % 10 !== 0 });
    const shown = printed(file);
    // A summary whose channels are missing is said, and the file is read for them.
    shown.problems = shown.problems.filter((problem) => !problem.includes("a summary section that cannot be used"));
    assertPrinted(shown, topics, messages);
  }
});

test("random types and messages in a database of Python", () => {
  for (let seed = 100; seed < 112; ++seed) {
    const { topics, messages } = randomBag(seed, 1, 40);
    const file = path.join(WORK, `random_${seed}.db3`);
    const hex = messages.map((m) => ({ topic: m.topic, log: String(m.log), data: Buffer.from(m.data).toString("hex") }));
    execFileSync("python3", ["db3.py", "write", file], {
      input: JSON.stringify({ topics, definitions: { [topics[0].type]: topics[0].text }, messages: hex }) });
    assertPrinted(printed(file), topics, messages.map((message) => ({ ...message, publish: message.log })));
  }
});

/** The foreign definition of `name` with all that it uses, the type itself first. */
function commonDefinitions(name) {
  const found = new Map();
  const add = (type) => {
    if (!found.has(type)) {
      found.set(type, { name: type, definitions: ros2humble[type].definitions });
      ros2humble[type].definitions.filter((field) => field.isComplex).forEach((field) => add(field.type));
    }
  };
  add(name);
  return [...found.values()];
}

test("every built-in type, in a database without definitions", () => {
  const names = readFileSync(process.env.BUILTIN_TYPES, "utf8").match(/(?<=TCERT_MESSAGE\(")[^"]+/g);
  assert.ok(names.length > 50);
  const random = randomOf(5);
  // The foreign list has no type without fields, and time and duration as primitives.
  const known = names.map((name) => name.replace("/msg/", "/")).filter((name) => ros2humble[name]?.definitions.length > 0);
  assert.ok(known.length >= names.length - 3, `missing: ${names.filter((n) => !known.includes(n.replace("/msg/", "/")))}`);
  const topics = known.map((name) => ({ name: `/${name}`, type: name, definitions: commonDefinitions(name), text: name }));
  const messages = topics.flatMap((topic, i) => Array.from({ length: 5 }, () => {
    const value = randomMessage(random, topic.definitions);
    const data = writeCdr(topic.definitions, value, EncapsulationKind.CDR_LE);
    return { topic: i, log: BigInt(i), publish: BigInt(i), data, value };
  }));
  const file = path.join(WORK, "builtin.db3");
  execFileSync("python3", ["db3.py", "write", file], {
    input: JSON.stringify({ topics, definitions: {}, messages: messages.map((m) =>
      ({ topic: m.topic, log: String(m.log), data: Buffer.from(m.data).toString("hex") })) }) });
  assertPrinted(printed(file), topics, messages);
});

test("JSON and ROS 1 messages", async () => {
  const text = "Header header\ntime t\nduration d\nbyte[] b\nchar c\nstring[] s\nfloat32[3] f\n" +
    `${"=".repeat(80)}\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id`;
  const value = { header: { seq: 7, stamp: { sec: 4000000000, nsec: 5 }, frame_id: "map" }, t: { sec: 1, nsec: 2 },
    d: { sec: 1, nsec: 3 }, b: [-1, 2], c: 200, s: ["", "ab"], f: [1.5, -2, 0.25] };
  const json = { pose: { x: 1.5, n: [1, 2, 3], mixed: [1, "a", null, { deep: [] }], big: 12345678901, none: null } };
  const topics = [
    { name: "/ros1", type: "a/B", encoding: "ros1", schemaEncoding: "ros1msg", text },
    { name: "/json", type: "c.D", encoding: "json", schemaEncoding: "jsonschema", text: "{}" }];
  const messages = [
    { topic: 0, log: 1n, publish: 1n, value, data: new Ros1Writer(parse(text)).writeMessage(value) },
    { topic: 1, log: 2n, publish: 1n, value: json, data: new TextEncoder().encode(JSON.stringify(json)) }];
  const file = path.join(WORK, "others.mcap");
  await writeMcap(file, topics, messages, {});
  assertPrinted(printed(file), topics, messages);
});

/** Messages of an MCAP file by the foreign reader. */
function foreignMcap(file) {
  const reader = new McapStreamReader(
    { decompressHandlers: { zstd: (data, size) => zstd.decompress(data, Number(size)) } });
  reader.append(readFileSync(file));
  const schemas = new Map();
  const channels = new Map();
  const messages = [];
  for (let record; (record = reader.nextRecord());) {
    if (record.type === "Schema") {
      schemas.set(record.id, new MessageReader(parse(new TextDecoder().decode(record.data), { ros2: true })));
    } else if (record.type === "Channel") {
      channels.set(record.id, record);
    } else if (record.type === "Message") {
      const channel = channels.get(record.channelId);
      messages.push({ topic: channel.topic, log: String(record.logTime), publish: String(record.publishTime),
        bytes: record.data.length, value: plain(schemas.get(channel.schemaId).readMessage(record.data)) });
    }
  }
  return messages;
}

const real = (name) => {
  const file = path.join(DATA, "logs", name);
  return { file, options: DATA && existsSync(file) ? {} : { skip: `TCERT_SHARED_DATA has no ${name}` } };
};

const nav2 = real("evo/nav2_turtlebot.mcap");
test("nav2_turtlebot.mcap, message by message", nav2.options, () => {
  const expected = foreignMcap(nav2.file);
  const shown = printed(nav2.file);
  assert.ok(expected.length > 2639 + 135);
  assert.deepEqual(shown.messages, expected);
  assert.deepEqual(shown.problems, []);
});

for (const [name, least] of [["evo/tf_example.db3", 518], ["plotjuggler/rosbag2_test_0.db3", 4695]]) {
  const database = real(name);
  test(`${path.basename(name)}, message by message`, database.options, () => {
    const rows = execFileSync("python3", ["db3.py", "read", database.file], { encoding: "utf8", maxBuffer: 2 ** 30 })
      .trimEnd().split("\n").map((line) => JSON.parse(line));
    const shown = printed(database.file);
    assert.equal(rows.length, least);
    assert.equal(shown.messages.length, least);
    let compared = 0;
    rows.forEach((row, i) => {
      const line = shown.messages[i];
      assert.deepEqual([line.topic, line.log, line.bytes], [row.topic, row.log, row.data.length / 2]);
      const type = row.type.replace("/msg/", "/");
      if (line.value !== undefined) {
        const reader = new MessageReader(commonDefinitions(type));
        assert.deepEqual(line.value, plain(reader.readMessage(Buffer.from(row.data, "hex"))));
        ++compared;
      } else {
        // Not built in, and these old databases have no definitions.
        assert.equal(type, "sensor_msgs/BatteryState");
      }
    });
    assert.ok(compared >= least * 0.6);
    assert.deepEqual(shown.problems, []);
  });
}
