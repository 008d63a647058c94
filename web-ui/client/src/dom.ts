// Elements without a framework: h('td', { class: 'number' }, '12.3').

import type { Cell } from './logic/csv';
import { saveMenu, tableItems } from './ui/save';

export type Child = Node | string | number | null | undefined | false | Child[];
type Handler = (event: Event) => void;
export type Props = Record<string, string | number | boolean | Handler | undefined>;

function append(parent: Node, children: Child[]): void {
  for (const child of children) {
    if (Array.isArray(child)) append(parent, child);
    else if (child instanceof Node) parent.appendChild(child);
    else if (child !== null && child !== undefined && child !== false) parent.appendChild(document.createTextNode(String(child)));
  }
}

/** Text always becomes a text node, never markup: names from a scenario cannot inject anything. */
export function h<K extends keyof HTMLElementTagNameMap>(tag: K, props: Props = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (value === undefined || value === false) continue;
    if (typeof value === 'function') element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, '');
    else element.setAttribute(name, String(value));
  }
  append(element, children);
  return element;
}

export function fragment(...children: Child[]): DocumentFragment {
  const f = document.createDocumentFragment();
  append(f, children);
  return f;
}

export interface Column<Row> {
  head: Child;
  unit?: string;
  /** Numbers stand to the right with aligned digits. */
  number?: boolean;
  cell: (row: Row) => Child;
  /** Heads the row for screen readers. */
  rowHead?: boolean;
  /** What is saved in place of the printed cell: numbers with all their digits. */
  raw?: (row: Row) => Cell;
}

/** An SVG element; like `h`. */
export function svg(tag: string, props: Record<string, string | number | undefined> = {}, ...children: Child[]): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(props)) if (value !== undefined) element.setAttribute(name, String(value));
  append(element, children);
  return element;
}

const textOf = (child: Child): string => {
  const f = document.createDocumentFragment();
  append(f, [child]);
  return (f.textContent ?? '').trim();
};

/** A table with a caption (read aloud, not shown unless `shown`) that scrolls sideways rather than the page. */
export function table<Row>(caption: string, columns: Column<Row>[], rows: readonly Row[], rowClass?: (row: Row) => string | undefined): HTMLElement {
  const data = (): Cell[][] => [
    columns.map((c) => [textOf(c.head), c.unit ? `[${c.unit}]` : ''].filter(Boolean).join(' ')),
    ...rows.map((row) => columns.map((c) => (c.raw ? c.raw(row) : textOf(c.cell(row))))),
  ];
  const body = h(
    'div',
    { class: 'table-wrap', tabindex: 0, role: 'region', 'aria-label': caption },
    h(
      'table',
      {},
      h('caption', { class: 'visually-hidden' }, caption),
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          columns.map((c) =>
            h('th', { scope: 'col', class: c.number ? 'number' : undefined }, c.head, c.unit ? h('span', { class: 'unit' }, ' ', c.unit) : null),
          ),
        ),
      ),
      h(
        'tbody',
        {},
        rows.map((row) =>
          h(
            'tr',
            { class: rowClass?.(row) },
            columns.map((c) =>
              c.rowHead ? h('th', { scope: 'row', class: c.number ? 'number' : undefined }, c.cell(row)) : h('td', { class: c.number ? 'number' : undefined }, c.cell(row)),
            ),
          ),
        ),
      ),
    ),
  );
  return rows.length === 0 ? body : h('div', { class: 'with-save' }, body, saveMenu(caption, tableItems(caption, data)));
}
