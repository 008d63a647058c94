// What a page is, and parts that several pages share.

import { api, ApiError } from './api';
import { h, type Child } from './dom';
import { t } from './i18n';
import type { Annotation, Change } from './types';

export interface PageContext {
  signal: AbortSignal;
  /** Called when the page has been put into the document: charts need a width. */
  whenShown: (draw: () => void) => void;
  /** Called when the page is left. */
  whenLeft: (clean: () => void) => void;
}

export interface PageContent {
  title: string;
  body: Node;
}

export type PageMaker = (context: PageContext, parameters: string[]) => Promise<PageContent>;

export function section(head: Child, unit: Child, ...children: Child[]): HTMLElement {
  return h('section', { class: 'panel' }, h('h2', {}, head, unit ? h('span', { class: 'unit' }, ' ', unit) : null), children);
}

/** Changes as a list "pointer = value"; a text that is no list is shown as it is. */
export function changeList(changes: Change[] | string): { pointer: string; value: string }[] {
  if (typeof changes === 'string') return changes ? [{ pointer: changes, value: '' }] : [];
  return changes.map((c) => ({ pointer: c.pointer, value: typeof c.value === 'string' ? c.value : JSON.stringify(c.value) }));
}

export function downloadButton(label: string, path: string, file: string): HTMLElement {
  const button = h(
    'button',
    {
      type: 'button',
      class: 'quiet',
      onclick: () => {
        api.download(path, file).catch((e: unknown) => {
          button.replaceWith(h('span', { class: 'bad' }, e instanceof ApiError && e.message ? e.message : t('state.offline')));
        });
      },
    },
    label,
  );
  return button;
}

export function command(text: string): HTMLElement {
  return h('pre', { class: 'command' }, h('code', {}, text));
}

/** Note and tags of a run or a study, edited in place. */
export function annotationEditor(what: 'runs' | 'studies', id: number, given: Partial<Annotation>, readOnly: boolean): HTMLElement {
  let saved: Annotation = { note: given.note ?? '', tags: given.tags ?? [] };
  const shown = h('p', { class: 'annotation' });
  const note = h('textarea', { id: 'note', rows: 3, maxlength: 5000 });
  const tags = h('input', { id: 'tags', type: 'text', maxlength: 500 });
  const error = h('p', { class: 'bad', role: 'alert' });
  const details = h('details', { class: 'no-print annotate' });
  const show = () => {
    shown.replaceChildren(...saved.tags.map((tag) => h('span', { class: 'tag' }, tag)), saved.note);
    note.value = saved.note;
    tags.value = saved.tags.join(', ');
  };
  show();
  details.append(
    h('summary', {}, t('note.edit')),
    h('p', {}, h('label', { for: 'tags' }, t('note.tags')), ' ', tags),
    h('p', {}, h('label', { for: 'note' }, t('note.note'))),
    note,
    h('p', {}, h('button', { type: 'button', id: 'save-note', onclick: () => {
      error.textContent = '';
      api.annotate(what, id, { note: note.value, tags: tags.value.split(',').map((x) => x.trim()).filter(Boolean) }).then(
        (kept) => {
          saved = kept;
          show();
          details.removeAttribute('open');
        },
        (e: unknown) => (error.textContent = e instanceof ApiError && e.message ? e.message : t('state.offline')),
      );
    } }, t('note.save'))),
    error,
  );
  return h('div', {}, shown, readOnly ? null : details);
}
