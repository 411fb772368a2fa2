"use strict";
// Runs through the frames at a steady pace.

class Player {
  constructor(frames, show) {
    Object.assign(this, { frames, show, frame: 0, playing: false, rate: 10, loop: false });
  }

  go(frame) {
    this.frame = Math.min(Math.max(Math.round(frame), 0), this.frames - 1);
    this.show(this.frame);
  }

  toggle() {
    this.playing ? this.pause() : this.play();
  }

  play() {
    if (this.frame === this.frames - 1) this.go(0);
    this.playing = true;
    this.began = null;
    requestAnimationFrame((now) => this.tick(now));
    this.show(this.frame);
  }

  pause() {
    this.playing = false;
    this.show(this.frame);
  }

  tick(now) {
    if (!this.playing) return;
    if (this.began === null || this.rateThen !== this.rate) {
      [this.began, this.from, this.rateThen] = [now, this.frame, this.rate];
    }
    const target = this.from + Math.floor(((now - this.began) / 1000) * this.rate);
    if (target > this.frame) {
      this.go(target);
      if (this.frame === this.frames - 1) {
        if (!this.loop) return this.pause();
        this.frame = -1;
        this.began = null;
      }
    }
    requestAnimationFrame((next) => this.tick(next));
  }
}
