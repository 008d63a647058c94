// The cost of a part as a bridge: components one upon the other up to the cost per part, then what scrapped parts
// add for a good one. Bars are drawn with full precision; printed amounts add up to the printed totals.

import type { Kpi } from '../types';
import { costComponents } from './kpis';
import { roundKeepingSum } from './shares';

export interface BridgeBar {
  /** Cost component, or "unassigned", "cost_per_part", "scrapped_parts", "cost_per_good_part". */
  key: string;
  total: boolean;
  from: number;
  to: number;
  /** What is printed, rounded so that the column adds up. */
  printed: number;
  kpi: Kpi | undefined;
}

const unassignedTolerance = 1e-9;

/**
 * Null when the run has no cost per part (no part was finished). What components do not explain becomes a bar of its
 * own, so that the bridge always closes and a gap is seen.
 */
export function costBridge(kpis: readonly Kpi[], digits = 2): BridgeBar[] | null {
  const part = kpis.find((k) => k.name === 'cost_per_part');
  const good = kpis.find((k) => k.name === 'cost_per_good_part');
  if (part?.mean === null || part?.mean === undefined) return null;
  const steps = costComponents(kpis)
    .filter((c) => c.kpi.mean !== null && c.kpi.mean !== 0)
    .map((c) => ({ key: c.component, amount: c.kpi.mean ?? 0, kpi: c.kpi as Kpi | undefined }));
  const explained = steps.reduce((sum, s) => sum + s.amount, 0);
  if (Math.abs(part.mean - explained) > unassignedTolerance * Math.abs(part.mean))
    steps.push({ key: 'unassigned', amount: part.mean - explained, kpi: undefined });

  const rounded = (x: number) => Math.round(x * 10 ** digits) / 10 ** digits;
  const printed = roundKeepingSum(steps.map((s) => s.amount), digits, part.mean);
  const bars: BridgeBar[] = [];
  let level = 0;
  steps.forEach((s, k) => {
    // The last step ends on the total itself, so that rounding of the sum leaves no hair's gap.
    const to = k + 1 === steps.length ? (part.mean ?? 0) : level + s.amount;
    bars.push({ key: s.key, total: false, from: level, to, printed: printed[k] ?? 0, kpi: s.kpi });
    level = to;
  });
  bars.push({ key: 'cost_per_part', total: true, from: 0, to: part.mean, printed: rounded(part.mean), kpi: part });
  if (good?.mean !== null && good?.mean !== undefined && good.mean !== part.mean) {
    const extra = rounded(good.mean) - rounded(part.mean);
    bars.push({ key: 'scrapped_parts', total: false, from: part.mean, to: good.mean, printed: rounded(extra), kpi: undefined });
    bars.push({ key: 'cost_per_good_part', total: true, from: 0, to: good.mean, printed: rounded(good.mean), kpi: good });
  }
  return bars;
}
