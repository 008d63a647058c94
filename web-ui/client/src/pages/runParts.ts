// Parts of a run's page: lead time, the shop's bottleneck, losses by ISO 22400 and SEMI E10, flow of parts, tools overnight.

import { api, ApiError } from '../api';
import { chart } from '../charts/chart';
import { sankeyOption } from '../charts/sankey';
import { timeBars, type TimeRow } from '../charts/timeBars';
import { fragment, h, table, type Child } from '../dom';
import { estimateText, fixed, significant, whole } from '../format';
import { named, t, type Key } from '../i18n';
import { lossesOf } from '../logic/answer';
import { readTrace } from '../logic/gantt';
import { find, machineTimes } from '../logic/kpis';
import { roundKeepingSum } from '../logic/shares';
import { bottleneck, e10Groups, e10Shares, empiricalQuantile, leadTimePhases, ownersOf, partFlows } from '../logic/shop';
import { section, type PageContext } from '../page';
import type { Kpi, Run } from '../types';
import { jobPanel } from '../ui/job';
import { lossTable } from './studyParts';
import { hourSection, shiftSection } from './traceParts';

const text = (kpi: Kpi | undefined, scale = 1) => (kpi ? estimateText(kpi.mean, kpi.half_width_95, scale) : '–');

/** Where parts spend their lead time. */
export function leadTimeSection(context: PageContext, run: Run): HTMLElement | null {
  const phases = leadTimePhases(run.kpis).filter((p) => (p.kpi.mean ?? 0) > 0);
  const total = find(run, 'lead_time_min');
  const sum = phases.reduce((s, p) => s + (p.kpi.mean ?? 0), 0);
  if (phases.length === 0 || sum <= 0) return null;
  const percent = roundKeepingSum(phases.map((p) => (100 * (p.kpi.mean ?? 0)) / sum), 1);
  const names = phases.map((p) => named('phase', p.phase));
  const quantiles = [['lead_time_p50_min', '50 %'], ['lead_time_p90_min', '90 %']].flatMap(([key = '', share = '']) => { const k = find(run, key); return k ? [t('lead.within', { share, time: text(k) })] : []; });
  return section(
    t('lead.title'),
    'min',
    chart(context, names.map((n, k) => `${n} ${fixed(percent[k] ?? 0, 1)} %`).join(', '), 'short', (theme) => timeBars(names, [{ machine: t('lead.title'), percent }], theme, phases.map((p) => p.phase)), { name: t('lead.title'), data: () => [['phase', 'min', '± 95 %'], ...phases.map((p) => [p.phase, p.kpi.mean, p.kpi.half_width_95])] }).element,
    table(t('lead.title'), [
      { head: t('lead.phase'), rowHead: true, cell: (p) => h('span', { title: p.kpi.meaning }, named('phase', p.phase)) },
      { head: t('col.mean'), unit: 'min', number: true, cell: (p) => text(p.kpi), raw: (p) => p.kpi.mean },
      { head: t('col.share'), unit: '%', number: true, cell: (p) => fixed(percent[phases.indexOf(p)] ?? 0, 1), raw: (p) => (100 * (p.kpi.mean ?? 0)) / sum },
    ], phases),
    total ? h('p', { class: 'muted', id: 'lead-total' }, [t('lead.total', { time: text(total) }), ...quantiles].join('; ')) : null,
  );
}

/** Which machine holds the shop back, and who waits for whom. */
export function flowSection(run: Run): HTMLElement | null {
  const machines = machineTimes(run.kpis).filter((m) => m.states.length > 0);
  if (machines.length < 2) return null;
  const first = bottleneck(run.kpis);
  const of = (machine: string, leaf: string) => find(run, `machine/${machine}/${leaf}`);
  const share = (machine: string, states: string[]) => states.reduce((s, state) => s + (of(machine, `state/${state}`)?.mean ?? 0), 0);
  type Row = (typeof machines)[number];
  const percent = (head: string, states: string[]) => ({ head, unit: '%', number: true, cell: (m: Row) => fixed(100 * share(m.machine, states), 1), raw: (m: Row) => 100 * share(m.machine, states) });
  const estimateColumn = (head: string, unit: string, leaf: string) => ({ head, unit, number: true, cell: (m: Row) => text(of(m.machine, leaf)), raw: (m: Row) => of(m.machine, leaf)?.mean ?? null });
  return section(
    t('flow.title'),
    '',
    first ? h('p', { id: 'bottleneck', 'data-machine': first.machine }, first.rivals.length === 0 ? t('flow.bottleneck', { machine: first.machine }) : t('flow.rivals', { machine: first.machine, rivals: first.rivals.join(', ') })) : null,
    table<Row>(t('flow.title'), [
      { head: t('col.machine'), rowHead: true, cell: (m) => fragment(m.machine, m.machine === first?.machine ? h('span', { class: 'tag' }, t('flow.mark')) : null) },
      estimateColumn(t('flow.active'), 'min', 'active_period_min'),
      percent(t('flow.working'), ['cutting', 'working']),
      percent(t('flow.starved'), ['idle']),
      percent(t('flow.blocked'), ['blocked']),
      percent(t('flow.people'), ['waiting_crew', 'waiting_repair']),
      percent(t('flow.tools'), ['waiting_tool']),
      estimateColumn('MTBF', 'min', 'mtbf_min'),
      estimateColumn('MTTR', 'min', 'mttr_min'),
      estimateColumn(t('flow.energy'), t('flow.energyUnit'), 'energy_kwh_per_part'),
    ], machines, (m) => (m.machine === first?.machine ? 'total' : undefined)),
    h('p', { class: 'muted' }, t('flow.hint')),
  );
}

