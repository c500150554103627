// The table of figures: sorted by any head, filtered by technique, scene and light, its details folded away.
{
  const table = document.querySelector("table.figures");
  const filters = document.getElementById("filters");

  // A first click on a head sorts upwards, a second one downwards. Cells carry their exact figure in data-value;
  // absent ones stay at the end.
  const sortBy = (head, column) => {
    const rising = head.getAttribute("aria-sort") !== "ascending";
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", rising ? "ascending" : "descending");
    const isName = head.classList.contains("name");
    const value = record => record.rows[0].cells[column].dataset.value;
    const compare = (a, b) => {
      const [x, y] = [value(a), value(b)];
      if (x === "" || y === "") return (x === "") - (y === "");
      return (rising ? 1 : -1) * (isName ? x.localeCompare(y, "en", { numeric: true }) : x - y);
    };
    table.append(...[...table.tBodies].sort(compare));
  };

  // Every word typed, in the title or in the name.
  const isFound = record => filters.elements.find.value.toLowerCase().split(/\s+/).every(word =>
    `${record.dataset.shown} ${record.dataset.technique}`.toLowerCase().includes(word));

  const filter = () => {
    const wanted = ["technique", "scene", "light"].map(name => [name, filters.elements[name].value]);
    let shown = 0;
    for (const record of table.tBodies) {
      record.hidden = !isFound(record) || wanted.some(([name, value]) =>
        value === "" ? name === "scene" && record.dataset.scene === "mean" : record.dataset[name] !== value);
      shown += record.hidden ? 0 : 1;
    }
    filters.querySelector("output").textContent = `${shown} ${shown === 1 ? "row" : "rows"}`;
  };

  const unfold = button => {
    const detail = document.getElementById(button.getAttribute("aria-controls"));
    const open = detail.classList.toggle("open");
    button.setAttribute("aria-expanded", open);
    button.textContent = open ? "Less" : "More";
  };

  if (table) {
    [...table.tHead.rows[0].cells].forEach((head, column) =>
      head.querySelector("button")?.addEventListener("click", () => sortBy(head, column)));
    for (const button of table.querySelectorAll(".unfold")) {
      button.setAttribute("aria-expanded", "false");
      button.addEventListener("click", () => unfold(button));
    }
    for (const button of table.querySelectorAll(".about")) {
      tooltip.attach(button, () => [...document.getElementById(button.dataset.tip).cloneNode(true).children]);
    }
    filters.addEventListener("input", filter);
    filters.addEventListener("reset", () => setTimeout(filter));
    filters.addEventListener("submit", event => event.preventDefault());
    filter();
  }
}
