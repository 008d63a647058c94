// The trace of one replication as rows of intervals, cut to a window and thinned to pixels before it is drawn. Rows are kept
// as typed arrays with running totals, so that a year of sixty machines (millions of intervals) zooms like a day of one.

export type Interval = [start: number, end: number, state: string];
export type RowKind = 'machine' | 'crew' | 'tool';

/** Intervals that follow each other without gaps; a time that the file says nothing of has the state `nothing`. */
export interface TraceRow {
  name: string;
  kind: RowKind;
  /** Calendar of the machine or crew, null when there is none. */
  calendar: string | null;
  start: number;
  /** Ends of the intervals, in minutes; each begins where the one before it ends. */
  until: Float64Array;
  /** Place of the state in the trace's list. */
  state: Uint16Array;
  /** Of a crew: place of the machine among the machines, -1 when at none. */
  at: Int32Array | null;
  /** Minutes per state before every block of intervals. */
  totals: Float64Array;
}
export interface StepSeries {
  name: string;
  /** Minutes. */
  at: Float64Array;
  /** From then on. */
  value: Float64Array;
}
export interface Shift {
  /** 0 is Monday. */
  days: number[];
  from_h: number;
  /** More than 24 when it passes midnight. */
  to_h: number;
}
/** An edge taken out: [tool, machine, at_min, cutting_min, "planned" | "failed"]. */
export type Edge = [tool: string, machine: string, at: number, cutting: number, how: string];
export interface Trace {
  rows: TraceRow[];
  /** Names of the machines, in the order of the file. */
  machines: string[];
  states: string[];
  /** Counting begins. */
  warmup: number;
  end: number;
  /** Parts in the shop; only parts that were finished are known. */
  wip: StepSeries | null;
  queues: StepSeries[];
  shifts: Map<string, Shift[]>;
  edges: Edge[];
  /** Finished parts: when each arrived and was done. */
  parts: { arrived: Float64Array; finished: Float64Array };
}

export const nothing = 0xffff;
const block = 64;

type ObjectJson = Record<string, unknown>;
const isObject = (v: unknown): v is ObjectJson => typeof v === 'object' && v !== null && !Array.isArray(v);
const listOf = (v: unknown): unknown[] => (Array.isArray(v) ? (v as unknown[]) : []);

/** Numbers of a list, each at least the one before when `rising`. Throws an Error that names the place. */
function numbers(v: unknown, place: string, rising = false): Float64Array {
  if (!Array.isArray(v)) throw new Error(`${place}: must be a list of numbers`);
  const all = new Float64Array(v.length);
  let before = -Infinity;
  for (let k = 0; k < v.length; ++k) {
    const x: unknown = v[k];
    if (typeof x !== 'number' || (rising && x < before)) throw new Error(`${place}/${k}: must be a number${rising ? ', none smaller than the one before' : ''}`);
    all[k] = x;
    before = x;
  }
  return all;
}

class States {
  readonly names: string[] = [];
  private readonly places = new Map<string, number>();
  place(name: string): number {
    let k = this.places.get(name);
    if (k === undefined) {
      k = this.names.push(name) - 1;
      this.places.set(name, k);
    }
    return k;
  }
}

function row(name: string, kind: RowKind, calendar: unknown, start: number, until: Float64Array, state: Uint16Array, at: Int32Array | null = null): TraceRow {
  return { name, kind, calendar: typeof calendar === 'string' ? calendar : null, start, until, state, at, totals: new Float64Array(0) };
}

/** A row of [start, end, state] in order of time; gaps are filled with `nothing`. */
function rowOf(name: string, kind: RowKind, calendar: unknown, intervals: readonly Interval[], states: States, machines: readonly string[] = [], where: readonly unknown[] = []): TraceRow {
  const until: number[] = [];
  const state: number[] = [];
  const at: number[] = [];
  const start = intervals[0]?.[0] ?? 0;
  let end = start;
  intervals.forEach(([a, b, s], k) => {
    if (a > end) {
      until.push(a);
      state.push(nothing);
      at.push(-1);
    }
    until.push(b);
    state.push(states.place(s));
    at.push(machines.indexOf(String(where[k] ?? '')));
    end = b;
  });
  return row(name, kind, calendar, start, Float64Array.from(until), Uint16Array.from(state), kind === 'crew' ? Int32Array.from(at) : null);
}

