// Values as typed by users. A number without a unit has the unit of its field. A comma is a decimal sign.

const NUMBER = String.raw`[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?`;
const BARE = new RegExp(`^${NUMBER}$`);
const COMMA = /(?<![\d.,])(\d*),(\d+)(?![\d.,])/g;
const SUM = /^[\d\s.,+\-*/()]*[*/()][\d\s.,+\-*/()]*/;

// Unit after the number of a text; empty if there is none.
export function unitOf(text = "") {
  const found = new RegExp(`^\\s*${NUMBER}\\s*([^\\d\\s].*)$`).exec(text);
  return found && !found[1].includes(":") ? found[1].trim() : "";
}

// Typed text in the form of the scene file, from a field that shows `unit`.
export function value(text, unit) {
  const plain = calculated(text.trim().replace(COMMA, (all, whole, part) => `${whole || "0"}.${part}`));
  return unit && BARE.test(plain) ? `${plain} ${unit}` : plain;
}

// Value of a text that is a single number with or without a unit.
export function number(text = "") {
  const [, x, unit = ""] = new RegExp(`^\\s*(${NUMBER})\\s*([^\\d\\s/].*)?$`).exec(text) ?? [];
  return x === undefined || unit.includes(":") ? NaN : Number(x.replace(",", "."));
}

// Replaces a calculation by its result: `2*40 mm` becomes 80 mm. A single fraction, `3/8 in`, stays unchanged, because scene files accept
// it.
function calculated(text) {
  const [part = ""] = SUM.exec(text) ?? [];
  if (part === "" || /^\s*\d+\s*\/\s*\d+\s*$/.test(part)) return text;
  const x = new Sum(part).result();
  return Number.isFinite(x) ? `${Number(x.toPrecision(12))} ${text.slice(part.length)}`.trim() : text;
}

// Sum of products, evaluated by recursive descent; NaN for any other text.
class Sum {
  constructor(text) {
    this.parts = text.match(/\d+\.?\d*|\.\d+|[-+*/()]/g) ?? [];
  }

  result() {
    const x = this.sum();
    return this.parts.length === 0 ? x : NaN;
  }

  sum() {
    let x = this.product();
    while ("+-".includes(this.parts[0] ?? "x")) x += (this.parts.shift() === "+" ? 1 : -1) * this.product();
    return x;
  }

  product() {
    let x = this.factor();
    while ("*/".includes(this.parts[0] ?? "x")) {
      const times = this.parts.shift() === "*";
      const y = this.factor();
      x = times ? x * y : x / y;
    }
    return x;
  }

  factor() {
    const part = this.parts.shift();
    if (part === "-") return -this.factor();
    if (part === "+") return this.factor();
    if (part !== "(") return part === undefined ? NaN : Number(part);
    const x = this.sum();
    return this.parts.shift() === ")" ? x : NaN;
  }
}
