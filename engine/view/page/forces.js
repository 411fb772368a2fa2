"use strict";
// Contact forces as lines: where, in which direction, how long to either side (m), how large (N/m).

const DRAWN_LEAST = 0.01; // of the largest of the frame; what is smaller is not drawn

function forceLines(run, points, contacts, mode) {
  if (mode === "none") return [];
  return mode === "joints" ? jointLines(run, points, contacts) : worthDrawing(contactLines(run, contacts));
}

function worthDrawing(lines) {
  const most = lines.reduce((largest, { force }) => Math.max(largest, force), 0);
  return lines.filter(({ force }) => force > DRAWN_LEAST * most);
}

function contactLines(run, contacts) {
  return contacts.map(({ a, b, x, y, fx, fy, pulls }) => {
    const force = Math.hypot(fx, fy);
    const half = 0.3 * Math.min(run.blockSize[a], run.blockSize[b]);
    return { x, y, dx: fx / force, dy: fy / force, before: half, after: half, force, pulls };
  });
}

// All contacts of two blocks together have one resultant. Where just two joints load a block from opposite sides,
// their lines meet half-way between them: the line of thrust. Elsewhere a line follows the direction of its force towards the block's centroid.
function jointLines(run, points, contacts) {
  const joints = new Map();
  for (const contact of contacts) {
    if (contact.status === "open") continue;
    const [first, second] = contact.a < contact.b ? [contact.a, contact.b] : [contact.b, contact.a];
    const key = first * run.blocks + second;
    if (!joints.has(key)) joints.set(key, { blocks: [first, second], parts: [] });
    const sign = contact.b === second ? 1 : -1;
    joints.get(key).parts.push({ ...contact, fx: sign * contact.fx, fy: sign * contact.fy });
  }
  const loaded = worthDrawing([...joints.values()].map((joint) => ({ ...joint, ...resultant(run, joint) })));
  const jointsOf = new Map();
  for (const joint of loaded) {
    for (const block of joint.blocks) {
      if (!jointsOf.has(block)) jointsOf.set(block, []);
      jointsOf.get(block).push(joint);
    }
  }
  return loaded.flatMap((joint) => joint.blocks.map((block) => {
    return { ...joint, ...armInto(run, points, joint, block, jointsOf.get(block)) };
  }));
}

// The sum of a joint's forces on its second block, and the point of its line of action nearest to the middle of the
// contacts; bending without thrust has its line far away, and is drawn no farther than a block off.
function resultant(run, { blocks, parts }) {
  let fx = 0, fy = 0, x = 0, y = 0, moment = 0, pull = 0;
  for (const part of parts) {
    fx += part.fx;
    fy += part.fy;
    x += part.x / parts.length;
    y += part.y / parts.length;
    pull += (part.pulls ? 1 : -1) * Math.hypot(part.fx, part.fy);
  }
  for (const part of parts) moment += (part.x - x) * part.fy - (part.y - y) * part.fx;
  const force = Math.hypot(fx, fy);
  const size = Math.min(...blocks.map((block) => run.blockSize[block]));
  const offset = Math.min(Math.max(moment / force, -size), size);
  return { x: x + (offset * fy) / force, y: y - (offset * fx) / force, dx: fx / force, dy: fy / force, force, size,
           pulls: pull > 0 };
}

// Thrust goes through a block from one joint to the other; two forces to the same side are borne by something else, such
// as a support.
function isThrust([a, b], block) {
  const sign = (a.blocks[1] === block) === (b.blocks[1] === block) ? 1 : -1;
  return sign * (a.dx * b.dx + a.dy * b.dy) < 0;
}

// The part of a joint's line that lies in one of its blocks: direction and length from the point of action.
function armInto(run, points, { x, y, dx, dy, size }, block, joints) {
  if (joints.length === 2 && isThrust(joints, block)) {
    const [a, b] = joints;
    const [ax, ay] = [(a.x + b.x) / 2 - x, (a.y + b.y) / 2 - y];
    const length = Math.hypot(ax, ay);
    if (length > 0 && length <= size) return { dx: ax / length, dy: ay / length, before: 0, after: length };
  }
  const [, cx, cy] = run.areaAndCentroid(points, block);
  const along = (cx - x) * dx + (cy - y) * dy;
  return { before: 0, after: Math.min(Math.max(along, -0.75 * size), 0.75 * size) };
}
