// One study: what it found, best plan against today's, how the search went.

import { api } from '../api';
import { chart } from '../charts/chart';
import { historyOption, planeOption } from '../charts/trials';
import { fragment, h, table, type Child } from '../dom';
import { dateTime, estimateText, fixed, significant, unitText, whole } from '../format';
import { language, named, t } from '../i18n';
import { distinctPlans, thinned } from '../logic/trials';
import { changeList, downloadButton, section, type PageContext, type PageMaker } from '../page';
import type { PlanPoint, Study, Trial } from '../types';

/** What the study found in a sentence: the program's own words, or their translation from the same numbers. */
export function findingWords(study: Pick<Study, 'result'>): string {
  const r = study.result;
  if (language() === 'en' && r.words) return r.words.replace(/\+-/g, '±');
  const base = r.baseline?.simulated.mean;
  const saving = r.saving?.mean;
  const half = r.saving?.half_width;
  if (typeof base !== 'number' || typeof saving !== 'number' || typeof half !== 'number' || base <= 0) return r.words ?? t('study.noResult');
  const distinguishable = r.verdict !== 'not distinguishable';
  const percent = (100 * saving) / base;
  return t(!distinguishable ? 'study.words.same' : saving > 0 ? 'study.words.better' : 'study.words.worse', {
    percent: fixed(distinguishable ? Math.abs(percent) : percent, 2),
    percentHalf: fixed((100 * half) / base, 2),
    saving: fixed(Math.abs(saving), 2),
    half: fixed(half, 2),
    base: fixed(base, 2),
    unit: r.unit ?? '',
  });
}

interface PointRow {
  head: Child;
  unit: string;
  range: string;
  today: string;
  best: string;
  strong?: boolean;
}

function pointSection(study: Study): HTMLElement {
  const { baseline, best, saving } = study.result;
  if (!baseline || !best) return section(t('study.point'), '', h('p', {}, t('study.noResult')));
  const unit = study.result.unit ?? '';
  const objective = named('kpi', study.objective);
  const value = (p: PlanPoint, pointer: string) => {
    const found = p.values.find((v) => v.pointer === pointer);
    return found ? significant(found.value) : '–';
  };
  const rows: PointRow[] = study.variables.map((v) => ({
    head: h('span', { title: v.pointer }, v.name),
    unit: unitText(v.unit) || '1',
    range: `${significant(v.low)} … ${significant(v.high)}`,
    today: value(baseline, v.pointer),
    best: value(best, v.pointer),
  }));
  const analytic = (p: PlanPoint) => (p.analytic === null ? '–' : significant(p.analytic));
  rows.push({ head: t('study.longRun', { objective }), unit, range: '', today: analytic(baseline), best: analytic(best) });
  rows.push({
    head: t('study.simulated', { objective }),
    unit,
    range: '',
    today: estimateText(baseline.simulated.mean, baseline.simulated.half_width_95),
    best: estimateText(best.simulated.mean, best.simulated.half_width_95),
  });
  if (saving) rows.push({ head: t('study.saving'), unit, range: '', today: '', best: estimateText(saving.mean, saving.half_width), strong: true });
  const { baseline_run: a, best_run: b } = study;
  return section(
    t('study.point'),
    '',
    table<PointRow>(
      t('study.point'),
      [
        { head: t('col.variable'), rowHead: true, cell: (r) => r.head },
        { head: t('col.today'), number: true, cell: (r) => r.today },
        { head: t('col.best'), number: true, cell: (r) => r.best },
        { head: t('col.unit'), cell: (r) => h('span', { class: 'unit' }, r.unit) },
        { head: t('col.range'), number: true, cell: (r) => r.range },
      ],
      rows,
      (r) => (r.strong ? 'total' : undefined),
    ),
    a !== null && b !== null
      ? h('p', {}, t('study.runs'), ' ', h('a', { href: `#/runs/${a}` }, t('study.runToday', { id: a })), ', ', h('a', { href: `#/runs/${b}` }, t('study.runBest', { id: b })), '; ', h('a', { href: `#/compare/${a}/${b}` }, t('study.compare')))
      : null,
  );
}

const mostDrawn = 4000;

