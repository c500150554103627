// The picture viewer: two pictures of one scene and light over each other, behind a border that the reader moves or
// by turns, enlarged, with the error as strong as the reader sets it.
class Viewer {
  static kBlink = 700;      // milliseconds; far from the three flashes a second that can do harm
  static kScales = [0.01, 1];  // errors in full colour: least and most, on a logarithmic slider

  constructor(root, index) {
    this.root = root;
    this.stages = index.stages;
    this.pixels = new Pixels(index);
    this.form = root.querySelector("form");
    this.stageBox = root.querySelector(".stage");
    this.canvas = this.stageBox.querySelector("canvas");
    this.divider = root.querySelector(".divider");
    this.border = 0.5;             // share of the width left of the border
    this.view = { zoom: 1, x: 0.5, y: 0.5 };  // zoom 1 fits; the point in the middle, as shares of the picture
    this.swapped = false;
    this.turn = false;             // blinking: whether the right picture shows
    // The widest light of the first scene: there techniques differ most.
    this.stage = this.stages.findLast(stage => stage.scene === this.stages[0].scene);
    this.item = this.#best();
    this.errorScale = this.item.errorScale;
    this.shown = null;             // { left, right }: canvases and what they are called
    this.#fillControls();
    this.#listen();
    this.#showStage();
  }

  get kind() { return this.form.elements.kind.value; }
  get mode() { return this.form.elements.mode.value; }

  open(id) {
    const stage = this.stages.find(each => each.items.some(item => item.id === id));
    if (!stage) return false;
    this.stage = stage;
    this.item = stage.items.find(item => item.id === id);
    this.form.elements.left.value = "";
    this.form.elements.kind.value = "result";
    this.#showStage();
    return true;
  }

