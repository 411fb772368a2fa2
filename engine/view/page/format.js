"use strict";
// Numbers for people: SI prefixes, round ticks.

const PREFIXES = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "\u00b5"], [1e-9, "n"]];

// {factor, name} of a unit with a prefix for numbers of this magnitude; no Mm, km/s or ks.
function scaledUnit(unit, magnitude) {
  const largest = unit.startsWith("m") || unit === "s" || unit === "rad" ? 1 : 1e9;
  const fitting = PREFIXES.find(([factor]) => factor <= largest && Math.abs(magnitude) >= factor);
  return fitting && unit !== "-" ? { factor: fitting[0], name: fitting[1] + unit } : { factor: 1, name: unit === "-" ? "" : unit };
}

// Round values from low to high in steps of 1, 2 or 5 times a power of ten; {step, values}.
function ticksBetween(low, high, most) {
  const rough = (high - low) / most;
  if (!(rough > 0) || !isFinite(rough)) return { step: 1, values: [low] };
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((digit) => digit * power >= rough * (1 - 1e-9));
  const values = [];
  for (let i = Math.ceil(low / step - 1e-6); i * step <= high + 1e-6 * step; ++i) values.push(i * step);
  return { step, values };
}

function label(value, step) {
  const digits = Math.min(Math.max(Math.ceil(-Math.log10(step) - 1e-6), 0), 9);
  return value.toFixed(digits).replace(/^-(?=[0.]*$)/, "").replace("-", "\u2212");
}

// A number with its unit, four digits.
function withUnit(value, unit) {
  if (!isFinite(value)) return "no number";
  const { factor, name } = scaledUnit(unit, value);
  return `${Number((value / factor).toPrecision(4))} ${name}`.trim().replace("-", "\u2212");
}

function timeText(time, interval) {
  const digits = Math.min(Math.max(Math.ceil(-Math.log10(interval)) + 1, 0), 9);
  return `${time.toFixed(digits)} s`;
}
