// The morning report of a study: one page to print. What to change, what it brings, what did not matter.

import { api } from '../api';
import { fragment, h, table } from '../dom';
import { dateTime, estimateText, fixed, significant, unitText } from '../format';
import { named, t } from '../i18n';
import { difference } from '../logic/statistics';
import { section, type PageMaker } from '../page';
import type { Kpi, PlanPoint, Run, Study } from '../types';
import { findingWords } from './study';

interface Move {
  name: string;
  unit: string;
  from: unknown;
  to: unknown;
  /** Step against the range searched; categories count as a whole one. */
  share: number;
}

export function moves(study: Study): Move[] {
  const { baseline, best } = study.result;
  if (!baseline || !best) return [];
  return study.variables.flatMap((v) => {
    const of = (p: PlanPoint): unknown => { const found = p.values.find((x) => x.pointer === v.pointer); return found?.text ?? found?.value; };
    const [from, to] = [of(baseline), of(best)];
    if (from === undefined || to === undefined) return [];
    const numbers = typeof from === 'number' && typeof to === 'number' && v.high > v.low;
    return [{ name: v.name, unit: v.unit, from, to, share: numbers ? Math.abs(to - from) / (v.high - v.low) : JSON.stringify(from) === JSON.stringify(to) ? 0 : 1 }];
  });
}

const shown = (value: unknown) => (typeof value === 'number' ? significant(value, 4) : typeof value === 'string' ? value : JSON.stringify(value));
/** A step of less than a hundredth of the range is left alone on a shop floor. */
const smallStep = 0.01;

export const reportPage: PageMaker = async (context, [id = '']) => {
  const study = await api.study(id, context.signal);
  const runs = study.baseline_run !== null && study.best_run !== null ? await Promise.all([study.baseline_run, study.best_run].map((r) => api.run(String(r), true, context.signal))) : [];
  const [a, b] = runs as [Run | undefined, Run | undefined];
  const all = moves(study);
  const change = all.filter((m) => m.share >= smallStep);
  const leave = all.filter((m) => m.share < smallStep);
  const effects = a && b ? a.kpis.flatMap((kpi) => {
    const other = b.kpis.find((k) => k.name === kpi.name);
    const d = other ? difference(kpi.values ?? [], other.values ?? [], a.seed === b.seed) : null;
    return other && d && !(kpi.mean === 0 && other.mean === 0) && !kpi.name.includes('/') ? [{ kpi, other, d }] : [];
  }) : [];
  interface Effect { kpi: Kpi; other: Kpi; d: NonNullable<ReturnType<typeof difference>> }
  const effectTable = (head: string, rows: Effect[]) =>
    table<Effect>(head, [
      { head: t('col.name'), rowHead: true, cell: (e) => h('span', { title: e.kpi.meaning }, named('kpi', e.kpi.name)) },
      { head: t('col.today'), number: true, cell: (e) => estimateText(e.kpi.mean, e.kpi.half_width_95), raw: (e) => e.kpi.mean },
      { head: t('col.best'), number: true, cell: (e) => estimateText(e.other.mean, e.other.half_width_95), raw: (e) => e.other.mean },
      { head: t('col.difference'), number: true, cell: (e) => estimateText(e.d.mean, e.d.halfWidth), raw: (e) => e.d.mean },
      { head: t('col.unit'), cell: (e) => h('span', { class: 'unit' }, unitText(e.kpi.unit) || '1') },
    ], rows);
  const clear = effects.filter((e) => e.d.verdict === 'higher' || e.d.verdict === 'lower');
  const same = effects.filter((e) => e.d.verdict === 'indistinguishable');
  const bounds = study.variables.filter((v) => {
    const to = study.result.best?.values.find((x) => x.pointer === v.pointer)?.value;
    return v.type !== 'categorical' && typeof to === 'number' && v.high > v.low && Math.min(Math.abs(to - v.low), Math.abs(v.high - to)) < smallStep * (v.high - v.low);
  });
  return {
    title: `${t('report.title')}: ${study.name}`,
    body: fragment(
      h('h1', {}, t('report.title'), h('span', { class: 'unit' }, ` ${study.name}`)),
      h('p', { class: 'muted facts' }, `${study.scenario} · ${dateTime(study.provenance.created)} · `, h('a', { href: `#/studies/${study.id}` }, t('study.title', { id: study.id }))),
      h('p', { class: 'no-print' }, h('button', { type: 'button', onclick: () => print() }, t('print'))),
      h('p', { class: `panel finding words ${study.result.verdict ?? ''}`, id: 'finding' }, findingWords(study)),
      section(t('report.change'), '', change.length === 0 ? h('p', {}, t('report.nothing')) : table<Move>(t('report.change'), [
        { head: t('col.variable'), rowHead: true, cell: (m) => m.name },
        { head: t('report.from'), number: true, cell: (m) => shown(m.from), raw: (m) => shown(m.from) },
        { head: t('report.to'), number: true, cell: (m) => h('strong', {}, shown(m.to)), raw: (m) => shown(m.to) },
        { head: t('col.unit'), cell: (m) => h('span', { class: 'unit' }, unitText(m.unit) || '1') },
        { head: t('report.step'), unit: '%', number: true, cell: (m) => fixed(100 * m.share, 0), raw: (m) => 100 * m.share },
      ], change)),
      clear.length > 0 ? section(t('report.effects'), '', effectTable(t('report.effects'), clear)) : null,
      section(t('report.noMatter'), '',
        leave.length > 0 ? h('p', {}, t('report.leave', { names: leave.map((m) => m.name).join(', ') })) : null,
        same.length > 0 ? h('p', {}, t('report.same', { names: same.map((e) => named('kpi', e.kpi.name)).join(', ') })) : null,
        leave.length + same.length === 0 ? h('p', {}, t('none')) : null),
      section(t('report.breaks'), '',
        bounds.length > 0 ? h('p', {}, t('report.bounds', { names: bounds.map((v) => v.name).join(', ') })) : h('p', {}, t('report.inside')),
        h('p', {}, t('report.assumes', { scenario: study.scenario, replications: b?.replications ?? '–' })),
        study.result.best?.analytic !== null && study.result.best?.analytic !== undefined && typeof study.result.best.simulated.mean === 'number'
          ? h('p', {}, t('report.model', { longRun: significant(study.result.best.analytic), simulated: significant(study.result.best.simulated.mean), unit: study.result.unit ?? '' }))
          : null),
    ),
  };
};
