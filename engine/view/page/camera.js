"use strict";
// Which part of the plane the canvas shows: a centre and pixels per metre.

class Camera {
  constructor() {
    Object.assign(this, { x: 0, y: 0, scale: 1, width: 1, height: 1 });
  }

  toScreen(x, y) {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  toWorld(px, py) {
    return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale];
  }

  // Shows the box, with room for the clock above and the ruler below.
  fit({ left, bottom, right, top }) {
    const margin = Math.min(44, this.height / 8);
    this.x = (left + right) / 2;
    this.y = (bottom + top) / 2;
    this.scale = Math.min((this.width - margin) / Math.max(right - left, 1e-12),
                          (this.height - 2 * margin) / Math.max(top - bottom, 1e-12));
  }

  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  // Keeps the point under (px, py) where it is.
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const [x, y] = this.toWorld(px, py);
    this.scale *= factor;
    this.x = x - (px - this.width / 2) / this.scale;
    this.y = y + (py - this.height / 2) / this.scale;
  }
}

function boxOf(points) {
  const box = { left: Infinity, bottom: Infinity, right: -Infinity, top: -Infinity };
  for (let i = 0; i < points.length; i += 2) {
    if (!isFinite(points[i] + points[i + 1])) continue;
    box.left = Math.min(box.left, points[i]);
    box.right = Math.max(box.right, points[i]);
    box.bottom = Math.min(box.bottom, points[i + 1]);
    box.top = Math.max(box.top, points[i + 1]);
  }
  return box;
}
