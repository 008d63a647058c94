// Runs and studies, newest first; what the last study found stands on top.

import { api, type ListOptions } from '../api';
import { fragment, h, table } from '../dom';
import { dateTime, estimateText, unitText, whole } from '../format';
import { named, t, type Key } from '../i18n';
import { find } from '../logic/kpis';
import { changeList, command, section, type PageMaker } from '../page';
import type { Page, RunHeader, StudyHeader } from '../types';
import { activeJobs } from '../ui/job';
import { findingWords } from './study';

const perPage = 20;

// Kept while one looks at a run and comes back.
const query: Required<ListOptions> = { limit: perPage, offset: 0, search: '', tag: '', sort: 'id', order: 'desc' };
const studyQuery: ListOptions = { limit: 10, offset: 0 };

/** A column head that sorts. */
function sortHead(text: string, sort: string, again: () => void): HTMLElement {
  const active = query.sort === sort;
  return h('button', { type: 'button', class: 'sort', 'aria-label': t('home.sortBy', { name: text }), 'data-sort': sort, onclick: () => {
    query.order = active && query.order === 'desc' ? 'asc' : 'desc';
    query.sort = sort;
    query.offset = 0;
    again();
  } }, text, active ? (query.order === 'desc' ? ' ▾' : ' ▴') : '');
}

function tagsCell(row: { tags?: string[]; note?: string }): Node {
  return fragment((row.tags ?? []).map((tag) => h('span', { class: 'tag' }, tag)), row.note ? h('span', { class: 'changes', title: row.note }, row.note) : null);
}

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
  return key === 'study.status.running' || key === 'study.status.finished' || key === 'study.status.failed' || key === 'study.status.interrupted' ? t(key as Key) : status;
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
  const [runs, studies, tags] = await Promise.all([api.runs(query, context.signal), api.studies({ ...studyQuery }, context.signal), api.tags(context.signal)]);
  const picked = new Set<number>();
  const compare = h('button', { type: 'button', disabled: true, onclick: () => {
    location.hash = `#/compare/${[...picked].sort((x, y) => x - y).join('/')}`;
  } }, t('home.compare'));
  const searching = () => query.search !== '' || query.tag !== '';

  const runPlace = h('div');
  const reload = () => void api.runs({ ...query }, context.signal).then(showRuns, () => undefined);
  let timer = 0;
  context.whenLeft(() => clearTimeout(timer));
  const search = h('input', { id: 'run-search', type: 'search', value: query.search, placeholder: t('home.searchHint'), oninput: () => {
    query.search = search.value.trim();
    query.offset = 0;
    clearTimeout(timer);
    timer = window.setTimeout(reload, 150);
  } });
  const tagPick = h('select', { id: 'run-tag', onchange: () => {
    query.tag = tagPick.value;
    query.offset = 0;
    reload();
  } }, h('option', { value: '' }, t('home.anyTag')), tags.tags.map((x) => h('option', { value: x.name, selected: x.name === query.tag }, `${x.name} (${whole(x.count)})`)));
  const showRuns = (page: typeof runs) => {
    query.offset = page.offset;
    if (page.total === 0 && searching()) {
      runPlace.replaceChildren(h('p', {}, t('home.noMatch')));
      return;
    }
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
            compare.disabled = picked.size < 2 || picked.size > 8;
          },
        }) },
        { head: sortHead(t('col.id'), 'id', reload), number: true, cell: (r) => h('a', { href: `#/runs/${r.id}` }, r.id) },
        { head: sortHead(t('col.scenario'), 'scenario', reload), rowHead: true, cell: (r) => h('a', { href: `#/runs/${r.id}` }, r.scenario) },
        { head: sortHead(t('col.label'), 'label', reload), cell: (r) => h('span', { class: 'nowrap' }, r.label) },
        { head: t('col.changes'), cell: changesCell },
        { head: sortHead(t('col.cost'), 'cost_per_part', reload), number: true, cell: (r) => moneyCell(r, 'cost_per_part') },
        { head: sortHead(t('col.throughput'), 'throughput_per_h', reload), number: true, cell: (r) => moneyCell(r, 'throughput_per_h') },
        { head: t('note.tags'), cell: tagsCell },
        { head: t('col.replications'), number: true, cell: (r) => whole(r.replications) },
        { head: sortHead(t('col.created'), 'created', reload), cell: (r) => h('span', { class: 'nowrap' }, dateTime(r.provenance.created)) },
      ],
      page.runs,
    );
    runPlace.replaceChildren(
      list,
      fragment(pager(page, (offset) => { query.offset = offset; reload(); }), page.total > 1 ? h('p', { class: 'row' }, compare, h('span', { class: 'muted' }, t('home.compareHint'))) : null),
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
          { head: t('note.tags'), cell: tagsCell },
          { head: t('col.created'), cell: (s) => h('span', { class: 'nowrap' }, dateTime(s.provenance.created)) },
        ],
        page.studies,
      ),
      fragment(pager(page, (offset) => void api.studies({ ...studyQuery, offset }, context.signal).then(showStudies, () => undefined))),
    );
  };
  showStudies(studies);

  const active = await activeJobs(context, ['run', 'study', 'again', 'trace', 'losses', 'resume'], () => {
    reload();
    void api.studies({ ...studyQuery }, context.signal).then(showStudies, () => undefined);
  });
  const latest = studies.studies.find((s) => s.status === 'finished' && s.kind === 'optimize');
  const report = latest ? await api.study(String(latest.id), context.signal) : undefined;
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
            h('p', { class: 'row' }, h('a', { href: `#/studies/${report.id}` }, t('home.open')), h('a', { href: `#/report/${report.id}` }, t('report.title'))),
          )
        : null,
      active,
      section(t('home.studies'), studies.total ? whole(studies.total) : '', studyPlace),
      section(t('home.runs'), runs.total ? whole(runs.total) : '', h('p', { class: 'row no-print' }, h('label', { for: 'run-search' }, t('home.search')), search, h('label', { for: 'run-tag' }, t('note.tags')), tagPick), runPlace),
    ),
  };
};