function planeSection(context: PageContext, study: Study): HTMLElement {
  const drawn = thinned(study.trial_list, mostDrawn);
  let x = 0;
  let y = Math.min(1, study.variables.length - 1);
  const at = (p: PlanPoint | undefined) => (p ? study.variables.map((v) => p.values.find((q) => q.pointer === v.pointer)?.value ?? 0) : undefined);
  const bestAt = at(study.result.best);
  const todayAt = at(study.result.baseline);
  const picture = chart(context, t('study.plane'), 'medium', (theme) =>
    planeOption(drawn, study.variables, x, y, study.result.unit ?? '', bestAt && { name: t('col.best'), at: bestAt }, todayAt && { name: t('col.today'), at: todayAt }, theme),
  );
  const choice = (id: string, label: string, chosen: number, set: (k: number) => void) => {
    const select = h('select', { id, onchange: () => { set(Number(select.value)); picture.redraw(); } }, study.variables.map((v, k) => h('option', { value: k, selected: k === chosen }, v.name)));
    return [h('label', { for: id }, label), select];
  };
  return section(
    t('study.plane'),
    '',
    study.variables.length > 2
      ? h('p', { class: 'row no-print' }, choice('axis-x', t('study.axisX'), x, (k) => (x = k)), choice('axis-y', t('study.axisY'), y, (k) => (y = k)))
      : null,
    picture.element,
    h('p', { class: 'muted' }, t('study.planeHint'), drawn.length < study.trial_list.length && drawn.length === mostDrawn ? ` ${t('study.planeThinned', { drawn: whole(drawn.length), total: whole(study.trial_list.length) })}` : null),
  );
}

function trialSections(context: PageContext, study: Study): Child {
  if (study.trial_list.length === 0) return section(t('study.history'), '', h('p', {}, t('study.noTrials')));
  const unit = study.result.unit ?? '';
  const objective = named('kpi', study.objective);
  const shown = distinctPlans(study.trial_list).slice(0, 12);
  const history = chart(context, t('study.history'), 'large', (theme) => historyOption(study.trial_list, objective, unit, study.result.baseline?.analytic ?? null, theme));
  return [
    section(t('study.history'), '', history.element),
    section(
      t('study.trialsHead'),
      t('study.trialsUnit', { total: whole(study.trial_list.length) }),
      h(
        'p',
        { class: 'row no-print' },
        downloadButton(t('run.csv'), `studies/${study.id}?format=csv`, `study-${study.id}.csv`),
        downloadButton(t('run.csvSemicolon'), `studies/${study.id}?format=csv&separator=semicolon&decimal=comma`, `study-${study.id}.csv`),
        downloadButton(t('run.json'), `studies/${study.id}`, `study-${study.id}.json`),
      ),
      table<Trial>(
        t('study.trialsHead'),
        [
          { head: t('col.number'), number: true, rowHead: true, cell: (r) => r.number },
          { head: t('col.stage'), cell: (r) => r.stage },
          ...study.variables.map((v, k) => ({ head: v.name, unit: unitText(v.unit), number: true, cell: (r: Trial) => significant(r.values[k] ?? NaN) })),
          { head: objective, unit, number: true, cell: (r) => (r.objective === null ? '–' : significant(r.objective, 8)) },
        ],
        shown,
      ),
    ),
  ];
}

export const studyPage: PageMaker = async (context, [id = '']) => {
  const study = await api.study(id, context.signal);
  const changes = changeList(study.changes);
  return {
    title: `${t('study.title', { id: study.id })}: ${study.name}`,
    body: fragment(
      h('h1', {}, study.name, h('span', { class: 'unit' }, ` ${t('study.title', { id: study.id })}`)),
      h(
        'p',
        { class: 'muted facts' },
        `${study.scenario} · ${t('run.madeBy', { created: dateTime(study.provenance.created), version: study.provenance.version, platform: study.provenance.platform })}`,
      ),
      changes.length > 0 ? h('p', { class: 'facts' }, `${t('run.changes')}: `, changes.map((c, k) => [k > 0 ? ', ' : '', h('code', {}, `${c.pointer} = ${c.value}`)])) : null,
      study.result.words ? h('p', { class: `panel finding words ${study.result.verdict ?? ''}`, id: 'finding' }, findingWords(study)) : null,
      h('div', { class: 'columns' }, pointSection(study), study.variables.length > 0 && study.trial_list.length > 0 ? planeSection(context, study) : null),
      trialSections(context, study),
    ),
  };
};
