// The pictures that a side of the viewer can hold, painted from numbers: reference, result, error, fetches, mask.
class Layers {
  constructor(index) { this.pixels = new Pixels(index); }

  forget() { this.pixels.forget(); }

  // Without an item the ray-traced reference. A layer is what it is called, and a canvas of the picture's size.
  async of(stage, item, kind, errorScale) {
    const grey = id => this.pixels.grey(id);
    const isVisibility = item && (kind === "result" || kind === "error");
    const planes = { receivers: await grey(stage.receivers), invalid: isVisibility ? await grey(item.invalid) : null };
    const paint = (ramp, share) => this.pixels.paint(stage.width, stage.height, planes, ramp, share);
    const reference = await grey(stage.reference);
    if (!item) return { name: "Ray traced", canvas: paint(null, i => reference[i] / 255) };
    const values = await grey(item[kind === "error" ? "result" : kind]);
    const { ramps } = this.pixels;
    const canvas = {
      result: () => paint(null, i => values[i] / 255),
      mask: () => paint(null, i => values[i] / 255),
      fetches: () => paint(ramps.fetches, i => values[i] / item.fetchScale),
      error: () => paint(ramps.error, i => ((values[i] - reference[i]) / 255 / errorScale + 1) / 2),
    }[kind]();
    return { name: kind === "result" ? item.shown : `${item.shown}: ${kind}`, canvas };
  }

  // What the colours of a kind mean, from one end to the other, and a strip of them.
  legend(item, kind, errorScale) {
    const [from, to] = { error: [`−${errorScale} too dark`, `+${errorScale} too bright`],
      fetches: ["0 fetches", `${item.fetchScale}`], mask: ["spared", "filtered"] }[kind] ?? ["0 hidden", "1 lit"];
    const receivers = new Uint8Array(256).fill(1);
    return { from, to, strip: this.pixels.paint(256, 1, { receivers }, this.pixels.ramps[kind] ?? null, i => i / 255) };
  }

  // The numbers behind one pixel, in words.
  async words(stage, item, column, row) {
    const i = row * stage.width + column;
    const [receivers, reference, result, fetches] = await Promise.all(
      [stage.receivers, stage.reference, item.result, item.fetches].map(id => this.pixels.grey(id)));
    const number = value => (value / 255).toFixed(3).replace("-", "−");
    return `Pixel ${column}, ${row}: ` + (receivers[i] === 0 ? "no surface" :
      `ray traced ${number(reference[i])}, ${item.shown} ${number(result[i])}, ` +
      `error ${number(result[i] - reference[i])}` + (fetches ? `, ${fetches[i]} fetches` : ""));
  }
}
