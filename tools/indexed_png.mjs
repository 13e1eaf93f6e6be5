// Reduces a PNG picture of a page to a palette of at most 256 colours, which makes the file about three times smaller.
import { deflateSync, inflateSync } from 'node:zlib';

const SIGNATURE = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
const COLOURS = 256;

// Takes and returns the bytes of a PNG file. The picture must have 8 bits a channel, RGB or RGBA, as Chromium writes it.
export function indexed(png) {
  const { width, height, pixels } = decode(png);
  const palette = paletteOf(pixels);
  const nearest = new Map();
  const indexOf = (r, g, b) => {
    const key = (r << 16) | (g << 8) | b;
    if (!nearest.has(key)) nearest.set(key, nearestIn(palette, r, g, b));
    return nearest.get(key);
  };
  const rows = Buffer.alloc((width + 1) * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const at = 3 * (y * width + x);
      rows[y * (width + 1) + 1 + x] = indexOf(pixels[at], pixels[at + 1], pixels[at + 2]);
    }
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 3, 0, 0, 0], 8); // 8 bits, palette, no interlacing
  return Buffer.concat([
    SIGNATURE,
    chunk('IHDR', header),
    chunk('PLTE', Buffer.from(palette.flat())),
    chunk('IDAT', deflateSync(rows, { level: 9, memLevel: 9 })),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

// Returns the checksum of a chunk of the file. Node 18 has no zlib.crc32.
function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  }
  return (crc ^ 0xffffffff) >>> 0;
}

function chunk(name, data) {
  const named = Buffer.concat([Buffer.from(name, 'latin1'), data]);
  const whole = Buffer.alloc(named.length + 8);
  whole.writeUInt32BE(data.length, 0);
  named.copy(whole, 4);
  whole.writeUInt32BE(crc32(named), whole.length - 4);
  return whole;
}

// Returns the width, the height and the pixels, with three bytes R, G, B for each pixel.
function decode(png) {
  if (!png.subarray(0, 8).equals(SIGNATURE)) throw new Error('not a PNG file');
  const parts = [];
  let header = null;
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
    const name = png.toString('latin1', at + 4, at + 8),
      data = png.subarray(at + 8, at + 8 + png.readUInt32BE(at));
    if (name === 'IHDR') header = data;
    if (name === 'IDAT') parts.push(data);
  }
  const width = header.readUInt32BE(0),
    height = header.readUInt32BE(4),
    [bits, kind, , , interlaced] = header.subarray(8);
  if (bits !== 8 || ![2, 6].includes(kind) || interlaced) throw new Error(`PNG of ${bits} bits, colour type ${kind}: not read`);
  const channels = kind === 2 ? 3 : 4,
    stride = channels * width,
    raw = inflateSync(Buffer.concat(parts)),
    pixels = Buffer.alloc(3 * width * height);
  let above = Buffer.alloc(stride);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (stride + 1)],
      row = raw.subarray(y * (stride + 1) + 1, (y + 1) * (stride + 1));
    for (let i = 0; i < stride; ++i) {
      const left = i < channels ? 0 : row[i - channels],
        corner = i < channels ? 0 : above[i - channels];
      row[i] += [0, left, above[i], (left + above[i]) >> 1, paeth(left, above[i], corner)][filter];
    }
    for (let x = 0; x < width; ++x) row.copy(pixels, 3 * (y * width + x), channels * x, channels * x + 3);
    above = row;
  }
  return { width, height, pixels };
}

function paeth(left, up, corner) {
  const [a, b, c] = [left, up, corner].map((value) => Math.abs(left + up - corner - value));
  if (a <= b && a <= c) return left;
  return b <= c ? up : corner;
}

// Returns a palette by a kind of median cut: again and again, the box of colours with the largest sum of squared
// deviations from the mean in one channel is cut in two at this mean.
function paletteOf(pixels) {
  const counts = new Map();
  for (let i = 0; i < pixels.length; i += 3) {
    const key = (pixels[i] << 16) | (pixels[i + 1] << 8) | pixels[i + 2];
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  // The count of a frequent colour is damped, so that a few pixels of a rare colour still get a place in the palette.
  const colours = [...counts].map(([key, count]) => ({ rgb: [key >> 16, (key >> 8) & 255, key & 255], weight: Math.sqrt(count) }));
  const boxes = [measured(colours)];
  while (boxes.length < COLOURS) {
    boxes.sort((a, b) => b.spread - a.spread);
    if (boxes[0].spread === 0) break;
    const { colours: cut, channel, mean } = boxes.shift();
    boxes.push(measured(cut.filter(({ rgb }) => rgb[channel] <= mean[channel])), measured(cut.filter(({ rgb }) => rgb[channel] > mean[channel])));
  }
  // A box takes its most frequent colour, so that large areas keep theirs exactly.
  return boxes.map(({ colours: box }) => box.reduce((a, b) => (b.weight > a.weight ? b : a)).rgb);
}

function measured(colours) {
  const total = colours.reduce((sum, { weight }) => sum + weight, 0),
    mean = [0, 1, 2].map((c) => colours.reduce((sum, { rgb, weight }) => sum + weight * rgb[c], 0) / total),
    spreads = [0, 1, 2].map((c) => colours.reduce((sum, { rgb, weight }) => sum + weight * (rgb[c] - mean[c]) ** 2, 0)),
    spread = Math.max(...spreads);
  return { colours, mean, spread: colours.length > 1 ? spread : 0, channel: spreads.indexOf(spread) };
}

function nearestIn(palette, r, g, b) {
  let best = 0,
    least = Infinity;
  palette.forEach(([R, G, B], i) => {
    const away = (R - r) ** 2 + (G - g) ** 2 + (B - b) ** 2;
    if (away < least) [best, least] = [i, away];
  });
  return best;
}
