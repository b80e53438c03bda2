// on a narrow screen each row is a block, whose values have the heads of their columns beside them
for (const table of document.querySelectorAll("table")) {
  const heads = [...table.querySelectorAll("thead th")].map(head => head.innerHTML.replace(/<br>/g, " ").replace(/<[^>]+>|\s+$/g, "").replace(/\s+/g, " "));
  for (const row of table.querySelectorAll("tbody tr"))
    [...row.cells].forEach((cell, k) => { cell.dataset.head = heads[k] || ""; });
}
