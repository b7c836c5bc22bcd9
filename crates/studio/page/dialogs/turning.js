// The rotating cam as an animated picture.

import { move, partsOf } from "../core/motion.js";
import * as stage from "../panels/stage.js";
import { GIFEncoder, applyPalette, quantize } from "../core/vendor.js";

// Longer side in pixels, number of frames per turn, time per frame in ms, and number of frames from which the colours are taken.
const [SIZE, COUNT, DELAY, SAMPLES] = [400, 48, 80, 6];
const COLOURS = ["--blue", "--orange", "--green", "--purple", "--red", "--quiet", "--ink", "--grid"];

// One turn of the displayed cam, without marks and other designs.
export async function turning({ motion }) {
  const picture = stage.picture();
  const [, , w, h] = picture.getAttribute("viewBox").split(" ").map(Number);
  const scale = SIZE / Math.max(w, h);
  const [width, height] = [Math.round(w * scale), Math.round(h * scale)];
  for (const [name, value] of Object.entries({ width, height })) picture.setAttribute(name, value);
  // The names of the colours are not defined outside the page, so their values are set.
  const colours = getComputedStyle(document.documentElement);
  for (const name of COLOURS) picture.style.setProperty(name, colours.getPropertyValue(name));
  const canvas = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  const parts = partsOf(picture);
  const frames = [];
  for (let i = 0; i < COUNT; i += 1) {
    const u = i / COUNT;
    move(parts, motion, u, motion.start + u * motion.length);
    const image = new Image(width, height);
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(new XMLSerializer().serializeToString(picture))}`;
    await image.decode();
    canvas.fillStyle = colours.getPropertyValue("--card");
    canvas.fillRect(0, 0, width, height);
    canvas.drawImage(image, 0, 0);
    frames.push(canvas.getImageData(0, 0, width, height));
  }
  return encoded(motion.back ? frames.reverse() : frames);
}

// Animation of frames with the same size and common colours, repeated without end.
function encoded(frames) {
  const [{ width, height }] = frames;
  const some = frames.filter((_, i) => i % Math.ceil(frames.length / SAMPLES) === 0);
  const sample = new Uint8Array(some.length * width * height * 4);
  some.forEach(({ data }, i) => sample.set(data, i * data.length));
  const palette = quantize(sample, 256);
  const film = GIFEncoder();
  frames.forEach(({ data }, i) => {
    film.writeFrame(applyPalette(data, palette), width, height, { delay: DELAY, ...(i === 0 ? { palette } : {}) });
  });
  film.finish();
  return new Blob([film.bytes()], { type: "image/gif" });
}