const iso = ['availability', 'effectiveness', 'quality', 'oee', 'busy'] as const;

/** The formulas behind the factors, for those who cannot hover. */
export function oeeFormulas(): HTMLElement {
  return h('details', { class: 'formulas' }, h('summary', {}, t('oee.formulas')), h('dl', {}, iso.map((f) => [h('dt', {}, t(`oee.name.${f}` as Key)), h('dd', {}, t(`oee.formula.${f}` as Key))])));
}

const six = ['breakdowns', 'setup', 'stops', 'speed', 'rejects', 'start_up'] as const;

/** The six big losses and SEMI E10: the same hours in two other groupings. */
export function groupingSection(context: PageContext, run: Run): HTMLElement | null {
  const machines = machineTimes(run.kpis).filter((m) => m.states.length > 0);
  if (machines.length === 0) return null;
  const e10: TimeRow[] = machines.map((m) => ({ machine: m.machine, percent: roundKeepingSum(e10Groups.map((g) => 100 * e10Shares(m.states)[g]), 1) }));
  const words = e10Groups.map((g) => t(`e10.${g}` as Key));
  const keys = ['cutting', 'idle', 'planned_change', 'failure_change', 'off_shift'];
  const withLosses = ownersOf(run.kpis, 'machine', 'loss/breakdowns').map((o) => o.name);
  const loss = (machine: string, l: string) => find(run, `machine/${machine}/loss/${l}`);
  return fragmentSections(
    section(
      t('e10.title'),
      '%',
      chart(context, e10.map((r) => `${r.machine}: ${words.map((w, k) => `${w} ${fixed(r.percent[k] ?? 0, 1)} %`).join(', ')}`).join('; '), e10.length > 6 ? 'tall' : e10.length > 3 ? 'medium' : 'short', (theme) => timeBars(words, e10, theme, keys), { name: 'SEMI E10', data: () => [[t('col.machine'), ...e10Groups], ...e10.map((r) => [r.machine, ...r.percent])] }).element,
      table<TimeRow>('SEMI E10', [
        { head: t('col.machine'), rowHead: true, cell: (r) => r.machine },
        ...e10Groups.map((g, k) => ({ head: h('span', { title: t(`e10.of.${g}` as Key) }, t(`e10.${g}` as Key)), unit: '%', number: true, cell: (r: TimeRow) => fixed(r.percent[k] ?? 0, 1) })),
      ], e10),
    ),
    withLosses.length === 0 ? null : section(
      t('six.title'),
      t('six.unit'),
      table<string>(t('six.title'), [
        { head: t('col.machine'), rowHead: true, cell: (m) => m },
        { head: h('span', { title: t('oee.formula.oee') }, 'OEE'), unit: '%', number: true, cell: (m) => text(find(run, `machine/${m}/oee`), 100), raw: (m) => find(run, `machine/${m}/oee`)?.mean ?? null },
        ...six.map((l) => ({ head: h('span', { title: find(run, `machine/${withLosses[0] ?? ''}/loss/${l}`)?.meaning ?? '' }, t(`six.${l}` as Key)), unit: '%', number: true, cell: (m: string) => text(loss(m, l), 100), raw: (m: string) => loss(m, l)?.mean ?? null })),
      ], withLosses),
    ),
  );
}
function fragmentSections(...sections: (HTMLElement | null)[]): HTMLElement {
  return h('div', {}, sections);
}

