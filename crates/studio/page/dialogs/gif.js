// An animated picture (GIF 89a) of at most 256 colours.

const COLOURS = 256;
const rough = (r, g, b) => (r >> 3) << 10 | (g >> 3) << 5 | b >> 3;

// The most frequent colours, of those that are alike in five bits the first; the others become the nearest of them.
function palette(frames) {
  const counts = new Map();
  for (const { data } of frames) {
    for (let i = 0; i < data.length; i += 4) {
      const key = rough(data[i], data[i + 1], data[i + 2]);
      const entry = counts.get(key);
      if (entry) entry.count += 1;
      else counts.set(key, { count: 1, rgb: [data[i], data[i + 1], data[i + 2]] });
    }
  }
  const list = [...counts.entries()].sort((a, b) => b[1].count - a[1].count);
  const colours = list.slice(0, COLOURS).map(([, { rgb }]) => rgb);
  const far = (a, b) => a.reduce((sum, x, k) => sum + (x - b[k]) ** 2, 0);
  const nearest = ({ rgb }) => colours.reduce((best, c, k) => (far(c, rgb) < far(colours[best], rgb) ? k : best), 0);
  const at = new Map(list.map(([key, entry], k) => [key, k < COLOURS ? k : nearest(entry)]));
  return { colours, of: (r, g, b) => at.get(rough(r, g, b)) };
}

// Indices of colours by LZW with codes of 9 to 12 bits, in blocks of at most 255 bytes (GIF 89a, appendix F).
function packed(indices) {
  const [clear, end] = [COLOURS, COLOURS + 1];
  const bytes = [];
  let [bits, held] = [0, 0];
  let [size, next, table] = [9, end + 1, new Map()];
  const put = (code) => {
    bits |= code << held;
    for (held += size; held >= 8; held -= 8) {
      bytes.push(bits & 255);
      bits >>>= 8;
    }
  };
  put(clear);
  let code = indices[0];
  for (let i = 1; i < indices.length; i += 1) {
    const key = code << 8 | indices[i];
    const known = table.get(key);
    if (known === undefined) {
      put(code);
      if (next === 4096) {
        put(clear);
        [size, next, table] = [9, end + 1, new Map()];
      } else {
        if (next === 1 << size) size += 1;
        table.set(key, next);
        next += 1;
      }
      code = indices[i];
    } else code = known;
  }
  put(code);
  if (next === 1 << size && size < 12) size += 1;
  put(end);
  if (held > 0) bytes.push(bits & 255);
  const blocks = [8];
  for (let i = 0; i < bytes.length; i += 255) {
    const block = bytes.slice(i, i + 255);
    blocks.push(block.length, ...block);
  }
  return [...blocks, 0];
}

const short = (x) => [x & 255, x >> 8];

// Frames of one size (ImageData, opaque), each shown for `delay` hundredths of a second, again and again.
export function gif(frames, delay) {
  const [{ width, height }] = frames;
  const { colours, of } = palette(frames);
  const table = Uint8Array.from({ length: 3 * COLOURS }, (_, i) => colours[Math.floor(i / 3)]?.[i % 3] ?? 0);
  const text = (s) => new TextEncoder().encode(s);
  const parts = [text("GIF89a"), Uint8Array.from([...short(width), ...short(height), 0xf7, 0, 0]), table,
    Uint8Array.from([0x21, 0xff, 11]), text("NETSCAPE2.0"), Uint8Array.from([3, 1, 0, 0, 0])];
  for (const { data } of frames) {
    const indices = Uint8Array.from({ length: width * height }, (_, i) => of(data[4 * i], data[4 * i + 1], data[4 * i + 2]));
    parts.push(Uint8Array.from([0x21, 0xf9, 4, 4, ...short(delay), 0, 0, 0x2c, 0, 0, 0, 0, ...short(width), ...short(height), 0]), Uint8Array.from(packed(indices)));
  }
  return new Blob([...parts, Uint8Array.of(0x3b)], { type: "image/gif" });
}
