// One run: tiles, where the time went, tools, the cost of a part, and every indicator.

import { api, ApiError } from '../api';
import { chart } from '../charts/chart';
import { barName, bridgeOption } from '../charts/costBridge';
import { colourOf } from '../charts/theme';
import { timeBars, type TimeRow } from '../charts/timeBars';
import { fragment, h, table, type Child } from '../dom';
import { dateTime, estimate, estimateText, fixed, unitText, whole } from '../format';
import { named, t } from '../i18n';
import { costBridge } from '../logic/bridge';
import { entities, entityKinds, extreme, find, lastStep, machineTimes } from '../logic/kpis';
import { oeeRows, type OeeRow } from '../logic/oee';
import { roundKeepingSum } from '../logic/shares';
import { annotationEditor, changeList, command, downloadButton, section, type PageContext, type PageMaker } from '../page';
import type { Job, Kpi, Run } from '../types';
import { jobPanel } from '../ui/job';
import { consumptionSection, flowSection, groupingSection, leadTimeSection, lossSection, oeeFormulas, onMachinesSection, sankeySection, slicesSection, standstillWarning, unattendedSection } from './runParts';

function tile(id: string, label: string, kpi: Kpi | undefined, unit: string, scale: number, below: Child): HTMLElement | null {
  if (!kpi) return null;
  const e = estimate(kpi.mean, kpi.half_width_95, scale);
  return h(
    'div',
    { class: 'tile', 'data-kpi': kpi.name, id: `tile-${id}` },
    h('dt', {}, label),
    h('dd', {}, h('span', { class: 'value' }, e.mean), h('span', { class: 'unit' }, ' ', unit), e.half ? h('span', { class: 'half' }, `± ${e.half}`) : null),
    below ? h('dd', { class: 'below' }, below) : null,
  );
}

function tiles(run: Run): HTMLElement {
  const good = find(run, 'cost_per_good_part');
  const scrapped = find(run, 'parts_scrapped');
  const machines = machineTimes(run.kpis).flatMap((m) => (m.availability ? [{ name: m.machine, kpi: m.availability }] : []));
  const lowest = extreme(machines, 1);
  const failing = entities(run.kpis, 'tool').flatMap((e) => e.kpis.filter((k) => k.key === 'failure_share').map((k) => ({ name: e.name, kpi: k.kpi })));
  const worst = extreme(failing, -1);
  const crews = entities(run.kpis, 'crew').flatMap((e) => e.kpis.filter((k) => k.key === 'utilization').map((k) => ({ name: e.name, kpi: k.kpi })));
  const busiest = extreme(crews, -1);
  return h(
    'dl',
    { class: 'tiles' },
    tile('cost', t('tile.cost'), find(run, 'cost_per_part'), run.currency, 1, good ? t('tile.good', { value: estimateText(good.mean, good.half_width_95) }) : null),
    tile('throughput', t('tile.throughput'), find(run, 'throughput_per_h'), 'parts/h', 1, null),
    tile('availability', t('tile.availability'), lowest?.kpi, '%', 100, lowest ? (machines.length > 1 ? t('tile.lowest', { name: lowest.name, count: machines.length }) : lowest.name) : null),
    tile('failures', t('tile.failures'), worst?.kpi, '%', 100, worst ? (failing.length > 1 ? t('tile.highest', { name: worst.name, count: failing.length }) : worst.name) : null),
    tile('quality', t('tile.quality'), find(run, 'quality_ratio'), '%', 100, scrapped ? t('tile.scrap', { value: estimateText(scrapped.mean, scrapped.half_width_95) }) : null),
    tile('crew', t('tile.crew'), busiest?.kpi, '%', 100, busiest ? (crews.length > 1 ? t('tile.highest', { name: busiest.name, count: crews.length }) : busiest.name) : null),
  );
}

function swatch(colour: string): HTMLElement {
  const box = h('span', { class: 'swatch', 'aria-hidden': 'true' });
  box.style.background = colour;
  return box;
}

