import { describe, expect, it } from 'vitest';
import { addMinutes, bars, compactTrace, edgeTable, firstAfter, hourShares, intervalTable, mostTableRows, readTrace, shiftShares, startOf, stateShares, thinned, type Bar, type Interval, type Trace, type TraceRow } from '../src/logic/gantt';
import { roundKeepingSum } from '../src/logic/shares';
import { shiftName } from '../src/pages/traceParts';

const of = (intervals: Interval[], more: object = {}): Trace => readTrace({ machines: [{ name: 'm', intervals }], ...more });
const first = (trace: Trace): TraceRow => trace.rows[0] as TraceRow;
const sum = (list: ArrayLike<number>) => Array.from(list).reduce((a, b) => a + b, 0);
const plain = (r: TraceRow, trace: Trace): Interval[] => Array.from(r.until, (end, k): Interval => [startOf(r, k), end, trace.states[r.state[k] ?? 0] ?? '-']);
/** Numbers between 0 and 1 that come again. */
function* random(seed: number): Generator<number> {
  for (let x = seed; ; ) {
    x = (x * 1103515245 + 12345) % 2147483648;
    yield x / 2147483648;
  }
}

describe('the Gantt chart', () => {
  // 20,000 intervals of 0.25 min: 5000 minutes.
  const trace = of(Array.from({ length: 20_000 }, (_, k) => [k / 4, (k + 1) / 4, k % 5 === 0 ? 'idle' : 'cutting']));
  const row = first(trace);
  const idle = trace.states.indexOf('idle');
  const area = (list: readonly Bar[], state: number, pixels: number) => list.filter((b) => b.state === state).reduce((s, b) => s + b.width * b.height, 0) / pixels;
  it('draws no more from afar than pixels times states, areas as shares of the time, and every interval from near', () => {
    const far = bars(row, 0, 5000, 1000, 2);
    expect(far.length).toBeLessThanOrEqual(2200);
    expect(area(far, idle, 1000)).toBeCloseTo(0.2, 9);
    expect(area(far, 1 - idle, 1000)).toBeCloseTo(0.8, 9);
    expect(Math.max(...far.map((b) => b.width))).toBeLessThanOrEqual(1 + 1e-9);
    const near = bars(row, 10, 15, 1000, 2);
    expect(near).toHaveLength(20);
    expect(near.reduce((s, b) => s + b.width, 0)).toBeCloseTo(1000, 9);
    expect(near[0]).toEqual({ x: 0, width: 50, top: 0, height: 1, state: idle });
  });
  it('shows rare long states beside many short ones, seen from afar and from near', () => {
    const mixed = of([...plain(row, trace).slice(0, 8000), [2000, 4000, 'down'], [4000, 4000.1, 'idle']]);
    const down = mixed.states.indexOf('down');
    for (const pixels of [1000, 3000]) {
      const long = bars(first(mixed), 0, 5000, pixels, 3).filter((b) => b.state === down);
      expect(long[0]?.x).toBeCloseTo(0.4 * pixels, 9);
      expect(sum(long.map((b) => b.width))).toBeCloseTo(0.4 * pixels, 9);
      expect(long.length).toBeLessThanOrEqual(2);
    }
  });
  it('counts minutes with running totals as one counts them interval by interval', () => {
    const next = random(7);
    const states = ['a', 'b', 'c', 'd'];
    let at = 0;
    const intervals = Array.from({ length: 3000 }, (): Interval => { const start = at; at += (next.next().value as number) * 3; return [start, at, states[Math.floor((next.next().value as number) * 4)] ?? 'a']; });
    const made = of(intervals);
    for (let k = 0; k < 300; ++k) {
      const [p, q] = [(next.next().value as number) * at, (next.next().value as number) * at].sort((x, y) => x - y) as [number, number];
      const sums = new Float64Array(4);
      addMinutes(first(made), p, q, sums);
      made.states.forEach((state, s) => expect(sums[s]).toBeCloseTo(intervals.filter((i) => i[2] === state).reduce((t, [x, y]) => t + Math.max(0, Math.min(q, y) - Math.max(p, x)), 0), 7));
    }
  });
  it('shares of a window add up to the window', () => {
    expect(sum(stateShares(row, 1.125, 100.3, 2))).toBeCloseTo(1, 12);
    expect(stateShares(row, 0, 5000, 2)[idle]).toBeCloseTo(0.2, 12);
    expect(firstAfter(row.until, 0.25)).toBe(1);
  });
  it('a year of sixty machines is drawn in a blink', () => {
    const length = 130_000; // 4 min each
    const until = Array.from({ length }, (_, k) => 4 * (k + 1));
    const state = Array.from({ length }, (_, k) => (k * 7) % 5);
    const large = readTrace({ states: ['a', 'b', 'c', 'd', 'e'], machines: [{ name: 'm', until, state }] });
    const rows = new Array<TraceRow>(60).fill(first(large));
    const took = (from: number, to: number) => {
      let best = Infinity;
      for (let k = 0; k < 3; ++k) {
        const begun = performance.now();
        for (const r of rows) bars(r, from, to, 1130, 5);
        best = Math.min(best, performance.now() - begun);
      }
      return best;
    };
    const [year, week, minute] = [took(0, large.end), took(100_000, 110_080), took(100_000, 100_001)];
    console.log(`60 rows of ${length} intervals: year ${year.toFixed(0)} ms, week ${week.toFixed(0)} ms, minute ${minute.toFixed(1)} ms`);
    expect(Math.max(year, week, minute)).toBeLessThan(400);
    const [r] = large.rows as [TraceRow];
    for (let s = 0; s < 5; ++s) expect(area(bars(r, 0, large.end, 1130, 5), s, 1130)).toBeCloseTo(0.2, 4);
  }, 30_000);
  it('a bad trace is refused with its place', () => {
    expect(() => of([[0, 1, 'a'], [0.5, 'x', 'b'] as unknown as Interval])).toThrow('/machines/0/intervals/1');
    expect(() => of([[2, 3, 'a'], [0, 1, 'b']])).toThrow('in order of time');
    expect(() => readTrace({ machines: [{}] })).toThrow('/machines/0');
    expect(() => readTrace([])).toThrow('object');
    expect(() => readTrace({})).toThrow('machines');
    expect(() => readTrace({ machines: [{ name: 'm', until: [1, 2], state: [0, 1] }], states: ['a'] })).toThrow('/machines/0/state/1');
    expect(() => readTrace({ machines: [{ name: 'm', until: [2, 1], state: [0, 0] }], states: ['a'] })).toThrow('/machines/0/until/1');
    expect(() => readTrace({ machines: [{ name: 'm', until: [1, 2], state: [0] }], states: ['a'] })).toThrow('1 entries beside 2');
    expect(() => of([], { queues: [['g', '0', 1]] })).toThrow('/queues');
    expect(() => of([[0, 2, 'a']], { edges: [['t', 'm']] })).toThrow('/edges/0');
    expect(() => of([[0, 2, 'a']], { parts: [['p', 'x', 1]] })).toThrow('/parts/0');
    expect(() => of([[0, 2, 'a']], { shifts: { c: [{}] } })).toThrow('/shifts/c/0');
    expect(() => of([[0, 2, 'a']], { crews: [{ name: 'k' }] })).toThrow('/crews/0');
  });
  it('takes queues, other lists of rows, and gaps', () => {
    const read = of([[0, 2, 'a'], [3, 4, 'a']], { queues: [['g', 0, 1], ['h', 1, 2], ['g', 1.5, 0]], tools: [{ name: 't', intervals: [[0, 1, 'b']] }] });
    expect(read.queues.map((q) => [q.name, [...q.at], [...q.value]])).toEqual([['g', [0, 1.5], [1, 0]], ['h', [1], [2]]]);
    expect(read).toMatchObject({ end: 4, states: ['a', 'b'] });
    expect(read.rows.map((r) => r.kind)).toEqual(['machine', 'tool']);
    expect(stateShares(first(read), 0, 4, 2)[0]).toBeCloseTo(0.75, 12);
  });
});