/** The rows of one list; those of the compact form have "until" and "state", others "intervals". */
function rowsOf(list: unknown, group: string, kind: RowKind, states: States, given: readonly string[], machines: readonly string[]): TraceRow[] {
  return listOf(list).flatMap((entry, k): TraceRow[] => {
    const place = `/${group}/${k}`;
    const e = isObject(entry) ? entry : {};
    if (typeof e['name'] === 'string' && Array.isArray(e['until'])) {
      const until = numbers(e['until'], `${place}/until`, true);
      const state = numbers(e['state'], `${place}/state`);
      if (state.length !== until.length) throw new Error(`${place}/state: ${state.length} entries beside ${until.length} of "until"`);
      const bad = state.findIndex((s) => !(s >= 0 && s < given.length && Number.isInteger(s)));
      if (bad >= 0) throw new Error(`${place}/state/${bad}: must be a place in "states"`);
      const at = kind === 'crew' && Array.isArray(e['machine']) ? Int32Array.from(numbers(e['machine'], `${place}/machine`)) : null;
      return [row(e['name'], kind, e['calendar'], 0, until, Uint16Array.from(state, (s) => states.place(given[s] ?? '')), at)];
    }
    if (typeof e['name'] !== 'string' || !Array.isArray(e['intervals'])) {
      if (group === 'machines' || group === 'crews') throw new Error(`${place}: needs "name" and "intervals"`);
      return [];
    }
    let before = -Infinity;
    const where: unknown[] = [];
    const intervals = listOf(e['intervals']).map((i, j): Interval => {
      const [start, end, state, machine] = listOf(i);
      if (typeof start !== 'number' || typeof end !== 'number' || typeof state !== 'string' || !(end >= start) || start < before)
        throw new Error(`${place}/intervals/${j}: must be [start_min, end_min, "state"], in order of time`);
      before = start;
      where.push(machine);
      return [start, end, state];
    });
    return [rowOf(e['name'], kind, e['calendar'], intervals, states, machines, where)];
  });
}

/** Reads what `verstat trace` writes, in either form of JSON; other lists of rows are taken as tools. Throws an Error that names the place. */
export function readTrace(json: unknown): Trace {
  if (!isObject(json)) throw new Error('the trace must be an object with "machines"');
  const states = new States();
  const given = listOf(json['states']).map(String);
  const machines = listOf(json['machines']).map((m) => (isObject(m) ? String(m['name']) : ''));
  const rows = rowsOf(json['machines'], 'machines', 'machine', states, given, machines);
  rows.push(...rowsOf(json['crews'], 'crews', 'crew', states, given, machines));
  const known = ['machines', 'crews', 'queues', 'edges', 'parts', 'steps', 'states'];
  for (const [group, list] of Object.entries(json)) if (!known.includes(group)) rows.push(...rowsOf(list, group, 'tool', states, given, machines));
  if (rows.length === 0) throw new Error('the trace has no "machines" with intervals');
  const edges = edgesOf(json['edges']);
  rows.push(...edgeRows(edges, states));
  const end = rows.reduce((last, r) => Math.max(last, r.until.at(-1) ?? 0), 0);
  for (const r of rows) r.totals = totalsOf(r, states.names.length);
  const parts = partsOf(json['parts']);
  const warmup = typeof json['warmup_min'] === 'number' && json['warmup_min'] < end ? json['warmup_min'] : 0;
  return { rows, machines, states: states.names, warmup, end, wip: partsInShop(parts.arrived, parts.finished), queues: queuesOf(json['queues']), shifts: shiftsOf(json['shifts']), edges, parts };
}

function edgesOf(edges: unknown): Edge[] {
  return listOf(edges).map((entry, k): Edge => {
    const [tool, machine, at, cutting, how] = listOf(entry);
    if (typeof tool !== 'string' || typeof machine !== 'string' || typeof at !== 'number' || typeof how !== 'string') throw new Error(`/edges/${k}: must be [tool, machine, at_min, cutting_min, how]`);
    return [tool, machine, at, typeof cutting === 'number' ? cutting : NaN, how];
  });
}

