// What the page uses of its libraries. `npm run vendor` joins it to page/core/vendor.js, so that cargo alone
// builds the page.

export { html, svg, render, nothing } from "lit-html";
export { repeat } from "lit-html/directives/repeat.js";
export { live } from "lit-html/directives/live.js";
export { zipSync } from "fflate";
export { GIFEncoder, quantize, applyPalette } from "gifenc/dist/gifenc.esm.js";
export { encode as qrCode } from "uqr";
