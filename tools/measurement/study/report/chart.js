// Points of the charts: pointed at or focused, each says what it is and shows its technique in every panel; arrow
// keys go from point to point; a click shows the technique's rows in the table.
for (const group of document.querySelectorAll(".chart .points")) {
  const points = [...group.querySelectorAll(".point")];
  const byCost = [...points].sort((a, b) =>
    a.querySelector(".ring").getAttribute("cx") - b.querySelector(".ring").getAttribute("cx"));
  const focusOn = point => {
    for (const other of points) other.setAttribute("tabindex", other === point ? "0" : "-1");
    point.focus();
  };
  const light = on => point => {
    for (const other of document.querySelectorAll(".chart .point")) {
      other.classList.toggle("lit", on && other.dataset.technique === point.dataset.technique);
    }
  };
  const words = point => {
    const name = document.createElement("strong");
    name.textContent = point.dataset.label;
    return [name, point.dataset.note];
  };
  byCost.forEach((point, place) => {
    point.setAttribute("tabindex", place === 0 ? "0" : "-1");
    tooltip.attach(point, words, light(true), light(false));
    point.addEventListener("keydown", event => {
      const step = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
      if (!step) return;
      event.preventDefault();
      focusOn(byCost[(place + step + byCost.length) % byCost.length]);
    });
    point.addEventListener("click", () => {
      const filters = document.getElementById("filters");
      if (!filters) return;
      filters.elements.technique.value = point.dataset.technique;
      filters.elements.find.value = "";
      filters.dispatchEvent(new Event("input"));
      tooltip.hide();
    });
  });
}
