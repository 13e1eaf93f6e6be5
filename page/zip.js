// Reads and writes zip files, in which the page saves campaigns. The format is defined by APPNOTE.TXT 6.3.10;
// encryption, spanning and ZIP64 are not supported. The files that are read from a zip file may together be at most 30
// times as large as the zip file. This limit is never below 64 MiB and never above 1 GiB. Records that are zip files
// have the same limit (docs/records.md).

const LOCAL = 0x04034b50,
  CENTRAL = 0x02014b50,
  END = 0x06054b50,
  MIB = 1024 * 1024;

let table = null;

function crc32(bytes) {
  table ??= Uint32Array.from({ length: 256 }, (_, n) => {
    for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
    return n;
  });
  let crc = 0xffffffff;
  for (let i = 0; i < bytes.length; ++i) crc = table[(crc ^ bytes[i]) & 0xff] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

// Thrown if a file unpacks to more bytes than are allowed.
export const TooLarge = class extends RangeError {};

// Sends bytes through a stream and returns its output. Throws TooLarge if the output is longer than `most`.
async function through(bytes, stream, most) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  let size = 0;
  for (let step = await reader.read(); !step.done; step = await reader.read()) {
    size += step.value.length;
    if (size > most) {
      reader.cancel();
      throw new TooLarge();
    }
    parts.push(step.value);
  }
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

export const looksLikeZip = (bytes) => bytes.length > 21 && bytes[0] === 0x50 && bytes[1] === 0x4b && (bytes[2] === 3 || bytes[2] === 5);

// Returns the bytes of a zip file with [{path, bytes}]. All files get the same date, so that equal files always give
// equal bytes.
export const writeZip = async (files) => {
  const encoder = new TextEncoder();
  const parts = [],
    entries = [];
  let at = 0;
  for (const { path, bytes } of files) {
    const name = encoder.encode(path);
    const packed = await through(bytes, new CompressionStream('deflate-raw'), Infinity);
    const stored = packed.length >= bytes.length;
    const data = stored ? bytes : packed;
    const head = new DataView(new ArrayBuffer(30));
    const common = (view, from) => {
      view.setUint16(from, 20, true);
      view.setUint16(from + 2, 0x0800, true); // flag: names are in UTF-8
      view.setUint16(from + 4, stored ? 0 : 8, true);
      view.setUint16(from + 6, 0, true);
      view.setUint16(from + 8, 0x21, true); // the date 1 January 1980
      view.setUint32(from + 10, crc, true);
      view.setUint32(from + 14, data.length, true);
      view.setUint32(from + 18, bytes.length, true);
      view.setUint16(from + 22, name.length, true);
    };
    const crc = crc32(bytes);
    head.setUint32(0, LOCAL, true);
    common(head, 4);
    const entry = new DataView(new ArrayBuffer(46));
    entry.setUint32(0, CENTRAL, true);
    entry.setUint16(4, 20, true);
    common(entry, 6);
    entry.setUint32(42, at, true);
    entries.push(new Uint8Array(entry.buffer), name);
    parts.push(new Uint8Array(head.buffer), name, data);
    at += 30 + name.length + data.length;
  }
  const size = entries.reduce((sum, { length }) => sum + length, 0);
  const end = new DataView(new ArrayBuffer(22));
  end.setUint32(0, END, true);
  end.setUint16(8, files.length, true);
  end.setUint16(10, files.length, true);
  end.setUint32(12, size, true);
  end.setUint32(16, at, true);
  return new Uint8Array(await new Blob([...parts, ...entries, end.buffer]).arrayBuffer());
};

// Returns the files in a zip file as [{path, bytes}]. Throws an Error if the bytes are damaged or no zip file, and
// TooLarge if the files are too large.
export const readZip = async (bytes) => {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let end = bytes.length - 22;
  while (end >= 0 && end > bytes.length - 65558 && view.getUint32(end, true) !== END) --end;
  if (end < 0 || view.getUint32(end, true) !== END) throw new Error('zip');
  let left = Math.min(1024 * MIB, Math.max(64 * MIB, 30 * bytes.length));
  const count = view.getUint16(end + 10, true);
  let at = view.getUint32(end + 16, true);
  const files = [];
  for (let i = 0; i < count; ++i) {
    if (view.getUint32(at, true) !== CENTRAL) throw new Error('zip');
    const flags = view.getUint16(at + 8, true),
      method = view.getUint16(at + 10, true),
      crc = view.getUint32(at + 16, true),
      packed = view.getUint32(at + 20, true),
      name = view.getUint16(at + 28, true),
      local = view.getUint32(at + 42, true);
    const path = new TextDecoder(flags & 0x800 ? 'utf-8' : 'windows-1252').decode(bytes.subarray(at + 46, at + 46 + name));
    at += 46 + name + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
    if (path.endsWith('/')) continue;
    if (flags & 1 || ![0, 8].includes(method) || view.getUint32(local, true) !== LOCAL) throw new Error('zip');
    const from = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    const data = bytes.subarray(from, from + packed);
    if (method === 0 && data.length > left) throw new TooLarge();
    const whole = method === 0 ? data.slice() : await through(data, new DecompressionStream('deflate-raw'), left);
    if (crc32(whole) !== crc) throw new Error('zip');
    left -= whole.length;
    files.push({ path, bytes: whole });
  }
  return files;
};
