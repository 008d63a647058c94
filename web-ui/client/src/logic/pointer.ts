// JSON pointers (RFC 6901), and a scenario as a list of changes against where it began.

import type { Change } from '../types';

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

export const escapeStep = (step: string): string => step.replace(/~/g, '~0').replace(/\//g, '~1');
export const steps = (pointer: string): string[] =>
  pointer === ''
    ? []
    : pointer
        .slice(1)
        .split('/')
        .map((s) => s.replace(/~1/g, '/').replace(/~0/g, '~'));
export const join = (pointer: string, step: string | number): string => `${pointer}/${escapeStep(String(step))}`;

const isObject = (value: unknown): value is { [key: string]: Json } => typeof value === 'object' && value !== null && !Array.isArray(value);

/** The value at a pointer; undefined when there is none. */
export function at(value: Json | undefined, pointer: string): Json | undefined {
  let here: Json | undefined = value;
  for (const step of steps(pointer)) {
    if (Array.isArray(here)) here = here[Number(step)];
    else if (isObject(here)) here = Object.hasOwn(here, step) ? here[step] : undefined;
    else return undefined;
  }
  return here;
}

/** A copy with the value at the pointer replaced, added to its object, or (undefined) taken out. Throws when the way is not there. */
export function put(root: Json, pointer: string, value: Json | undefined): Json {
  const way = steps(pointer);
  if (way.length === 0) return value ?? null;
  const [first = '', ...rest] = way;
  const below = rest.map((s) => `/${escapeStep(s)}`).join('');
  if (Array.isArray(root)) {
    const k = Number(first);
    if (!Number.isInteger(k) || k < 0 || k > root.length) throw new Error(`${pointer}: no such entry`);
    const copy = [...root];
    if (rest.length === 0 && value === undefined) copy.splice(k, 1);
    else copy[k] = put(root[k] ?? null, below, value);
    return copy;
  }
  if (!isObject(root)) throw new Error(`${pointer}: no such member`);
  const copy = { ...root };
  if (rest.length === 0 && value === undefined) delete copy[first];
  else copy[first] = rest.length === 0 ? (value as Json) : put(root[first] ?? {}, below, value);
  return copy;
}

export function equal(a: Json | undefined, b: Json | undefined): boolean {
  if (a === b) return true;
  if (Array.isArray(a) && Array.isArray(b)) return a.length === b.length && a.every((v, k) => equal(v, b[k]));
  if (!isObject(a) || !isObject(b)) return false;
  const keys = Object.keys(a);
  return keys.length === Object.keys(b).length && keys.every((k) => Object.hasOwn(b, k) && equal(a[k], b[k]));
}

/**
 * The changes that turn `from` into `to`, each as deep as a what-if change can go: members may be set and added one by one;
 * where a member was taken out or a list has another length the whole object or list is one change. A pointer '' means that
 * changes cannot say it and the whole must be sent.
 */
export function changesBetween(from: Json, to: Json, pointer = ''): Change[] {
  if (equal(from, to)) return [];
  if (Array.isArray(from) && Array.isArray(to) && from.length === to.length) return to.flatMap((v, k) => changesBetween(from[k] as Json, v, join(pointer, k)));
  if (isObject(from) && isObject(to) && Object.keys(from).every((k) => Object.hasOwn(to, k)))
    return Object.entries(to).flatMap(([k, v]) => (Object.hasOwn(from, k) ? changesBetween(from[k] as Json, v, join(pointer, k)) : [{ pointer: join(pointer, k), value: v }]));
  return [{ pointer, value: to }];
}

/** The scenario with changes made, in order, as the program makes them. */
export function applyChanges(root: Json, changes: readonly Change[]): Json {
  return changes.reduce((json, c) => put(json, c.pointer, c.value as Json), root);
}
