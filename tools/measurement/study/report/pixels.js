// Pictures as numbers, and numbers as colours.
//
// The page holds each picture as a grey PNG: visibility in 255ths, or fetches. It is decoded when it is first shown.
// Colours come from the tables that the page brings (the ones that also draw the picture files).
class Pixels {
  constructor(index) {
    const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
    const colour = hex => [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16));
    this.ramps = { error: bytes(index.ramps.error), fetches: bytes(index.ramps.fetches) };
    this.noReceiver = colour(index.noReceiver);
    this.invalid = colour(index.invalid);
    this.decoded = new Map();
  }

  // The samples of a picture; undefined has none.
  grey(id) {
    if (id === undefined) return Promise.resolve(null);
    if (!this.decoded.has(id)) this.decoded.set(id, this.#decode(id));
    return this.decoded.get(id);
  }

  forget() { this.decoded.clear(); }

  #decode(id) {
    return new Promise((resolve, reject) => {
      const image = new Image();
      image.onerror = () => reject(new Error(`picture ${id} cannot be decoded`));
      image.onload = () => {
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
        const context = canvas.getContext("2d", { willReadFrequently: true });
        context.drawImage(image, 0, 0);
        const rgba = context.getImageData(0, 0, canvas.width, canvas.height).data;
        resolve(Uint8Array.from({ length: rgba.length / 4 }, (_, i) => rgba[4 * i]));
      };
      image.src = "data:image/png;base64," + document.getElementById(`png-${id}`).textContent;
    });
  }

  // share: 0 is the ramp's first colour, 1 its last. Returns the place of its red byte in the ramp.
  static placeIn(ramp, share) {
    const last = ramp.length / 3 - 1;
    return 3 * Math.round(Math.min(Math.max(share, 0), 1) * last);
  }

  // A canvas of the picture's own size. share(i): of pixel i; without a ramp it is a grey.
  paint(width, height, planes, ramp, share) {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [width, height];
    const image = new ImageData(width, height);
    const out = image.data;
    const set = (i, red, green, blue) => { out[i] = red; out[i + 1] = green; out[i + 2] = blue; out[i + 3] = 255; };
    for (let i = 0; i < width * height; ++i) {
      if (planes.receivers[i] === 0) set(4 * i, ...this.noReceiver);
      else if (planes.invalid?.[i]) set(4 * i, ...this.invalid);
      else if (ramp) {
        const place = Pixels.placeIn(ramp, share(i));
        set(4 * i, ramp[place], ramp[place + 1], ramp[place + 2]);
      } else {
        const grey = Math.round(255 * share(i));
        set(4 * i, grey, grey, grey);
      }
    }
    canvas.getContext("2d").putImageData(image, 0, 0);
    return canvas;
  }
}
