// Parts of a study's page: what holds the plan back, one cut against the shop, uncertain inputs, losses, the front.

import { api, ApiError } from '../api';
import { chart } from '../charts/chart';
import { frontOption } from '../charts/studyViews';
import { timeBars } from '../charts/timeBars';
import { tornadoOption } from '../charts/tornado';
import { fragment, h, table, type Child } from '../dom';
import { estimateText, significant, unitText, whole } from '../format';
import { named, t } from '../i18n';
import { bindingOf, frontPlans, lossesOf, oneCutOf, pricedLosses, sensitivityOf, type Binding, type FrontPlan, type Losses, type OneCut, type PricedLoss, type Sensitivity } from '../logic/answer';
import { begin, remember } from '../logic/draft';
import { applyChanges, type Json } from '../logic/pointer';
import { section, type PageContext } from '../page';
import type { Change, Job, Kpi, PlanPoint, Study } from '../types';
import { jobPanel } from '../ui/job';

const number = (x: number | null | undefined, digits = 4) => (typeof x === 'number' ? significant(x, digits) : '–');

/** Variables on their bounds and constraints that are used up, with what a unit of more room would bring. */
export function bindingSection(study: Study): HTMLElement | null {
  const rows = bindingOf(study.result);
  if (rows.length === 0) return null;
  const unit = study.result.unit ?? '';
  return section(t('binding.title'), '', table<Binding>(t('binding.title'), [
    { head: t('col.name'), rowHead: true, cell: (b) => named('kpi', b.name) },
    { head: t('binding.value'), number: true, cell: (b) => number(b.value, 6), raw: (b) => b.value },
    { head: t('binding.allowed'), number: true, cell: (b) => number(b.allowed, 6), raw: (b) => b.allowed },
    { head: t('col.unit'), cell: (b) => h('span', { class: 'unit' }, unitText(b.unit) || '1') },
    { head: t('binding.price'), unit, number: true, cell: (b) => number(b.shadow_price, 3), raw: (b) => b.shadow_price },
  ], rows), h('p', { class: 'muted' }, t('binding.hint')));
}

/** The textbook's two speeds of every cut beside the one that the shop as a whole wants. */
export function oneCutSection(study: Study): HTMLElement | null {
  const rows = oneCutOf(study.result);
  if (rows.length === 0) return null;
  return section(t('onecut.title'), 'm/min', table<OneCut>(t('onecut.title'), [
    { head: t('sheet.operation'), rowHead: true, cell: (r) => r.operation },
    { head: t('onecut.cost'), number: true, cell: (r) => number(r.speed_min_cost_m_min), raw: (r) => r.speed_min_cost_m_min },
    { head: t('onecut.rate'), number: true, cell: (r) => number(r.speed_max_rate_m_min), raw: (r) => r.speed_max_rate_m_min },
    { head: t('onecut.shop'), number: true, cell: (r) => h('strong', {}, number(r.speed_shop_m_min)), raw: (r) => r.speed_shop_m_min },
    { head: t('onecut.why'), cell: (r) => r.why ?? '' },
  ], rows), h('p', { class: 'muted' }, t('onecut.hint')));
}

export function tornadoSection(context: PageContext, study: Study): HTMLElement | null {
  const rows = sensitivityOf(study.result);
  const centre = study.result.best?.analytic ?? null;
  if (rows.length === 0) return null;
  const unit = study.result.unit ?? '';
  const regret = (x: number | null) => (x === null ? h('span', { class: 'bad' }, t('tornado.broken')) : significant(x, 3));
  return section(
    t('tornado.title'),
    unit,
    centre === null ? null : chart(context, rows.map((r) => `${r.name}: ${number(r.objective_low)} … ${number(r.objective_high)} ${unit}`).join('; '), rows.length > 5 ? 'large' : 'medium', (theme) => tornadoOption(rows, centre, unit, { low: t('tornado.low'), high: t('tornado.high') }, theme), { name: t('tornado.title'), data: () => [['input', 'lower', 'higher'], ...rows.map((r) => [r.name, r.objective_low, r.objective_high])] }).element,
    table<Sensitivity>(t('tornado.title'), [
      { head: t('tornado.input'), rowHead: true, cell: (r) => `${r.name}${r.relative === null ? '' : ` ± ${significant(100 * r.relative, 3)} %`}` },
      { head: t('tornado.low'), unit, number: true, cell: (r) => number(r.objective_low, 6), raw: (r) => r.objective_low },
      { head: t('tornado.high'), unit, number: true, cell: (r) => number(r.objective_high, 6), raw: (r) => r.objective_high },
      { head: t('tornado.regretLow'), unit, number: true, cell: (r) => regret(r.regret_low), raw: (r) => r.regret_low },
      { head: t('tornado.regretHigh'), unit, number: true, cell: (r) => regret(r.regret_high), raw: (r) => r.regret_high },
    ], rows),
    h('p', { class: 'muted' }, t('tornado.hint')),
  );
}

