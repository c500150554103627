"use strict";
// One tooltip for the whole page. It opens where a pointer rests or the focus is, stays while the pointer is on it,
// and Escape closes it (WCAG 2.2, 1.4.13). Content is made of nodes and text, never of markup.
const tooltip = (() => {
  const box = document.getElementById("tooltip");
  let owner = null;
  let leaving = 0;

  const place = () => {
    const at = owner.getBoundingClientRect();
    const own = box.getBoundingClientRect();
    const gap = 8;
    const above = at.top - own.height - gap;
    const top = at.bottom + gap + own.height <= innerHeight || above < gap ? at.bottom + gap : above;
    const left = at.left + at.width / 2 - own.width / 2;
    box.style.top = `${top}px`;
    box.style.left = `${Math.max(gap, Math.min(left, document.documentElement.clientWidth - own.width - gap))}px`;
  };
  const hide = () => {
    clearTimeout(leaving);
    owner?.removeAttribute("aria-describedby");
    owner = null;
    box.hidden = true;
  };
  const show = (element, content) => {
    hide();
    owner = element;
    box.replaceChildren(...content);
    box.hidden = false;
    owner.setAttribute("aria-describedby", "tooltip");
    place();
  };
  const hideSoon = () => { leaving = setTimeout(hide, 150); };

  box.addEventListener("pointerenter", () => clearTimeout(leaving));
  box.addEventListener("pointerleave", hideSoon);
  addEventListener("keydown", event => { if (event.key === "Escape") hide(); });
  addEventListener("scroll", () => { if (owner) place(); }, { capture: true, passive: true });

  // content(element) makes the nodes; onShow and onHide, when given, hear of it.
  const attach = (element, content, onShow, onHide) => {
    const open = () => { show(element, content(element)); onShow?.(element); };
    const close = later => { onHide?.(element); if (owner === element) later(); };
    element.addEventListener("pointerenter", open);
    element.addEventListener("focus", open);
    element.addEventListener("pointerleave", () => { if (document.activeElement !== element) close(hideSoon); });
    element.addEventListener("blur", () => close(hide));
  };
  return { attach, hide };
})();
