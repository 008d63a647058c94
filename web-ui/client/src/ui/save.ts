// "Save": every table as CSV or JSON, every chart as a picture or the numbers behind it.

import { saveBlob } from '../api';
import { h } from '../dom';
import { t } from '../i18n';
import { fileName, toCsv, type Cell } from '../logic/csv';

export interface SaveItem {
  label: string;
  file: string;
  /** null: nothing is saved, and whoever gave the item has said why. */
  content: () => Blob | null | Promise<Blob | null>;
}

/** A menu that opens on click or Enter; not printed. */
export function saveMenu(name: string, items: readonly SaveItem[]): HTMLElement {
  const menu = h(
    'details',
    { class: 'save no-print' },
    h('summary', { 'aria-label': t('save.of', { name }) }, t('save')),
    h(
      'div',
      { class: 'save-items' },
      items.map((item) =>
        h(
          'button',
          {
            type: 'button',
            class: 'quiet',
            onclick: () => {
              void Promise.resolve(item.content()).then((blob) => blob && saveBlob(blob, item.file));
              menu.removeAttribute('open');
            },
          },
          item.label,
        ),
      ),
    ),
  );
  return menu;
}

/** Items for a table: head row and rows of full precision. */
export function tableItems(name: string, rows: () => Cell[][]): SaveItem[] {
  const file = fileName(name);
  const csv = (separator: ',' | ';', decimal: '.' | ',') => new Blob([toCsv(rows(), { separator, decimal })], { type: 'text/csv;charset=utf-8' });
  return [
    { label: t('save.csv'), file: `${file}.csv`, content: () => csv(',', '.') },
    { label: t('save.excel'), file: `${file}.csv`, content: () => csv(';', ',') },
    {
      label: 'JSON',
      file: `${file}.json`,
      content: () => {
        const [head = [], ...body] = rows();
        const list = body.map((row) => Object.fromEntries(head.map((name, k) => [String(name), row[k] ?? null])));
        return new Blob([`${JSON.stringify(list, null, 2)}\n`], { type: 'application/json' });
      },
    },
  ];
}
