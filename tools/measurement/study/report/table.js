// The table of figures: drawn from the embedded data, sorted by any head, filtered by technique, scene and light, its
// details folded away. Names become text, never markup.
if (document.getElementById("figures-data")) {
  const data = JSON.parse(document.getElementById("figures-data").textContent);
  const table = document.querySelector("table.figures");
  const filters = document.getElementById("filters");

  const make = (tag, attributes, ...children) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  };
  const sceneValue = scene => scene === null ? "mean" : `scene ${scene}`;
  const meanOf = `mean of ${data.scenes.length}`;

  // "0.147 ± 0.031" or "0.07 [0, 0.17]": the interval stands in a box of its own, so that figures end at one edge.
  const figure = (column, [value, text]) => {
    const [words, ...interval] = text.split(" ");
    const cell = make("td", { class: "figure", "data-value": value ?? "" }, column.wide ? `${words} ` : text);
    if (column.wide) cell.append(make("span", { class: "plus" }, interval.join(" ")));
    if (column.bar && value !== null && column.largest > 0)
      cell.append(make("span", { class: "bar", style: `--share:${(value / column.largest).toFixed(4)}` }));
    return cell;
  };
  const groupOf = ({ title, entries }) => make("div", { class: "group" }, make("h4", {}, title), make("dl", {},
    ...entries.flatMap(([term, text]) => [make("dt", {}, term), make("dd", {}, text)])));

  const unfold = (button, detail, row) => {
    const open = detail.classList.toggle("open");
    if (open && !detail.firstChild.firstChild)
      detail.firstChild.append(make("div", { class: "groups" }, ...row.groups.map(groupOf)));
    button.setAttribute("aria-expanded", open);
    button.textContent = open ? "Less" : "More";
  };

  const bodyOf = (row, place) => {
    const about = make("button", { type: "button", class: "about", "aria-label": `Parameters of ${row.shown}` }, "i");
    tooltip.attach(about, () => [...groupOf(row.groups[0]).children]);
    const button = make("button",
      { type: "button", class: "unfold", "aria-expanded": "false", "aria-controls": `detail-${place}` }, "More");
    const detail = make("tr", { class: "detail", id: `detail-${place}` },
      make("td", { colspan: data.columns.length + 3 }));
    button.addEventListener("click", () => unfold(button, detail, row));
    const links = row.pictures === undefined ? []
      : [make("a", { class: "to-pictures", href: `#picture-${row.pictures}` }, "Pictures"), " "];
    const names = { technique: row.technique, shown: row.shown, scene: sceneValue(row.scene), light: row.light };
    return make("tbody", Object.fromEntries(Object.entries(names).map(([name, value]) => [`data-${name}`, value])),
      make("tr", { class: row.scene === null ? "record mean" : "record" },
        make("th", { scope: "row", class: "name technique", "data-value": row.shown },
          make("span", { class: "label", title: row.technique }, row.shown), about),
        make("td", { class: "name scene", "data-value": row.scene ?? "" }, row.scene ?? meanOf),
        ...row.cells.map((cell, column) => figure(data.columns[column], cell)),
        make("td", { class: "links" }, ...links, button)),
      detail);
  };

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
  const headOf = (kind, title, unit) => make("th", { scope: "col", class: kind },
    make("button", { type: "button" }, title, ...(unit ? [make("span", { class: "unit" }, unit)] : [])));

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
  const choose = (name, options) =>
    filters.elements[name].append(...options.map(([value, text]) => new Option(text, value)));

  data.columns.forEach((column, place) => {
    column.wide = data.rows.some(row => row.cells[place][1].includes(" "));
    column.largest = Math.max(...data.rows.map(row => row.cells[place][0] ?? 0));
  });
  const head = make("tr", {}, headOf("name technique", "Technique"), headOf("name scene", "Scene"),
    ...data.columns.map(column => headOf(column.wide ? "figure wide" : "figure", column.title, column.unit)),
    make("th", { scope: "col", class: "links" }, make("span", { class: "hidden" }, "Pictures and details")));
  table.append(make("thead", {}, head), ...data.rows.map(bodyOf));
  [...head.cells].forEach((cell, column) =>
    cell.querySelector("button")?.addEventListener("click", () => sortBy(cell, column)));
  choose("technique", [["", "all"], ...new Map(data.rows.map(row => [row.technique, row.shown]))]);
  choose("scene", [...(data.scenes.length > 1 ? [["mean", meanOf]] : []), ["", "every scene"],
    ...data.scenes.map(scene => [sceneValue(scene), scene])]);
  choose("light", [["", "all"], ...data.lights.map(light => [light, `${light}°`])]);
  filters.addEventListener("input", filter);
  filters.addEventListener("reset", () => setTimeout(filter));
  filters.addEventListener("submit", event => event.preventDefault());
  filter();
}
