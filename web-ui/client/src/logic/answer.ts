// Parts of a study's answer that have a view of their own: what holds the plan back, one cut against the shop, what an
// uncertain input does, the price list of losses, the points of a front.

import type { PlanPoint, Study } from '../types';

type Result = Study['result'];
type Values = PlanPoint['values'];

export interface Binding {
  name: string;
  unit: string;
  value: number;
  allowed: number;
  shadow_price: number | null;
  words?: string;
}
export interface OneCut {
  operation: string;
  speed_min_cost_m_min: number | null;
  speed_max_rate_m_min: number | null;
  speed_shop_m_min: number;
  why?: string;
}
export interface Sensitivity {
  name: string;
  relative: number | null;
  objective_low: number | null;
  objective_high: number | null;
  /** null: the plan would break a constraint. */
  regret_low: number | null;
  regret_high: number | null;
}
export interface Loss {
  name: string;
  kind: string;
  parts: { mean: number | null; half_width: number | null };
  saving_per_good_part: { mean: number | null; half_width: number | null };
}
export interface Losses {
  currency: string;
  minutes: number;
  replications: number;
  today: { cost_per_good_part: number | null; parts_good: number | null };
  losses: Loss[];
}
export interface FrontPlan {
  objectives: number[];
  values: Values;
  simulated: { mean: number | null; half_width: number | null }[];
  knee: boolean;
}
export interface Front {
  names: string[];
  points: FrontPlan[];
}

const list = <T>(value: unknown): T[] => (Array.isArray(value) ? (value as T[]) : []);

export const bindingOf = (r: Result): Binding[] => list<Binding>(r['binding']);
export const oneCutOf = (r: Result): OneCut[] => list<OneCut>(r['one_cut']);

export function sensitivityOf(r: Result): Sensitivity[] {
  const all = list<Sensitivity>(r['sensitivity']);
  const width = (s: Sensitivity) => (typeof s.objective_low === 'number' && typeof s.objective_high === 'number' ? Math.abs(s.objective_high - s.objective_low) : 0);
  return [...all].sort((a, b) => width(b) - width(a));
}

export function lossesOf(r: Result): Losses | null {
  return Array.isArray(r['losses']) && typeof r['minutes'] === 'number' ? (r as unknown as Losses) : null;
}

export function frontPlans(r: Result): Front | null {
  const front = r['front'] as { objectives?: { kpi: string }[]; points?: FrontPlan[]; knee?: number } | undefined;
  if (!front || !Array.isArray(front.points) || front.points.length === 0) return null;
  return {
    names: (front.objectives ?? []).map((o) => o.kpi),
    points: front.points.map((p, k) => ({ objectives: p.objectives, values: p.values ?? [], simulated: p.simulated ?? [], knee: k === front.knee })),
  };
}

export interface PricedLoss {
  name: string;
  kind: string;
  partsPerWeek: number | null;
  partsHalf: number | null;
  moneyPerMonth: number | null;
  moneyHalf: number | null;
}
const weekMin = 7 * 1440;
const monthMin = 30 * 1440;

/**
 * Losses as good parts a week and money a month of 30 days. Money is what a good part would cost less, times the good parts that
 * the shop makes today: the gain without selling a part more. Dearest first.
 */
export function pricedLosses(all: Losses): PricedLoss[] {
  const week = weekMin / all.minutes;
  const volume = ((all.today.parts_good ?? 0) * monthMin) / all.minutes;
  const times = (x: number | null, f: number) => (x === null ? null : x * f);
  return all.losses
    .map((l) => ({
      name: l.name,
      kind: l.kind,
      partsPerWeek: times(l.parts.mean, week),
      partsHalf: times(l.parts.half_width, week),
      moneyPerMonth: times(l.saving_per_good_part.mean, volume),
      moneyHalf: times(l.saving_per_good_part.half_width, volume),
    }))
    .sort((a, b) => (b.moneyPerMonth ?? -Infinity) - (a.moneyPerMonth ?? -Infinity));
}
