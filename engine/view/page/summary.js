"use strict";
// What the page says of the run: title, facts, the table of the summary, and the keys of the drawing.

function fillTable(id, rows) {
  document.getElementById(id).replaceChildren(...rows.map((cells) => {
    const row = document.createElement("tr");
    row.append(...cells.map((text) => {
      const cell = document.createElement("td");
      cell.append(text);
      return cell;
    }));
    return row;
  }));
}

function showSummary(run) {
  const { summary, title, frames_in_run: all } = run.header;
  document.getElementById("title").textContent = title;
  const thinned = all > run.frames ? ` (of ${all}, thinned to keep the page small)` : "";
  const facts = document.getElementById("facts");
  facts.textContent = `${run.blocks} blocks, ${run.frames} frames${thinned}`;
  if (!summary) {
    facts.append("; the run has no summary.json yet");
    document.getElementById("summary-box").hidden = true;
    return;
  }
  if (summary.status !== "ok") {
    const status = Object.assign(document.createElement("span"), { className: "bad", textContent: summary.status });
    facts.append("; ended: ", status, ` ${summary.message}`);
  } else if (summary.message) {
    facts.append(`; ${summary.message}`);
  }
  const residual = summary.energy && summary.energy.residual_relative;
  fillTable("summary", [
    ["Status", summary.status],
    ["Steps", String(summary.steps)],
    ["Simulated", withUnit(summary.time_s, "s")],
    ["Blocks", String(summary.blocks)],
    ["Contacts", String(summary.contacts)],
    ["Energy residual", typeof residual === "number" ? residual.toExponential(1).replaceAll("-", "\u2212") : "none"],
    ["Solver", summary.solver],
    ["Wall time", withUnit(summary.wall_s, "s")],
  ]);
}

const svg = (content, height = 16) => `<svg width="34" height="${height}" aria-hidden="true">${content}</svg>`;

// The thickest line of a force, two thinner ones, and the marks that are shown.
function showKeys(stage) {
  const { show } = stage;
  const rows = [];
  const colour = (name) => `var(--${name})`;
  const line = (width, name, style = 'stroke-linecap="round"') =>
    svg(`<line x1="4" y1="8" x2="30" y2="8" stroke="${colour(name)}" stroke-width="${width}" ${style}/>`);
  const most = stage.thickestForce();
  if (most > 0) {
    rows.push("<b>Force</b>");
    const { factor, name } = scaledUnit("N/m", most);
    const { step } = ticksBetween(0, most / factor, 3);
    for (const value of [step, 2 * step, 3 * step].filter((value) => value <= 1.05 * most / factor))
      rows.push(`<div>${line(stage.widthOf(value * factor), "force")}${label(value, step)} ${name}</div>`);
    if (stage.lines.some((force) => force.pulls)) rows.push(`<div>${line(4, "pull")}tension</div>`);
  }
  if (stage.bolts.length > 0) {
    const largest = stage.thickestBoltForce();
    const { factor, name } = scaledUnit("N", largest);
    const { step, values } = ticksBetween(0, largest / factor, 2);
    rows.push("<b>Axial force</b>");
    for (const value of largest > 0 ? values : [0])
      rows.push(`<div>${line(stage.widthOfBolt(value * factor), "bolt", "")}${label(value, step)} ${name}</div>`);
    if (stage.bolts.some(({ utilisation }) => !Number.isNaN(utilisation))) {
      rows.push("<b>Utilisation</b>");
      for (const share of [0, 0.25, 0.5, 0.75, 1]) {
        const shade = utilisationColour(stage.run.header.maps.utilisation, share);
        rows.push(`<div>${svg(`<line x1="4" y1="8" x2="30" y2="8" stroke="${shade}" stroke-width="4"/>`)}${100 * share} %</div>`);
      }
    }
    const has = (condition) => stage.bolts.some((bolt) => bolt.condition === condition);
    if (has("yielded")) rows.push(`<div>${line(4, "sliding", "")}yielded</div>`);
    if (has("broken")) rows.push(`<div>${line(2, "broken", 'stroke-dasharray="4 3"')}broken</div>`);
  }
  if (show.crosses) {
    rows.push("<b>Principal stress</b>");
    rows.push(`<div>${line(1.8, "outline")}compression</div><div>${line(1.8, "force")}tension</div>`);
  }
  if (show.status) {
    const disk = (fill, stroke) => svg(`<circle cx="17" cy="8" r="4" fill="${fill}" stroke="${stroke}"/>`);
    rows.push("<b>Contacts</b>");
    rows.push(`<div>${disk(colour("outline"), colour("halo"))}locked</div>`);
    rows.push(`<div>${svg(`<path d="M17 2l6 6-6 6-6-6z" fill="${colour("sliding")}" stroke="${colour("halo")}"/>`)}sliding</div>`);
    rows.push(`<div>${disk(colour("open"), colour("outline"))}open</div>`);
  }
  document.getElementById("keys").innerHTML = rows.join("");
}
