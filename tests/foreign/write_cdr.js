// A message as CDR in any byte order and version, by the writer of @foxglove/cdr: what MessageWriter of
// @foxglove/rosmsg2-serialization does in little endian alone.
import { CdrWriter, EncapsulationKind } from "@foxglove/cdr";

const isSecondVersion = (kind) =>
  kind === EncapsulationKind.RTPS_CDR2_BE || kind === EncapsulationKind.RTPS_CDR2_LE;

function writeScalar(writer, type, value) {
  if (type === "bool") {
    writer.uint8(value ? 1 : 0);
  } else if (type === "time" || type === "duration") {
    writer.int32(value.sec);
    writer.uint32(value.nanosec);
  } else if (type === "string") {
    const bytes = new TextEncoder().encode(value);
    writer.uint32(bytes.length + 1);
    bytes.forEach((byte) => writer.uint8(byte));
    writer.uint8(0);
  } else {
    writer[type](value);
  }
}

function writeStructure(writer, definitions, fields, message, kind) {
  const stored = fields.filter((field) => !field.isConstant);
  if (stored.length === 0) {
    writer.uint8(0);
  }
  for (const field of stored) {
    const nested = field.isComplex ? definitions.find((d) => d.name === field.type).definitions : undefined;
    const one = (value) => nested
      ? writeStructure(writer, definitions, nested, value, kind)
      : writeScalar(writer, field.type, value);
    const value = message[field.name];
    if (!field.isArray) {
      one(value);
      continue;
    }
    // Arrays of what is no number have their length in bytes before them (DDS-XTypes 1.3, 7.4.3.5.3).
    const isDelimited = isSecondVersion(kind) && (nested || ["string", "time", "duration"].includes(field.type));
    let place;
    if (isDelimited) {
      writer.uint32(0);
      place = writer.size;
    }
    if (field.arrayLength == undefined) {
      writer.sequenceLength(value.length);
    }
    value.forEach(one);
    if (isDelimited) {
      new DataView(writer.data.buffer).setUint32(
        place - 4, writer.size - place, kind === EncapsulationKind.RTPS_CDR2_LE);
    }
  }
}

export function writeCdr(definitions, message, kind) {
  const writer = new CdrWriter({ kind });
  writeStructure(writer, definitions, definitions[0].definitions, message, kind);
  return Uint8Array.from(writer.data);
}
