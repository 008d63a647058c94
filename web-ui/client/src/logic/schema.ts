// Reading the scenario's JSON Schema for forms: units, references between elements, alternatives, first values.

import type { JsonSchema } from '../types';
import type { Json } from './pointer';

/** A local reference followed, and "this or null" taken for this: leaving a member out says null. */
export function resolve(root: JsonSchema, schema: JsonSchema): JsonSchema {
  let here = schema;
  for (let k = 0; k < 16; ++k) {
    const { $ref, anyOf, ...beside } = here;
    if ($ref?.startsWith('#/')) {
      let next: unknown = root;
      for (const step of $ref.slice(2).split('/')) next = (next as Record<string, unknown> | undefined)?.[step];
      if (typeof next !== 'object' || next === null) break;
      here = { ...(next as JsonSchema), ...beside };
    } else if (anyOf) {
      const real = anyOf.filter((one) => one.type !== 'null');
      if (real.length !== 1) break;
      here = { ...real[0], ...beside };
    } else break;
  }
  return here;
}

/** "spindle power [kW]" in its two halves. */
export function meaningAndUnit(schema: JsonSchema): { meaning: string; unit: string } {
  const match = /^(.*?)\s*\[([^\]]*)\]$/s.exec(schema.description ?? '');
  return match ? { meaning: match[1] ?? '', unit: match[2] ?? '' } : { meaning: schema.description ?? '', unit: '' };
}

/** The "kind" of an alternative, "" when it has none. */
export function kindOf(schema: JsonSchema): string {
  const kind = schema.properties?.['kind'];
  const name = kind?.const ?? kind?.enum?.[0];
  return typeof name === 'string' ? name : '';
}

/** The alternative that a value is, by its kind. */
export function alternative(root: JsonSchema, schema: JsonSchema, value: Json | undefined): JsonSchema | undefined {
  const kind = typeof value === 'object' && value !== null && !Array.isArray(value) ? value['kind'] : undefined;
  return (schema.oneOf ?? []).map((s) => resolve(root, s)).find((s) => kindOf(s) === kind);
}

/**
 * The list of the scenario that a text refers to by name: its description says "name of the insert", "names of the
 * operations", and the scenario has a list "inserts", "operations". Undefined for plain texts.
 */
export function referredList(root: JsonSchema, schema: JsonSchema): string | undefined {
  const word = /\bnames? of (?:the |an? )?(\w+)/i.exec(schema.description ?? '')?.[1]?.toLowerCase();
  if (!word) return undefined;
  return Object.keys(root.properties ?? {}).find((list) => root.properties?.[list]?.type === 'array' && (list === word || list === `${word}s` || list === `${word}es`));
}

/** The allowed range in words. */
export function rangeOf(schema: JsonSchema): string {
  const low = schema.exclusiveMinimum !== undefined ? `> ${schema.exclusiveMinimum}` : schema.minimum !== undefined ? `≥ ${schema.minimum}` : '';
  const high = schema.exclusiveMaximum !== undefined ? `< ${schema.exclusiveMaximum}` : schema.maximum !== undefined ? `≤ ${schema.maximum}` : '';
  return [low, high].filter(Boolean).join(', ');
}

/** The smallest value that has what the schema requires: what "add" puts into a list. */
export function firstValue(root: JsonSchema, given: JsonSchema, depth = 0): Json {
  const schema = resolve(root, given);
  if (schema.default !== undefined && schema.default !== null) return schema.default as Json;
  if (schema.enum?.[0] !== undefined) return schema.enum[0] as Json;
  if (schema.const !== undefined) return schema.const as Json;
  if (schema.oneOf?.[0] && depth < 8) return firstValue(root, schema.oneOf[0], depth + 1);
  switch (schema.type) {
    case 'object': {
      const value: { [key: string]: Json } = {};
      if (depth < 8) for (const name of schema.required ?? []) value[name] = firstValue(root, schema.properties?.[name] ?? {}, depth + 1);
      return value;
    }
    case 'array':
      return Array.from({ length: Math.min(schema.minItems ?? 0, 20) }, () => firstValue(root, schema.items ?? {}, depth + 1));
    case 'integer':
    case 'number': {
      const low = schema.minimum ?? (schema.exclusiveMinimum !== undefined ? Math.max(schema.exclusiveMinimum + 1, 1) : undefined);
      const high = schema.maximum ?? schema.exclusiveMaximum;
      if (low === undefined) return high !== undefined && high < 1 ? high : 1;
      return schema.exclusiveMinimum !== undefined && high !== undefined && low >= high ? (schema.exclusiveMinimum + high) / 2 : low;
    }
    case 'boolean':
      return false;
    default:
      return '';
  }
}

/** "spindle_speed_max_rpm" as people read it; a unit that is shown beside it is not said twice. */
export function title(name: string, unit = ''): string {
  const suffix = `_${(unit === 'degC' ? 'c' : unit).toLowerCase().replace(/[^a-z0-9]+/g, '_')}`;
  const bare = suffix !== '_' && suffix !== '_1' && name.toLowerCase().endsWith(suffix) ? name.slice(0, -suffix.length) : name;
  return bare.replace(/_/g, ' ');
}

/** Bounds for a variable of a study: half to double today's value, inside what the schema allows. */
export function searchBounds(schema: JsonSchema, value: number): { low: number; high: number } {
  const size = Math.abs(value);
  const step = schema.type === 'integer' ? 1 : size > 0 ? size / 100 : 0.01;
  const floor = schema.exclusiveMinimum !== undefined ? schema.exclusiveMinimum + step : (schema.minimum ?? -Infinity);
  const ceiling = schema.exclusiveMaximum !== undefined ? schema.exclusiveMaximum - step : (schema.maximum ?? Infinity);
  let low = value === 0 ? -1 : value - size / 2;
  let high = value === 0 ? 1 : value + size;
  if (schema.type === 'integer') [low, high] = [Math.min(Math.floor(low), value - 1), Math.max(Math.ceil(high), value + 1)];
  const digits = (x: number) => Number(x.toPrecision(6));
  return { low: digits(Math.max(low, floor)), high: digits(Math.min(high, ceiling)) };
}

/** The schema of the first member of this name, wherever it stands; breadth first. */
export function findProperty(root: JsonSchema, name: string): JsonSchema | undefined {
  let level: JsonSchema[] = [root];
  for (let depth = 0; depth < 8 && level.length > 0; ++depth) {
    const next: JsonSchema[] = [];
    for (const given of level) {
      const schema = resolve(root, given);
      const found = schema.properties?.[name];
      if (found) return found;
      next.push(...Object.values(schema.properties ?? {}), ...(schema.items ? [schema.items] : []), ...(schema.oneOf ?? []));
    }
    level = next;
  }
  return undefined;
}
