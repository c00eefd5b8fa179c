// Pictures as PNG: read, written with a palette, compared. No package is needed for it.
import { crc32, deflateSync, inflateSync } from 'node:zlib';

/** A picture: three bytes for each point. */
export interface Picture {
  width: number;
  height: number;
  rgb: Uint8Array;
}

/** A part of a picture, in points. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

const SIGNATURE = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
/** Colours of a palette. */
const COLOURS_MAX = 256;
/** Two colours that differ by no more than this in each channel are the same to the eye; a palette moves colours by less. */
const SAME = 40;
/** Bytes of a point by the kind of colour: grey, RGB, palette, RGB with opacity. */
const CHANNELS: Record<number, number> = { 0: 1, 2: 3, 3: 1, 6: 4 };

/** Reads a picture with eight bits a channel, not interlaced: what Chromium and `encode` write. */
export function decode(file: Buffer): Picture {
  if (!file.subarray(0, 8).equals(SIGNATURE)) throw new Error('no PNG');
  const width = file.readUInt32BE(16);
  const height = file.readUInt32BE(20);
  const [depth, kind, interlaced] = [file[24], file[25] ?? -1, file[28]];
  const channels = CHANNELS[kind];
  if (depth !== 8 || interlaced !== 0 || channels === undefined) throw new Error(`a PNG of kind ${kind} with ${depth} bits is not read`);
  const data: Buffer[] = [];
  let palette: Buffer = Buffer.alloc(0);
  for (let at = 8; at < file.length; ) {
    const length = file.readUInt32BE(at);
    const name = file.toString('latin1', at + 4, at + 8);
    const body = file.subarray(at + 8, at + 8 + length);
    if (name === 'IDAT') data.push(body);
    if (name === 'PLTE') palette = body;
    at += length + 12;
  }
  const bytes = unfiltered(inflateSync(Buffer.concat(data)), width * channels, height, channels);
  const rgb = new Uint8Array(width * height * 3);
  for (let point = 0; point < width * height; point++)
    for (let channel = 0; channel < 3; channel++)
      rgb[point * 3 + channel] =
        (kind === 3 ? palette[(bytes[point] ?? 0) * 3 + channel] : bytes[point * channels + (channels === 1 ? 0 : channel)]) ?? 0;
  return { width, height, rgb };
}

/** Undoes what each row says is done to it: differences to the left, above, both. */
function unfiltered(raw: Buffer, row: number, height: number, channels: number): Uint8Array {
  const out = new Uint8Array(row * height);
  for (let y = 0; y < height; y++) {
    const filter = raw[y * (row + 1)];
    for (let x = 0; x < row; x++) {
      const left = x >= channels ? (out[y * row + x - channels] ?? 0) : 0;
      const above = y > 0 ? (out[(y - 1) * row + x] ?? 0) : 0;
      const corner = x >= channels && y > 0 ? (out[(y - 1) * row + x - channels] ?? 0) : 0;
      let add = 0;
      if (filter === 1) add = left;
      else if (filter === 2) add = above;
      else if (filter === 3) add = (left + above) >> 1;
      else if (filter === 4) {
        const [a, b, c] = [Math.abs(above - corner), Math.abs(left - corner), Math.abs(left + above - 2 * corner)];
        add = a <= b && a <= c ? left : b <= c ? above : corner;
      }
      out[y * row + x] = ((raw[y * (row + 1) + 1 + x] ?? 0) + add) & 255;
    }
  }
  return out;
}

/** Writes a picture with at most 256 colours, those that it has most of and means of the rest. */
export function encode(picture: Picture): Buffer {
  const { width, height, rgb } = picture;
  const counts = new Map<number, number>();
  const colour = (point: number) => ((rgb[point * 3] ?? 0) << 16) | ((rgb[point * 3 + 1] ?? 0) << 8) | (rgb[point * 3 + 2] ?? 0);
  for (let point = 0; point < width * height; point++) counts.set(colour(point), (counts.get(colour(point)) ?? 0) + 1);
  const { palette, index } = chosen(counts);
  const raw = Buffer.alloc((width + 1) * height);
  for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) raw[y * (width + 1) + 1 + x] = index.get(colour(y * width + x)) ?? 0;
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 3, 0, 0, 0], 8);
  const colours = Buffer.from(palette.flatMap((one) => [one >> 16, (one >> 8) & 255, one & 255]));
  return Buffer.concat([SIGNATURE, chunk('IHDR', head), chunk('PLTE', colours), chunk('IDAT', deflateSync(raw, { level: 9 })), chunk('IEND', Buffer.alloc(0))]);
}

