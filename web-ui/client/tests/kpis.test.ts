import { describe, expect, it } from 'vitest';
import { costComponents, entities, extreme, machineTimes } from '../src/logic/kpis';
import type { Kpi } from '../src/types';

const kpi = (name: string, mean: number | null = 0.5): Kpi => ({ name, unit: '1', meaning: '', mean, half_width_95: 0.1, samples: 2 });

describe('views of the KPI list', () => {
  it('gathers the states of each machine, also when its name holds a slash', () => {
    const machines = machineTimes([kpi('machine/line 1/2/availability'), kpi('machine/line 1/2/state/cutting'), kpi('machine/lathe/state/idle')]);
    expect(machines.map((m) => m.machine)).toEqual(['line 1/2', 'lathe']);
    expect(machines[0]?.states.map((s) => s.state)).toEqual(['cutting']);
    expect(machines[0]?.availability).toBeDefined();
    expect(machines[1]?.availability).toBeUndefined();
  });
  it('gathers tools and crews apart', () => {
    const all = [kpi('tool/a/failures'), kpi('tool/a/failure_share'), kpi('crew/a/utilization')];
    expect(entities(all, 'tool').map((e) => e.kpis.map((k) => k.key))).toEqual([['failures', 'failure_share']]);
    expect(entities(all, 'crew').map((e) => e.name)).toEqual(['a']);
  });
  it('takes as components only what stands right below cost/', () => {
    expect(costComponents([kpi('cost/inserts'), kpi('cost_per_part'), kpi('cost/x/y')]).map((c) => c.component)).toEqual(['inserts']);
  });
  it('finds the extreme and passes over missing values', () => {
    const list = [3, null, 1, 2].map((m, k) => ({ name: String(k), kpi: kpi('x', m) }));
    expect(extreme(list, 1)?.name).toBe('2');
    expect(extreme(list, -1)?.name).toBe('0');
    expect(extreme([{ name: 'n', kpi: kpi('x', null) }], 1)).toBeUndefined();
  });
});
