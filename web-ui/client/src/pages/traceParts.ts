// What one replication says beside its Gantt chart: each machine and member of a crew by shift and by hour of the day, queues
// and parts in the shop over time. Used by the Gantt page and by the page of a run.

import { chart } from '../charts/chart';
import { queueOption } from '../charts/queues';
import { timeBars } from '../charts/timeBars';
import { h, table } from '../dom';
import { fixed, whole } from '../format';
import { language, named, t } from '../i18n';
import { hourShares, shiftShares, thinned, type Shift, type StepSeries, type Trace, type TraceRow } from '../logic/gantt';
import { roundKeepingSum } from '../logic/shares';
import { section, type PageContext } from '../page';

/** Charts of a part that comes after its page was shown are drawn as soon as it stands in the document. */
export function later(context: PageContext): PageContext {
  const drawers: (() => void)[] = [];
  requestAnimationFrame(() => drawers.forEach((d) => d()));
  return { ...context, whenShown: (d) => drawers.push(d) };
}

const clockOf = (hours: number) => `${String(Math.floor(hours) % 24).padStart(2, '0')}:${String(Math.round((hours % 1) * 60)).padStart(2, '0')}`;

/** "Mon–Fri 06:00–14:00" */
export function shiftName(shift: Shift): string {
  const weekday = new Intl.DateTimeFormat(language() === 'uk' ? 'uk-UA' : 'en-GB', { weekday: 'short', timeZone: 'UTC' });
  const name = (d: number) => weekday.format(new Date(Date.UTC(2024, 0, 1 + d))); // a Monday
  const days = [...new Set(shift.days)].sort((a, b) => a - b);
  const runs: string[] = [];
  for (let k = 0; k < days.length; ) {
    let end = k;
    while (days[end + 1] === (days[end] ?? 0) + 1) ++end;
    runs.push(end - k >= 2 ? `${name(days[k] ?? 0)}–${name(days[end] ?? 0)}` : days.slice(k, end + 1).map(name).join(', '));
    k = end + 1;
  }
  return `${runs.join(', ')} ${clockOf(shift.from_h)}–${clockOf(shift.to_h)}`;
}

interface Slice {
  name: string;
  minutes: number | null;
  shares: Float64Array;
}

/** One bar of 100.0 % per slice of time, with a table behind it, of a row that is chosen. */
function sliceSection(context: PageContext, trace: Trace, id: string, head: string, hint: string, height: string, column: string, slices: (row: TraceRow) => Slice[]): HTMLElement | null {
  const rows = trace.rows.filter((r) => r.kind !== 'tool' && slices(r).length > 0);
  let row = rows[0];
  if (!row) return null;
  let list: { machine: string; minutes: number | null; percent: number[] }[] = [];
  let states: number[] = [];
  const shown = h('div');
  const words = () => states.map((s) => named('state', trace.states[s] ?? ''));
  const keys = () => states.map((s) => trace.states[s] ?? '');
  const read = () => {
    const all = row ? slices(row) : [];
    states = trace.states.flatMap((_, s) => (all.some((x) => (x.shares[s] ?? 0) > 0) ? [s] : []));
    list = all.map((x) => ({ machine: x.name, minutes: x.minutes, percent: roundKeepingSum(states.map((s) => 100 * (x.shares[s] ?? 0)), 1) }));
  };
  read();
  const picture = chart(later(context), head, height, (theme) => timeBars(words(), list, theme, keys()), { name: head, data: () => [[column, ...keys()], ...list.map((x) => [x.machine, ...x.percent])] });
  const fill = () => {
    type Row = (typeof list)[number];
    shown.replaceChildren(table<Row>(head, [
      { head: column, rowHead: true, cell: (x) => x.machine },
      ...(list.some((x) => x.minutes !== null) ? [{ head: t('trace.counted'), unit: 'min', number: true, cell: (x: Row) => whole(x.minutes ?? 0), raw: (x: Row) => x.minutes }] : []),
      ...words().map((word, k) => ({ head: word, unit: '%', number: true, cell: (x: Row) => fixed(x.percent[k] ?? 0, 1), raw: (x: Row) => x.percent[k] })),
      { head: t('total'), unit: '%', number: true, cell: (x: Row) => fixed(x.percent.reduce((a, b) => Math.round(10 * (a + b)) / 10, 0), 1) },
    ], list));
  };
  const pick = h('select', { id: `${id}-row`, onchange: () => { row = rows[Number(pick.value)] ?? row; read(); picture.redraw(); fill(); } }, rows.map((r, k) => h('option', { value: k }, r.name)));
  fill();
  return section(head, '%', h('p', { class: 'row no-print' }, h('label', { for: `${id}-row` }, t('trace.row')), pick), picture.element, h('details', { id: `${id}-table` }, h('summary', {}, t('trace.asTable')), shown), h('p', { class: 'muted' }, hint));
}

/** What a machine or a member of a crew does at each hour of the day, in the counted time. */
export function hourSection(context: PageContext, trace: Trace): HTMLElement | null {
  if (trace.end - trace.warmup < 1440) return null;
  return sliceSection(context, trace, 'hours', t('trace.hours'), t('trace.hoursHint'), 'hours', t('trace.hour'), (row) =>
    hourShares(row, trace.warmup, trace.end, trace.states.length).map((shares, hour) => ({ name: `${String(hour).padStart(2, '0')}:00`, minutes: null, shares })));
}

/** The same by the shifts of its calendar. */
export function shiftSection(context: PageContext, trace: Trace): HTMLElement | null {
  return sliceSection(context, trace, 'shifts', t('trace.shifts'), t('trace.shiftsHint'), 'medium', t('trace.shift'), (row) => {
    const shifts = row.calendar === null ? undefined : trace.shifts.get(row.calendar);
    if (!shifts || trace.warmup >= trace.end) return [];
    return shiftShares(row, shifts, trace.warmup, trace.end, trace.states.length).flatMap((s) => (s.minutes > 0 ? [{ name: s.shift ? shiftName(s.shift) : t('trace.outside'), minutes: s.minutes, shares: s.shares }] : []));
  });
}

const points = (series: StepSeries) => Array.from(series.at, (time, k): [number, number] => [time, series.value[k] ?? 0]);

/** How many batches wait before each machine group. */
export function queueSection(context: PageContext, trace: Trace): HTMLElement | null {
  if (trace.queues.length === 0) return null;
  const drawn = trace.queues.map((q) => ({ name: q.name, points: thinned(q, Math.max(100, Math.floor(20_000 / trace.queues.length))) }));
  const picture = chart(later(context), t('trace.queues'), 'large', (theme) => queueOption(drawn, trace.end, theme), { name: t('trace.queues'), data: () => [['machine', 'min', 'waiting'], ...drawn.flatMap((q) => q.points.map(([time, n]) => [q.name, time, n]))] });
  return section(t('trace.queues'), '', picture.element);
}

/** How many parts are in the shop. */
export function wipSection(context: PageContext, trace: Trace): HTMLElement | null {
  const { wip } = trace;
  if (!wip || wip.at.length === 0) return null;
  const picture = chart(later(context), t('trace.wip'), 'large', (theme) => queueOption([{ name: t('trace.wip'), points: thinned(wip) }], wip.at.at(-1) ?? trace.end, theme, t('trace.parts')), { name: t('trace.wip'), data: () => [['min', 'parts'], ...points(wip)] });
  return section(t('trace.wip'), '', picture.element, h('p', { class: 'muted' }, t('trace.wipHint')));
}