/** A row per tool and machine: each edge from the one before it to its own end. */
function edgeRows(edges: readonly Edge[], states: States): TraceRow[] {
  const rows = new Map<string, Interval[]>();
  for (const [tool, machine, at, , how] of edges) {
    const name = `${machine}: ${tool}`;
    let list = rows.get(name);
    if (!list) rows.set(name, (list = []));
    const last = list.at(-1);
    const before = last?.[1] ?? 0;
    // Teeth of one tool come out together: the first of them has the interval.
    if (at > before) list.push([before, at, `edge_${how}`]);
    else if (how === 'failed' && at === before && last) last[2] = 'edge_failed';
  }
  return [...rows].map(([name, intervals]) => rowOf(name, 'tool', null, intervals, states));
}

function queuesOf(given: unknown): StepSeries[] {
  const list = listOf(given);
  if (list.every(isObject)) return list.map((q, k) => ({ name: String(q['name']), at: numbers(q['at'], `/queues/${k}/at`, true), value: numbers(q['waiting'], `/queues/${k}/waiting`) }));
  const queues = new Map<string, [number, number][]>();
  for (const entry of list) {
    const [name, time, waiting] = listOf(entry);
    if (typeof name !== 'string' || typeof time !== 'number' || typeof waiting !== 'number') throw new Error('/queues: each entry must be [name, at_min, waiting]');
    const points = queues.get(name);
    if (points) points.push([time, waiting]);
    else queues.set(name, [[time, waiting]]);
  }
  return [...queues].map(([name, points]) => ({ name, at: Float64Array.from(points, (p) => p[0]), value: Float64Array.from(points, (p) => p[1]) }));
}

function partsOf(given: unknown): Trace['parts'] {
  if (isObject(given)) {
    const arrived = numbers(given['arrived'], '/parts/arrived');
    const finished = numbers(given['finished'], '/parts/finished');
    if (arrived.length !== finished.length) throw new Error(`/parts/finished: ${finished.length} entries beside ${arrived.length} of "arrived"`);
    return { arrived, finished };
  }
  const list = listOf(given);
  const [arrived, finished] = [new Float64Array(list.length), new Float64Array(list.length)];
  list.forEach((entry, k) => {
    const [name, a, f] = listOf(entry);
    if (typeof name !== 'string' || typeof a !== 'number' || typeof f !== 'number') throw new Error(`/parts/${k}: must be [name, arrived_min, finished_min]`);
    arrived[k] = a;
    finished[k] = f;
  });
  return { arrived, finished };
}

function shiftsOf(given: unknown): Map<string, Shift[]> {
  const all = new Map<string, Shift[]>();
  for (const [calendar, list] of Object.entries(isObject(given) ? given : {}))
    all.set(calendar, listOf(list).map((entry, k) => {
      const s = isObject(entry) ? entry : {};
      if (!Array.isArray(s['days']) || typeof s['from_h'] !== 'number' || typeof s['to_h'] !== 'number') throw new Error(`/shifts/${calendar}/${k}: needs "days", "from_h" and "to_h"`);
      return { days: (s['days'] as unknown[]).map(Number), from_h: s['from_h'], to_h: s['to_h'] };
    }));
  return all;
}

/**
 * Number of parts in the shop over time. Parts still under way at the end are not in a trace, so the series stops where they
 * could be missing: the longest stay before the last finish.
 */