function timeSection(context: PageContext, run: Run): HTMLElement {
  const machines = machineTimes(run.kpis).filter((m) => m.states.length > 0);
  if (machines.length === 0) return section(t('run.time'), '', h('p', {}, t('run.noMachines')));
  const order = [...new Set(machines.flatMap((m) => m.states.map((s) => s.state)))];
  // States that no machine was ever in are noise.
  const states = order.filter((state) => machines.some((m) => m.states.some((s) => s.state === state && s.kpi.mean !== 0)));
  const rows: TimeRow[] = machines.map((m) => ({
    machine: m.machine,
    percent: roundKeepingSum(states.map((state) => 100 * (m.states.find((s) => s.state === state)?.kpi.mean ?? 0)), 1),
  }));
  const label = rows.map((r) => `${r.machine}: ${states.map((s, k) => `${named('state', s)} ${fixed(r.percent[k] ?? 0, 1)} %`).join(', ')}`).join('; ');
  const bars = chart(context, label, rows.length > 6 || (rows.length > 3 && states.length > 8) ? 'tall' : rows.length > 3 || states.length > 8 ? 'medium' : 'short', (theme) => timeBars(states.map((s) => named('state', s)), rows, theme, states), { name: t('run.time'), data: () => [[t('col.machine'), ...states], ...machines.map((m) => [m.machine, ...states.map((st) => m.states.find((x) => x.state === st)?.kpi.mean ?? 0)])] });
  return section(
    t('run.time'),
    t('run.timeUnit'),
    bars.element,
    table(
      t('run.time'),
      [
        { head: t('col.machine'), rowHead: true, cell: (r: TimeRow) => r.machine },
        ...states.map((state, k) => ({ head: fragment(swatch(colourOf(state, k)), named('state', state)), unit: '%', number: true, cell: (r: TimeRow) => fixed(r.percent[k] ?? 0, 1) })),
        { head: t('total'), unit: '%', number: true, cell: (r: TimeRow) => fixed(r.percent.reduce((a, b) => Math.round(10 * (a + b)) / 10, 0), 1) },
      ],
      rows,
    ),
  );
}

/** Shares are printed in percent. */
const isShare = (key: string, kpi: Kpi | undefined) => (kpi === undefined || kpi.unit === '1') && /(_share|_ratio|_rate|utilization|availability|effectiveness|oee)$|^state\//.test(key);

/** One table for the tools, the crews, or whatever else the run has indicators of. */
function entitySection(run: Run, kind: string, head: string): HTMLElement {
  const tools = entities(run.kpis, kind);
  // Machine by machine has a table of its own.
  const keys = [...new Set(tools.flatMap((e) => e.kpis.map((k) => k.key)))].filter((key) => !key.startsWith('on/'));
  // One tool reads best down the page, several side by side.
  return section(
    head,
    t('run.toolsUnit'),
    table(
      head,
      [
        { head: t('col.name'), rowHead: true, cell: (key: string) => named('kpi', key) },
        ...tools.map((tool) => ({
          head: tool.name,
          number: true,
          raw: (key: string) => tool.kpis.find((k) => k.key === key)?.kpi.mean,
          cell: (key: string) => {
            const kpi = tool.kpis.find((k) => k.key === key)?.kpi;
            return kpi ? h('span', { title: kpi.meaning }, estimateText(kpi.mean, kpi.half_width_95, isShare(key, kpi) ? 100 : 1)) : '–';
          },
        })),
        { head: t('col.unit'), cell: (key: string) => h('span', { class: 'unit' }, isShare(key, tools.flatMap((e) => e.kpis).find((k) => k.key === key)?.kpi) ? '%' : unitText(tools.flatMap((e) => e.kpis).find((k) => k.key === key)?.kpi.unit ?? '')) },
      ],
      keys,
    ),
  );
}

function toolSection(run: Run): HTMLElement {
  if (entities(run.kpis, 'tool').length === 0) return section(t('run.tools'), '', h('p', {}, t('run.noTools')));
  return entitySection(run, 'tool', t('run.tools'));
}

