// The catalogue: every function, searched as one types.

import { api } from '../api';
import { fragment, h, table } from '../dom';
import { t } from '../i18n';
import { provenanceKind } from '../logic/fields';
import { section, type PageMaker } from '../page';
import type { FunctionHead } from '../types';

/** True when every word stands somewhere in the function's key, summary or folder. */
export function matches(f: FunctionHead, words: string): boolean {
  const all = `${f.key} ${f.summary} ${f.role} ${f.provenance} ${f.key.replace(/[._]/g, ' ')}`.toLowerCase();
  return words
    .toLowerCase()
    .split(/\s+/)
    .every((w) => all.includes(w));
}

let lastSearch = '';

export const modelsPage: PageMaker = async (context) => {
  const list = await api.models(context.signal);
  const place = h('div');
  const show = (words: string) => {
    lastSearch = words;
    const found = list.functions.filter((f) => matches(f, words));
    place.replaceChildren(
      found.length === 0
        ? h('p', { class: 'state' }, t('models.none'))
        : table<FunctionHead>(
            t('models.title'),
            [
              { head: t('col.function'), rowHead: true, cell: (f) => h('a', { href: `#/models/${f.key}` }, h('code', {}, f.key)) },
              { head: t('col.meaning'), cell: (f) => f.summary },
              { head: t('models.role'), cell: (f) => h('span', { class: 'muted' }, f.role) },
              { head: t('models.source'), cell: (f) => h('span', {}, f.equation, ' ', h('span', { class: `flag ${provenanceKind(f.provenance) ?? ''}` }, f.provenance)) },
            ],
            found,
          ),
    );
  };
  const search = h('input', { id: 'model-search', type: 'search', value: lastSearch, placeholder: t('models.hint'), oninput: () => show(search.value.trim()) });
  show(lastSearch);
  return {
    title: t('models.title'),
    body: fragment(
      h('h1', {}, t('models.title')),
      section(h('label', { for: 'model-search' }, t('models.search', { count: list.total })), '', h('p', {}, search), place),
    ),
  };
};
