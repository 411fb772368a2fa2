"use strict";
// Draws one frame of the run into the canvas.

const LEAST_CROWD = 20; // blocks
const CROWDED = 1.25; // joints a block that carry the largest force

class Stage {
  constructor(run, canvas) {
    Object.assign(this, { run, canvas, context: canvas.getContext("2d"), camera: new Camera(), hovered: -1, chosen: -1 });
    this.show = { frame: 0, quantity: 0, range: "run", forces: "joints", thickness: 1, deformationScale: 1, status: false,
                  crosses: false, outlines: true, bolts: true };
    this.typicalBlock = [...run.blockSize].sort((a, b) => a - b)[Math.floor(run.blocks / 2)] || 1;
  }

  scaleOfColours() {
    const { run, show } = this;
    const quantity = run.quantities[show.quantity];
    const { maps } = run.header;
    return show.range === "run" ? new ColourScale(quantity.scale, maps)
                                : ColourScale.ofRange(...quantity.ranges[show.frame], maps);
  }

  colourOf(block) {
    return this.colours.colour(this.run.value(this.show.quantity, this.show.frame, block));
  }

  // Width of the line of a force, in pixels; the largest fill a quarter of a block, within what looks like a line.
  widthOf(force) {
    const most = Math.min(Math.max(0.25 * this.typicalBlock * this.camera.scale, 1), 10) * this.show.thickness;
    return Math.min(Math.max(most * force / (this.thickestForce() || 1), 0.3), 1.5 * most);
  }

  // What the widest line stands for: nearly the largest force of the run, or the largest of this frame.
  thickestForce() {
    return this.show.range === "run" ? this.run.header.thickest_force[this.show.forces]
                                     : this.lines.reduce((most, { force }) => Math.max(most, force), 0);
  }

  // Whether lines of forces would hide the blocks: where most joints carry about as much as the one that carries most, as
  // in rock under stress. (A wall under its weight has 1 by this measure, and an arch 0.9.)
  forcesCrowd() {
    const { lines, run: { blocks } } = this;
    const most = lines.reduce((largest, { force }) => Math.max(largest, force), 0);
    const together = lines.reduce((sum, { force }) => sum + force / 2, 0); // two lines a joint
    return blocks >= LEAST_CROWD && together > CROWDED * blocks * most;
  }

  // Width of a bolt, in pixels: it is seen without a force too.
  widthOfBolt(force) {
    const most = this.thickestBoltForce();
    return 1.6 + (most > 0 ? Math.min(3.9 * Math.abs(force) / most, 5) : 0);
  }

  thickestBoltForce() {
    return this.show.range === "run" ? this.run.header.bolts.most_force
                                     : this.bolts.reduce((most, { force }) => Math.max(most, Math.abs(force)), 0);
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    const ratio = window.devicePixelRatio || 1;
    const changed = this.camera.width !== clientWidth || this.camera.height !== clientHeight;
    this.canvas.width = Math.round(clientWidth * ratio);
    this.canvas.height = Math.round(clientHeight * ratio);
    Object.assign(this.camera, { width: clientWidth, height: clientHeight, ratio });
    return changed;
  }

  // The blocks of the first and the last frame, unless debris of the last is far away. Blocks that a later frame adds
  // count where they are drawn, so that what is built up stays in sight.
  fitRun() {
    const { run } = this;
    const first = boxOf(run.positions(0, 1).map((place, i) => (isFinite(place) ? place : run.reference[i])));
    const last = boxOf(run.positions(run.frames - 1, 1));
    const margin = 0.5 * Math.max(first.right - first.left, first.top - first.bottom);
    this.camera.fit({
      left: Math.max(Math.min(first.left, last.left), first.left - margin),
      right: Math.min(Math.max(first.right, last.right), first.right + margin),
      bottom: Math.max(Math.min(first.bottom, last.bottom), first.bottom - margin),
      top: Math.min(Math.max(first.top, last.top), first.top + margin),
    });
  }