/** Overall effectiveness: what each of the three factors takes, as shares of the planned time. */
function oeeSection(context: PageContext, run: Run): HTMLElement | null {
  const rows = oeeRows(run.kpis);
  if (rows.length === 0) return null;
  const label = rows.map((r) => `${r.name}: OEE ${fixed(100 * r.oee, 1)} %`).join('; ');
  const parts: [string, (r: OeeRow) => number][] = [
    [t('oee.good'), (r) => r.oee],
    [t('oee.quality'), (r) => r.qualityLoss],
    [t('oee.speed'), (r) => r.speedLoss],
    [t('oee.availability'), (r) => r.availabilityLoss],
  ];
  const percent = rows.map((r) => roundKeepingSum(parts.map(([, f]) => 100 * f(r)), 1));
  const picture = chart(context, label, rows.length > 6 ? 'tall' : 'medium', (theme) => timeBars(parts.map(([name]) => name), rows.map((r, k) => ({ machine: r.name, percent: percent[k] ?? [] })), theme), { name: 'OEE', data: () => [[t('col.name'), ...parts.map(([name]) => name)], ...rows.map((r) => [r.name, ...parts.map(([, f]) => f(r))])] });
  return section(
    t('oee.title'),
    '%',
    picture.element,
    table<OeeRow>('OEE', [
      { head: t('col.name'), rowHead: true, cell: (r) => r.name },
      ...oeeFactors(),
      { head: 'OEE', unit: '%', number: true, cell: (r) => h('span', { title: t('oee.formula.oee') }, fixed(100 * r.oee, 1)), raw: (r) => 100 * r.oee },
      ...parts.slice(1).map(([name, f]) => ({ head: name, unit: '%', number: true, cell: (r: OeeRow) => fixed(100 * f(r), 1), raw: (r: OeeRow) => 100 * f(r) })),
    ], rows),
    oeeFormulas(),
  );
}
function oeeFactors() {
  return (['availability', 'effectiveness', 'quality'] as const).map((factor) => ({
    head: h('span', { title: t(`oee.formula.${factor}`) }, t(`oee.factor.${factor}`)),
    unit: '%',
    number: true,
    cell: (r: OeeRow) => h('span', { title: t(`oee.formula.${factor}`) }, fixed(100 * r[factor], 1)),
    raw: (r: OeeRow) => 100 * r[factor],
  }));
}

/** Repeats the run from what stands beside it and compares every value of every replication. */
function againSection(context: PageContext, run: Run): HTMLElement {
  const place = h('div', { id: 'again' });
  const button = h('button', { type: 'button', id: 'compute-again', class: 'quiet', onclick: () => {
    button.disabled = true;
    api.startJob({ kind: 'again', run: run.id }).then(
      (job) => place.replaceChildren(jobPanel(context, job, (end) => { button.disabled = false; place.append(verdictOf(end)); })),
      (e: unknown) => { button.disabled = false; place.replaceChildren(h('p', { class: 'bad', role: 'alert' }, e instanceof ApiError && e.message ? e.message : t('state.offline'))); },
    );
  } }, t('again.button'));
  return h('div', { class: 'no-print' }, button, place);
}
function verdictOf(job: Job): HTMLElement {
  const r = job.result;
  if (!r || r.identical === undefined) return h('p');
  return h('p', { class: r.identical ? 'good' : 'bad', 'data-identical': String(r.identical) },
    r.identical
      ? t('again.same', { values: whole(r.values ?? 0), run: r.run ?? '' })
      : t('again.different', { different: whole(r.different ?? 0), values: whole(r.values ?? 0), where: r.first_difference ?? '', versions: (r.versions ?? []).join(' / '), platforms: (r.platforms ?? []).join(' / ') }));
}

function costSection(context: PageContext, run: Run): HTMLElement {
  const bars = costBridge(run.kpis);
  const head = t('run.costUnit', { currency: run.currency });
  if (!bars) return section(t('run.cost'), '', h('p', {}, t('run.noParts')));
  const total = bars.find((b) => b.key === 'cost_per_part')?.to ?? 0;
  const shares = roundKeepingSum(bars.filter((b) => !b.total && b.key !== 'scrapped_parts').map((b) => (100 * (b.to - b.from)) / total), 1, 100);
  const picture = chart(context, bars.map((b) => `${barName(b)} ${fixed(b.printed, 2)}`).join(', '), 'medium', (theme) => bridgeOption(bars, run.currency, theme), { name: t('run.cost'), data: () => [[t('col.component'), run.currency, t('col.half')], ...bars.map((b) => [barName(b), b.total ? b.to : b.to - b.from, b.kpi?.half_width_95])] });
  return section(
    t('run.cost'),
    head,
    picture.element,
    table(
      t('run.cost'),
      [
        { head: t('col.component'), rowHead: true, cell: (b) => fragment(b.total ? null : swatch(colourOf(b.key, bars.indexOf(b))), barName(b)) },
        { head: t('col.mean'), unit: `${run.currency}/part`, number: true, cell: (b) => fixed(b.printed, 2) },
        { head: t('col.half'), unit: `${run.currency}/part`, number: true, cell: (b) => (b.kpi?.half_width_95 ? (b.kpi.half_width_95 < 0.005 ? `< ${fixed(0.01, 2)}` : fixed(b.kpi.half_width_95, 2)) : '–') },
        { head: t('col.share'), unit: '%', number: true, cell: (b) => (b.total || b.key === 'scrapped_parts' ? '' : fixed(shares[bars.indexOf(b)] ?? 0, 1)) },
      ],
      bars,
      (b) => (b.total ? 'total' : undefined),
    ),
  );
}