/** A palette for these colours, and which of it each colour becomes. */
function chosen(counts: Map<number, number>): { palette: number[]; index: Map<number, number> } {
  // Boxes of colours, halved where the most points lie far apart, until there are enough of them.
  const channel = (one: number, shift: number) => (one >> shift) & 255;
  const width = (box: number[], shift: number) => Math.max(...box.map((one) => channel(one, shift))) - Math.min(...box.map((one) => channel(one, shift)));
  const shiftOf = (box: number[]) => [16, 8, 0].reduce((best, shift) => (width(box, shift) > width(box, best) ? shift : best), 16);
  const weight = (box: number[]) => Math.sqrt(box.reduce((sum, one) => sum + (counts.get(one) ?? 0), 0)) * width(box, shiftOf(box));
  const boxes: { colours: number[]; weight: number }[] = [];
  const add = (colours: number[]) => boxes.push({ colours, weight: colours.length > 1 ? weight(colours) : 0 });
  // A colour that fills areas keeps exactly its place.
  const often = [...counts].sort((a, b) => b[1] - a[1]).slice(0, 64).map(([one]) => one);
  for (const one of often) add([one]);
  const rest = [...counts.keys()].filter((one) => !often.includes(one));
  if (rest.length > 0) add(rest);
  while (boxes.length < COLOURS_MAX) {
    const at = boxes.reduce((best, box, i) => (box.weight > (boxes[best]?.weight ?? 0) ? i : best), 0);
    const box = boxes[at];
    if (box === undefined || box.weight === 0) break;
    boxes.splice(at, 1);
    const shift = shiftOf(box.colours);
    const sorted = box.colours.sort((a, b) => channel(a, shift) - channel(b, shift) || a - b);
    const half = sorted.reduce((sum, one) => sum + (counts.get(one) ?? 0), 0) / 2;
    let cut = 0;
    for (let sum = 0; cut < sorted.length - 1 && (cut === 0 || sum < half); cut++) sum += counts.get(sorted[cut] ?? 0) ?? 0;
    add(sorted.slice(0, cut));
    add(sorted.slice(cut));
  }
  const index = new Map<number, number>();
  const palette = boxes.map(({ colours }, i) => {
    for (const one of colours) index.set(one, i);
    const all = colours.reduce((sum, one) => sum + (counts.get(one) ?? 0), 0);
    const mean = (shift: number) => Math.round(colours.reduce((sum, one) => sum + channel(one, shift) * (counts.get(one) ?? 0), 0) / all);
    return (mean(16) << 16) | (mean(8) << 8) | mean(0);
  });
  return { palette, index };
}

function chunk(name: string, body: Buffer): Buffer {
  const out = Buffer.alloc(body.length + 12);
  out.writeUInt32BE(body.length, 0);
  out.write(name, 4, 'latin1');
  body.copy(out, 8);
  out.writeUInt32BE(crc32(out.subarray(4, body.length + 8)) >>> 0, body.length + 8);
  return out;
}

/** Which part of two pictures differs, outside of some boxes; 1 if they are not of one size. */
export function difference(one: Picture, other: Picture, except: Box[]): number {
  if (one.width !== other.width || one.height !== other.height) return 1;
  let differ = 0;
  for (let y = 0; y < one.height; y++)
    for (let x = 0; x < one.width; x++) {
      const at = (y * one.width + x) * 3;
      const far = [0, 1, 2].some((channel) => Math.abs((one.rgb[at + channel] ?? 0) - (other.rgb[at + channel] ?? 0)) > SAME);
      if (far && !except.some((box) => x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height)) differ += 1;
    }
  return differ / (one.width * one.height);
}
