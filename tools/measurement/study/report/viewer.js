// The picture viewer: two pictures of one scene and light over each other, behind a border that the reader moves or
// by turns, enlarged, with the error as strong as the reader sets it.
class Viewer {
  static kBlink = 700;      // milliseconds; far from the three flashes a second that can do harm
  static kScales = [0.01, 1];  // errors in full colour: least and most, on a logarithmic slider

  constructor(root, index) {
    this.root = root;
    this.stages = index.stages;
    this.layers = new Layers(index);
    this.form = root.querySelector("form");
    this.stageBox = root.querySelector(".stage");
    this.canvas = this.stageBox.querySelector("canvas");
    this.divider = root.querySelector(".divider");
    this.view = new View();
    this.swapped = false;
    this.turn = false;  // blinking: whether the right picture shows
    // The widest light of the first scene: there techniques differ most.
    this.stage = this.stages.findLast(stage => stage.scene === this.stages[0].scene);
    this.item = this.#best();
    this.errorScale = this.item.errorScale;
    this.shown = null;  // { left, right }: layers
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
    for (const item of this.stage.items) this.#option(left, `item-${item.technique}`, item.shown);
    left.value = before;
    if (left.selectedIndex < 0) left.value = "";
    const list = this.root.querySelector(".techniques");
    list.replaceChildren(...this.stage.items.map(item => {
      const button = document.createElement("button");
      button.type = "button";
      const rmse = document.createElement("small");
      rmse.textContent = item.rmse === undefined ? "" : item.rmse.toFixed(3);
      rmse.title = "RMSE in penumbra";
      button.title = item.technique;
      button.append(item.shown, rmse);
      button.addEventListener("click", () => this.#choose(item));
      return button;
    }));
    this.layers.forget();
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

  #leftItem() {
    const value = this.form.elements.left.value;
    if (value === "") return null;
    return value === "same" ? this.item : this.stage.items.find(item => `item-${item.technique}` === value);
  }

  // The left side shows the right one's kind when it holds another technique, and a result otherwise.
  #leftKind(left) {
    const other = left !== null && left !== this.item;
    return other && (this.kind === "error" || left[this.kind] !== undefined) ? this.kind : "result";
  }

  // Decodes and paints both sides; a later call overtakes an earlier one.
  async #load() {
    const ticket = this.ticket = {};
    const left = this.#leftItem();
    const [first, second] = await Promise.all([
      this.layers.of(this.stage, left, this.#leftKind(left), this.errorScale),
      this.layers.of(this.stage, this.item, this.kind, this.errorScale)]);
    if (ticket !== this.ticket) return;
    this.shown = this.swapped ? { left: second, right: first } : { left: first, right: second };
    this.draw();
    this.#legend();
  }

  #legend() {
    const { from, to, strip } = this.layers.legend(this.item, this.kind, this.errorScale);
    const legend = this.root.querySelector(".legend");
    legend.querySelector(".from").textContent = from;
    legend.querySelector(".to").textContent = to;
    legend.querySelector("canvas").setAttribute("aria-label", `colours from ${from} to ${to}`);
    legend.querySelector("canvas").getContext("2d").drawImage(strip, 0, 0);
    this.root.querySelector(".scale output").textContent = `${this.errorScale}`;
    this.root.querySelector(".scale").hidden = this.kind !== "error";
  }

  draw() {
    if (!this.shown) return;
    const { width, height } = this.stage;
    const size = Math.max(1, Math.round(this.stageBox.clientWidth * devicePixelRatio));
    this.canvas.width = size;
    this.canvas.height = Math.round(size * height / width);
    const context = this.canvas.getContext("2d");
    const { factor, left, top } = this.view.place(width, height, this.canvas);
    context.imageSmoothingEnabled = factor < 1;
    const part = (layer, from, to) => {
      context.save();
      context.beginPath();
      context.rect(from, 0, to - from, this.canvas.height);
      context.clip();
      context.drawImage(layer.canvas, left, top, width * factor, height * factor);
      context.restore();
    };
    const blinks = this.mode === "blink";
    const border = Math.round(blinks ? (this.turn ? 0 : size) : this.view.border * size);
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
    this.divider.style.left = `${100 * this.view.border}%`;
    this.divider.setAttribute("aria-valuenow", Math.round(100 * this.view.border));
    this.stageBox.classList.toggle("enlarged", this.view.zoom > 1);
    this.canvas.setAttribute("aria-label",
      `${this.stage.scene}, ${this.stage.light} degree light: ${left.name} and ${right.name}`);
    this.root.querySelector(".zoom output").textContent = `${Math.round(100 * factor / devicePixelRatio)} %`;
  }

  #moveBorder(share) {
    this.view.moveBorder(share);
    this.draw();
  }

  #zoom(by, at) {
    this.view.zoomBy(by, at);
    this.draw();
  }

  #pan(x, y) {
    this.view.pan(x, y);
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

  async #readOut(at) {
    const { width, height } = this.stage;
    const point = this.view.pointAt(at);
    const [column, row] = [Math.floor(point.x * width), Math.floor(point.y * height)];
    if (column < 0 || column >= width || row < 0 || row >= height) return;
    this.root.querySelector(".readout").textContent = await this.layers.words(this.stage, this.item, column, row);
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
    if (key in arrows && onBorder) this.#moveBorder(this.view.border + 0.02 * (arrows[key][0] - arrows[key][1]));
    else if (key in arrows) this.#pan(-0.1 * arrows[key][0], -0.1 * arrows[key][1]);
    else if (key in border) this.#moveBorder(this.view.border + border[key]);
    else if (key in letters) letters[key]();
    else return;
    event.preventDefault();
  }

  // A drag moves the border, and the picture once it is enlarged.
  #listenToPointers() {
    let dragsBorder = false;
    listenToPointers(this.stageBox, {
      press: (at, target) => {
        dragsBorder = this.mode === "slider" && (this.view.zoom === 1 || this.divider.contains(target));
        if (dragsBorder) this.#moveBorder(at.x);
      },
      drag: (from, to) => dragsBorder ? this.#moveBorder(to.x) : this.#pan(to.x - from.x, to.y - from.y),
      point: at => this.#readOut(at),
      zoom: (factor, at) => this.#zoom(factor, at),
    });
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
