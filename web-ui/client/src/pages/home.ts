// Runs and studies, newest first; what the last study found stands on top.

import { api } from '../api';
import { fragment, h, table } from '../dom';
import { dateTime, estimateText, unitText, whole } from '../format';
import { named, t, type Key } from '../i18n';
import { find } from '../logic/kpis';
import { changeList, command, section, type PageMaker } from '../page';
import type { Page, RunHeader, StudyHeader } from '../types';
import { findingWords } from './study';

const perPage = 20;

/** A list that can be paged without leaving the page. `load` fills `place` from an offset. */
function pager(page: Page, load: (offset: number) => void): HTMLElement | null {
  if (page.total <= page.limit) return null;
  const go = (text: string, offset: number, possible: boolean) =>
    h('button', { type: 'button', class: 'quiet', disabled: !possible, onclick: () => load(offset) }, text);
  return h(
    'p',
    { class: 'row pager' },
    go(t('home.newer'), Math.max(0, page.offset - page.limit), page.offset > 0),
    h('span', {}, t('home.range', { from: whole(page.offset + 1), to: whole(Math.min(page.total, page.offset + page.limit)), total: whole(page.total) })),
    go(t('home.older'), page.offset + page.limit, page.offset + page.limit < page.total),
  );
}

function statusText(status: string): string {
  const key = `study.status.${status}`;
  return key === 'study.status.running' || key === 'study.status.finished' || key === 'study.status.failed' ? t(key as Key) : status;
}

function moneyCell(run: RunHeader, name: string): Node {
  const kpi = find(run, name);
  return kpi ? fragment(estimateText(kpi.mean, kpi.half_width_95), h('span', { class: 'unit' }, ' ', unitText(kpi.unit))) : fragment('–');
}

function changesCell(run: RunHeader): Node {
  const list = changeList(run.changes);
  if (list.length === 0) return fragment('–');
  const words = list.map((c) => `${c.pointer}${c.value ? ` = ${c.value}` : ''}`);
  return h('span', { class: 'changes', title: words.join('\n') }, words.join(', '));
}

export const homePage: PageMaker = async (context) => {
  const [runs, studies] = await Promise.all([api.runs(perPage, 0, context.signal), api.studies(perPage, 0, context.signal)]);
  const picked = new Set<number>();
  const compare = h('button', { type: 'button', disabled: true, onclick: () => {
    const [a, b] = [...picked].sort((x, y) => x - y);
    location.hash = `#/compare/${a}/${b}`;
  } }, t('home.compare'));

  const runPlace = h('div');
  const showRuns = (page: typeof runs) => {
    if (page.total === 0) {
      runPlace.replaceChildren(h('p', {}, t('home.noRuns')), command('verstat run scenarios/gallery/heavy-lathe.json'));
      return;
    }
    const list = table<RunHeader>(
      t('home.runs'),
      [
        { head: h('span', { class: 'visually-hidden' }, t('home.compare')), cell: (r) => h('input', {
          type: 'checkbox', 'aria-label': t('home.pick', { id: r.id }), checked: picked.has(r.id),
          onchange: (event: Event) => {
            if ((event.target as HTMLInputElement).checked) picked.add(r.id);
            else picked.delete(r.id);
            compare.disabled = picked.size !== 2;
          },
        }) },
        { head: t('col.id'), number: true, cell: (r) => h('a', { href: `#/runs/${r.id}` }, r.id) },
        { head: t('col.scenario'), rowHead: true, cell: (r) => h('a', { href: `#/runs/${r.id}` }, r.scenario) },
        { head: t('col.label'), cell: (r) => h('span', { class: 'nowrap' }, r.label) },
        { head: t('col.changes'), cell: changesCell },
        { head: t('col.cost'), number: true, cell: (r) => moneyCell(r, 'cost_per_part') },
        { head: t('col.throughput'), number: true, cell: (r) => moneyCell(r, 'throughput_per_h') },
        { head: t('col.replications'), number: true, cell: (r) => whole(r.replications) },
        { head: t('col.created'), cell: (r) => h('span', { class: 'nowrap' }, dateTime(r.provenance.created)) },
      ],
      page.runs,
    );
    runPlace.replaceChildren(
      list,
      fragment(pager(page, (offset) => void api.runs(perPage, offset, context.signal).then(showRuns)), page.total > 1 ? h('p', { class: 'row' }, compare, h('span', { class: 'muted' }, t('home.compareHint'))) : null),
    );
  };
  showRuns(runs);

  const studyPlace = h('div');
  const showStudies = (page: typeof studies) => {
    if (page.total === 0) {
      studyPlace.replaceChildren(h('p', {}, t('home.noStudies')), command('verstat optimize scenarios/gallery/heavy-lathe.study.json'));
      return;
    }
    studyPlace.replaceChildren(
      table<StudyHeader>(
        t('home.studies'),
        [
          { head: t('col.id'), number: true, cell: (s) => h('a', { href: `#/studies/${s.id}` }, s.id) },
          { head: t('col.study'), rowHead: true, cell: (s) => h('a', { href: `#/studies/${s.id}` }, s.name) },
          { head: t('col.scenario'), cell: (s) => s.scenario },
          { head: t('col.objective'), cell: (s) => named('kpi', s.objective) },
          { head: t('col.trials'), number: true, cell: (s) => whole(s.trials) },
          { head: t('col.status'), cell: (s) => statusText(s.status) },
          { head: t('col.created'), cell: (s) => h('span', { class: 'nowrap' }, dateTime(s.provenance.created)) },
        ],
        page.studies,
      ),
      fragment(pager(page, (offset) => void api.studies(perPage, offset, context.signal).then(showStudies))),
    );
  };
  showStudies(studies);

  const latest = studies.studies.find((s) => s.status === 'finished');
  const report = latest ? await api.studyHead(String(latest.id), context.signal) : undefined;
  return {
    title: t('home.title'),
    body: fragment(
      h('h1', { class: 'visually-hidden' }, t('home.title')),
      report
        ? h(
            'section',
            { class: `panel finding ${report.result.verdict ?? ''}` },
            h('h2', {}, t('home.latest'), h('span', { class: 'unit' }, ` ${report.name}`)),
            h('p', { class: 'words' }, findingWords(report)),
            h('p', {}, h('a', { href: `#/studies/${report.id}` }, t('home.open'))),
          )
        : null,
      section(t('home.studies'), studies.total ? whole(studies.total) : '', studyPlace),
      section(t('home.runs'), runs.total ? whole(runs.total) : '', runPlace),
    ),
  };
};
