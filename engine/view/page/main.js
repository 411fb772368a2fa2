"use strict";
// Puts the page together. `dda` is there for tests and for the console.

const dda = (() => {
  const run = new Run();
  const stage = new Stage(run, byId("blocks"));
  const { camera, show } = stage;
  // Between two frames, as most lie; a stage that settles has one frame for all of its time.
  const intervals = run.times.slice(1).map((time, i) => time - run.times[i]).sort((a, b) => a - b);
  const interval = intervals.length > 0 ? intervals[Math.floor((intervals.length - 1) / 2)] : 1;

  let pending = false;
  const redraw = () => {
    if (pending) return;
    pending = true;
    requestAnimationFrame(() => {
      pending = false;
      stage.draw();
      showRuler();
      showKeys(stage);
    });
  };

  function showRuler() {
    const { step } = ticksBetween(0, 160 / camera.scale, 1.6);
    byId("ruler-line").style.width = `${step * camera.scale}px`;
    const { factor, name } = scaledUnit("m", step);
    byId("ruler-text").textContent = `${Number((step / factor).toPrecision(2))} ${name}`;
  }

  function refresh() {
    stage.prepare();
    showColourBar(run.quantities[show.quantity], stage.colours);
    byId("deformation-text").textContent = `\u00d7 ${show.deformationScale.toLocaleString("en")}`;
    byId("time").textContent = timeText(run.times[show.frame], interval);
    for (const panel of [...panels, chosen]) panel.draw(run.times[show.frame]);
    redraw();
  }

  const player = new Player(run.frames, (frame) => {
    show.frame = frame;
    byId("slider").value = frame;
    byId("slider").setAttribute("aria-valuetext", `frame ${frame + 1} of ${run.frames}`);
    byId("play").querySelector("path").setAttribute("d", player.playing ? "M3 2h4v12H3zM9 2h4v12H9z" : "M3 1v14l11-7z");
    byId("play").setAttribute("aria-label", player.playing ? "Pause" : "Play");
    refresh();
  });

  const seek = (time) => {
    const away = run.times.map((at) => Math.abs(at - time));
    player.go(away.indexOf(Math.min(...away)));
  };
  const stages = run.header.summary?.stages;
  const panels = historyPanels(run.header.histories, stages, run.header.title, seek);
  const chosen = new ChosenBlock(run, new TimeAxis(run.times[0], run.times.at(-1), stages), seek);

  function choose(px, py) {
    chosen.choose(stage.chosen = stage.blockAt(px, py));
    refresh();
  }

  function readOut(px, py) {
    const hovered = px < 0 ? -1 : stage.blockAt(px, py);
    if (hovered !== stage.hovered) redraw();
    stage.hovered = hovered;
    const quantity = run.quantities[show.quantity];
    const bolt = px < 0 ? undefined : stage.boltAt(px, py);
    byId("readout").textContent = bolt ? `${bolt.name}: axial force ${withUnit(bolt.force, "N")}, ${bolt.condition}` +
      (Number.isNaN(bolt.utilisation) ? "" : `, ${(100 * bolt.utilisation).toPrecision(3)} % of its strength`) :
      hovered < 0 ? "" :
      `${run.header.block_names[hovered]}: ${quantity.title.toLowerCase()} ${withUnit(run.value(show.quantity, show.frame, hovered), quantity.unit)}`;
  }

  function fit() {
    stage.fitRun();
    redraw();
  }

  showSummary(run);
  byId("bolts-choice").hidden = !run.header.bolts;
  connectChoices(stage, refresh);
  connectPlayer(player);
  connectPointers(stage, redraw, readOut, choose);
  connectKeys(stage, player, redraw, fit);
  byId("chosen-close").addEventListener("click", () => {
    stage.chosen = -1;
    redraw();
  });
  byId("picture").addEventListener("click", () => {
    stage.draw();
    pictureOf(stage, run.header.title, byId("time").textContent)
      .toBlob((blob) => saveFile(`${fileName(run.header.title)}_${show.frame}.png`, blob));
  });
  const zoom = (factor) => () => {
    camera.zoom(factor);
    redraw();
  };
  byId("zoom-in").addEventListener("click", zoom(1.25));
  byId("zoom-out").addEventListener("click", zoom(0.8));
  byId("fit").addEventListener("click", fit);
  new ResizeObserver(() => {
    if (stage.resize()) stage.fitRun();
    refresh();
  }).observe(byId("blocks"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", refresh);

  show.quantity = Math.max(run.quantityIndex(run.header.first_quantity), 0);
  byId("quantity").value = show.quantity;
  stage.resize();
  stage.fitRun();
  player.go(run.frames - 1);
  if (stage.forcesCrowd()) {
    show.forces = byId("forces").value = "none";
    refresh();
  }
  return { run, stage, player, panels, chosen, refresh };
})();
