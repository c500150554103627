// What part of a picture shows, and where the border between left and right is: all in shares, so that it stays when
// the window or the picture changes.
class View {
  static kMost = 64;  // times the size that fits

  constructor() {
    this.border = 0.5;  // share of the width left of the border
    this.zoom = 1;      // 1 fits
    this.x = 0.5;       // the point in the middle, of the picture
    this.y = 0.5;
  }

  moveBorder(share) { this.border = Math.min(Math.max(share, 0), 1); }

  // Around a point of the stage.
  zoomBy(factor, at = { x: 0.5, y: 0.5 }) {
    const before = this.zoom;
    this.zoom = Math.min(Math.max(before * factor, 1), View.kMost);
    this.x += (at.x - 0.5) * (1 / before - 1 / this.zoom);
    this.y += (at.y - 0.5) * (1 / before - 1 / this.zoom);
    this.#keepInside();
  }

  // By shares of the stage; the picture follows the hand.
  pan(x, y) {
    this.x -= x / this.zoom;
    this.y -= y / this.zoom;
    this.#keepInside();
  }

  // From a point of the stage to one of the picture.
  pointAt(at) { return { x: this.x + (at.x - 0.5) / this.zoom, y: this.y + (at.y - 0.5) / this.zoom }; }

  // Where a picture of this size lies on a canvas: canvas pixels per pixel, and its left upper corner.
  place(width, height, canvas) {
    const factor = canvas.width / width * this.zoom;
    return { factor, left: canvas.width / 2 - this.x * width * factor, top: canvas.height / 2 - this.y * height * factor };
  }

  #keepInside() {
    const half = 0.5 / this.zoom;
    this.x = Math.min(Math.max(this.x, half), 1 - half);
    this.y = Math.min(Math.max(this.y, half), 1 - half);
  }
}
