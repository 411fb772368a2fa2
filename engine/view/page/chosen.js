"use strict";
// The block that was clicked at: what colours show of it, in all frames, a plot for each unit.

class ChosenBlock {
  constructor(run, axis, seek) {
    Object.assign(this, { run, axis, seek, block: -1, columns: [], panels: [] });
    document.getElementById("chosen-csv").addEventListener("click", () => saveCsv(this.name, run.times, this.columns));
    document.getElementById("chosen-close").addEventListener("click", () => this.choose(-1));
  }

  get name() {
    return this.run.header.block_names[this.block];
  }

  // -1: none.
  choose(block) {
    const { run, axis, seek } = this;
    this.block = block;
    document.getElementById("chosen").hidden = block < 0;
    this.columns = block < 0 ? [] : run.quantities.map(({ title, unit }, quantity) => ({
      name: title, unit,
      values: run.times.map((_, frame) => {
        const value = run.value(quantity, frame, block);
        return run.isPresent(frame, block) && isFinite(value) ? value : null;
      }),
    }));
    this.panels = panelsByUnit(run.times, axis, this.columns, seek);
    document.getElementById("chosen-panels").replaceChildren(...this.panels.map((panel) => panel.element));
    if (block >= 0) document.getElementById("chosen-title").textContent = this.name;
    showHistories();
  }

  draw(time) {
    for (const panel of this.panels) panel.draw(time);
  }
}
