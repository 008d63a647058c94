// What the indicators of a run say about the shop as a whole: lead-time phases, the bottleneck, SEMI E10 groups, flow of
// parts, consumption.

import type { Kpi } from '../types';

const meanOf = (kpis: readonly Kpi[], name: string): number | null => kpis.find((k) => k.name === name)?.mean ?? null;

/** Names below "kind/", which may hold slashes themselves, as far as `leaf` follows. */
export function ownersOf(kpis: readonly Kpi[], kind: string, leaf: string): { name: string; kpi: Kpi }[] {
  return kpis.flatMap((kpi) => (kpi.name.startsWith(`${kind}/`) && kpi.name.endsWith(`/${leaf}`) && kpi.name.length > kind.length + leaf.length + 2 ? [{ name: kpi.name.slice(kind.length + 1, -leaf.length - 1), kpi }] : []));
}

/** Parts of the mean lead time; they add up to it. */
export function leadTimePhases(kpis: readonly Kpi[]): { phase: string; kpi: Kpi }[] {
  return kpis.flatMap((kpi) => {
    const match = /^lead_time\/([^/]+)_min$/.exec(kpi.name);
    return match ? [{ phase: match[1] ?? '', kpi }] : [];
  });
}

export interface Bottleneck {
  /** Machine with the longest mean active period (Roser 2001). */
  machine: string;
  /** Machines whose interval reaches into its interval: this run cannot tell them apart. */
  rivals: string[];
}

export function bottleneck(kpis: readonly Kpi[]): Bottleneck | null {
  const all = ownersOf(kpis, 'machine', 'active_period_min').filter((m) => m.kpi.mean !== null);
  const first = all.reduce<(typeof all)[number] | undefined>((best, m) => (best === undefined || (m.kpi.mean ?? 0) > (best.kpi.mean ?? 0) ? m : best), undefined);
  if (!first || all.length < 2) return null;
  const low = (first.kpi.mean ?? 0) - (first.kpi.half_width_95 ?? 0);
  return { machine: first.name, rivals: all.filter((m) => m !== first && (m.kpi.mean ?? 0) + (m.kpi.half_width_95 ?? 0) >= low).map((m) => m.name) };
}

/** SEMI E10 names of the machine states. */
export const e10Groups = ['productive', 'standby', 'scheduled_down', 'unscheduled_down', 'non_scheduled'] as const;
export type E10 = (typeof e10Groups)[number];
const groupOfState: Record<string, E10> = {
  cutting: 'productive', working: 'productive', loading: 'productive',
  idle: 'standby', off: 'standby', blocked: 'standby', waiting_crew: 'standby', waiting_tool: 'standby',
  setup: 'scheduled_down', planned_change: 'scheduled_down', tool_swap: 'scheduled_down', maintenance: 'scheduled_down', warm_up: 'scheduled_down',
  failure_change: 'unscheduled_down', repair: 'unscheduled_down', waiting_repair: 'unscheduled_down', overload_reset: 'unscheduled_down',
  off_shift: 'non_scheduled',
};

/** Shares of one machine's states by SEMI E10; a state that is not known counts as unscheduled downtime. */
export function e10Shares(states: readonly { state: string; kpi: Kpi }[]): Record<E10, number> {
  const shares: Record<E10, number> = { productive: 0, standby: 0, scheduled_down: 0, unscheduled_down: 0, non_scheduled: 0 };
  for (const { state, kpi } of states) shares[groupOfState[state] ?? 'unscheduled_down'] += kpi.mean ?? 0;
  return shares;
}

export interface Flow {
  from: string;
  to: string;
  value: number;
}

/**
 * Every finished part makes one pass through its route and one more per rework; a pass ends good, good with a hidden defect,
 * scrapped or back in rework. What goes in comes out.
 */
export function partFlows(kpis: readonly Kpi[], words: { fresh: string; back: string; good: string; hidden: string; scrapped: string; rework: string }): Flow[] {
  return ownersOf(kpis, 'part', 'good').flatMap(({ name }): Flow[] => {
    const good = meanOf(kpis, `part/${name}/good`) ?? 0;
    const scrapped = meanOf(kpis, `part/${name}/scrapped`) ?? 0;
    const reworked = (meanOf(kpis, `part/${name}/rework_ratio`) ?? 0) * (good + scrapped);
    const hidden = (meanOf(kpis, `part/${name}/escape_ratio`) ?? 0) * good;
    return [
      { from: words.fresh, to: name, value: good + scrapped },
      { from: words.back, to: name, value: reworked },
      { from: name, to: words.good, value: good - hidden },
      { from: name, to: words.hidden, value: hidden },
      { from: name, to: words.scrapped, value: scrapped },
      { from: name, to: words.rework, value: reworked },
    ].filter((f) => f.value > 0);
  });
}

/** Smallest value that at least `share` of the values do not exceed: no law assumed. */
export function empiricalQuantile(values: readonly (number | null)[], share: number): number | null {
  const known = values.filter((v): v is number => v !== null).sort((a, b) => a - b);
  return known.length === 0 ? null : (known[Math.max(0, Math.ceil(share * known.length - 1e-9) - 1)] ?? null);
}
