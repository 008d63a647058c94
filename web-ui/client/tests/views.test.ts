import { describe, expect, it } from 'vitest';
import { fileName, toCsv } from '../src/logic/csv';
import { begin, changed, current, mostSteps, moved, request } from '../src/logic/draft';
import { parseNumber, sliderRange, spread } from '../src/logic/fields';
import { flowOf, groupsOf, shopGraph } from '../src/logic/graph';
import { entityKinds } from '../src/logic/kpis';
import { oeeRows } from '../src/logic/oee';
import { put, type Json } from '../src/logic/pointer';
import { blocks } from '../src/logic/result';
import { changeSheet, stops } from '../src/logic/windows';
import { stretches } from '../src/charts/sweep';
import { mapOption } from '../src/charts/modelMap';
import type { Field, Kpi } from '../src/types';
import heavyLathe from '../../../scenarios/gallery/heavy-lathe.json?raw';
import mixedPlant from '../../../scenarios/gallery/mixed-plant.json?raw';

const kpi = (name: string, mean: number | null): Kpi => ({ name, unit: '1', meaning: '', mean, half_width_95: null, samples: 2 });

describe('CSV out of the pages', () => {
  it('is RFC 4180, with formulas disarmed and the decimal sign asked for', () => {
    const rows = [['name', 'a;b'], ['=1+1', 0.5], ['say "x"', -2], ['two\nlines', null], ['-', true]];
    expect(toCsv(rows, { separator: ',', decimal: '.' })).toBe('name,a;b\r\n\'=1+1,0.5\r\n"say ""x""",-2\r\n"two\nlines",\r\n\'-,1\r\n');
    expect(toCsv(rows, { separator: ';', decimal: ',' })).toBe('\uFEFFname;"a;b"\r\n\'=1+1;0,5\r\n"say ""x""";-2\r\n"two\nlines";\r\n\'-;1\r\n');
  });
  it('read again it gives the same numbers', () => {
    const numbers = [0.1 + 0.2, -1e-300, 12345678.9, 5e-324, 2 ** 53];
    const text = toCsv(numbers.map((n) => [n]), { separator: ';', decimal: ',' });
    expect(text.slice(1).trim().split('\r\n').map((line) => Number(line.replace(',', '.')))).toEqual(numbers);
  });
  it('file names hold nothing that a file system refuses', () => {
    expect(fileName('What a part costs / UAH?')).toBe('what-a-part-costs-uah');
    expect(fileName('Верстат №1')).toBe('верстат-1');
    expect(fileName('***')).toBe('table');
  });
});

describe('the draft of a scenario', () => {
  const base = { name: 'cell', machines: [{ count: 2 }] } as Json;
  it('is undone, redone, and forgets what was undone before a new change', () => {
    let d = begin('x', JSON.stringify(base), base, base);
    d = changed(d, 'a', put(current(d), '/machines/0/count', 3));
    d = changed(d, 'b', put(current(d), '/machines/0/count', 4));
    d = moved(d, 1);
    expect(current(d)).toEqual(put(base, '/machines/0/count', 3));
    d = changed(d, 'c', put(current(d), '/name', 'shop'));
    expect(d.history.map((s) => s.what)).toEqual(['x', 'a', 'c']);
    expect(moved(d, -5).position).toBe(0);
  });
  it('is sent as the text opened and the changes against it', () => {
    const text = JSON.stringify(base);
    const d = changed(begin('x', text, base, base), 'a', put(base, '/machines/0/count', 3));
    expect(request(d)).toEqual({ scenario: text, changes: [{ pointer: '/machines/0/count', value: 3 }] });
  });
  it('is sent whole when changes cannot say it', () => {
    const d = changed(begin('x', JSON.stringify(base), base, base), 'a', { machines: [] });
    expect(request(d).changes).toEqual([]);
    expect(JSON.parse(request(d).scenario)).toEqual({ machines: [] });
  });
  it('keeps its beginning in a long history', () => {
    let d = begin('x', '{}', {}, {});
    for (let k = 0; k < mostSteps + 50; ++k) d = changed(d, String(k), { k });
    expect(d.history).toHaveLength(mostSteps);
    expect(d.history[0]?.what).toBe('x');
    expect(current(d)).toEqual({ k: mostSteps + 49 });
  });
});