export function partsInShop(arrived: Float64Array, finished: Float64Array): StepSeries | null {
  if (arrived.length === 0) return null;
  let [last, longest] = [0, 0];
  for (let k = 0; k < arrived.length; ++k) {
    last = Math.max(last, finished[k] ?? 0);
    longest = Math.max(longest, (finished[k] ?? 0) - (arrived[k] ?? 0));
  }
  const [ins, outs] = [arrived.slice().sort(), finished.slice().sort()];
  const at: number[] = [];
  const value: number[] = [];
  let count = 0;
  for (let i = 0, o = 0; i < ins.length || o < outs.length; ) {
    const time = Math.min(ins[i] ?? Infinity, outs[o] ?? Infinity);
    if (time > last - longest) break;
    for (; i < ins.length && ins[i] === time; ++i) ++count;
    for (; o < outs.length && outs[o] === time; ++o) --count;
    at.push(time);
    value.push(count);
  }
  return { name: '', at: Float64Array.from(at), value: Float64Array.from(value) };
}

/** The highest value in each of `most` stretches of equal length: what a picture of so many pixels can show. */
export function thinned(series: StepSeries, most = 1500): [number, number][] {
  const points: [number, number][] = [];
  const { at, value } = series;
  const every = at.length <= 2 * most;
  const length = ((at.at(-1) ?? 0) - (at[0] ?? 0)) / most;
  for (let k = 0; k < at.length; ++k) {
    const point: [number, number] = [at[k] ?? 0, value[k] ?? 0];
    const before = points.at(-1);
    if (every || !before || k === at.length - 1 || Math.floor((point[0] - (at[0] ?? 0)) / length) > Math.floor((before[0] - (at[0] ?? 0)) / length)) points.push(point);
    else if (point[1] > before[1]) before[1] = point[1];
  }
  return points;
}

function totalsOf(r: TraceRow, states: number): Float64Array {
  const totals = new Float64Array((Math.floor(r.until.length / block) + 1) * states);
  const sums = new Float64Array(states);
  let before = r.start;
  for (let k = 0; k < r.until.length; ++k) {
    if (k % block === 0) totals.set(sums, (k / block) * states);
    const [end, s] = [r.until[k] ?? 0, r.state[k] ?? nothing];
    if (s !== nothing) sums[s] = (sums[s] ?? 0) + end - before;
    before = end;
  }
  if (r.until.length % block === 0) totals.set(sums, (r.until.length / block) * states);
  return totals;
}

/** Where the k-th interval of a row begins. */
export const startOf = (r: TraceRow, k: number): number => (k === 0 ? r.start : (r.until[k - 1] ?? r.start));

/** First interval that ends after `time` (binary search). */
export function firstAfter(until: Float64Array, time: number): number {
  let [low, high] = [0, until.length];
  while (low < high) {
    const mid = (low + high) >> 1;
    if ((until[mid] ?? 0) > time) high = mid;
    else low = mid + 1;
  }
  return low;
}

/** Minutes of the row within [from, to] per state, added to `sums`. */
export function addMinutes(r: TraceRow, from: number, to: number, sums: Float64Array): void {
  const states = sums.length;
  const add = (k: number) => {
    const s = r.state[k] ?? nothing;
    const length = Math.min(to, r.until[k] ?? 0) - Math.max(from, startOf(r, k));
    if (s !== nothing && length > 0) sums[s] = (sums[s] ?? 0) + length;
  };
  const first = firstAfter(r.until, from);
  const last = Math.min(r.until.length - 1, firstAfter(r.until, to));
  const [low, high] = [Math.ceil((first + 1) / block), Math.floor(last / block)];
  if (high <= low) {
    for (let k = first; k <= last; ++k) add(k);
    return;
  }
  for (let k = first; k < low * block; ++k) add(k);
  for (let s = 0; s < states; ++s) sums[s] = (sums[s] ?? 0) + (r.totals[high * states + s] ?? 0) - (r.totals[low * states + s] ?? 0);
  for (let k = high * block; k <= last; ++k) add(k);
}

/** Share of the time within [from, to] per state. */
export function stateShares(r: TraceRow, from: number, to: number, states: number): Float64Array {
  const sums = new Float64Array(states);
  addMinutes(r, from, to, sums);
  return sums.map((x) => x / (to - from));
}

export interface Bar {
  x: number;
  width: number;
  /** Part of the row's height, from the top: all of it, or a state's share of a pixel. */
  top: number;
  height: number;
  state: number;
}

/**
 * Bars of one row within [from, to] over `pixels`. What is shorter than a pixel shares one with its neighbours, each state
 * with its part of the height: a year takes no more bars than pixels times states, and areas are shares of the time.
 */