/** Parts, scrap and rework. */
export function sankeySection(context: PageContext, run: Run): HTMLElement | null {
  const words = { fresh: t('sankey.fresh'), back: t('sankey.back'), good: t('sankey.good'), hidden: t('sankey.hidden'), scrapped: t('sankey.scrapped'), rework: t('sankey.rework') };
  const flows = partFlows(run.kpis, words);
  if (flows.length === 0) return null;
  const height = new Set(flows.map((f) => f.to)).size > 6 ? 'large' : 'medium';
  return section(
    t('sankey.title'),
    t('sankey.unit'),
    chart(context, flows.map((f) => `${f.from} → ${f.to}: ${significant(f.value, 4)}`).join('; '), height, (theme) => sankeyOption(flows, { [words.good]: theme.good, [words.hidden]: '#E69F00', [words.scrapped]: theme.bad, [words.rework]: '#CC79A7', [words.back]: '#CC79A7', [words.fresh]: theme.muted }, theme), { name: t('sankey.title'), data: () => [['from', 'to', 'parts'], ...flows.map((f) => [f.from, f.to, f.value])] }).element,
    h('p', { class: 'muted' }, t('sankey.hint')),
  );
}

const bounds = (low: Kpi | undefined, high: Kpi | undefined) => (typeof low?.mean === 'number' && typeof high?.mean === 'number' ? `${significant(100 * low.mean, 4)} … ${significant(100 * high.mean, 4)}` : '–');

/** Whether the shop gets through an unattended interval, tool by tool. */
export function unattendedSection(run: Run): HTMLElement | null {
  const tools = ownersOf(run.kpis, 'tool', 'no_stop_share').filter((o) => o.kpi.mean !== null);
  if (tools.length === 0) return null;
  type Row = (typeof tools)[number];
  return section(t('night.title'), '', table<Row>(t('night.title'), [
    { head: t('col.tool'), rowHead: true, cell: (r) => r.name },
    { head: t('night.share'), unit: '%', number: true, cell: (r) => text(r.kpi, 100), raw: (r) => 100 * (r.kpi.mean ?? 0) },
    { head: t('night.interval'), unit: '%', number: true, cell: (r) => bounds(find(run, `tool/${r.name}/unattended/no_stop_low`), find(run, `tool/${r.name}/unattended/no_stop_high`)) },
    { head: t('night.sisters'), number: true, cell: (r) => text(find(run, `tool/${r.name}/sisters_needed`)), raw: (r) => find(run, `tool/${r.name}/sisters_needed`)?.mean ?? null },
    { head: t('night.surely'), number: true, cell: (r) => text(find(run, `tool/${r.name}/sisters_needed_surely`)), raw: (r) => find(run, `tool/${r.name}/sisters_needed_surely`)?.mean ?? null },
  ], tools), h('p', { class: 'muted' }, t('night.hint')));
}

/** How many inserts to order: the mean, and what nine of ten horizons like this one do not exceed. */
export function consumptionSection(context: PageContext, run: Run): HTMLElement | null {
  if (ownersOf(run.kpis, 'insert', 'consumption').length === 0) return null;
  const place = h('div', { id: 'consumption' }, h('p', { class: 'muted' }, t('page.loading')));
  const counted = run.horizon_min - run.warmup_min;
  api.run(String(run.id), true, context.signal).then((whole_) => {
    // Inserts, and the grades that several of them are of.
    const rows = (['insert', 'grade'] as const).flatMap((kind) => ownersOf(whole_.kpis, kind, 'consumption').map((o) => ({ ...o, path: `${kind}/${o.name}`, label: kind === 'grade' ? t('stock.grade', { name: o.name }) : o.name })));
    type Row = (typeof rows)[number];
    const p90 = (r: Row) => empiricalQuantile(r.kpi.values ?? [], 0.9);
    place.replaceChildren(
      table<Row>(t('stock.title'), [
        { head: t('stock.insert'), rowHead: true, cell: (r) => r.label },
        { head: t('col.mean'), unit: t('stock.counted', { days: significant(counted / 1440, 4) }), number: true, cell: (r) => text(r.kpi), raw: (r) => r.kpi.mean },
        { head: 'P90', unit: t('stock.counted', { days: significant(counted / 1440, 4) }), number: true, cell: (r) => significant(p90(r) ?? NaN, 5), raw: p90 },
        { head: t('stock.week'), unit: t('stock.weekUnit'), number: true, cell: (r) => text(find(whole_, `${r.path}/consumption_per_week`)), raw: (r) => find(whole_, `${r.path}/consumption_per_week`)?.mean ?? null },
        { head: t('stock.weekP90'), unit: t('stock.weekUnit'), number: true, cell: (r) => text(find(whole_, `${r.path}/consumption_week_p90`)), raw: (r) => find(whole_, `${r.path}/consumption_week_p90`)?.mean ?? null },
        { head: t('stock.month'), number: true, cell: (r) => estimateText(r.kpi.mean, r.kpi.half_width_95, 43200 / counted), raw: (r) => ((r.kpi.mean ?? 0) * 43200) / counted },
        { head: t('stock.per100'), number: true, cell: (r) => text(find(whole_, `${r.path}/consumption_per_100_parts`)), raw: (r) => find(whole_, `${r.path}/consumption_per_100_parts`)?.mean ?? null },
      ], rows),
      h('p', { class: 'muted' }, t('stock.hint', { replications: whole(run.replications) })),
    );
  }, (e: unknown) => { if (!context.signal.aborted) place.replaceChildren(h('p', { class: 'bad' }, e instanceof ApiError && e.message ? e.message : t('state.offline'))); });
  return section(t('stock.title'), '', place);
}

