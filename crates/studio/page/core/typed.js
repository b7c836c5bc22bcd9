// Values as people type them: a bare number means the unit that its field shows, a comma is a decimal one.

const NUMBER = String.raw`[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?`;
const BARE = new RegExp(`^${NUMBER}$`);
const COMMA = /(?<![\d.,])(\d*),(\d+)(?![\d.,])/g;
const SUM = /^[\d\s.,+\-*/()]*[*/()][\d\s.,+\-*/()]*/;

// The unit behind the number of a text; empty where there is none.
export function unitOf(text = "") {
  const found = new RegExp(`^\\s*${NUMBER}\\s*([^\\d\\s].*)$`).exec(text);
  return found && !found[1].includes(":") ? found[1].trim() : "";
}

// What the scene takes for a typed text, in a field that shows `unit`.
export function value(text, unit) {
  const plain = calculated(text.trim().replace(COMMA, (all, whole, part) => `${whole || "0"}.${part}`));
  return unit && BARE.test(plain) ? `${plain} ${unit}` : plain;
}

// The number of a text that is one number with or without a unit.
export function number(text = "") {
  const [, x, unit = ""] = new RegExp(`^\\s*(${NUMBER})\\s*([^\\d\\s/].*)?$`).exec(text) ?? [];
  return x === undefined || unit.includes(":") ? NaN : Number(x.replace(",", "."));
}

// `2*40 mm` is 80 mm. A single fraction, `3/8 in`, is left as it is: the scene takes it.
function calculated(text) {
  const [part = ""] = SUM.exec(text) ?? [];
  if (part === "" || /^\s*\d+\s*\/\s*\d+\s*$/.test(part)) return text;
  const x = new Sum(part).result();
  return Number.isFinite(x) ? `${Number(x.toPrecision(12))} ${text.slice(part.length)}`.trim() : text;
}

// A sum of products by recursive descent; anything else is NaN.
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