describe('the shop as a graph', () => {
  it('the heavy-lathe cell is blanks, lathe, store', () => {
    const graph = shopGraph(JSON.parse(heavyLathe) as Json);
    expect(graph.nodes.map((n) => [n.kind, n.label, n.column])).toEqual([['source', '', 0], ['machine', 'lathe', 1], ['store', 'finished shafts', 2]]);
    expect(graph.edges.map((e) => [e.from, e.to])).toEqual([['source:', 'machine:lathe'], ['machine:lathe', 'store:finished shafts']]);
  });
  it('every machine of the mixed plant that a route uses is joined, and no two boxes share a place', () => {
    const scenario = JSON.parse(mixedPlant) as { machines: { name: string }[] };
    const graph = shopGraph(scenario as unknown as Json);
    for (const m of scenario.machines) expect(graph.edges.some((e) => e.to === `machine:${m.name}`), m.name).toBe(true);
    expect(new Set(graph.nodes.map((n) => `${n.column}/${n.row}`)).size).toBe(graph.nodes.length);
    for (const e of graph.edges.filter((x) => !x.back)) expect(graph.nodes.find((n) => n.id === e.from)?.column).toBeLessThan(graph.nodes.find((n) => n.id === e.to)?.column ?? 0);
  });
  it('branches and rework loops of steps are followed; loops are drawn back and do not hang the layout', () => {
    const steps = [{ name: 'a', operation: 'oa' }, { name: 'b', operation: 'ob', next: [{ to: 'c', probability: 0.9 }, { to: '', probability: 0.1 }], rework: 'a' }, { name: 'c', operation: 'oc' }];
    expect(flowOf({ steps }).pairs).toEqual([[-1, 0], [0, 1], [1, 2], [1, 3], [1, 0], [2, 3]]);
    const machines = [{ name: 'A' }, { name: 'B1' }, { name: 'B2' }, { name: 'C', capabilities: ['fine'] }];
    const operations = [{ name: 'oa', machine: 'A' }, { name: 'ob', machines: ['B1', 'B2'] }, { name: 'oc', capability: 'fine' }];
    expect(groupsOf(operations[2], machines)).toEqual(['C']);
    const graph = shopGraph({ machines, operations, stores: [{ name: 's' }], parts: [{ name: 'p', steps, store: 's' }] } as Json);
    expect(graph.edges.filter((e) => e.back).map((e) => [e.from, e.to])).toEqual([['machine:B1', 'machine:A'], ['machine:B2', 'machine:A']]);
    expect(graph.edges.filter((e) => e.to === 'store:s').map((e) => e.from)).toEqual(['machine:B1', 'machine:B2', 'machine:C']);
    expect(shopGraph(null).nodes).toEqual([]);
    expect(shopGraph({ machines: 'x', parts: [3] } as Json).nodes).toEqual([]);
  });
});

describe('the tool-change sheet', () => {
  const job = (tool: string, cutting_min: number, age_min: number | null) => ({ machine: 'lathe', tool, operation: tool, cutting_min, age_min });
  it('whole parts within the age, merged into multiples of the shortest', () => {
    const rows = changeSheet([job('rough', 10, 35), job('finish', 2, 25), job('drill', 1, null)]);
    expect(rows.map((r) => [r.every, r.merged])).toEqual([[3, 3], [12, 12], [null, null]]);
    const other = changeSheet([job('rough', 10, 35), job('finish', 2, 22)]);
    expect(other.map((r) => [r.every, r.merged])).toEqual([[3, 3], [11, 9]]);
    expect(other[1]?.lost).toBeCloseTo(1 - 18 / 22, 12);
    expect(stops(other, 'lathe', 3)).toEqual([[3, ['rough']], [6, ['rough']], [9, ['rough', 'finish']]]);
  });
  it('no edge ever grows older than allowed, unless one part alone takes longer', () => {
    for (let k = 1; k < 200; ++k) {
      const rows = changeSheet([job('a', 0.37 * k, 50), job('b', 1.9, 3 + (k % 40)), job('c', 0.05, 20)]);
      for (const r of rows) expect((r.merged ?? 0) === 1 || (r.merged ?? 0) * r.cutting_min <= (r.age_min ?? 0) + 1e-6).toBe(true);
    }
  });
  it('a machine on which edges only fail has no stops', () => {
    expect(stops(changeSheet([job('a', 1, null)]), 'lathe', 3)).toEqual([]);
  });
});

