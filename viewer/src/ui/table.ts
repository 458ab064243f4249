import type { Table } from '../model/report_data';
import { element } from './element';

// Longer cells are treated as prose, not as figures.
const proseLength = 40;
const figure = /^([-−+]?[\d.].*|-|)$/;
const isProse = (text: string) => text.length > proseLength;

/** The CSS class of a column, by its contents. */
function columnClass(table: Table, column: number): string {
  const cells = table.rows.map((row) => row[column] ?? '');
  if (cells.some(isProse)) return 'prose';
  return cells.some((text) => !figure.test(text)) ? 'words' : '';
}

/** A table of the report. `first` may replace the text in the first cell of a row by an element. */
export function tableElement(table: Table, first?: (text: string, row: number) => Node | string): HTMLElement {
  const classes = table.header.map((_, column) => columnClass(table, column));
  const head = element(
    'thead',
    {},
    element('tr', {}, ...table.header.map((text, c) => element('th', { scope: 'col', class: classes[c] }, text))),
  );
  const body = element(
    'tbody',
    {},
    ...table.rows.map((row, r) =>
      element(
        'tr',
        {},
        ...row.map((text, c) => {
          const content = c === 0 && first ? first(text, r) : text;
          return c === 0 ? element('th', { scope: 'row' }, content) : element('td', { class: classes[c] }, content);
        }),
      ),
    ),
  );
  const note = table.note ? [element('p', { class: 'note' }, table.note)] : [];
  return element(
    'figure',
    { class: 'table' },
    element('figcaption', {}, table.title),
    ...note,
    element(
      'div',
      { class: 'scroll', tabIndex: 0, role: 'region', aria: { label: table.title } },
      element('table', {}, head, body),
    ),
  );
}
