"use strict";
// Turns values into colours, by the scale that the program chose for the run or by the values of one frame.

class ColourScale {
  constructor(scale, maps) {
    Object.assign(this, scale);
    this.map = scale.diverging ? maps.diverging : maps.sequential;
  }

  // Makes a scale as the program does it for a whole run (engine/view/colour_scale.cpp), but with all values.
  static ofRange(low, high, maps) {
    const [least, most] = [low, high];
    const far = Math.max(Math.abs(low), Math.abs(high));
    if (far === 0) return new ColourScale({ low: 0, high: 1, diverging: false, dark_low: false, least, most }, maps);
    const near = Math.min(Math.abs(low), Math.abs(high));
    if (low < 0 && high > 0 && near > 0.05 * far)
      return new ColourScale({ low: -far, high: far, diverging: true, dark_low: false, least, most }, maps);
    const negative = -low > high;
    if (low * high < 0 || near < 0.5 * far) negative ? (high = 0) : (low = 0);
    if (high - low < 1e-9 * far) negative ? (low *= 1.01) : (high *= 1.01);
    return new ColourScale({ low, high, diverging: false, dark_low: negative, least, most }, maps);
  }

  colour(value) {
    return isFinite(value) ? this.colourAt((value - this.low) / (this.high - this.low)) : "#969696";
  }

  colourAt(share) {
    const place = this.diverging || !this.dark_low ? share : 1 - share;
    return this.map[Math.round(255 * Math.min(Math.max(place, 0), 1))];
  }
}

// What is written beside a scale: title, notes, and numbers with their share of its length.
function colourBar(quantity, scale) {
  const unit = scaledUnit(quantity.unit, Math.max(Math.abs(scale.low), Math.abs(scale.high)));
  const beyond = [scale.least, scale.most].map((value) => Number((value / unit.factor).toPrecision(2)));
  const clipped = scale.least < scale.low || scale.most > scale.high;
  const signed = quantity.unit === "Pa" && quantity.id !== "max_shear";
  const { step, values } = ticksBetween(scale.low / unit.factor, scale.high / unit.factor, 6);
  return {
    title: `${quantity.title} [${unit.name}]`,
    notes: [signed ? "tension positive" : "", clipped ? `values ${beyond.join(" to ").replaceAll("-", "\u2212")}` : ""],
    ticks: values.map((value) => ({ text: label(value, step),
                                    share: (value * unit.factor - scale.low) / (scale.high - scale.low) })),
  };
}

// Shows a scale as the colour bar of the page.
function showColourBar(quantity, scale) {
  const { title, notes, ticks } = colourBar(quantity, scale);
  document.getElementById("bar-title").replaceChildren(
    title, ...notes.map((text) => Object.assign(document.createElement("small"), { textContent: text })));
  const gradient = document.getElementById("gradient");
  const stops = Array.from({ length: 33 }, (_, i) => scale.colourAt(i / 32));
  gradient.style.setProperty("--stops", stops.join(","));
  gradient.replaceChildren(...ticks.map(({ text, share }) => {
    const tick = Object.assign(document.createElement("span"), { textContent: text });
    tick.style.setProperty("--at", `${100 * share}%`);
    return tick;
  }));
}

// Returns the colour for the share of its strength that a lining carries, from 0 to 1.
function utilisationColour(map, share) {
  return map[Math.round(Math.min(Math.max(share, 0), 1) * (map.length - 1))];
}
