import { describe, expect, it } from 'vitest';
import { frontPlans, lossesOf, pricedLosses, sensitivityOf } from '../src/logic/answer';
import { entities } from '../src/logic/kpis';
import { decode, headers } from '../src/logic/ownData';
import { bottleneck, e10Groups, e10Shares, empiricalQuantile, leadTimePhases, partFlows } from '../src/logic/shop';
import { planChanges } from '../src/pages/studyParts';
import type { Kpi } from '../src/types';

const kpi = (name: string, mean: number | null, half: number | null = null): Kpi => ({ name, unit: '1', meaning: '', mean, half_width_95: half, samples: 2 });

describe('what a study answers', () => {
  it('losses become parts a week and money a month at today’s output', () => {
    const losses = { currency: 'UAH', minutes: 20160, replications: 4, today: { cost_per_good_part: 100, parts_good: 280 }, losses: [
      { name: 'small', kind: 'change', parts: { mean: 2, half_width: 1 }, saving_per_good_part: { mean: 1, half_width: 0.5 } },
      { name: 'large', kind: 'failure', parts: { mean: 20, half_width: 2 }, saving_per_good_part: { mean: 10, half_width: null } },
    ] };
    const [first, second] = pricedLosses(lossesOf(losses)!);
    // Two weeks counted: half of it a week; 280 parts in 14 days are 600 in 30.
    expect(first).toMatchObject({ name: 'large', partsPerWeek: 10, partsHalf: 1, moneyPerMonth: 6000, moneyHalf: null });
    expect(second).toMatchObject({ name: 'small', partsPerWeek: 1, moneyPerMonth: 600, moneyHalf: 300 });
    expect(lossesOf({})).toBeNull();
  });
  it('the widest sensitivity stands on top', () => {
    const s = (name: string, low: number | null, high: number) => ({ name, relative: 0.1, objective_low: low, objective_high: high, regret_low: 0, regret_high: null });
    expect(sensitivityOf({ sensitivity: [s('a', 1, 2), s('b', 5, 1), s('c', null, 9)] }).map((x) => x.name)).toEqual(['b', 'a', 'c']);
  });
  it('a front keeps the plan of every point, and a category becomes its option', () => {
    const values = [{ name: 'strategy', pointer: '/s', unit: '1', value: 1 }, { name: 'speed', pointer: '/v', unit: 'm/min', value: 50 }];
    const front = frontPlans({ front: { objectives: [{ kpi: 'a' }, { kpi: 'b' }], points: [{ objectives: [1, 2], values }, { objectives: [2, 1], values }], knee: 1 } });
    expect(front?.names).toEqual(['a', 'b']);
    expect(front?.points.map((p) => p.knee)).toEqual([false, true]);
    const variables = [{ name: 'strategy', pointer: '/s', unit: '1', low: 0, high: 1, type: 'categorical' as const, options: ['age', { kind: 'block' }] }, { name: 'speed', pointer: '/v', unit: 'm/min', low: 1, high: 9 }];
    expect(planChanges({ variables }, front!.points[0]!.values)).toEqual([{ pointer: '/s', value: { kind: 'block' } }, { pointer: '/v', value: 50 }]);
    expect(frontPlans({})).toBeNull();
  });
});

describe('the shop in a run', () => {
  it('the bottleneck is the longest active period, with those it cannot be told from', () => {
    const all = [kpi('machine/a/active_period_min', 40, 3), kpi('machine/b/active_period_min', 50, 4), kpi('machine/c/d/active_period_min', 44, 3)];
    expect(bottleneck(all)).toEqual({ machine: 'b', rivals: ['c/d'] });
    expect(bottleneck(all.slice(0, 1))).toBeNull();
  });
  it('SEMI E10 groups hold every state once', () => {
    const states = ['cutting', 'working', 'loading', 'setup', 'planned_change', 'failure_change', 'waiting_crew', 'waiting_tool', 'repair', 'waiting_repair', 'maintenance', 'overload_reset', 'warm_up', 'blocked', 'idle', 'off', 'off_shift', 'tool_swap'];
    const shares = e10Shares(states.map((state, k) => ({ state, kpi: kpi(state, (k + 1) / 171) })));
    expect(e10Groups.reduce((sum, g) => sum + shares[g], 0)).toBeCloseTo(1, 12);
    expect(shares.productive).toBeCloseTo(6 / 171, 12);
    expect(shares.non_scheduled).toBeCloseTo(17 / 171, 12);
  });
  it('what goes into a part’s passes comes out', () => {
    const words = { fresh: 'new', back: 'back', good: 'good', hidden: 'hidden', scrapped: 'scrapped', rework: 'rework' };
    const flows = partFlows([kpi('part/p/q/good', 90), kpi('part/p/q/scrapped', 10), kpi('part/p/q/rework_ratio', 0.2), kpi('part/p/q/escape_ratio', 0.1)], words);
    const sum = (of: 'from' | 'to') => flows.filter((f) => f[of] === 'p/q').reduce((s, f) => s + f.value, 0);
    expect(sum('to')).toBeCloseTo(120, 9);
    expect(sum('from')).toBeCloseTo(120, 9);
    expect(flows.find((f) => f.to === 'hidden')?.value).toBeCloseTo(9, 9);
    expect(partFlows([], words)).toEqual([]);
  });
  it('lead time has its phases, quantiles are values that were seen', () => {
    expect(leadTimePhases([kpi('lead_time_min', 3), kpi('lead_time/queue_min', 1), kpi('lead_time/machine_min', 2)]).map((p) => p.phase)).toEqual(['queue', 'machine']);
    expect(empiricalQuantile([5, 1, 4, 2, 3, 6, 7, 8, 10, 9], 0.9)).toBe(9);
    expect(empiricalQuantile([3, null], 0.9)).toBe(3);
    expect(empiricalQuantile([null], 0.9)).toBeNull();
  });
  it('what stands below a tool’s groups belongs to the tool, names may hold slashes', () => {
    const all = entities([kpi('tool/a/failures', 1), kpi('tool/a/edges/used', 2), kpi('tool/b/c/failures', 3)], 'tool');
    expect(all.map((e) => [e.name, e.kpis.map((k) => k.key)])).toEqual([['a', ['failures', 'edges/used']], ['b/c', ['failures']]]);
  });
});

describe('a table of the shop’s own', () => {
  it('has its headers whatever separates and quotes them', () => {
    expect(headers('\uFEFFEdge;"Cutting time; min";Cause\n1;2;3')).toEqual(['Edge', 'Cutting time; min', 'Cause']);
    expect(headers('a,b,"c ""d"""\r\n')).toEqual(['a', 'b', 'c "d"']);
    expect(headers('Стійкість, хв\tПричина')).toEqual(['Стійкість, хв', 'Причина']);
    expect(headers('')).toEqual([]);
  });
  it('is UTF-8, else Windows-1251', () => {
    expect(decode(new TextEncoder().encode('Стійкість').buffer as ArrayBuffer)).toEqual({ text: 'Стійкість', encoding: 'utf-8' });
    expect(decode(Uint8Array.from([0xd1, 0xf2, 0xb3, 0xe9]).buffer)).toEqual({ text: 'Стій', encoding: 'windows-1251' });
  });
});
