// SPDX-License-Identifier: MIT
// All settings as a table that can be sorted.
import { bytes, part, percent } from './figures.js';

const columnsOf = (axes) => [
  { name: 'engine', of: (p) => p.engine, isWord: true },
  { name: 'R', of: (p) => p.resolution || null },
  { name: 'profile', of: (p) => p.profile, isWord: true },
  { name: 'elements', of: (p) => p.elements },
  { name: 'flux / row', of: (p) => p.flux_per_row, text: part },
  { name: 'RAM', of: (p) => p.ram, text: bytes },
  { name: 'mean error', of: (p) => p.error, text: percent },
  { name: 'worst face', of: (p) => p.worst, text: percent },
  ...axes.map((axis) => ({ name: axis.name.replace(/^(instructions|cycles) on /, ''), of: axis.of, text: axis.text })),
];

const compare = (a, b) => (typeof a === 'string' ? a.localeCompare(b) : (a ?? Infinity) - (b ?? Infinity));

export class Table {
  constructor(table, axes, select) {
    this.columns = columnsOf(axes);
    this.sorted = { column: 6, direction: 1 };
    this.select = select;
    this.body = document.createElement('tbody');
    table.replaceChildren(this.head(), this.body);
  }

  head() {
    const head = document.createElement('thead');
    const row = head.insertRow();
    this.heads = this.columns.map((column, i) => {
      const cell = document.createElement('th');
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = column.name;
      button.addEventListener('click', () => this.sortBy(i));
      cell.className = column.isWord ? 'word' : '';
      cell.scope = 'col';
      cell.append(button);
      row.append(cell);
      return cell;
    });
    return head;
  }

  sortBy(column) {
    const direction = this.sorted.column === column ? -this.sorted.direction : 1;
    this.sorted = { column, direction };
    this.draw(this.points, this.selected);
  }

  draw(points, selected) {
    this.points = points;
    this.selected = selected;
    const { column, direction } = this.sorted;
    const key = this.columns[column].of;
    this.heads.forEach((cell, i) =>
      cell.setAttribute('aria-sort', i !== column ? 'none' : direction > 0 ? 'ascending' : 'descending'));
    this.body.replaceChildren(...[...points].sort((a, b) => direction * compare(key(a), key(b)))
      .map((point) => this.row(point, point === selected)));
  }

  row(point, isSelected) {
    const row = document.createElement('tr');
    row.tabIndex = 0;
    row.setAttribute('aria-selected', isSelected);
    for (const { of, text, isWord } of this.columns) {
      const cell = row.insertCell();
      const value = of(point);
      cell.className = isWord ? 'word' : '';
      cell.textContent = value === null ? '' : text ? text(value) : value;
    }
    row.addEventListener('click', () => this.select(point));
    row.addEventListener('keydown', (event) => event.key === 'Enter' && this.select(point));
    return row;
  }
}