  // Everything that a new frame or another choice changes.
  prepare() {
    const { run, show } = this;
    this.points = run.positions(show.frame, show.deformationScale);
    this.colours = this.scaleOfColours();
    this.contacts = run.contacts(show.frame, this.points);
    this.lines = forceLines(run, this.points, this.contacts, show.forces);
    this.bolts = show.bolts ? run.bolts(show.frame, show.deformationScale) : [];
  }

  draw() {
    const { context, camera, show } = this;
    const style = getComputedStyle(document.documentElement);
    this.ink = Object.fromEntries(["panel", "outline", "force", "pull", "halo", "sliding", "open", "accent", "bolt", "broken"].map(
      (name) => [name, style.getPropertyValue(`--${name}`).trim()]));
    context.setTransform(camera.ratio, 0, 0, camera.ratio, 0, 0);
    context.clearRect(0, 0, camera.width, camera.height);
    context.lineJoin = "round";
    this.drawBlocks();
    if (show.crosses) this.drawCrosses();
    this.drawForces();
    this.drawBolts();
    if (show.status) this.drawStatus();
  }

  pathOf(block) {
    const path = new Path2D();
    for (const [begin, end] of this.run.ringsOf(block)) {
      for (let i = begin; i < end; ++i) {
        const [x, y] = this.camera.toScreen(this.points[2 * i], this.points[2 * i + 1]);
        i === begin ? path.moveTo(x, y) : path.lineTo(x, y);
      }
      path.closePath();
    }
    return path;
  }

  drawBlocks() {
    const { context, run, show } = this;
    const size = this.typicalBlock * this.camera.scale;
    context.strokeStyle = this.ink.outline;
    for (let block = 0; block < run.blocks; ++block) {
      if (!run.isPresent(show.frame, block)) continue;
      const path = this.pathOf(block);
      const colour = this.colourOf(block);
      context.fillStyle = colour;
      context.fill(path, "evenodd");
      context.lineWidth = show.outlines ? Math.min(Math.max(size / 40, 0.25), 1.2) : 0.6;
      context.strokeStyle = show.outlines ? this.ink.outline : colour; // its own colour closes the hairlines
      context.stroke(path);
    }
    for (const block of new Set([this.hovered, this.chosen])) {
      if (block < 0 || !run.isPresent(show.frame, block)) continue;
      context.strokeStyle = this.ink.accent;
      context.lineWidth = 3;
      context.stroke(this.pathOf(block));
    }
  }

  strokeLine(x, y, dx, dy, before, after) {
    const { context, camera } = this;
    context.beginPath();
    context.moveTo(...camera.toScreen(x - before * dx, y - before * dy));
    context.lineTo(...camera.toScreen(x + after * dx, y + after * dy));
    context.stroke();
  }

  drawForces() {
    const { context, ink } = this;
    context.lineCap = "round";
    for (const halo of [true, false]) {
      for (const { x, y, dx, dy, before, after, force, pulls } of this.lines) {
        const width = this.widthOf(force);
        if (halo && width < 0.8) continue;
        context.lineWidth = halo ? width + Math.min(width - 0.8, 1.6) : width;
        context.strokeStyle = halo ? ink.halo : pulls ? ink.pull : ink.force;
        this.strokeLine(x, y, dx, dy, before, after);
      }
    }
    context.lineCap = "butt";
  }

  // Yielded ones in a colour of their own, linings with a strength by how much of it they carry.
  colourOfBolt({ condition, utilisation }) {
    const { ink } = this;
    if (condition !== "elastic") return { yielded: ink.sliding, broken: ink.broken }[condition];
    return Number.isNaN(utilisation) ? ink.bolt : utilisationColour(this.run.header.maps.utilisation, utilisation);
  }

