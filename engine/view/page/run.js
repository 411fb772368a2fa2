"use strict";
// The run that the page carries. Values are 16-bit codes between the least and the greatest of each frame; see
// engine/view/README.md for the sections. Coordinates here count from header.origin.

function takeSection(name) {
  const element = document.getElementById(`data-${name}`);
  const text = atob(element.textContent);
  element.remove();
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

const NO_NUMBER = 65535;
const decoded = (code, [low, high]) => (code === NO_NUMBER ? NaN : low + ((high - low) * code) / 65534);

class Run {
  constructor() {
    this.header = JSON.parse(document.getElementById("data-header").textContent);
    const header = this.header;
    this.times = header.times;
    this.frames = header.times.length;
    this.blocks = header.blocks;
    this.quantities = header.quantities.map((quantity) => ({
      ...quantity,
      codes: new Uint16Array(takeSection(`quantity-${quantity.id}`)),
    }));
    this.reference = new Float32Array(takeSection("reference"));
    this.x = new Uint16Array(takeSection("displacement-x"));
    this.y = new Uint16Array(takeSection("displacement-y"));
    this.sites = new Uint32Array(takeSection("sites"));
    const contactSites = takeSection("contact-sites");
    this.contactSites = header.wide_sites ? new Uint32Array(contactSites) : new Uint16Array(contactSites);
    this.contactForces = new Int16Array(takeSection("contact-forces"));
    if (header.bolts) this.takeBolts();
    this.findContactsOfFrames();
    this.blockSize = this.findBlockSizes();
  }

  takeBolts() {
    this.boltReference = new Float32Array(takeSection("bolt-reference"));
    this.boltX = new Uint16Array(takeSection("bolt-x"));
    this.boltY = new Uint16Array(takeSection("bolt-y"));
    this.boltForce = new Uint16Array(takeSection("bolt-force"));
    this.boltCondition = new Uint8Array(takeSection("bolt-condition"));
    if (this.header.bolts.utilisation) this.boltUtilisation = new Uint16Array(takeSection("bolt-utilisation"));
  }

  // The links of bolts in a frame: points x, y along each, axial force (N in one bolt, tension positive), condition, and
  // the share of its strength that an element of a lining carries; without those that wait to be put in.
  bolts(frame, deformationScale) {
    const { bolts } = this.header;
    if (!bolts) return [];
    const points = bolts.begin.at(-1), links = bolts.names.length;
    const all = bolts.names.map((name, link) => {
      const path = [];
      for (let i = bolts.begin[link]; i < bolts.begin[link + 1]; ++i) {
        path.push(this.boltReference[2 * i] + deformationScale * decoded(this.boltX[frame * points + i], bolts.x[frame]),
                  this.boltReference[2 * i + 1] + deformationScale * decoded(this.boltY[frame * points + i], bolts.y[frame]));
      }
      return { name, path, force: decoded(this.boltForce[frame * links + link], bolts.force[frame]),
               utilisation: this.boltUtilisation
                 ? decoded(this.boltUtilisation[frame * links + link], bolts.utilisation[frame]) : NaN,
               condition: ["elastic", "yielded", "broken", "waiting"][this.boltCondition[frame * links + link]] };
    });
    return all.filter(({ condition }) => condition !== "waiting");
  }

  // Where the contacts and forces of each frame begin.
  findContactsOfFrames() {
    this.firstContact = [0];
    this.firstForce = [0];
    for (const [locked, pulled, sliding, open] of this.header.contact_counts) {
      this.firstContact.push(this.firstContact.at(-1) + locked + pulled + sliding + open);
      this.firstForce.push(this.firstForce.at(-1) + locked + pulled + sliding);
    }
  }

  findBlockSizes() {
    const sizes = new Float32Array(this.blocks);
    for (let block = 0; block < this.blocks; ++block) sizes[block] = Math.sqrt(this.areaAndCentroid(this.reference, block)[0]);
    return sizes;
  }

  // [first, end) of the vertices of every ring of a block.
  ringsOf(block) {
    const { ring_begin: begins, block_begin: rings } = this.header;
    const found = [];
    for (let ring = rings[block]; ring < rings[block + 1]; ++ring) found.push([begins[ring], begins[ring + 1]]);
    return found;
  }

  // Positions x, y of all vertices, with motion drawn `deformationScale` times.
  positions(frame, deformationScale) {
    const count = this.reference.length / 2;
    const points = new Float32Array(2 * count);
    const { displacement_x: rangesX, displacement_y: rangesY } = this.header;
    for (let i = 0; i < count; ++i) {
      points[2 * i] = this.reference[2 * i] + deformationScale * decoded(this.x[frame * count + i], rangesX[frame]);
      points[2 * i + 1] = this.reference[2 * i + 1] + deformationScale * decoded(this.y[frame * count + i], rangesY[frame]);
    }
    return points;
  }

  value(quantity, frame, block) {
    const { codes, ranges } = this.quantities[quantity];
    return decoded(codes[frame * this.blocks + block], ranges[frame]);
  }

  // Blocks that have been removed, or are still to be added, are nowhere.
  isPresent(frame, block) {
    const [[first]] = this.ringsOf(block);
    return this.x[(frame * this.reference.length) / 2 + first] !== NO_NUMBER;
  }

  quantityIndex(id) {
    return this.quantities.findIndex((quantity) => quantity.id === id);
  }

  // Area and centroid of a block; holes count negative, as their rings run clockwise.
  areaAndCentroid(points, block) {
    let area = 0, x = 0, y = 0;
    const rings = this.ringsOf(block);
    const [x0, y0] = [points[2 * rings[0][0]], points[2 * rings[0][0] + 1]];
    for (const [begin, end] of rings) {
      for (let i = begin, before = end - 1; i < end; before = i++) {
        const ax = points[2 * before] - x0, ay = points[2 * before + 1] - y0;
        const bx = points[2 * i] - x0, by = points[2 * i + 1] - y0;
        const twice = ax * by - ay * bx;
        area += twice / 2;
        x += (twice * (ax + bx)) / 6;
        y += (twice * (ay + by)) / 6;
      }
    }
    return [area, x0 + x / area, y0 + y / area];
  }

  // The contacts of a frame: where they are in `points`, force on block b, status.
  contacts(frame, points) {
    const [locked, pulled, sliding] = this.header.contact_counts[frame];
    const unit = this.header.force_units[frame];
    const found = [];
    const count = this.firstContact[frame + 1] - this.firstContact[frame];
    for (let i = 0; i < count; ++i) {
      const site = 5 * this.contactSites[this.firstContact[frame] + i];
      const [a, b, from, to, fraction] = this.sites.subarray(site, site + 5);
      const share = fraction / 65536;
      const closed = i < locked + pulled + sliding;
      const force = 2 * (this.firstForce[frame] + i);
      found.push({
        a, b,
        x: points[2 * from] + share * (points[2 * to] - points[2 * from]),
        y: points[2 * from + 1] + share * (points[2 * to + 1] - points[2 * from + 1]),
        fx: closed ? unit * this.contactForces[force] : 0,
        fy: closed ? unit * this.contactForces[force + 1] : 0,
        pulls: i >= locked && i < locked + pulled,
        status: i < locked + pulled ? "locked" : closed ? "sliding" : "open",
      });
    }
    return found;
  }
}
