// Sorts the table of load cases by a column, and hides the rows without the words of the filter.
for (const box of document.querySelectorAll(".cases")) {
  const body = box.querySelector("tbody");
  const rows = [...body.rows];
  const filter = box.querySelector("input");
  filter.hidden = false;
  filter.addEventListener("input", () => {
    const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const row of rows) {
      const text = row.textContent.toLowerCase();
      row.hidden = !words.every(word => text.includes(word));
    }
  });
  box.querySelectorAll("th").forEach((head, column) => {
    let sign = 1;
    const text = row => row.cells[column].textContent.trim();
    const number = cell => parseFloat(cell.replace("−", "-"));
    head.tabIndex = 0;
    const sort = () => {
      rows.sort((a, b) => {
        const [s, t] = [text(a), text(b)];
        const difference = number(s) - number(t);
        return sign * (Number.isNaN(difference) ? s.localeCompare(t, undefined, {numeric: true}) : difference);
      });
      sign = -sign;
      body.append(...rows);
    };
    head.addEventListener("click", sort);
    head.addEventListener("keydown", event => { if (event.key === "Enter") sort(); });
  });
}
