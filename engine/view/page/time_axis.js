"use strict";
// Time on the axis of a plot. A stage that settles is a narrow strip, however long it lasts: nothing moves in its time.

const STRIP = 0.03; // of the axis, for each such stage

class TimeAxis {
  // `stages`: those of the run, {begin_s, end_s, settles}; none for runs that did not write them.
  constructor(first, last, stages = []) {
    Object.assign(this, { first, last });
    const strips = stages.filter(({ settles }) => settles)
      .map(({ begin_s: begin, end_s: end }) => ({ begin: Math.max(begin, first), end: Math.min(end, last) }))
      .filter(({ begin, end }) => end > begin);
    const still = strips.reduce((sum, { begin, end }) => sum + end - begin, 0);
    this.moving = last - first - still;
    this.strips = this.moving > 1e-9 * (last - first) ? strips : []; // while it has only settled, time is all there is
    if (this.strips.length === 0) this.moving = last - first || 1;
    this.pieces = this.makePieces();
  }

  // Stretches of time with the shares of the axis that they have, in order.
  makePieces() {
    const room = 1 - STRIP * this.strips.length;
    const pieces = [];
    let time = this.first, share = 0;
    const add = (end, width, still) => {
      if (end > time) pieces.push({ begin: time, end, from: share, to: share + width, still });
      [time, share] = [Math.max(end, time), end > time ? share + width : share];
    };
    for (const { begin, end } of this.strips) {
      add(begin, (room * (begin - time)) / this.moving, false);
      add(end, STRIP, true);
    }
    add(this.last, (room * (this.last - time)) / this.moving, false);
    return pieces;
  }

  // From 0 at the first time to 1 at the last.
  shareOf(time) {
    const piece = this.pieces.find(({ end }) => time <= end) || this.pieces.at(-1);
    if (!piece) return 0;
    const { begin, end, from, to } = piece;
    return from + ((to - from) * (time - begin)) / (end - begin);
  }

  timeAt(share) {
    const piece = this.pieces.find(({ to }) => share <= to) || this.pieces.at(-1);
    if (!piece) return this.first;
    const { begin, end, from, to } = piece;
    return begin + ((end - begin) * (share - from)) / (to - from);
  }

  // Round times in the stretches that move, in units of `factor` s; {step, values}.
  ticks(factor, most) {
    const { step } = ticksBetween(0, this.moving / factor, most);
    const values = this.pieces.filter(({ still }) => !still).flatMap(({ begin, end }) => {
      const found = [];
      for (let i = Math.ceil(begin / factor / step - 1e-6); i * step <= end / factor + 1e-6 * step; ++i) found.push(i * step);
      return found;
    });
    return { step, values };
  }
}
