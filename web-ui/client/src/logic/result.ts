// The answer of a study beyond its best plan, read without knowing every member by name: a program that says more shows
// more, as tables.

import type { Study } from '../types';

export type Scalar = string | number | boolean | null;
export interface Block {
  /** Path of the member: "constraints", "choice/finalists". */
  name: string;
  columns: string[];
  rows: Record<string, Scalar>[];
  /** Members with single values that stand beside a list, or alone. */
  facts: [string, Scalar][];
}

/** What the study page shows in its own way. */
const known = new Set(['objective', 'unit', 'baseline', 'best', 'evaluations', 'saving', 'verdict', 'words', 'currency', 'direction', 'plan', 'study', 'baseline_run', 'best_run', 'id', 'name', 'binding', 'one_cut', 'sensitivity', 'losses', 'front']);

type ObjectValue = Record<string, unknown>;
const isObject = (v: unknown): v is ObjectValue => typeof v === 'object' && v !== null && !Array.isArray(v);
const isScalar = (v: unknown): v is Scalar => v === null || typeof v === 'string' || typeof v === 'number' || typeof v === 'boolean';

/** Members of members as "a/b"; lists of scalars become texts, deeper ones stay JSON. */
export function flat(value: ObjectValue, prefix = ''): [string, Scalar][] {
  return Object.entries(value).flatMap(([key, v]): [string, Scalar][] => {
    const name = prefix + key;
    if (isScalar(v)) return [[name, v]];
    if (isObject(v)) return flat(v, `${name}/`);
    // A list of named values reads as its members: [{"name": "speed", "value": 47}] is speed 47.
    if (Array.isArray(v) && v.every((e) => isObject(e) && typeof e['name'] === 'string' && 'value' in e))
      return (v as ObjectValue[]).map((e) => [String(e['name']), typeof e['text'] === 'string' ? e['text'] : isScalar(e['value']) ? e['value'] : JSON.stringify(e['value'])]);
    return [[name, Array.isArray(v) && v.every(isScalar) ? v.join(', ') : JSON.stringify(v)]];
  });
}

export function blocks(result: Study['result']): Block[] {
  const all: Block[] = [];
  const visit = (name: string, value: unknown): void => {
    if (Array.isArray(value) && value.length > 0 && value.every(isObject)) {
      const rows = value.map((v) => Object.fromEntries(flat(v)));
      all.push({ name, columns: [...new Set(rows.flatMap((r) => Object.keys(r)))], rows, facts: [] });
    } else if (isObject(value)) {
      const facts: [string, Scalar][] = [];
      const below: [string, unknown][] = [];
      for (const [key, v] of Object.entries(value)) {
        if (Array.isArray(v) && v.length > 0 && v.every(isObject)) below.push([key, v]);
        else facts.push(...flat({ [key]: v }));
      }
      if (facts.length > 0) all.push({ name, columns: [], rows: [], facts });
      for (const [key, v] of below) visit(`${name}/${key}`, v);
    }
  };
  const facts: [string, Scalar][] = [];
  for (const [key, value] of Object.entries(result)) {
    if (known.has(key)) continue;
    if (isScalar(value)) {
      if (value !== null && value !== '') facts.push([key, value]);
    } else visit(key, value);
  }
  if (facts.length > 0) all.unshift({ name: '', columns: [], rows: [], facts });
  return all;
}
