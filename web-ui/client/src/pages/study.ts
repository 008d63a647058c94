// One study: what it found, best plan against today's, how the search went.

import { api } from '../api';
import { chart } from '../charts/chart';
import { parallelOption, sliceOption } from '../charts/studyViews';
import { historyOption, planeOption } from '../charts/trials';
import { fragment, h, table, type Child } from '../dom';
import { dateTime, estimateText, fixed, significant, unitText, whole } from '../format';
import { language, named, t } from '../i18n';
import { blocks, type Block } from '../logic/result';
import { title } from '../logic/schema';
import { distinctPlans, type Sign } from '../logic/trials';
import { annotationEditor, changeList, downloadButton, section, type PageContext, type PageMaker } from '../page';
import type { PlanPoint, Study, Trial } from '../types';
import { bindingSection, frontSection, lossSection, oneCutSection, resumeSection, tornadoSection } from './studyParts';

/** What the study found in a sentence: the program's own words, or their translation from the same numbers. */
export function findingWords(study: Pick<Study, 'result'>): string {
  const r = study.result;
  // The words of other objectives than a cost are not translated here.
  if (r.words && (language() === 'en' || !(r.objective ?? 'cost').startsWith('cost'))) return r.words.replace(/\+-/g, '±');
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

/** A number, or what a categorical variable was set to. */
function valueText(value: unknown): string {
  return typeof value === 'number' ? significant(value) : typeof value === 'string' ? value : JSON.stringify(value);
}

function pointSection(study: Study): HTMLElement {
  const { baseline, best, saving } = study.result;
  if (!baseline || !best) return section(t('study.point'), '', h('p', {}, t('study.noResult')));
  const unit = study.result.unit ?? '';
  const objective = named('kpi', study.objective);
  const value = (p: PlanPoint, pointer: string) => {
    const found = p.values.find((v) => v.pointer === pointer);
    return found ? (found.text ?? valueText(found.value)) : '–';
  };
  const rows: PointRow[] = study.variables.map((v) => ({
    head: h('span', { title: v.pointer }, v.name),
    unit: unitText(v.unit) || '1',
    range: v.type === 'categorical' ? (v.options ?? []).map(valueText).join(', ').slice(0, 80) : `${significant(v.low)} … ${significant(v.high)}`,
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

const mostDrawn = 2000;

/** Trials as far as they are known here; the charts read them again when more have come. */
interface Trials {
  total: number;
  list: Trial[];
}

const at = (study: Study, p: PlanPoint | undefined): number[] | undefined =>
  p ? study.variables.map((v) => { const x = p.values.find((q) => q.pointer === v.pointer)?.value; return typeof x === 'number' ? x : (v.options ?? []).findIndex((o) => JSON.stringify(o) === JSON.stringify(x)); }) : undefined;

const signOf = (study: Study): Sign => (study.result['direction'] === 'maximize' ? -1 : 1);

function trialRows(study: Study, trials: Trials) {
  return () => [
    [t('col.number'), t('col.stage'), ...study.variables.map((v) => v.name), study.objective],
    ...trials.list.map((x) => [x.number, x.stage, ...x.values, x.objective]),
  ];
}

function planeSection(context: PageContext, study: Study, trials: Trials, redraws: (() => void)[]): HTMLElement {
  let x = 0;
  let y = Math.min(1, study.variables.length - 1);
  const bestAt = at(study, study.result.best);
  const todayAt = at(study, study.result.baseline);
  const picture = chart(context, t('study.plane'), 'medium', (theme) =>
    planeOption(trials.list, study.variables, x, y, study.result.unit ?? '', bestAt && { name: t('col.best'), at: bestAt }, todayAt && { name: t('col.today'), at: todayAt }, theme), { name: t('study.plane'), data: trialRows(study, trials) });
  redraws.push(picture.redraw);
  const choice = (id: string, label: string, chosen: number, set: (k: number) => void) => {
    const select = h('select', { id, onchange: () => { set(Number(select.value)); picture.redraw(); } }, study.variables.map((v, k) => h('option', { value: k, selected: k === chosen }, v.name)));
    return [h('label', { for: id }, label), select];
  };
  const thin = h('span', {});
  const note = () => (thin.textContent = trials.list.length < trials.total ? ` ${t('study.planeThinned', { drawn: whole(trials.list.length), total: whole(trials.total) })}` : '');
  redraws.push(note);
  note();
  return section(
    t('study.plane'),
    '',
    study.variables.length > 2
      ? h('p', { class: 'row no-print' }, choice('axis-x', t('study.axisX'), x, (k) => (x = k)), choice('axis-y', t('study.axisY'), y, (k) => (y = k)))
      : null,
    picture.element,
    h('p', { class: 'muted' }, t('study.planeHint'), thin),
  );
}

function trialSections(context: PageContext, study: Study, trials: Trials, redraws: (() => void)[]): Child {
  const unit = study.result.unit ?? '';
  const objective = named('kpi', study.objective);
  const today = study.result.baseline?.analytic ?? null;
  const noise = study.result.best?.simulated?.half_width_95 ?? null;
  const history = chart(context, t('study.history'), 'large', (theme) => historyOption(trials.list, objective, unit, today, noise, theme, signOf(study)), { name: t('study.history'), data: trialRows(study, trials) });
  redraws.push(history.redraw);
  let place = 0;
  const todayAt = at(study, study.result.baseline);
  const slice = study.variables.length > 0 ? chart(context, t('study.slice'), 'medium', (theme) => sliceOption(trials.list, study.variables[place] as Study['variables'][number], place, objective, unit, todayAt?.[place], theme, signOf(study)), { name: t('study.slice'), data: trialRows(study, trials) }) : null;
  const parallel = study.variables.length > 0 ? chart(context, t('study.parallel'), 'medium', (theme) => parallelOption(trials.list, study.variables, objective, theme, signOf(study)), { name: t('study.parallel'), data: trialRows(study, trials) }) : null;
  if (slice) redraws.push(slice.redraw);
  if (parallel) redraws.push(parallel.redraw);
  const pick = h('select', { id: 'slice-variable', onchange: () => { place = Number(pick.value); slice?.redraw(); } }, study.variables.map((v, k) => h('option', { value: k }, v.name)));
  return [
    section(t('study.history'), '', history.element, noise ? h('p', { class: 'muted' }, t('study.noise', { half: significant(noise, 2), unit })) : null),
    slice && parallel ? h('div', { class: 'columns even' }, section(t('study.slice'), '', h('p', { class: 'row no-print' }, h('label', { for: 'slice-variable' }, t('col.variable')), pick), slice.element), section(t('study.parallel'), '', parallel.element, h('p', { class: 'muted' }, t('study.parallelHint')))) : null,
    section(
      t('study.trialsHead'),
      t('study.trialsUnit', { total: whole(trials.total) }),
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
          { head: t('col.number'), number: true, rowHead: true, cell: (r) => r.number, raw: (r) => r.number },
          { head: t('col.stage'), cell: (r) => r.stage },
          ...study.variables.map((v, k) => ({ head: v.name, unit: unitText(v.unit), number: true, cell: (r: Trial) => (v.type === 'categorical' ? valueText(v.options?.[r.values[k] ?? 0]) : significant(r.values[k] ?? NaN)), raw: (r: Trial) => r.values[k] })),
          { head: objective, unit, number: true, cell: (r) => (r.objective === null ? '–' : significant(r.objective, 8)), raw: (r) => r.objective },
        ],
        distinctPlans(trials.list, signOf(study)).slice(0, 12),
      ),
    ),
  ];
}

/** Members of the answer that have no view of their own yet, as tables. */
function blockSections(study: Study): Child {
  const value = (v: Block['rows'][number][string] | undefined) => (v === undefined || v === null ? '–' : typeof v === 'number' ? significant(v) : typeof v === 'boolean' ? t(v ? 'yes' : 'no') : v);
  const head = (name: string) => (name === '' ? t('study.more') : name.split('/').map((n) => title(n)).join(': '));
  return blocks(study.result).map((block) =>
    section(
      head(block.name),
      '',
      block.facts.length > 0
        ? table<Block['facts'][number]>(head(block.name), [
            { head: t('col.name'), rowHead: true, cell: ([k]) => title(k) },
            { head: t('col.value'), cell: ([, v]) => value(v), raw: ([, v]) => v },
          ], block.facts)
        : table<Block['rows'][number]>(head(block.name), block.columns.map((c, k) => {
            const number = block.rows.some((r) => typeof r[c] === 'number');
            return { head: title(c), number, rowHead: k === 0, cell: (r: Block['rows'][number]) => value(r[c]), raw: (r: Block['rows'][number]) => r[c] };
          }), block.rows),
    ),
  );
}

/** A plan as a scenario to go on with: the study's scenario lies with its runs. */
function continueLink(study: Study): Child {
  return study.best_run === null ? null : h('a', { href: `#/scenario/run/${study.best_run}`, class: 'button' }, t('study.continue'));
}

const often = 2000;

export const studyPage: PageMaker = async (context, [id = '']) => {
  const [study, version] = await Promise.all([api.study(id, context.signal), api.version(context.signal)]);
  const sample = await api.trials(id, `sample=${mostDrawn}&best=${signOf(study) === 1 ? 'low' : 'high'}`, context.signal);
  const today = study.result['front'] && study.baseline_run !== null ? await api.run(String(study.baseline_run), false, context.signal) : null;
  const changes = changeList(study.changes);
  const trials: Trials = { total: sample.total, list: sample.trials };
  const redraws: (() => void)[] = [];
  const live = h('p', { class: 'live', role: 'status', id: 'live' });
  if (study.status === 'running') {
    // The study writes, this page reads: what is new since the last look, every two seconds.
    let last = Math.max(0, ...trials.list.map((x) => x.number));
    const look = async () => {
      try {
        for (;;) {
          const news = await api.trials(id, `after=${last}&limit=2000`, context.signal);
          trials.total = news.total;
          trials.list.push(...news.trials);
          last = Math.max(last, ...news.trials.map((x) => x.number));
          if (news.trials.length > 0) redraws.forEach((f) => f());
          if (news.trials.length < 2000) break;
        }
        const now = await api.study(id, context.signal);
        live.textContent = t('study.live', { trials: whole(trials.total), time: dateTime(new Date().toISOString()) });
        if (now.status !== 'running') return dispatchEvent(new HashChangeEvent('hashchange'));
      } catch {
        if (context.signal.aborted) return;
        live.textContent = t('state.offline');
      }
      timer = window.setTimeout(() => void look(), often);
    };
    let timer = window.setTimeout(() => void look(), often);
    context.whenLeft(() => clearTimeout(timer));
  }
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
      study.status === 'running' ? live : null,
      study.result.words ? h('p', { class: `panel finding words ${study.result.verdict ?? ''}`, id: 'finding' }, findingWords(study)) : null,
      resumeSection(context, study, version.read_only),
      h('p', { class: 'row no-print' }, continueLink(study), study.kind === 'optimize' ? h('a', { href: `#/report/${study.id}` }, t('report.title')) : null, study.best_run !== null ? h('a', { href: `#/sheet/${study.best_run}` }, t('sheet.title')) : null),
      annotationEditor('studies', study.id, study, version.read_only),
      study.kind === 'optimize' ? h('div', { class: 'columns' }, pointSection(study), study.variables.length > 0 && trials.total > 0 ? planeSection(context, study, trials, redraws) : null) : null,
      bindingSection(study),
      oneCutSection(study),
      frontSection(context, study, today?.kpis ?? []),
      tornadoSection(context, study),
      lossSection(context, study),
      study.kind === 'losses' || study.kind === 'compare' ? null : trials.total === 0 && study.status !== 'running' ? section(t('study.history'), '', h('p', {}, t('study.noTrials'))) : trialSections(context, study, trials, redraws),
      blockSections(study),
    ),
  };
};
