"use strict";
// Connects the page's buttons, lists and keys with the drawing.

const byId = (id) => document.getElementById(id);

// 0, then 1 to 10^5 in steps that the eye tells apart.
const deformationScaleOf = (slider) => (slider <= 0 ? 1 : Number((10 ** slider).toPrecision(2)));

function connectChoices(stage, refresh) {
  const { show, run } = stage;
  byId("quantity").replaceChildren(...run.quantities.map(({ title }, i) => new Option(title, i)));
  const choose = (id, read) => byId(id).addEventListener("input", () => {
    read(byId(id));
    refresh();
  });
  choose("quantity", (list) => (show.quantity = Number(list.value)));
  choose("range", (list) => (show.range = list.value));
  choose("forces", (list) => (show.forces = list.value));
  choose("thickness", (slider) => (show.thickness = 2 ** slider.value));
  choose("deformation", (slider) => (show.deformationScale = deformationScaleOf(slider.value)));
  for (const id of ["status", "crosses", "outlines", "bolts"]) choose(id, (box) => (show[id] = box.checked));
}

function connectPlayer(player) {
  const rates = [2, 5, 10, 24, 60];
  byId("speed").replaceChildren(...rates.map((rate) => new Option(rate, rate, false, rate === player.rate)));
  byId("speed").addEventListener("input", () => (player.rate = Number(byId("speed").value)));
  byId("loop").addEventListener("input", () => (player.loop = byId("loop").checked));
  byId("slider").max = player.frames - 1;
  byId("slider").addEventListener("input", () => player.go(byId("slider").value));
  const click = (id, action) => byId(id).addEventListener("click", action);
  click("play", () => player.toggle());
  click("first", () => player.go(0));
  click("back", () => player.go(player.frame - 1));
  click("forward", () => player.go(player.frame + 1));
  click("last", () => player.go(player.frames - 1));
}

// Drag, wheel, two fingers; and a click, which is a pointer that goes up where it went down.
function connectPointers(stage, redraw, readOut, choose) {
  const { canvas, camera } = stage;
  const down = new Map();
  let start = null; // of what may become a click
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, event);
    start = down.size === 1 ? event : null;
  });
  canvas.addEventListener("pointerup", (event) => {
    if (start && down.has(event.pointerId)) choose(event.offsetX, event.offsetY);
    start = null;
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => down.delete(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (!before) return readOut(event.offsetX, event.offsetY);
    if (start && Math.hypot(event.offsetX - start.offsetX, event.offsetY - start.offsetY) > 3) start = null;
    const other = [...down.values()].find((pointer) => pointer.pointerId !== event.pointerId);
    if (other) {
      const distance = (pointer) => Math.hypot(pointer.offsetX - other.offsetX, pointer.offsetY - other.offsetY);
      camera.zoom(distance(event) / Math.max(distance(before), 1), other.offsetX, other.offsetY);
    } else {
      camera.pan(event.offsetX - before.offsetX, event.offsetY - before.offsetY);
    }
    down.set(event.pointerId, event);
    redraw();
  });
  canvas.addEventListener("pointerleave", () => readOut(-1, -1));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    camera.zoom(Math.exp(-event.deltaY / 500), event.offsetX, event.offsetY);
    redraw();
  }, { passive: false });
}

function connectKeys(stage, player, redraw, fit) {
  const { camera } = stage;
  const view = (action) => () => {
    action();
    redraw();
  };
  const next = (id, step) => () => {
    const list = byId(id);
    list.selectedIndex = (list.selectedIndex + step + list.length) % list.length;
    list.dispatchEvent(new Event("input"));
  };
  const click = (id) => () => byId(id).click();
  const actions = {
    " ": ["Space", "play or pause", () => player.toggle()],
    ArrowLeft: ["\u2190", "back one frame", () => player.go(player.frame - 1)],
    ArrowRight: ["\u2192", "on one frame", () => player.go(player.frame + 1)],
    Home: ["Home", "first frame", () => player.go(0)],
    End: ["End", "last frame", () => player.go(player.frames - 1)],
    "+": ["+", "zoom in", view(() => camera.zoom(1.25))],
    "-": ["\u2212", "zoom out", view(() => camera.zoom(0.8))],
    0: ["0", "fit into the window", fit],
    w: ["w a s d", "move up, left, down, right", view(() => camera.pan(0, 60))],
    a: ["", "", view(() => camera.pan(60, 0))],
    s: ["", "", view(() => camera.pan(0, -60))],
    d: ["", "", view(() => camera.pan(-60, 0))],
    q: ["q", "next colour", next("quantity", 1)],
    Q: ["Q", "previous colour", next("quantity", -1)],
    r: ["r", "scale to run or frame", next("range", 1)],
    f: ["f", "contact forces", next("forces", 1)],
    c: ["c", "contact status", click("status")],
    x: ["x", "principal stresses", click("crosses")],
    o: ["o", "outlines", click("outlines")],
    p: ["p", "the picture as a file", click("picture")],
    ...(stage.run.header.bolts && { b: ["b", "bolts", click("bolts")] }),
  };
  fillTable("shortcuts", Object.values(actions).filter(([key]) => key).map(([key, what]) => {
    return [Object.assign(document.createElement("kbd"), { textContent: key }), what];
  }));
  document.addEventListener("keydown", (event) => {
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target.closest("select, input[type=range]")) return; // they have uses of their own for these keys
    if (event.key === " " && event.target.closest("button, input, summary")) return;
    event.preventDefault();
    action[2]();
  });
}
