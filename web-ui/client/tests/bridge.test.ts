import { describe, expect, it } from 'vitest';
import { costBridge } from '../src/logic/bridge';
import type { Kpi } from '../src/types';

const kpi = (name: string, mean: number | null): Kpi => ({ name, unit: 'UAH', meaning: '', mean, half_width_95: null, samples: 1 });
const parts = [78.5397737, 9.1745986, 15.4183136, 3.1490961, 22.2716744, 15.2928197, 5.8769817];

describe('cost bridge', () => {
  const total = parts.reduce((a, b) => a + b, 0);
  const kpis = [kpi('cost_per_part', total), kpi('cost_per_good_part', total + 0.8856), ...parts.map((p, k) => kpi(`cost/c${k}`, p)), kpi('cost/idle', 0)];
  const bars = costBridge(kpis) ?? [];

  it('starts at nought, leaves no gap and closes exactly on the total', () => {
    const steps = bars.filter((b) => b.key.startsWith('c') && !b.total);
    expect(steps.length).toBe(parts.length);
    expect(steps[0]?.from).toBe(0);
    for (let k = 1; k < steps.length; ++k) expect(steps[k]?.from).toBe(steps[k - 1]?.to);
    expect(steps.at(-1)?.to).toBe(total);
  });
  it('prints amounts that add up to the printed totals', () => {
    const cents = (x: number) => Math.round(100 * x);
    const steps = bars.filter((b) => !b.total && b.key !== 'scrapped_parts');
    const part = bars.find((b) => b.key === 'cost_per_part');
    const good = bars.find((b) => b.key === 'cost_per_good_part');
    const extra = bars.find((b) => b.key === 'scrapped_parts');
    expect(steps.reduce((sum, b) => sum + cents(b.printed), 0)).toBe(cents(part?.printed ?? 0));
    expect(cents(part?.printed ?? 0) + cents(extra?.printed ?? 0)).toBe(cents(good?.printed ?? 0));
  });
  it('shows what the components do not explain', () => {
    const open = costBridge([kpi('cost_per_part', 100), kpi('cost/machining', 90)]) ?? [];
    expect(open.map((b) => b.key)).toEqual(['machining', 'unassigned', 'cost_per_part']);
    expect(open[1]?.printed).toBe(10);
  });
  it('is none when no part was finished', () => {
    expect(costBridge([kpi('cost_per_part', null)])).toBeNull();
    expect(costBridge([])).toBeNull();
  });
});
