'use strict';
// Sorts, searches and filters the table of students. What is shown is kept in the address, so that a view can be
// linked: #q=words&status=refused&sort=total&down=1
(() => {
  const table = document.getElementById('students');
  const body = table.tBodies[0];
  const heads = Array.from(table.tHead.rows[0].cells).filter(head => head.dataset.key);
  const search = document.getElementById('search');
  const status = document.getElementById('status');
  const count = document.getElementById('count');
  const order = new Intl.Collator(undefined, {numeric: true, sensitivity: 'base'});
  let own = false;  // whether the next change of the address comes from here
  const plain = text => text.normalize('NFKD').replace(/\p{M}/gu, '').toLowerCase();

  const rows = Array.from(body.rows, (row, place) => ({
    row, place,
    text: plain(row.cells[0].textContent + ' ' + row.dataset.found),
    status: row.dataset.status,
    late: row.dataset.late === '1',
    values: heads.map(head => {
      const text = row.cells[head.cellIndex].dataset.value ?? row.cells[head.cellIndex].textContent.trim();
      return head.dataset.type === 'number' ? (text === '' ? null : Number(text)) : text;
    }),
  }));

  function compare(one, other, column, down) {
    const a = one.values[column], b = other.values[column];
    if (a === null || b === null) return (a === null) - (b === null) || one.place - other.place;  // no mark: last
    const sign = typeof a === 'number' ? a - b : order.compare(a, b);
    return (down ? -sign : sign) || one.place - other.place;
  }

  function read() {
    const state = new URLSearchParams(location.hash.slice(1));
    return {q: state.get('q') ?? '', status: state.get('status') ?? '', sort: state.get('sort') ?? '',
            down: state.get('down') === '1'};
  }

  function keep(change) {
    const state = {...read(), ...change};
    const kept = new URLSearchParams();
    for (const [name, value] of Object.entries(state)) if (value) kept.set(name, value === true ? '1' : value);
    own = true;
    location.replace('#' + (kept.toString() || 'all'));
  }

  function show() {
    const state = read();
    const words = plain(state.q).split(/\s+/).filter(word => word);
    if (document.activeElement !== search) search.value = state.q;
    status.value = state.status;
    const column = heads.findIndex(head => head.dataset.key === state.sort);
    for (const [index, head] of heads.entries()) {
      if (index === column) head.setAttribute('aria-sort', state.down ? 'descending' : 'ascending');
      else head.removeAttribute('aria-sort');
    }
    const sorted = [...rows].sort((one, other) =>
      column < 0 ? one.place - other.place : compare(one, other, column, state.down));
    let shown = 0;
    for (const entry of sorted) {
      const fits = (!state.status || (state.status === 'late' ? entry.late : entry.status === state.status)) &&
                   words.every(word => entry.text.includes(word));
      entry.row.hidden = !fits;
      if (fits) ++shown;
    }
    body.append(...sorted.map(entry => entry.row));
    count.textContent = shown === rows.length ? rows.length + ' students' : shown + ' of ' + rows.length + ' students';
  }

  for (const head of heads) {
    const button = document.createElement('button');
    button.type = 'button';
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener('click', () => {
      const state = read(), same = state.sort === head.dataset.key, numbers = head.dataset.type === 'number';
      keep({sort: head.dataset.key, down: same ? !state.down : numbers});
    });
  }
  search.addEventListener('input', () => keep({q: search.value}));
  status.addEventListener('change', () => keep({status: status.value}));
  document.getElementById('controls').addEventListener('submit', event => event.preventDefault());
  document.getElementById('controls').hidden = false;
  window.addEventListener('hashchange', () => {
    show();
    if (!own) table.parentElement.scrollIntoView();
    own = false;
  });
  show();
  if (location.hash.includes('=')) table.parentElement.scrollIntoView();
})();