/** What each loss costs: simulated on demand, the shop without it against the shop. */
export function lossSection(context: PageContext, run: Run, readOnly: boolean): HTMLElement {
  const place = h('div', { id: 'losses' });
  const drawers: (() => void)[] = [];
  const button = h('button', { type: 'button', id: 'price-losses', disabled: readOnly || run.replications < 2, onclick: () => {
    button.disabled = true;
    const failed = (e: unknown): Child => { button.disabled = false; return h('p', { class: 'bad', role: 'alert' }, e instanceof ApiError && e.message ? e.message : t('state.offline')); };
    api.startJob({ kind: 'losses', run: run.id }).then(
      (job) => place.replaceChildren(jobPanel(context, job, (end) => {
        button.disabled = false;
        const study = end.result?.study;
        if (end.state !== 'finished' || study === undefined) return;
        api.study(String(study), context.signal).then((s) => {
          const losses = lossesOf(s.result);
          if (!losses) return;
          place.replaceChildren(losses.losses.length === 0 ? h('p', {}, t('loss.none')) : lossTable({ ...context, whenShown: (d) => drawers.push(d) }, losses), h('p', {}, h('a', { href: `#/studies/${study}` }, t('study.title', { id: study }))));
          requestAnimationFrame(() => drawers.splice(0).forEach((d) => d()));
        }, (e: unknown) => place.append(fragment(failed(e))));
      })),
      (e: unknown) => place.replaceChildren(fragment(failed(e))),
    );
  } }, t('loss.price'));
  return section(t('loss.title'), '', h('p', { class: 'muted' }, t('loss.what')), h('p', { class: 'no-print' }, button), place);
}

/** Insert-cycle availability of every tool on every machine that it works on. */
export function onMachinesSection(run: Run): HTMLElement | null {
  const found = run.kpis.flatMap((kpi) => {
    const match = /^tool\/(.+)\/on\/(.+)\/insert_cycle_availability$/.exec(kpi.name);
    return match ? [{ tool: match[1] ?? '', machine: match[2] ?? '', kpi }] : [];
  });
  type Row = (typeof found)[number];
  // With one machine the ledger says it already.
  if (found.length === 0 || found.every((a) => found.filter((b) => b.tool === a.tool).length === 1)) return null;
  return section(t('run.onMachines'), '%', table<Row>(t('run.onMachines'), [
    { head: t('col.tool'), rowHead: true, cell: (r) => r.tool },
    { head: t('col.machine'), cell: (r) => r.machine },
    { head: 'K_r', unit: '%', number: true, cell: (r) => h('span', { title: r.kpi.meaning }, text(r.kpi, 100)), raw: (r) => 100 * (r.kpi.mean ?? 0) },
  ], found));
}

/** A shop that locks itself is no shop to plan with: said above everything else. */
export function standstillWarning(run: Run): HTMLElement | null {
  const share = find(run, 'standstill_share');
  return share && (share.mean ?? 0) > 0 ? h('p', { class: 'panel warn', role: 'alert', id: 'standstill' }, t('run.standstill', { share: text(share, 100) })) : null;
}

/** Where the time went by shift and by hour: one replication, recorded on demand. */
export function slicesSection(context: PageContext, run: Run, readOnly: boolean): HTMLElement {
  const place = h('div', { id: 'slices' });
  const button = h('button', { type: 'button', id: 'record-slices', disabled: readOnly, onclick: () => {
    button.disabled = true;
    const failed = (e: unknown) => { button.disabled = false; place.replaceChildren(h('p', { class: 'bad', role: 'alert' }, e instanceof Error && e.message ? e.message : t('state.offline'))); };
    api.startJob({ kind: 'trace', run: run.id, replication: 0 }).then(
      (job) => place.replaceChildren(jobPanel(context, job, (end) => {
        button.disabled = false;
        if (end.state !== 'finished') return;
        api.jobOutput(end.id, context.signal).then((json) => {
          const trace = readTrace(json);
          place.replaceChildren(fragment(shiftSection(context, trace), hourSection(context, trace)));
          if (!place.firstChild) place.append(h('p', {}, t('run.bySlicesShort')));
        }).catch(failed);
      })),
      failed,
    );
  } }, t('trace.record'));
  return h('div', {}, section(t('run.bySlices'), '', h('p', { class: 'muted' }, t('run.bySlicesWhat')), h('p', { class: 'row no-print' }, button, h('a', { href: `#/trace/${run.id}` }, t('nav.trace')))), place);
}
