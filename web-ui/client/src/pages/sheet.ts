// The tool-change sheet of a run: printable, per machine, every N parts, stops merged into common windows. Ages and times
// come from the plans and the catalogue; only whole parts and windows are counted here.

import { api } from '../api';
import { chart } from '../charts/chart';
import { survivalOption, type SurvivalCurve } from '../charts/survival';
import { fragment, h, table } from '../dom';
import { dateTime, significant, whole } from '../format';
import { t } from '../i18n';
import { groupsOf } from '../logic/graph';
import { applyChanges, type Json } from '../logic/pointer';
import { changeSheet, stops, type SheetRow, type ToolJob } from '../logic/windows';
import { section, type PageContext, type PageMaker } from '../page';

type ObjectJson = { [key: string]: Json };
const isObject = (v: Json | undefined): v is ObjectJson => typeof v === 'object' && v !== null && !Array.isArray(v);
const list = (v: Json | undefined): ObjectJson[] => (Array.isArray(v) ? v.filter(isObject) : []);
const text = (v: Json | undefined): string => (typeof v === 'string' ? v : Array.isArray(v) && typeof v[0] === 'string' ? v[0] : '');
const key = 'K117.gamma_percent_life';
const mostStops = 8;
const shares = Array.from({ length: 99 }, (_, k) => (99 - k) / 100);

/** How many edges live how long, with the age at which they are changed. */
function survival(context: PageContext, curves: readonly SurvivalCurve[]): HTMLElement | null {
  if (curves.length === 0) return null;
  const label = t('sheet.survival');
  return chart(context, `${label}: ${curves.map((c) => c.name).join('; ')}`, 'medium', (theme) => survivalOption(curves, theme), {
    name: label,
    data: () => [['tool', 'min', label], ...curves.flatMap((c) => c.points.map(([age, share]) => [c.name, age, share]))],
  }).element;
}

export const sheetPage: PageMaker = async (context, [id = '']) => {
  const [run, stored] = await Promise.all([api.run(id, false, context.signal), api.runScenario(id, context.signal)]);
  const scenario = applyChanges(JSON.parse(stored.scenario) as Json, stored.changes) as ObjectJson;
  const tools = new Map(list(scenario['tools']).map((x) => [text(x['name']), x]));
  const groups = list(scenario['machines']);
  const jobs: ToolJob[] = [];
  const curves: SurvivalCurve[] = [];
  const failed: string[] = [];
  for (const operation of list(scenario['operations'])) {
    const tool = tools.get(text(operation['tool']));
    if (!tool) continue;
    const name = text(operation['name']);
    try {
      const plan = await api.plan({ scenario: stored.scenario, changes: stored.changes, operation: name }, context.signal);
      const strategy = isObject(tool['strategy']) ? tool['strategy'] : {};
      const gamma = typeof strategy['gamma'] === 'number' ? strategy['gamma'] : strategy['kind'] === undefined ? 0.64 : null;
      const life = plan.edge_life;
      let age: number | null = null;
      if (life && gamma !== null) {
        const inputs = { law: life.law, gamma, mean_min: life.mean_min, ...(life.law === 'exponential' ? {} : { cv: life.cv }) };
        const answer = await api.evaluate(key, inputs, context.signal);
        age = typeof answer['T_gamma_min'] === 'number' ? answer['T_gamma_min'] : null;
      }
      if (life) {
        // The age that a share of the edges survives, share by share, is the survival curve.
        const inputs = { law: life.law, gamma: 0.5, mean_min: life.mean_min, ...(life.law === 'exponential' ? {} : { cv: life.cv }) };
        const map = await api.map(key, { inputs, output: 'T_gamma_min', x: { name: 'gamma', values: shares } }, context.signal);
        const points = shares.flatMap((share, k): [number, number][] => { const at = map.values[0]?.[k]; return typeof at === 'number' ? [[at, share]] : []; });
        curves.push({ name: `${text(operation['tool'])}, ${name}`, machine: groupsOf(operation, groups).join(', '), points, age, share: gamma });
      }
      jobs.push({ machine: groupsOf(operation, groups).join(', '), tool: text(operation['tool']), operation: name, cutting_min: plan.main_time_min, age_min: age });
    } catch (e) {
      if (context.signal.aborted) throw e;
      failed.push(`${name}: ${String(e instanceof Error ? e.message : e)}`);
    }
  }
  const rows = changeSheet(jobs);
  const machines = [...new Set(rows.map((r) => r.machine))];
  const parts = (n: number | null) => (n === null ? t('sheet.atFailure') : whole(n));
  return {
    title: t('sheet.title'),
    body: fragment(
      h('h1', {}, t('sheet.title'), h('span', { class: 'unit' }, ` ${run.scenario}, `, h('a', { href: `#/runs/${run.id}` }, t('run.title', { id: run.id })))),
      h('p', { class: 'muted facts' }, dateTime(run.provenance.created)),
      h('p', { class: 'no-print' }, h('button', { type: 'button', onclick: () => print() }, t('print'))),
      rows.length === 0 ? h('p', {}, t('sheet.empty')) : null,
      failed.map((f) => h('p', { class: 'bad' }, f)),
      machines.map((machine) => {
        const own = rows.filter((r) => r.machine === machine);
        const planned = stops(rows, machine, mostStops);
        return section(
          machine,
          '',
          table<SheetRow>(`${t('sheet.title')} ${machine}`, [
            { head: t('col.tool'), rowHead: true, cell: (r) => r.tool },
            { head: t('sheet.operation'), cell: (r) => r.operation },
            { head: t('sheet.merged'), unit: t('sheet.parts'), number: true, cell: (r) => h('strong', { class: 'every' }, parts(r.merged)), raw: (r) => r.merged },
            { head: t('sheet.alone'), unit: t('sheet.parts'), number: true, cell: (r) => parts(r.every), raw: (r) => r.every },
            { head: t('sheet.age'), unit: 'min', number: true, cell: (r) => (r.age_min === null ? '–' : significant(r.age_min, 4)), raw: (r) => r.age_min },
            { head: t('sheet.cutting'), unit: 'min', number: true, cell: (r) => significant(r.cutting_min, 4), raw: (r) => r.cutting_min },
            { head: t('sheet.lost'), unit: '%', number: true, cell: (r) => significant(100 * r.lost, 2), raw: (r) => 100 * r.lost },
            { head: t('sheet.done'), cell: () => '' },
          ], own),
          survival(context, curves.filter((c) => c.machine === machine)),
          planned.length > 0 && own.length > 1 ? [h('h3', {}, t('sheet.stops')), h('ol', { class: 'stops' }, planned.map(([n, names]) => h('li', {}, t('sheet.stop', { n: whole(n), names: names.join(', ') }))))] : null,
        );
      }),
      h('p', { class: 'muted' }, t('sheet.hint', { key })),
    ),
  };
};