describe('a trace', () => {
  const edges = [['t', 'm', 10, 5, 'planned'], ['t', 'm', 30, 9, 'planned'], ['t', 'm', 30, 9, 'failed'], ['u', 'm', 4, 4, 'failed']];
  const full = {
    warmup_min: 5,
    machines: [{ name: 'm', group: 'm', calendar: 'two', intervals: [[0, 12.5, 'cutting'], [12.5, 40, 'planned_change']] }],
    crews: [{ name: 'setter 1', crew: 'setter', calendar: null, intervals: [[0, 12.5, 'free'], [12.5, 40, 'planned_change', 'm']] }],
    shifts: { two: [{ days: [0, 1], from_h: 6, to_h: 14 }] },
    queues: [['m', 0, 2]],
    parts: [['p', 0, 4], ['p', 3, 5], ['p', 7, 10]],
    edges,
  };
  it('shows each edge from the one before it; teeth of one tool come out together', () => {
    const read = of([[0, 40, 'cutting']], { edges });
    expect(read.rows.slice(1).map((r) => [r.name, r.kind, plain(r, read)])).toEqual([
      ['m: t', 'tool', [[0, 10, 'edge_planned'], [10, 30, 'edge_failed']]],
      ['m: u', 'tool', [[0, 4, 'edge_failed']]],
    ]);
    expect(edgeTable(read)[3]).toEqual(['t', 'm', 30, 9, 'failed']);
  });
  it('shows crews, at which machine they are, and is the same in its compact form', () => {
    const read = readTrace(full);
    expect(read.rows.map((r) => [r.name, r.kind])).toEqual([['m', 'machine'], ['setter 1', 'crew'], ['m: t', 'tool'], ['m: u', 'tool']]);
    expect([...(read.rows[1]?.at ?? [])]).toEqual([-1, 0]);
    expect(read.warmup).toBe(5);
    expect(readTrace(JSON.parse(JSON.stringify(compactTrace(read))))).toEqual(read);
  });
  it('gives the intervals shown as a table, cut to the window, and refuses more than a spreadsheet takes', () => {
    expect(intervalTable(readTrace(full), 10, 13)).toEqual([
      ['kind', 'name', 'state', 'from_min', 'to_min', 'machine'],
      ['machine', 'm', 'cutting', 10, 12.5, 'm'],
      ['machine', 'm', 'planned_change', 12.5, 13, 'm'],
      ['crew', 'setter 1', 'free', 10, 12.5, ''],
      ['crew', 'setter 1', 'planned_change', 12.5, 13, 'm'],
      ['tool', 'm: t', 'edge_failed', 10, 13, ''],
    ]);
    const many = readTrace({ states: ['a'], machines: [{ name: 'm', until: Array.from({ length: mostTableRows + 5 }, (_, k) => k + 1), state: new Array<number>(mostTableRows + 5).fill(0) }] });
    expect(intervalTable(many, 0, many.end)).toBeNull();
    expect(intervalTable(many, 0, 10)).toHaveLength(11);
  }, 30_000);
  it('adds up to one in every hour that it reaches, across days', () => {
    const read = of([[0, 90, 'cutting'], [90, 1440 * 3 + 30, 'idle'], [1440 * 3 + 30, 1440 * 3 + 60, 'cutting']]);
    const hours = hourShares(first(read), 0, read.end, 2);
    for (const hour of hours) expect(sum(hour)).toBeCloseTo(1, 12);
    // Hour 0: 60 + 30 of four hours; hour 1: 30 of three.
    expect(hours[0]?.[0]).toBeCloseTo(90 / 240, 12);
    expect(hours[1]?.[0]).toBeCloseTo(30 / 180, 12);
    expect(hours[5]?.[1]).toBe(1);
    expect(sum(hourShares(first(of([[0, 30, 'idle']])), 0, 30, 1)[7] ?? [1])).toBe(0);
  });
  it('is divided by shifts that add up to 100.0 % each and to the time together, past midnight and past Sunday', () => {
    const next = random(3);
    let at = 0;
    const read = of(Array.from({ length: 9000 }, (_, k): Interval => { const start = at; at += (next.next().value as number) * 7; return [start, at, ['cutting', 'idle', 'off_shift', 'repair'][k % 4] ?? '']; }));
    const week = [0, 1, 2, 3, 4, 5, 6];
    const shifts = [{ days: week.slice(0, 5), from_h: 6, to_h: 14 }, { days: week, from_h: 22, to_h: 30 }];
    const [from, to] = [1000, read.end - 500];
    const slices = shiftShares(first(read), shifts, from, to, 4);
    expect(slices).toHaveLength(3);
    expect(sum(slices.map((s) => s.minutes))).toBeCloseTo(to - from, 6);
    for (const s of slices) expect(sum(roundKeepingSum([...s.shares].map((x) => 100 * x), 1).map((x) => Math.round(10 * x)))).toBe(1000);
    // Minute by minute: every night from 22 to 6 is a night shift, that of Sunday, too.
    let night = 0;
    for (let minute = from; minute < Math.floor(to); ++minute) if (minute % 1440 >= 22 * 60 || minute % 1440 < 6 * 60) ++night;
    expect(Math.abs((slices[1]?.minutes ?? 0) - night)).toBeLessThan(1);
    expect(shiftShares(first(read), [{ days: week, from_h: 0, to_h: 24 }], from, to, 4)).toHaveLength(1);
    expect(shiftName({ days: [0, 1, 2, 3, 4], from_h: 6, to_h: 14.5 })).toBe('Mon–Fri 06:00–14:30');
    expect(shiftName({ days: [5, 0, 2], from_h: 22, to_h: 30 })).toBe('Mon, Wed, Sat 22:00–06:00');
  });
  it('counts the parts in the shop where none can be missing', () => {
    // Stays of 4, 2 and 3; the last finish is at 10: known up to 6.
    const { wip } = readTrace(full);
    expect([[...(wip?.at ?? [])], [...(wip?.value ?? [])]]).toEqual([[0, 3, 4, 5], [1, 2, 1, 0]]);
    expect(of([[0, 1, 'a']]).wip).toBeNull();
  });
  it('lines over time keep their peaks when they are thinned', () => {
    const at = Float64Array.from({ length: 100_000 }, (_, k) => k);
    const series = { name: 'q', at, value: at.map((k) => (k === 77_777 ? 900 : k % 10)) };
    const points = thinned(series, 1000);
    expect(points.length).toBeLessThanOrEqual(1002);
    expect(Math.max(...points.map((p) => p[1]))).toBe(900);
    expect(points.at(-1)?.[0]).toBe(99_999);
    expect(thinned({ ...series, at: at.slice(0, 50), value: series.value.slice(0, 50) }, 1000)).toHaveLength(50);
  });
});
