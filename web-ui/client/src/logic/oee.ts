// Overall equipment effectiveness by ISO 22400-2, as losses from 100 % of the planned time.

import type { Kpi } from '../types';

export interface OeeRow {
  name: string;
  availability: number;
  effectiveness: number;
  quality: number;
  oee: number;
  /** Shares of the planned time that each factor takes; with `oee` they add up to 1 (effectiveness above 1 is a gain, below nought). */
  availabilityLoss: number;
  speedLoss: number;
  qualityLoss: number;
  kpis: Partial<Record<'availability' | 'effectiveness' | 'quality' | 'oee', Kpi>>;
}

/**
 * One row per machine (or for the whole, name '') that has availability, effectiveness and quality ratio. The product of the
 * means is what the waterfall ends on.
 */
export function oeeRows(kpis: readonly Kpi[]): OeeRow[] {
  const groups = new Map<string, OeeRow['kpis']>();
  for (const kpi of kpis) {
    const cut = kpi.name.lastIndexOf('/');
    const leaf = kpi.name.slice(cut + 1);
    const factor = leaf === 'availability' || leaf === 'effectiveness' || leaf === 'oee' ? leaf : leaf === 'quality_ratio' ? 'quality' : undefined;
    if (!factor) continue;
    const owner = cut < 0 ? '' : kpi.name.slice(0, cut).replace(/^machine\//, '');
    groups.set(owner, { ...groups.get(owner), [factor]: kpi });
  }
  return [...groups].flatMap(([name, k]) => {
    const [a, e, q] = [k.availability?.mean, k.effectiveness?.mean, k.quality?.mean];
    if (typeof a !== 'number' || typeof e !== 'number' || typeof q !== 'number') return [];
    return [{ name, availability: a, effectiveness: e, quality: q, oee: a * e * q, availabilityLoss: 1 - a, speedLoss: a * (1 - e), qualityLoss: a * e * (1 - q), kpis: k }];
  });
}
