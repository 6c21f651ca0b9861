// Random message types, as ros2msg text, and random messages of them.

const PRIMITIVES = [
  "bool", "byte", "char", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32",
  "float64", "string",
];

/** A generator of numbers in [0, 1) that a seed determines (mulberry32). */
export function randomOf(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const below = (random, n) => Math.floor(random() * n);
const one = (random, list) => list[below(random, list.length)];

function arity(random) {
  switch (below(random, 6)) {
    case 0: return `[${1 + below(random, 5)}]`;
    case 1: return "[]";
    case 2: return `[<=${1 + below(random, 6)}]`;
    default: return "";
  }
}

/** A type "test_msgs/msg/Root" with up to `depth` levels of others: { name, text }. */
export function randomDefinition(random, depth = 3) {
  const sections = [];
  let count = 0;
  const structure = (level) => {
    const name = level === depth ? "Root" : `Part${count++}`;
    const lines = ["# a comment", "int32 CONSTANT=5  # takes no bytes"];
    const fields = level < depth && random() < 0.1 ? 0 : 1 + below(random, 9);
    for (let i = 0; i < fields; ++i) {
      const nested = level > 0 && random() < 0.3;
      let type = nested ? structure(level - 1) : one(random, PRIMITIVES);
      if (random() < 0.06) {
        type = one(random, ["builtin_interfaces/Time", "builtin_interfaces/Duration"]);
      }
      const bound = type === "string" && random() < 0.2 ? "<=40" : "";
      lines.push(`${type}${bound}${arity(random)} field_${i}  # of ${name}`);
    }
    sections.push([name, lines.join("\n")]);
    return one(random, [name, `test_msgs/${name}`]);
  };
  structure(depth);
  const [, root] = sections.pop();
  const rule = "=".repeat(80);
  const time = "int32 sec\nuint32 nanosec";
  sections.push(["builtin_interfaces/Time", time], ["builtin_interfaces/Duration", time]);
  const parts = sections.map(([name, text]) =>
    `${rule}\nMSG: ${name.includes("/") ? name : `test_msgs/${name}`}\n${text}`);
  return { name: "test_msgs/msg/Root", text: [root, ...parts].join("\n") };
}

const FLOATS = [0, -0, NaN, Infinity, -Infinity, 1.5, -2.25, 1e-30, 3.0e38];

function integer(random, bits, signed) {
  if (bits === 64) {
    const value = (BigInt(below(random, 2 ** 32)) << 32n) | BigInt(below(random, 2 ** 32));
    const edge = random() < 0.2 ? one(random, [0n, 1n, (1n << 64n) - 1n, 1n << 63n]) : value;
    return signed ? BigInt.asIntN(64, edge) : edge;
  }
  const value = random() < 0.2 ? one(random, [0, 1, 2 ** bits - 1, 2 ** (bits - 1)]) : below(random, 2 ** bits);
  return signed && value >= 2 ** (bits - 1) ? value - 2 ** bits : value;
}

function text(random) {
  const letters = ["a", "Z", " ", "0", "\"", "\\", "\n", "ä", "€", "😀"];
  return Array.from({ length: below(random, 12) }, () => one(random, letters)).join("");
}

function scalar(random, type) {
  switch (type) {
    case "bool": return random() < 0.5;
    case "float32": return Math.fround(random() < 0.3 ? one(random, FLOATS) : (random() - 0.5) * 1e3);
    case "float64": return random() < 0.3 ? one(random, FLOATS) : (random() - 0.5) * 1e9;
    case "string": return text(random);
    case "time":
    case "duration": return { sec: integer(random, 32, true), nanosec: below(random, 1e9) };
    default: {
      const [, unsigned, bits] = /^(u?)int(\d+)$/.exec(type);
      return integer(random, Number(bits), unsigned === "");
    }
  }
}

/** A message of the first of `definitions` (as @foxglove/rosmsg parses them), with every field. */
export function randomMessage(random, definitions, fields = definitions[0].definitions) {
  const message = {};
  for (const field of fields.filter((f) => !f.isConstant)) {
    const value = () => field.isComplex
      ? randomMessage(random, definitions, definitions.find((d) => d.name === field.type).definitions)
      : scalar(random, field.type);
    if (field.isArray) {
      const length = field.arrayLength ?? below(random, 1 + (field.arrayUpperBound ?? one(random, [0, 3, 20])));
      message[field.name] = Array.from({ length }, value);
    } else {
      message[field.name] = value();
    }
  }
  return message;
}