  // Broken ones are dashed.
  drawBolts() {
    const { context, ink } = this;
    for (const halo of [true, false]) {
      for (const bolt of this.bolts) {
        const { path, force, condition } = bolt;
        const width = this.widthOfBolt(force);
        context.lineWidth = halo ? width + 2 : width;
        context.strokeStyle = halo ? ink.halo : this.colourOfBolt(bolt);
        context.setLineDash(!halo && condition === "broken" ? [4, 3] : []);
        context.stroke(this.pathAlong(path));
      }
    }
    context.setLineDash([]);
  }

  pathAlong(points) {
    const path = new Path2D();
    for (let i = 0; i < points.length; i += 2) path.lineTo(...this.camera.toScreen(points[i], points[i + 1]));
    return path;
  }

  // The link of a bolt under a point of the canvas (pixels of the page), or undefined.
  boltAt(px, py) {
    const { context } = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    return this.bolts.findLast(({ path, force }) => {
      context.lineWidth = this.widthOfBolt(force) + 6;
      return context.isPointInStroke(this.pathAlong(path), px, py);
    });
  }

  // Principal stresses: the longest arm of the colour range fills half of its block.
  drawCrosses() {
    const { context, run, show, ink } = this;
    const [xx, yy, xy] = ["stress_xx", "stress_yy", "stress_xy"].map((id) => run.quantityIndex(id));
    const scales = [xx, yy].map((index) => run.quantities[index].scale);
    const most = Math.max(...scales.map(({ low, high }) => Math.max(Math.abs(low), Math.abs(high))));
    for (let block = 0; block < run.blocks; ++block) {
      const [sx, sy, t] = [xx, yy, xy].map((index) => run.value(index, show.frame, block));
      const [, x, y] = run.areaAndCentroid(this.points, block);
      const angle = Math.atan2(2 * t, sx - sy) / 2;
      const mean = (sx + sy) / 2, shear = Math.hypot((sx - sy) / 2, t);
      for (const [stress, turn] of [[mean + shear, angle], [mean - shear, angle + Math.PI / 2]]) {
        const size = Math.min(run.blockSize[block], 1.5 * this.typicalBlock);
        const half = 0.45 * size * Math.min(Math.abs(stress) / most, 1.2);
        for (const halo of [true, false]) {
          context.lineWidth = halo ? 3.4 : 1.8;
          context.strokeStyle = halo ? ink.halo : stress > 0 ? ink.force : ink.outline;
          if (half * this.camera.scale > 1) this.strokeLine(x, y, Math.cos(turn), Math.sin(turn), half, half);
        }
      }
    }
  }

  // Locked: a filled disk; sliding: a diamond; open: a ring.
  drawStatus() {
    const { context, camera, ink } = this;
    const radius = Math.min(Math.max(0.07 * this.typicalBlock * camera.scale, 1.5), 4.5);
    for (const { x: wx, y: wy, status } of this.contacts) {
      const [x, y] = camera.toScreen(wx, wy);
      context.beginPath();
      if (status === "sliding") {
        const r = 1.5 * radius;
        context.moveTo(x, y - r);
        for (const [px, py] of [[x + r, y], [x, y + r], [x - r, y]]) context.lineTo(px, py);
        context.closePath();
      } else {
        context.arc(x, y, radius, 0, 2 * Math.PI);
      }
      context.fillStyle = { locked: ink.outline, sliding: ink.sliding, open: ink.open }[status];
      context.lineWidth = 1;
      context.strokeStyle = status === "open" ? ink.outline : ink.halo;
      context.fill();
      context.stroke();
    }
  }

  // The block under a point of the canvas, or -1.
  blockAt(px, py) {
    for (let block = this.run.blocks - 1; block >= 0; --block) {
      if (!this.run.isPresent(this.show.frame, block)) continue;
      this.context.setTransform(1, 0, 0, 1, 0, 0);
      if (this.context.isPointInPath(this.pathOf(block), px, py, "evenodd")) return block;
    }
    return -1;
  }
}
