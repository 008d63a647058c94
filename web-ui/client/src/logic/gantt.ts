// The trace of one replication as rows of state intervals, cut to a window and thinned to pixels before it is drawn.

export type Interval = [start: number, end: number, state: string];
export interface TraceRow {
  name: string;
  /** Edges in a machine, not states of one. */
  tool?: boolean;
  intervals: Interval[];
}
export interface QueueSeries {
  name: string;
  /** [time in minutes, waiting from then on] */
  points: [number, number][];
}
export interface Trace {
  /** Parts in the shop: [time in minutes, number from then on]; only parts that were finished are known. */
  wip: [number, number][];
  queues: QueueSeries[];
  rows: TraceRow[];
  end: number;
  states: string[];
}

/** Reads {"machines": [{"name", "intervals": [[start_min, end_min, "state"], ...]}]}; other lists of the same form (tools, crews) are taken, too, and "queues": [[name, at_min, waiting], ...]. Throws an Error that names the place. */
export function readTrace(json: unknown): Trace {
  if (typeof json !== 'object' || json === null || Array.isArray(json)) throw new Error('the trace must be an object with "machines"');
  const rows: TraceRow[] = [];
  for (const [group, list] of Object.entries(json)) {
    if (!Array.isArray(list) || group === 'queues' || group === 'edges' || group === 'parts') continue;
    list.forEach((entry: unknown, k) => {
      const e = entry as { name?: unknown; intervals?: unknown };
      if (typeof e?.name !== 'string' || !Array.isArray(e.intervals)) {
        if (group === 'machines') throw new Error(`/${group}/${k}: needs "name" and "intervals"`);
        return;
      }
      let before = -Infinity;
      const intervals = e.intervals.map((i: unknown, j): Interval => {
        const [start, end, state] = Array.isArray(i) ? (i as unknown[]) : [];
        if (typeof start !== 'number' || typeof end !== 'number' || typeof state !== 'string' || !(end >= start) || start < before)
          throw new Error(`/${group}/${k}/intervals/${j}: must be [start_min, end_min, "state"], in order of time`);
        before = start;
        return [start, end, state];
      });
      rows.push({ name: e.name, intervals });
    });
  }
  if (rows.length === 0) throw new Error('the trace has no "machines" with intervals');
  rows.push(...edgeRows((json as { edges?: unknown }).edges));
  const queues = new Map<string, [number, number][]>();
  const given = (json as { queues?: unknown }).queues;
  for (const entry of Array.isArray(given) ? (given as unknown[]) : []) {
    const [name, time, waiting] = Array.isArray(entry) ? (entry as unknown[]) : [];
    if (typeof name !== 'string' || typeof time !== 'number' || typeof waiting !== 'number') throw new Error('/queues: each entry must be [name, at_min, waiting]');
    const points = queues.get(name);
    if (points) points.push([time, waiting]);
    else queues.set(name, [[time, waiting]]);
  }
  return { wip: partsInShop((json as { parts?: unknown }).parts), queues: [...queues].map(([name, points]) => ({ name, points })), rows, end: Math.max(...rows.map((r) => r.intervals.at(-1)?.[1] ?? 0)), states: [...new Set(rows.flatMap((r) => r.intervals.map((i) => i[2])))] };
}

/** "edges": [[tool, machine, taken_out_min, cutting_min, "planned" | "failed"], ...] as rows: each edge from the one before it to its own end. */
export function edgeRows(edges: unknown): TraceRow[] {
  const rows = new Map<string, TraceRow>();
  (Array.isArray(edges) ? (edges as unknown[]) : []).forEach((entry, k) => {
    const [tool, machine, at, , how] = Array.isArray(entry) ? (entry as unknown[]) : [];
    if (typeof tool !== 'string' || typeof machine !== 'string' || typeof at !== 'number' || typeof how !== 'string') throw new Error(`/edges/${k}: must be [tool, machine, at_min, cutting_min, how]`);
    const name = `${machine}: ${tool}`;
    let row = rows.get(name);
    if (!row) rows.set(name, (row = { name, tool: true, intervals: [] }));
    const before = row.intervals.at(-1)?.[1] ?? 0;
    // Teeth of one tool come out together: the first of them has the interval.
    if (at > before) row.intervals.push([before, at, `edge_${how}`]);
    else if (how === 'failed' && at === before) (row.intervals.at(-1) ?? [0, 0, ''])[2] = 'edge_failed';
  });
  return [...rows.values()];
}