export function bars(r: TraceRow, from: number, to: number, pixels: number, states: number): Bar[] {
  const first = firstAfter(r.until, from);
  const last = Math.min(r.until.length - 1, firstAfter(r.until, to));
  return last - first > 3 * pixels ? pixelBars(r, from, to, pixels, states) : intervalBars(r, from, to, pixels, first, last);
}

/** Pixel by pixel out of the running totals. */
function pixelBars(r: TraceRow, from: number, to: number, pixels: number, states: number): Bar[] {
  const all: Bar[] = [];
  const sums = new Float64Array(states);
  const count = Math.ceil(pixels);
  for (let x = 0; x < count; ++x) {
    const width = Math.min(1, pixels - x);
    const [a, b] = [from + (x / pixels) * (to - from), from + ((x + width) / pixels) * (to - from)];
    sums.fill(0);
    addMinutes(r, a, b, sums);
    let top = 0;
    for (let s = 0; s < states; ++s) {
      const height = (sums[s] ?? 0) / (b - a);
      if (height <= 0) continue;
      const before = all.at(-1);
      if (height > 0.999 && before && before.state === s && before.height > 0.999 && before.x + before.width === x) before.width += width;
      else all.push({ x, width, top, height, state: s });
      top += height;
    }
  }
  return all;
}

function intervalBars(r: TraceRow, from: number, to: number, pixels: number, first: number, last: number): Bar[] {
  const scale = pixels / (to - from);
  const all: Bar[] = [];
  const shares = new Map<number, number>();
  let [begin, end] = [0, 0]; // of the stretch that is being gathered
  const flush = () => {
    let top = 0;
    for (const [state, width] of shares) {
      const height = width / (end - begin);
      all.push({ x: begin, width: end - begin, top, height, state });
      top += height;
    }
    shares.clear();
  };
  for (let k = first; k <= last; ++k) {
    const state = r.state[k] ?? nothing;
    const x0 = (Math.max(startOf(r, k), from) - from) * scale;
    const x1 = (Math.min(r.until[k] ?? 0, to) - from) * scale;
    if (state === nothing || x1 <= x0) continue;
    if (shares.size > 0 && (x1 - x0 >= 1 || x1 - begin > 1 || x0 > end)) flush();
    if (x1 - x0 >= 1) {
      all.push({ x: x0, width: x1 - x0, top: 0, height: 1, state });
      continue;
    }
    if (shares.size === 0) begin = x0;
    end = x1;
    shares.set(state, (shares.get(state) ?? 0) + (x1 - x0));
  }
  flush();
  return all;
}

const day = 1440;
const week = 7 * day;

/** Shares of each slice of time: nought everywhere when the slice is empty. */
const sharesOf = (sums: Float64Array): Float64Array => {
  const total = sums.reduce((a, b) => a + b, 0);
  return total > 0 ? sums.map((x) => x / total) : sums;
};

/** Shares per state in each hour of the day between `from` and `to`. Time 0 is midnight. */
export function hourShares(r: TraceRow, from: number, to: number, states: number): Float64Array[] {
  return Array.from({ length: 24 }, (_, hour) => {
    const sums = new Float64Array(states);
    for (let d = Math.floor(from / day); d * day + hour * 60 < to; ++d) {
      const a = Math.max(from, d * day + hour * 60);
      const b = Math.min(to, d * day + (hour + 1) * 60);
      if (b > a) addMinutes(r, a, b, sums);
    }
    return sharesOf(sums);
  });
}

export interface ShiftShares {
  /** null: outside all shifts. */
  shift: Shift | null;
  minutes: number;
  shares: Float64Array;
}