/** The price list: each loss as parts a week and money a month. */
export function lossTable(context: PageContext, losses: Losses): HTMLElement {
  const rows = pricedLosses(losses);
  const money = rows.filter((r) => (r.moneyPerMonth ?? 0) > 0);
  return h('div', { class: 'losses' },
    money.length > 1 ? chart(context, t('loss.title'), 'medium', (theme) => ({
      ...timeBars([losses.currency], money.map((r) => ({ machine: r.name, percent: [r.moneyPerMonth ?? 0] })), theme),
      legend: { show: false },
      xAxis: { type: 'value', min: 0, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v, 3) }, splitLine: { lineStyle: { color: theme.line } } },
      series: [{ type: 'bar', name: losses.currency, barMaxWidth: 24, itemStyle: { color: theme.accent }, data: money.map((r) => r.moneyPerMonth ?? 0), tooltip: { valueFormatter: (v: unknown) => `${significant(Number(v), 4)} ${losses.currency}` } }],
    }), { name: t('loss.title'), data: () => [['loss', `${losses.currency} / 30 d`, '± 95 %'], ...money.map((r) => [r.name, r.moneyPerMonth, r.moneyHalf])] }).element : null,
    table<PricedLoss>(t('loss.title'), [
      { head: t('loss.removed'), rowHead: true, cell: (r) => r.name },
      { head: t('loss.parts'), unit: t('loss.partsUnit'), number: true, cell: (r) => estimateText(r.partsPerWeek, r.partsHalf), raw: (r) => r.partsPerWeek },
      { head: t('loss.money'), unit: `${losses.currency} / 30 ${t('trace.day')}`, number: true, cell: (r) => estimateText(r.moneyPerMonth, r.moneyHalf), raw: (r) => r.moneyPerMonth },
    ], rows),
    h('p', { class: 'muted' }, t('loss.hint', { replications: losses.replications })));
}

export function lossSection(context: PageContext, study: Study): HTMLElement | null {
  const losses = lossesOf(study.result);
  return losses ? section(t('loss.title'), '', lossTable(context, losses)) : null;
}

/** What makes a plan of a study's scenario; a categorical value is the place of its option. */
export function planChanges(study: Pick<Study, 'variables'>, values: PlanPoint['values']): Change[] {
  return values.map((v) => {
    const variable = study.variables.find((x) => x.pointer === v.pointer);
    const categorical = variable?.type === 'categorical' && typeof v.value === 'number';
    return { pointer: v.pointer, value: categorical ? (variable?.options?.[v.value as number] ?? null) : v.value };
  });
}

async function openPlan(study: Study, values: PlanPoint['values'], signal: AbortSignal): Promise<void> {
  const run = study.baseline_run ?? study.best_run;
  if (run === null) return;
  const stored = await api.runScenario(String(run), signal);
  const base = JSON.parse(stored.scenario) as Json;
  const now = applyChanges(base, [...stored.changes, ...planChanges(study, values)]);
  remember({ ...begin(study.name, stored.scenario, base, now), runs: [run] });
  location.hash = '#/scenario';
}

