// What a page is, and parts that several pages share.

import { api, ApiError } from './api';
import { h, type Child } from './dom';
import { t } from './i18n';
import type { Change } from './types';

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