/**
 * "parts": [[name, arrived_min, finished_min], ...] as the number in the shop over time. Parts still under way at the end are not
 * in a trace, so the series stops where they could be missing: the longest stay before the last finish.
 */
export function partsInShop(parts: unknown): [number, number][] {
  const steps: [number, number][] = [];
  let [last, longest] = [0, 0];
  (Array.isArray(parts) ? (parts as unknown[]) : []).forEach((entry, k) => {
    const [name, arrived, finished] = Array.isArray(entry) ? (entry as unknown[]) : [];
    if (typeof name !== 'string' || typeof arrived !== 'number' || typeof finished !== 'number') throw new Error(`/parts/${k}: must be [name, arrived_min, finished_min]`);
    steps.push([arrived, 1], [finished, -1]);
    last = Math.max(last, finished);
    longest = Math.max(longest, finished - arrived);
  });
  steps.sort((a, b) => a[0] - b[0]);
  const series: [number, number][] = [];
  let count = 0;
  for (const [time, step] of steps) {
    if (time > last - longest) break;
    count += step;
    const before = series.at(-1);
    if (before && before[0] === time) before[1] = count;
    else series.push([time, count]);
  }
  return series;
}

/** First interval that ends after `time` (binary search; intervals are in order). */
export function firstAfter(intervals: readonly Interval[], time: number): number {
  let [low, high] = [0, intervals.length];
  while (low < high) {
    const mid = (low + high) >> 1;
    if ((intervals[mid]?.[1] ?? 0) > time) high = mid;
    else low = mid + 1;
  }
  return low;
}

export interface Bar {
  x: number;
  width: number;
  /** Part of the row's height, from the top: all of it, or a state's share of a pixel. */
  top: number;
  height: number;
  state: string;
}

/**
 * Bars of one row within [from, to] over `pixels`. What is shorter than a pixel shares one with its neighbours, each state
 * with its part of the height: a year takes no more bars than pixels times states, and areas are shares of the time.
 */
export function bars(row: TraceRow, from: number, to: number, pixels: number): Bar[] {
  const scale = pixels / (to - from);
  const all: Bar[] = [];
  const shares = new Map<string, number>();
  let [begin, end] = [0, 0]; // of the stretch that is being gathered
  const flush = () => {
    let top = 0;
    for (const [state, share] of shares) {
      all.push({ x: begin, width: end - begin, top, height: share / (end - begin), state });
      top += share / (end - begin);
    }
    shares.clear();
  };
  for (let k = firstAfter(row.intervals, from); k < row.intervals.length; ++k) {
    const [start, stop, state] = row.intervals[k] as Interval;
    if (start >= to) break;
    const x0 = (Math.max(start, from) - from) * scale;
    const x1 = (Math.min(stop, to) - from) * scale;
    if (x1 <= x0) continue;
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

/** Share of the time within [from, to] per state. */
export function stateShares(row: TraceRow, from: number, to: number): Map<string, number> {
  const shares = new Map<string, number>();
  for (let k = firstAfter(row.intervals, from); k < row.intervals.length; ++k) {
    const [start, end, state] = row.intervals[k] as Interval;
    if (start >= to) break;
    shares.set(state, (shares.get(state) ?? 0) + (Math.min(end, to) - Math.max(start, from)) / (to - from));
  }
  return shares;
}

/**
 * Shares of the time per state in each hour of the day, of the whole trace; hours that the trace does not reach are empty. Time 0
 * is midnight.
 */
export function hourShares(row: TraceRow): Map<string, number>[] {
  const hours = Array.from({ length: 24 }, () => new Map<string, number>());
  const totals = new Array<number>(24).fill(0);
  for (const [start, end, state] of row.intervals) {
    // Whole days at once: a machine may stand for weeks.
    const days = Math.floor((end - start) / 1440);
    const add = (hour: number, minutes: number) => {
      const slot = hours[hour] as Map<string, number>;
      slot.set(state, (slot.get(state) ?? 0) + minutes);
      totals[hour] = (totals[hour] ?? 0) + minutes;
    };
    if (days > 0) for (let hour = 0; hour < 24; ++hour) add(hour, 60 * days);
    for (let at = start + days * 1440; at < end; ) {
      const next = Math.min(end, (Math.floor(at / 60) + 1) * 60);
      add(Math.floor(at / 60) % 24, next - at);
      at = next;
    }
  }
  return hours.map((slot, hour) => new Map([...slot].map(([state, minutes]) => [state, minutes / (totals[hour] ?? 1)])));
}