  // Of the first scene, the technique nearest to ray tracing.
  #best() {
    const rmse = item => item.rmse ?? Infinity;
    return this.stage.items.reduce((best, item) => rmse(item) < rmse(best) ? item : best);
  }

  #option(select, value, text) {
    const option = document.createElement("option");
    option.value = value;
    option.textContent = text;
    select.append(option);
  }

  #fillControls() {
    const { scene, light } = this.form.elements;
    const once = values => [...new Set(values)];
    for (const name of once(this.stages.map(stage => stage.scene))) this.#option(scene, name, name);
    for (const degrees of once(this.stages.map(stage => stage.light)).sort((a, b) => a - b)) {
      this.#option(light, degrees, `${degrees}°`);
    }
    const range = this.root.querySelector("[name=scale]");
    const [least, most] = Viewer.kScales;
    range.value = 100 * Math.log(this.errorScale / least) / Math.log(most / least);
  }

  // Controls follow the scene: its techniques, what the left side may hold.
  #showStage() {
    const { scene, light, left } = this.form.elements;
    // All of it fits a window, controls included.
    this.stageBox.style.maxWidth = `calc(70vh * ${this.stage.width / this.stage.height})`;
    scene.value = this.stage.scene;
    light.value = this.stage.light;
    const before = left.value;
    left.replaceChildren();
    this.#option(left, "", "Ray traced");
    this.#option(left, "same", "Result");
    for (const item of this.stage.items) this.#option(left, `item-${item.technique}`, item.technique);
    left.value = before;
    if (left.selectedIndex < 0) left.value = "";
    const list = this.root.querySelector(".techniques");
    list.replaceChildren(...this.stage.items.map(item => {
      const button = document.createElement("button");
      button.type = "button";
      const rmse = document.createElement("small");
      rmse.textContent = item.rmse === undefined ? "" : item.rmse.toFixed(3);
      rmse.title = "RMSE in penumbra";
      button.append(item.technique, rmse);
      button.addEventListener("click", () => this.#choose(item));
      return button;
    }));
    this.pixels.forget();
    this.#choose(this.item);
  }

  #choose(item) {
    this.item = item;
    [...this.root.querySelectorAll(".techniques button")].forEach((button, i) =>
      button.setAttribute("aria-pressed", this.stage.items[i] === item));
    for (const kind of ["fetches", "mask"]) {
      const radio = this.form.querySelector(`[value=${kind}]`);
      radio.disabled = item[kind] === undefined;
      if (radio.disabled && radio.checked) this.form.elements.kind.value = "result";
    }
    return this.#load();
  }

  async #layer(item, kind) {
    const { width, height } = this.stage;
    const planes = { receivers: await this.pixels.grey(this.stage.receivers),
      invalid: item && kind !== "fetches" && kind !== "mask" ? await this.pixels.grey(item.invalid) : null };
    const reference = await this.pixels.grey(this.stage.reference);
    const paint = (ramp, share) => this.pixels.paint(width, height, planes, ramp, share);
    if (!item) return { name: "Ray traced", canvas: paint(null, i => reference[i] / 255) };
    if (kind === "fetches") {
      const counts = await this.pixels.grey(item.fetches);
      return { name: `${item.technique}: fetches`,
        canvas: paint(this.pixels.ramps.fetches, i => counts[i] / item.fetchScale) };
    }
    if (kind === "mask") {
      const mask = await this.pixels.grey(item.mask);
      return { name: `${item.technique}: mask`, canvas: paint(null, i => mask[i] / 255) };
    }
    const result = await this.pixels.grey(item.result);
    if (kind === "result") return { name: item.technique, canvas: paint(null, i => result[i] / 255) };
    const scale = this.errorScale;
    return { name: `${item.technique}: error`,
      canvas: paint(this.pixels.ramps.error, i => ((result[i] - reference[i]) / 255 / scale + 1) / 2) };
  }

  #leftItem() {
    const value = this.form.elements.left.value;
    if (value === "") return null;
    return value === "same" ? this.item : this.stage.items.find(item => `item-${item.technique}` === value);
  }

  // Decodes and paints both sides; a later call overtakes an earlier one.
  async #load() {
    const ticket = this.ticket = {};
    const left = this.#leftItem();
    const leftKind = left && this.form.elements.left.value !== "same" && left[this.kind] !== undefined
      ? this.kind : left && this.kind === "error" && left !== this.item ? "error" : "result";
    const sides = await Promise.all([this.#layer(left, leftKind), this.#layer(this.item, this.kind)]);
    if (ticket !== this.ticket) return;
    this.shown = this.swapped ? { left: sides[1], right: sides[0] } : { left: sides[0], right: sides[1] };
    this.planes = { receivers: await this.pixels.grey(this.stage.receivers),
      reference: await this.pixels.grey(this.stage.reference), result: await this.pixels.grey(this.item.result),
      fetches: await this.pixels.grey(this.item.fetches) };
    this.#legend();
    this.draw();
  }

  #legend() {
    const legend = this.root.querySelector(".legend");
    const [from, to] = { error: [`−${this.errorScale} too dark`, `+${this.errorScale} too bright`],
      fetches: ["0 fetches", `${this.item.fetchScale}`] }[this.kind] ?? ["0 hidden", "1 lit"];
    legend.querySelector(".from").textContent = from;
    legend.querySelector(".to").textContent = to;
    const strip = legend.querySelector("canvas");
    strip.setAttribute("aria-label", `colours from ${from} to ${to}`);
    const receivers = new Uint8Array(256).fill(1);
    strip.getContext("2d").drawImage(
      this.pixels.paint(256, 1, { receivers }, this.pixels.ramps[this.kind] ?? null, i => i / 255), 0, 0);
    this.root.querySelector(".scale output").textContent = `${this.errorScale}`;
    this.root.querySelector(".scale").hidden = this.kind !== "error";
  }

  // Picture pixels to canvas pixels.
  #transform() {
    const { width, height } = this.stage;
    const factor = this.canvas.width / width * this.view.zoom;
    return { factor, x: this.canvas.width / 2 - this.view.x * width * factor,
      y: this.canvas.height / 2 - this.view.y * height * factor };
  }

  #keepInside() {
    const half = 0.5 / this.view.zoom;
    for (const axis of ["x", "y"]) this.view[axis] = Math.min(Math.max(this.view[axis], half), 1 - half);
  }

  draw() {
    if (!this.shown) return;
    const { width, height } = this.stage;
    const size = Math.max(1, Math.round(this.stageBox.clientWidth * devicePixelRatio));
    this.canvas.width = size;
    this.canvas.height = Math.round(size * height / width);
    this.#keepInside();
    const context = this.canvas.getContext("2d");
    const { factor, x, y } = this.#transform();
    context.imageSmoothingEnabled = factor < 1;
    const part = (layer, from, to) => {
      context.save();
      context.beginPath();
      context.rect(from, 0, to - from, this.canvas.height);
      context.clip();
      context.drawImage(layer.canvas, x, y, width * factor, height * factor);
      context.restore();
    };
    const blinks = this.mode === "blink";
    const border = Math.round(blinks ? (this.turn ? 0 : size) : this.border * size);
    part(this.shown.left, 0, border);
    part(this.shown.right, border, size);
    this.#words(blinks, factor);
  }

  #words(blinks, factor) {
    const { left, right } = this.shown;
    const [leftTag, rightTag] = this.stageBox.querySelectorAll(".tag");
    leftTag.textContent = left.name;
    rightTag.textContent = right.name;
    leftTag.hidden = blinks && this.turn;
    rightTag.hidden = blinks && !this.turn;
    this.divider.hidden = blinks;
    this.divider.style.left = `${100 * this.border}%`;
    this.divider.setAttribute("aria-valuenow", Math.round(100 * this.border));
    this.stageBox.classList.toggle("enlarged", this.view.zoom > 1);
    this.canvas.setAttribute("aria-label",
      `${this.stage.scene}, ${this.stage.light} degree light: ${left.name} and ${right.name}`);
    this.root.querySelector(".zoom output").textContent = `${Math.round(100 * factor / devicePixelRatio)} %`;
  }

  #moveBorder(share) {
    this.border = Math.min(Math.max(share, 0), 1);
    this.draw();
  }

  // Around a point of the stage, in shares of it.
  #zoom(by, at = { x: 0.5, y: 0.5 }) {
    const { view } = this;
    const before = view.zoom;
    view.zoom = Math.min(Math.max(before * by, 1), 64);
    for (const axis of ["x", "y"]) view[axis] += (at[axis] - 0.5) * (1 / before - 1 / view.zoom);
    this.draw();
  }

  #pan(x, y) {
    this.view.x -= x / this.view.zoom;
    this.view.y -= y / this.view.zoom;
    this.draw();
  }

  #setMode(mode) {
    this.form.elements.mode.value = mode;
    clearInterval(this.timer);
    this.turn = true;
    if (mode === "blink") this.timer = setInterval(() => { this.turn = !this.turn; this.draw(); }, Viewer.kBlink);
    this.draw();
  }

  #next(step) {
    const { items } = this.stage;
    this.#choose(items[(items.indexOf(this.item) + step + items.length) % items.length]);
  }

  #shareOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height };
  }

  #readOut(event) {
    const { width, height } = this.stage;
    const at = this.#shareOf(event);
    const column = Math.floor((this.view.x + (at.x - 0.5) / this.view.zoom) * width);
    const row = Math.floor((this.view.y + (at.y - 0.5) / this.view.zoom) * height);
    const i = row * width + column;
    const line = this.root.querySelector(".readout");
    if (!this.planes || column < 0 || column >= width || row < 0 || row >= height) return;
    const { receivers, reference, result, fetches } = this.planes;
    const number = value => value.toFixed(3).replace("-", "−");
    line.textContent = `Pixel ${column}, ${row}: ` + (receivers[i] === 0 ? "no surface" :
      `ray traced ${number(reference[i] / 255)}, ${this.item.technique} ${number(result[i] / 255)}, ` +
      `error ${number((result[i] - reference[i]) / 255)}` + (fetches ? `, ${fetches[i]} fetches` : ""));
  }

  #listen() {
    this.form.addEventListener("submit", event => event.preventDefault());
    this.form.addEventListener("change", event => {
      const { scene, light } = this.form.elements;
      if (event.target === scene || event.target === light) {
        const found = this.stages.find(stage => stage.scene === scene.value && String(stage.light) === light.value) ??
          this.stages.find(stage => stage.scene === scene.value);
        this.stage = found;
        this.item = found.items.find(item => item.technique === this.item.technique) ?? found.items[0];
        this.#showStage();
      } else if (event.target.name === "mode") this.#setMode(this.mode);
      else this.#load();
    });
    const range = this.root.querySelector("[name=scale]");
    range.addEventListener("input", () => {
      const [least, most] = Viewer.kScales;
      this.errorScale = Number((least * (most / least) ** (range.value / 100)).toPrecision(2));
      this.#load();
    });
    const zoom = { in: 2, out: 0.5, fit: 0 };
    for (const [name, by] of Object.entries(zoom)) {
      this.root.querySelector(`[name=${name}]`).addEventListener("click", () => this.#zoom(by));
    }
    this.stageBox.addEventListener("keydown", event => this.#key(event));
    this.#listenToPointers();
    new ResizeObserver(() => this.draw()).observe(this.stageBox);
  }

  #key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const onBorder = event.target === this.divider;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const border = { ",": -0.02, ".": 0.02, PageUp: 0.1, PageDown: -0.1, Home: -1, End: 1 };
    const letters = { "+": () => this.#zoom(2), "=": () => this.#zoom(2), "-": () => this.#zoom(0.5), 0: () => this.#zoom(0),
      b: () => this.#setMode(this.mode === "blink" ? "slider" : "blink"),
      x: () => { this.swapped = !this.swapped; this.#load(); }, n: () => this.#next(1), p: () => this.#next(-1) };
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (key in arrows && onBorder) this.#moveBorder(this.border + 0.02 * (arrows[key][0] - arrows[key][1]));
    else if (key in arrows) this.#pan(-0.1 * arrows[key][0], -0.1 * arrows[key][1]);
    else if (key in border) this.#moveBorder(this.border + border[key]);
    else if (key in letters) letters[key]();
    else return;
    event.preventDefault();
  }

  // One pointer moves the border (the picture, once it is enlarged), two zoom.
  #listenToPointers() {
    const pointers = new Map();
    let dragsBorder = false;
    const spread = () => {
      const [a, b] = [...pointers.values()];
      return { length: Math.hypot(a.x - b.x, a.y - b.y), x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
    };
    this.stageBox.addEventListener("pointerdown", event => {
      if (event.button !== 0) return;
      pointers.set(event.pointerId, this.#shareOf(event));
      this.stageBox.setPointerCapture(event.pointerId);
      dragsBorder = this.mode === "slider" && (this.view.zoom === 1 || this.divider.contains(event.target));
      if (dragsBorder && pointers.size === 1) this.#moveBorder(this.#shareOf(event).x);
    });
    this.stageBox.addEventListener("pointermove", event => {
      this.#readOut(event);
      const before = pointers.get(event.pointerId);
      if (!before) return;
      const at = this.#shareOf(event);
      const old = pointers.size === 2 ? spread() : null;
      pointers.set(event.pointerId, at);
      if (old) this.#zoom(spread().length / Math.max(old.length, 1e-3), spread());
      else if (dragsBorder) this.#moveBorder(at.x);
      else this.#pan(at.x - before.x, at.y - before.y);
    });
    const release = event => pointers.delete(event.pointerId);
    this.stageBox.addEventListener("pointerup", release);
    this.stageBox.addEventListener("pointercancel", release);
    this.stageBox.addEventListener("wheel", event => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      this.#zoom(2 ** (-event.deltaY / 200), this.#shareOf(event));
    }, { passive: false });
  }
}

{
  const root = document.getElementById("viewer");
  const index = document.getElementById("picture-index");
  if (root && index) {
    const content = JSON.parse(index.textContent);
    for (const [name, value] of [["no-receiver", content.noReceiver], ["invalid", content.invalid]]) {
      document.querySelector(`.swatch.${name}`).style.background = value;
    }
    const viewer = new Viewer(root, content);
    // A row of the table leads to "#picture-N".
    const follow = () => {
      const match = /^#picture-(\d+)$/.exec(location.hash);
      if (!match || !viewer.open(Number(match[1]))) return;
      document.getElementById("pictures").scrollIntoView();
      viewer.stageBox.focus({ preventScroll: true });
    };
    addEventListener("hashchange", follow);
    // The same link twice changes no hash.
    for (const link of document.querySelectorAll("a.to-pictures")) {
      link.addEventListener("click", () => { if (link.hash === location.hash) follow(); });
    }
    follow();
  }
}
