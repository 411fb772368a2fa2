"use strict";
// What can be taken out of the page as files: columns against time as CSV, and the picture as PNG.

// As histories.csv has it: a unit in every name, and nothing where there is no value.
function csvOf(times, columns) {
  const cell = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const head = columns.map(({ name, unit }) => cell(`${name} [${unit}]`));
  const rows = times.map((time, i) => [time, ...columns.map(({ values }) => values[i] ?? "")]);
  return [["time [s]", ...head], ...rows].map((row) => `${row.join(",")}\n`).join("");
}

function saveFile(name, blob) {
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function saveCsv(name, times, columns) {
  saveFile(`${fileName(name)}.csv`, new Blob([csvOf(times, columns)], { type: "text/csv" }));
}

// Letters, digits and what does no harm in a name of a file.
const fileName = (text) => text.replace(/[^\p{L}\p{N}._-]+/gu, "_").slice(0, 80) || "page";

// The drawing with its title, the time and the colour bar, as a canvas.
function pictureOf(stage, title, time) {
  const { canvas, colours, camera: { width, height, ratio } } = stage;
  const head = 52, side = 130, bar = Math.min(height - 130, 340);
  const sheet = document.createElement("canvas");
  [sheet.width, sheet.height] = [Math.round((width + side) * ratio), Math.round((height + head) * ratio)];
  const context = sheet.getContext("2d");
  const style = getComputedStyle(document.documentElement), font = getComputedStyle(document.body).fontFamily;
  const write = (text, x, y, size, weight = 400) => {
    context.font = `${weight} ${size}px ${font}`;
    context.fillText(text, x, y);
  };
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.fillStyle = style.getPropertyValue("--panel");
  context.fillRect(0, 0, width + side, height + head);
  context.drawImage(canvas, 0, head, width, height);
  context.fillStyle = style.getPropertyValue("--ink");
  write(title, 12, 22, 17, 650);
  write(time, 12, 42, 14);
  const legend = colourBar(stage.run.quantities[stage.show.quantity], colours);
  const words = legend.title.split(" ");
  const notes = legend.notes.filter((note) => note);
  [...words, ...notes].forEach((text, i) => {
    write(text, width + 8, head + 8 + 17 * i, 13, i < words.length ? 650 : 400);
  });
  const top = head + 16 + 17 * (words.length + notes.length);
  for (let y = 0; y < bar; ++y) {
    context.fillStyle = colours.colourAt(1 - y / (bar - 1));
    context.fillRect(width + 8, top + y, 20, 1.5);
  }
  context.fillStyle = style.getPropertyValue("--ink");
  context.textBaseline = "middle";
  for (const { text, share } of legend.ticks) write(text, width + 36, top + bar * (1 - share), 13);
  return sheet;
}