describe('other views', () => {
  it('OEE falls from 100 % by its three losses', () => {
    const [row] = oeeRows([kpi('machine/mill/availability', 0.8), kpi('machine/mill/effectiveness', 0.9), kpi('machine/mill/quality_ratio', 0.95), kpi('machine/saw/availability', 0.8)]);
    expect(row?.name).toBe('mill');
    expect(row?.oee).toBeCloseTo(0.684, 12);
    expect((row?.oee ?? 0) + (row?.availabilityLoss ?? 0) + (row?.speedLoss ?? 0) + (row?.qualityLoss ?? 0)).toBeCloseTo(1, 12);
  });
  it('kinds of entities are found by their paths', () => {
    expect(entityKinds([kpi('cost_per_part', 1), kpi('cost/idle', 1), kpi('machine/a/state/idle', 1), kpi('crew/b/utilization', 1), kpi('part/p/lead_time_min', 1)])).toEqual(['machine', 'crew', 'part']);
  });
  it('what a study says beyond its plan becomes tables', () => {
    const result = {
      words: 'w', verdict: 'better', not_covered: '',
      constraints: [{ name: 'power', value: 3.9, shadow: { price: 0.8, unit: 'UAH/kW' }, binds: true }],
      choice: { decided: true, confidence: 0.95, finalists: [{ mean: 1, values: [{ name: 'speed', value: 47 }] }] },
    };
    expect(blocks(result)).toEqual([
      { name: 'constraints', columns: ['name', 'value', 'shadow/price', 'shadow/unit', 'binds'], rows: [{ name: 'power', value: 3.9, 'shadow/price': 0.8, 'shadow/unit': 'UAH/kW', binds: true }], facts: [] },
      { name: 'choice', columns: [], rows: [], facts: [['decided', true], ['confidence', 0.95]] },
      { name: 'choice/finalists', columns: ['mean', 'speed'], rows: [{ mean: 1, speed: 47 }], facts: [] },
    ]);
    expect(blocks({})).toEqual([]);
  });
  it('stretches of broken limits reach half-way to their neighbours', () => {
    const at = (value: number, bad: boolean) => ({ value, bad });
    expect(stretches([at(0, true), at(1, true), at(2, false), at(3, true)])).toEqual([[0, 1.5], [2.5, 3]]);
    expect(stretches([at(0, false)])).toEqual([]);
  });
  it('a map draws every point once, gaps as gaps', () => {
    const theme = { font: '', text: '', muted: '', line: '', panel: '', accent: '', good: '', bad: '', cheap: '', middle: '', dear: '' };
    const option = mapOption([1, 2], [3, 4], [[5, null], [7, 8]], 'x', 'y', 'z', theme) as { series: { data: unknown[] }[]; visualMap: { min: number; max: number } };
    expect(option.series[0]?.data).toEqual([[0, 0, 5], [1, 0, '-'], [0, 1, 7], [1, 1, 8]]);
    expect([option.visualMap.min, option.visualMap.max]).toEqual([5, 8]);
  });
  it('sliders stay inside the range', () => {
    const field = (more: Partial<Field>): Field => ({ name: 'x', symbol: '', unit: '1', type: 'number', kind: 'number', meaning: '', ...more });
    expect(sliderRange(field({ above: 0, below: 1 }), 0.64)).toEqual({ low: 0.00064, high: 0.99936 });
    expect(sliderRange(field({ at_least: 10, at_most: 1e6 }), 12)).toEqual({ low: 10, high: 24 });
    expect(sliderRange(field({ kind: 'integer', at_least: 1 }), 1)).toEqual({ low: 1, high: 2 });
    expect(spread(1, 4, 10, true)).toEqual([1, 2, 3, 4]);
    expect(parseNumber('1\u00a0234,5')).toBe(1234.5);
  });
});
