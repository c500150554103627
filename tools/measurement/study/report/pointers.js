// Mouse, pen and fingers on the viewer's stage: one pointer drags, two zoom, the wheel zooms with Ctrl. Places are
// shares of the stage. heard: { press(at, target), drag(from, to), point(at), zoom(factor, at) }.
const listenToPointers = (stage, heard) => {
  const pointers = new Map();
  const shareOf = event => {
    const box = stage.getBoundingClientRect();
    return { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height };
  };
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return { length: Math.max(Math.hypot(a.x - b.x, a.y - b.y), 1e-3), x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  };
  stage.addEventListener("pointerdown", event => {
    if (event.button !== 0) return;
    pointers.set(event.pointerId, shareOf(event));
    stage.setPointerCapture(event.pointerId);
    if (pointers.size === 1) heard.press(shareOf(event), event.target);
  });
  stage.addEventListener("pointermove", event => {
    const at = shareOf(event);
    heard.point(at);
    const from = pointers.get(event.pointerId);
    if (!from) return;
    const before = pointers.size === 2 ? spread() : null;
    pointers.set(event.pointerId, at);
    if (before) heard.zoom(spread().length / before.length, spread());
    else heard.drag(from, at);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    stage.addEventListener(end, event => pointers.delete(event.pointerId));
  }
  stage.addEventListener("wheel", event => {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    heard.zoom(2 ** (-event.deltaY / 200), shareOf(event));
  }, { passive: false });
};