/** Shares per state in each shift of a calendar and outside them, between `from` and `to`; breaks and holidays stand within their shift. Time 0 is Monday 00:00. */
export function shiftShares(r: TraceRow, shifts: readonly Shift[], from: number, to: number, states: number): ShiftShares[] {
  const taken: [number, number][] = [];
  const all = shifts.map((shift): ShiftShares => {
    const sums = new Float64Array(states);
    for (const d of shift.days)
      // A shift of Sunday may reach into the week after.
      for (let w = Math.floor(from / week) - 1; w * week < to; ++w) {
        const begin = w * week + d * day + shift.from_h * 60;
        const a = Math.max(from, begin);
        const b = Math.min(to, begin + (shift.to_h - shift.from_h) * 60);
        if (b <= a) continue;
        taken.push([a, b]);
        addMinutes(r, a, b, sums);
      }
    return { shift, minutes: sums.reduce((x, y) => x + y, 0), shares: sharesOf(sums) };
  });
  const outside = new Float64Array(states);
  let at = from;
  for (const [a, b] of [...taken.sort((x, y) => x[0] - y[0]), [to, to] as [number, number]]) {
    if (a > at) addMinutes(r, at, a, outside);
    at = Math.max(at, b);
  }
  const minutes = outside.reduce((x, y) => x + y, 0);
  // What rounding of the times leaves over is no time outside.
  return minutes > 1e-6 * (to - from) ? [...all, { shift: null, minutes, shares: sharesOf(outside) }] : all;
}

/** The compact form again, which `readTrace` reads. */
export function compactTrace(trace: Trace): Record<string, unknown> {
  const rows = (kind: RowKind) => trace.rows.filter((r) => r.kind === kind);
  // Times without a state, and a start that is not 0, are only in files of others: those go as intervals.
  const plain = (r: TraceRow) => r.start === 0 && !r.state.includes(nothing);
  const one = (r: TraceRow) => ({
    name: r.name,
    calendar: r.calendar,
    ...(plain(r)
      ? { until: [...r.until], state: [...r.state], ...(r.at ? { machine: [...r.at] } : {}) }
      : { intervals: [...r.until].flatMap((end, k): unknown[] => { const s = r.state[k] ?? nothing; return s === nothing ? [] : [[startOf(r, k), end, trace.states[s]]]; }) }),
  });
  const edges = new Set(trace.edges.map(([tool, machine]) => `${machine}: ${tool}`));
  return {
    warmup_min: trace.warmup,
    states: trace.states,
    machines: rows('machine').map(one),
    crews: rows('crew').map(one),
    tools: rows('tool').filter((r) => !edges.has(r.name)).map(one),
    shifts: Object.fromEntries(trace.shifts),
    queues: trace.queues.map((q) => ({ name: q.name, at: [...q.at], waiting: [...q.value] })),
    parts: { arrived: [...trace.parts.arrived], finished: [...trace.parts.finished] },
    edges: trace.edges,
  };
}

/** Most rows that a spreadsheet takes. */
export const mostTableRows = 1_000_000;

/** Every interval that reaches into [from, to], cut to it; null when there are more than a spreadsheet takes. */
export function intervalTable(trace: Trace, from: number, to: number): (string | number)[][] | null {
  const within = (r: TraceRow): [number, number] => [firstAfter(r.until, from), Math.min(r.until.length - 1, firstAfter(r.until, to))];
  if (trace.rows.reduce((sum, r) => sum + within(r)[1] - within(r)[0] + 1, 0) > mostTableRows) return null;
  const table: (string | number)[][] = [['kind', 'name', 'state', 'from_min', 'to_min', 'machine']];
  for (const r of trace.rows) {
    const [first, last] = within(r);
    for (let k = first; k <= last; ++k) {
      const [a, b, s] = [Math.max(from, startOf(r, k)), Math.min(to, r.until[k] ?? 0), r.state[k] ?? nothing];
      if (s === nothing || b <= a) continue;
      table.push([r.kind, r.name, trace.states[s] ?? '', a, b, r.kind === 'machine' ? r.name : (trace.machines[r.at?.[k] ?? -1] ?? '')]);
    }
  }
  return table;
}

/** The edges taken out as a log that `verstat fit life` reads. */
export function edgeTable(trace: Trace): (string | number)[][] {
  return [['tool', 'machine', 'at_min', 'cutting time [min]', 'cause'], ...trace.edges.map(([tool, machine, at, cutting, how]) => [tool, machine, at, cutting, how])];
}