function allSection(run: Run): HTMLElement {
  const place = h('div');
  const show = (words: string) => {
    const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
    const rows = run.kpis.filter((k) => wanted.every((w) => `${k.name} ${k.meaning} ${named('kpi', lastStep(k.name))}`.toLowerCase().includes(w)));
    place.replaceChildren(
      table<Kpi>(
        t('run.all'),
        [
          { head: t('col.name'), rowHead: true, cell: (k) => h('code', {}, k.name) },
          { head: t('col.mean'), number: true, cell: (k) => estimate(k.mean, k.half_width_95).mean, raw: (k) => k.mean },
          { head: t('col.half'), number: true, cell: (k) => estimate(k.mean, k.half_width_95).half || '–', raw: (k) => k.half_width_95 },
          { head: t('col.unit'), cell: (k) => h('span', { class: 'unit' }, unitText(k.unit) || '1') },
          { head: t('col.samples'), number: true, cell: (k) => whole(k.samples) },
          { head: t('col.meaning'), cell: (k) => h('span', { class: 'muted' }, k.meaning) },
        ],
        rows,
      ),
    );
  };
  const filter = h('input', { id: 'kpi-filter', type: 'search', oninput: () => show(filter.value) });
  show('');
  return section(
    t('run.all'),
    whole(run.kpis.length),
    h(
      'p',
      { class: 'row no-print' },
      h('label', { for: 'kpi-filter' }, t('run.filter')),
      filter,
      downloadButton(t('run.csv'), `runs/${run.id}?format=csv`, `run-${run.id}.csv`),
      downloadButton(t('run.csvSemicolon'), `runs/${run.id}?format=csv&separator=semicolon&decimal=comma`, `run-${run.id}.csv`),
      downloadButton(t('run.json'), `runs/${run.id}?replications=1`, `run-${run.id}.json`),
    ),
    place,
    h('p', { class: 'muted' }, t('run.again')),
    command(`verstat runs --run ${run.id} --json`),
  );
}

export const runPage: PageMaker = async (context, [id = '']) => {
  const [run, version] = await Promise.all([api.run(id, false, context.signal), api.version(context.signal)]);
  const changes = changeList(run.changes);
  return {
    title: `${t('run.title', { id: run.id })}: ${run.scenario}`,
    body: fragment(
      h('h1', {}, run.scenario, h('span', { class: 'unit' }, ` ${t('run.title', { id: run.id })}${run.label === 'run' ? '' : ` · ${run.label}`}`)),
      h(
        'p',
        { class: 'muted facts' },
        t('run.facts', { replications: whole(run.replications), time: whole(run.horizon_min - run.warmup_min), warmup: whole(run.warmup_min), seed: run.seed }),
        ' ',
        t('run.madeBy', { created: dateTime(run.provenance.created), version: run.provenance.version, platform: run.provenance.platform }),
        run.fingerprint ? ` ${t('run.fingerprint', { fingerprint: run.fingerprint })}` : '',
      ),
      changes.length > 0
        ? h('p', { class: 'facts' }, `${t('run.changes')}: `, changes.map((c, k) => [k > 0 ? ', ' : '', h('code', {}, c.value ? `${c.pointer} = ${c.value}` : c.pointer)]))
        : null,
      h('p', { class: 'row no-print' }, h('a', { href: `#/scenario/run/${run.id}`, class: 'button' }, t('run.change')), h('a', { href: `#/sheet/${run.id}` }, t('sheet.title')), h('a', { href: `#/trace/${run.id}` }, t('nav.trace')), version.read_only ? null : againSection(context, run)),
      annotationEditor('runs', run.id, run, version.read_only),
      run.warnings && run.warnings.length > 0
        ? h('div', { class: 'warn', id: 'run-warnings' }, h('p', {}, t('run.warnings')), h('ul', {}, run.warnings.map((w) => h('li', {}, w.text))))
        : null,
      standstillWarning(run),
      tiles(run),
      h('div', { class: 'columns' }, timeSection(context, run), toolSection(run)),
      onMachinesSection(run),
      slicesSection(context, run, version.read_only),
      flowSection(run),
      costSection(context, run),
      lossSection(context, run, version.read_only),
      oeeSection(context, run),
      groupingSection(context, run),
      leadTimeSection(context, run),
      sankeySection(context, run),
      h('div', { class: 'columns even' }, consumptionSection(context, run), unattendedSection(run)),
      entityKinds(run.kpis).filter((kind) => kind !== 'tool' && kind !== 'machine' && kind !== 'cost' && kind !== 'insert' && kind !== 'grade').map((kind) => entitySection(run, kind, named('entity', kind))),
      allSection(run),
    ),
  };
};
