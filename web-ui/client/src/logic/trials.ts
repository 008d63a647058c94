// What the study page draws of the trials.

import type { Trial } from '../types';

/** 1: lower is better; -1: higher is. */
export type Sign = 1 | -1;

/** Best objective up to each trial, over feasible trials with a value: [trial number, objective], steps only. */
export function bestSoFar(trials: readonly Trial[], sign: Sign = 1): [number, number][] {
  const steps: [number, number][] = [];
  let best = sign * Infinity;
  for (const t of trials) {
    if (!t.feasible || t.objective === null || sign * t.objective >= sign * best) continue;
    best = t.objective;
    steps.push([t.number, best]);
  }
  const last = trials.at(-1);
  if (last && steps.length > 0 && steps.at(-1)?.[0] !== last.number) steps.push([last.number, best]);
  return steps;
}

/** Value below which the share `q` of the sorted list lies (nearest rank). */
export function quantile(values: readonly number[], q: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.max(0, Math.ceil(q * sorted.length) - 1))] ?? NaN;
}

/** Feasible trials with a value, best first, ties by number. */
export function ranked(trials: readonly Trial[], sign: Sign = 1): Trial[] {
  return trials
    .filter((t) => t.feasible && t.objective !== null)
    .sort((a, b) => sign * ((a.objective ?? 0) - (b.objective ?? 0)) || a.number - b.number);
}

/** Ranked trials without those whose variables all agree to `digits` significant digits with a cheaper one. */
export function distinctPlans(trials: readonly Trial[], sign: Sign = 1, digits = 3): Trial[] {
  const seen = new Set<string>();
  return ranked(trials, sign).filter((t) => {
    const key = t.values.map((v) => v.toPrecision(digits)).join(' ');
    if (seen.has(key)) return false;
    seen.add(key);
    return true;
  });
}