/** @param kpis of the study's run of today: where the units of the objectives stand */
export function frontSection(context: PageContext, study: Study, kpis: readonly Kpi[]): HTMLElement | null {
  const front = frontPlans(study.result);
  if (!front) return null;
  const names = front.names.map((n) => named('kpi', n));
  const units = front.names.map((n) => unitText(kpis.find((k) => k.name === n)?.unit ?? ''));
  const withUnits = names.map((n, o) => [n, units[o]].filter(Boolean).join(', '));
  const today = (pointer: string) => study.result.baseline?.values.find((v) => v.pointer === pointer);
  const shown = (v: PlanPoint['values'][number] | undefined) => (v === undefined ? '–' : (v.text ?? (typeof v.value === 'number' ? significant(v.value) : JSON.stringify(v.value))));
  const place = h('div', { id: 'front-plan', role: 'status' }, h('p', { class: 'muted' }, t('front.click')));
  const show = (k: number) => {
    const plan = front.points[k];
    if (!plan) return;
    place.replaceChildren(fragment(
      h('h3', {}, t('front.plan', { n: k + 1 }), plan.knee ? ` (${t('study.knee')})` : ''),
      table<PlanPoint['values'][number]>(t('front.plan', { n: k + 1 }), [
        { head: t('col.variable'), rowHead: true, cell: (v) => v.name },
        { head: t('col.today'), number: true, cell: (v) => shown(today(v.pointer)) },
        { head: t('front.this'), number: true, cell: shown, raw: (v) => (typeof v.value === 'number' ? v.value : shown(v)) },
        { head: t('col.unit'), cell: (v) => h('span', { class: 'unit' }, unitText(v.unit) || '1') },
      ], plan.values),
      h('p', {}, names.map((n, o) => `${n}: ${estimateText(plan.simulated[o]?.mean ?? plan.objectives[o], plan.simulated[o]?.half_width)} ${units[o] ?? ''}`.trim()).join('; ')),
      h('p', { class: 'no-print' }, h('button', { type: 'button', onclick: () => void openPlan(study, plan.values, context.signal) }, t('front.use'))),
    ));
    place.dataset['point'] = String(k);
  };
  const knee = front.points.findIndex((p) => p.knee);
  const picture = names.length < 2 ? null : chart(context, t('study.front'), 'large', (theme) => frontOption(front.points, withUnits, theme), {
    name: t('study.front'),
    data: () => [withUnits, ...front.points.map((p) => p.objectives)],
    onClick: (item) => show(item.seriesName === t('study.knee') ? knee : item.dataIndex),
  });
  return section(
    t('study.front'),
    '',
    h('div', { class: 'columns even' }, picture?.element ?? null, place),
    table<FrontPlan>(t('study.front'), [
      { head: t('front.point'), rowHead: true, cell: (p) => { const k = front.points.indexOf(p); return h('button', { type: 'button', class: 'quiet small', onclick: () => show(k), 'aria-label': t('front.show', { n: k + 1 }) }, k + 1, p.knee ? ` ${t('study.knee')}` : ''); } },
      ...names.map((n, o) => ({ head: n, unit: units[o] ?? '', number: true, cell: (p: FrontPlan) => number(p.objectives[o], 6), raw: (p: FrontPlan) => p.objectives[o] })),
      ...names.map((n, o) => ({ head: t('study.simulated', { objective: n }), unit: units[o] ?? '', number: true, cell: (p: FrontPlan) => estimateText(p.simulated[o]?.mean, p.simulated[o]?.half_width), raw: (p: FrontPlan) => p.simulated[o]?.mean })),
      ...study.variables.map((v) => ({ head: v.name, unit: unitText(v.unit), number: true, cell: (p: FrontPlan) => shown(p.values.find((x) => x.pointer === v.pointer)) })),
    ], front.points),
  );
}

/** An interrupted study goes on where it stopped. */
export function resumeSection(context: PageContext, study: Study, readOnly: boolean): Child {
  if (study.status !== 'interrupted') return null;
  const place = h('div');
  const note = h('p', { class: 'bad', role: 'alert' });
  const can = study.kind === 'optimize' || study.kind === 'sweep';
  const button = h('button', { type: 'button', id: 'resume', disabled: readOnly, onclick: () => {
    button.disabled = true;
    note.textContent = '';
    api.startJob({ kind: 'resume', study: study.id }).then(
      (job: Job) => place.replaceChildren(jobPanel(context, job, (end) => { if (end.state === 'finished') dispatchEvent(new HashChangeEvent('hashchange')); else button.disabled = false; })),
      (e: unknown) => { button.disabled = false; note.textContent = e instanceof ApiError && e.message ? e.message : t('state.offline'); },
    );
  } }, t('study.resume'));
  return h('div', { class: 'no-print' }, h('p', { class: 'warn' }, t('study.interrupted', { trials: whole(study.trials) })), can ? h('p', {}, button) : null, note, place);
}
