"use strict";
// The measurements against time, a panel for each unit, with a line at the time of the frame shown.

const SERIES = ["#0072b2", "#d55e00", "#009e73", "#b8669a", "#b58900", "#4aa3d8", "#7b5ea7", "#8a8a8a"];

class HistoryPanel {
  constructor(times, axis, unit, columns, seek) {
    Object.assign(this, { times, axis, columns });
    const finite = columns.flatMap((column) => column.values).filter((value) => value !== null && isFinite(value));
    [this.low, this.high] = finite.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)],
                                          [Infinity, -Infinity]);
    if (!(this.low < this.high)) [this.low, this.high] = [(this.low || 0) - 1, (this.high || 0) + 1];
    this.unit = scaledUnit(unit, Math.max(Math.abs(this.low), Math.abs(this.high)));
    this.element = document.createElement("div");
    this.canvas = this.element.appendChild(document.createElement("canvas"));
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", `${columns.map((column) => column.name).join(", ")} against time`);
    this.names = this.element.appendChild(Object.assign(document.createElement("div"), { className: "names" }));
    this.values = columns.map((column, i) => {
      const name = this.names.appendChild(document.createElement("span"));
      name.style.setProperty("--series", SERIES[i % SERIES.length]);
      name.append(`${column.name} `);
      return name.appendChild(document.createElement("b"));
    });
    const follow = (event) => event.buttons && seek(this.timeAt(event.offsetX));
    this.canvas.addEventListener("pointerdown", follow);
    this.canvas.addEventListener("pointermove", follow);
  }

  get plot() {
    return { left: 78, right: this.canvas.clientWidth - 14, top: 10, bottom: this.canvas.clientHeight - 20 };
  }

  x(time) {
    const { left, right } = this.plot;
    return left + (right - left) * this.axis.shareOf(time);
  }

  y(value) {
    const { top, bottom } = this.plot;
    return bottom - ((bottom - top) * (value - this.low)) / (this.high - this.low);
  }

  timeAt(x) {
    const { left, right } = this.plot;
    return this.axis.timeAt((x - left) / (right - left));
  }

  valueAt(column, time) {
    const after = this.times.findIndex((at) => at >= time - 1e-9 * this.axis.moving);
    return column.values[after < 0 ? column.values.length - 1 : after];
  }

  draw(time) {
    const { canvas } = this;
    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.round(canvas.clientWidth * ratio);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const style = getComputedStyle(document.documentElement);
    const ink = (name) => style.getPropertyValue(`--${name}`).trim();
    this.drawAxes(context, ink);
    this.columns.forEach((column, i) => this.drawSeries(context, column, SERIES[i % SERIES.length]));
    context.strokeStyle = ink("ink");
    context.lineWidth = 1.2;
    context.beginPath();
    context.moveTo(this.x(time), this.plot.top - 6);
    context.lineTo(this.x(time), this.plot.bottom);
    context.stroke();
    this.columns.forEach((column, i) => {
      const value = this.valueAt(column, time);
      this.values[i].textContent = value === null ? "" : withUnit(value, column.unit);
    });
  }

  drawAxes(context, ink) {
    const { left, right, top, bottom } = this.plot;
    context.font = `12px ${getComputedStyle(document.body).fontFamily}`;
    context.fillStyle = ink("quiet");
    context.strokeStyle = ink("line");
    context.lineWidth = 1;
    const { factor, name } = this.unit;
    context.save();
    context.fillStyle = ink("wash");
    for (const { begin, end } of this.axis.strips)
      context.fillRect(this.x(begin), top, this.x(end) - this.x(begin), bottom - top);
    context.restore();
    const vertical = ticksBetween(this.low / factor, this.high / factor, 3);
    const line = (x0, y0, x1, y1) => {
      context.beginPath();
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
      context.stroke();
    };
    context.textAlign = "right";
    context.textBaseline = "middle";
    vertical.values.forEach((value, i) => {
      const y = this.y(value * factor);
      line(left, y, right, y);
      context.fillText(label(value, vertical.step) + (i === vertical.values.length - 1 ? ` ${name}` : ""), left - 6, y);
    });
    context.textAlign = "center";
    context.textBaseline = "top";
    const span = scaledUnit("s", this.times.at(-1));
    const horizontal = this.axis.ticks(span.factor, Math.max(2, (right - left) / 90));
    let labelled = -Infinity;
    for (const value of horizontal.values) {
      const x = this.x(value * span.factor);
      line(x, top, x, bottom);
      if (x - labelled < 56) continue; // on both sides of a strip
      labelled = x;
      const text = `${label(value, horizontal.step)} ${span.name}`;
      const half = context.measureText(text).width / 2;
      context.fillText(text, Math.min(x, this.canvas.clientWidth - half), bottom + 4);
    }
  }

  drawSeries(context, column, colour) {
    context.strokeStyle = colour;
    context.lineWidth = 1.6;
    context.lineJoin = "round";
    context.beginPath();
    let pen = false;
    column.values.forEach((value, i) => {
      if (value === null) {
        pen = false;
        return;
      }
      pen ? context.lineTo(this.x(this.times[i]), this.y(value)) : context.moveTo(this.x(this.times[i]), this.y(value));
      pen = true;
    });
    context.stroke();
  }
}

// One panel for each unit, in the order of the columns.
function panelsByUnit(times, axis, columns, seek) {
  const byUnit = new Map();
  for (const column of columns) byUnit.set(column.unit, [...(byUnit.get(column.unit) || []), column]);
  return [...byUnit].map(([unit, ofUnit]) => new HistoryPanel(times, axis, unit, ofUnit, seek));
}

// The section is there for measurements, and for a block that was clicked at.
function showHistories() {
  const shown = ["measured", "chosen"].some((id) => !document.getElementById(id).hidden);
  document.getElementById("histories").hidden = !shown;
}

// Panels of the measurements; none hides their part. `stages` as for TimeAxis.
function historyPanels(histories, stages, title, seek) {
  const part = document.getElementById("measured");
  part.hidden = !histories || histories.columns.length === 0 || histories.times.length < 2;
  showHistories();
  if (part.hidden) return [];
  const { times, columns } = histories;
  const panels = panelsByUnit(times, new TimeAxis(times[0], times.at(-1), stages), columns, seek);
  document.getElementById("panels").replaceChildren(...panels.map((panel) => panel.element));
  document.getElementById("measured-csv").addEventListener("click", () => saveCsv(title, times, columns));
  return panels;
}
